/* stepped.c: share/engine/host/run/stepped.h on an oscillator q'' = -4 q + v in steps of 0.01 s,
 * against closed forms: inputs that are set, events of the user, a run that is copied, what is
 * refused. A line for each check. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/run/stepped.h"

static void
check (const char *what, int true_)
{
  printf ("%sok %s\n", true_ ? "" : "not ", what);
}

static void
near (const char *what, double found, double wanted, double error)
{
  if (fabs (found - wanted) <= error)
    printf ("ok %s\n", what);
  else
    printf ("not ok %s: expected %.17g, found %.17g\n", what, wanted, found);
}

/* cst[1] is the number of its calls */
static int
rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)t;
  xd[0] = x[1];
  xd[1] = -4 * x[0] + v[0];
  ((gs_real *)cst)[1]++;
  return cst[0] < 0;
}

/* where q falls through 0 it is thrown back; where it falls through cst[0] the run ends */
static void
evt (gs_real t, const gs_real *x, const gs_real *v, const int *mode, const gs_real *cst,
     gs_real *g)
{
  (void)t, (void)v, (void)mode;
  g[0] = x[0];
  g[1] = 4 - cst[0] - t;
}

static int
rst (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst)
{
  (void)t, (void)v, (void)mode, (void)cst;
  if (k == 1)
    x[1] = -x[1];
  return 0;
}

static const double nominal[] = { 1, 1 };
static const char *const states[] = { "q", "u" }, *const events[] = { "floor", "late" };
static const int kinds[] = { 3, 4 }, no_inputs[] = { 0, 0 };
static const gs_scene free_scene = { .name = "spring", .nq = 1, .nu = 1, .nx = 2, .nv = 1,
                                     .rhs = rhs };
static const gs_scene thrown = { .name = "thrown", .nq = 1, .nu = 1, .nx = 2, .nv = 1, .nev = 2,
                                 .event_inputs = no_inputs, .event_kinds = kinds, .rhs = rhs,
                                 .evt = evt, .rst = rst };

static gs_description
about (const gs_scene *s)
{
  return (gs_description){ .scene = s, .nominal = nominal, .states = states, .events = events,
                           .ncst = 2, .loop_method = -1 };
}

static const gs_real times[] = { 0, 5 }, x0[] = { 1, 0 }, cst[] = { 1, 0 };
static const gs_run_start start = { .nt = 2, .times = times, .x0 = x0, .cst = cst };

/* n steps of 0.01 s: is one refused, or does it fail? */
static int
steps (gs_stepped_run *a, int from, int to)
{
  int failed = 0;
  for (int k = from; k < to && ! failed && *a->ended == 0; k++)
    failed = gs_step_on (a, (gs_real)(k + 1) / 100);
  return failed;
}

static int
began (gs_stepped_run *a, const gs_description *d, const char *method)
{
  *a = (gs_stepped_run){ .o = gs_default_options () };
  a->o.method = method;
  if (strcmp (method, "gauss") == 0)
    a->o.step = 0.005;
  return gs_step_open (a, d, 3, 2) == 0 && gs_step_begin (a, &start) == 0;
}

/* q = cos 2t, from 1 s on (3/4)(1 - cos 2(t - 1)) on top */
static void
inputs (const char *method, double error, int calls)
{
  const gs_description d = about (&free_scene);
  gs_stepped_run a;
  char what[80];
  snprintf (what, sizeof what, "%s goes on", method);
  int good = began (&a, &d, method) && steps (&a, 0, 99) == 0;
  near (what, (double)a.x[0], cos (2 * 0.99), error);
  good = good && steps (&a, 99, 100) == 0;
  gs_step_set (&a, 0, 3);
  check ("... under an input", good && steps (&a, 100, 200) == 0);
  near ("... its state", (double)a.x[0], cos (4) + 0.75 * (1 - cos (2)), error);
  near ("... its time", (double)a.clock[GS_STEP_NOW], 2, 0);
  snprintf (what, sizeof what, "... in %d calls: found %g", calls, (double)a.r.cst[1]);
  check (what, a.r.cst[1] <= calls);
  gs_step_close (&a);
}

/* a copy of the two arrays, in another run: the same bits */
static void
copied (const char *method)
{
  const gs_description d = about (&free_scene);
  gs_stepped_run a, b = { .o = gs_default_options () };
  b.o.method = method;
  int good = began (&a, &d, method) && steps (&a, 0, 57) == 0 && gs_step_open (&b, &d, 3, 2) == 0;
  a.own[2] = 7;
  a.own_wholes[1] = 8;
  memcpy (b.numbers, a.numbers, a.nnumbers * sizeof *a.numbers);
  memcpy (b.wholes, a.wholes, a.nwholes * sizeof *a.wholes);
  good = good && steps (&a, 57, 120) == 0 && steps (&b, 57, 120) == 0;
  check ("a copy goes on with the same bits", good && memcmp (a.x, b.x, 2 * sizeof *a.x) == 0);
  check ("... with what is the host's", good && b.own[2] >= 7 && b.own_wholes[1] == 8);
  gs_step_close (&a);
  gs_step_close (&b);
}

/* q = |cos 2t|, to its end at 3 s */
static void
thrown_back (const char *method)
{
  const gs_description d = about (&thrown);
  gs_stepped_run a;
  int good = began (&a, &d, method) && steps (&a, 0, 250) == 0;
  near (method, (double)a.x[0], fabs (cos (5)), 1e-7);
  check ("... thrown back twice", good && a.tally[0] == 2 && *a.ended == 0);
  near ("... at the last time", (double)a.when[0], 3 * acos (-1) / 4, 1e-8);
  check ("... to its end", steps (&a, 250, 400) == 0 && *a.ended == 2);
  near ("... at its time", (double)a.clock[GS_STEP_NOW], 3, 1e-12);
  check ("... not beyond", gs_step_on (&a, 4) != 0 && a.r.refused == GS_REFUSED_TIME
         && strstr (a.r.text, "has ended the run at t = 3 s"));
  gs_step_close (&a);
}

static void
refusals (void)
{
  const gs_description d = about (&free_scene);
  gs_stepped_run a = { .o = gs_default_options () };
  a.o.method = "euler";
  check ("an unknown method is refused", gs_step_open (&a, &d, 0, 0) != 0
         && a.r.refused == GS_REFUSED_OPTION && strstr (a.r.text, "euler"));
  gs_step_close (&a);
  a.o = gs_default_options ();
  a.o.audit = 1;
  check ("an audit is refused", gs_step_open (&a, &d, 0, 0) != 0
         && strcmp (a.r.option, "audit") == 0);
  gs_step_close (&a);
  check ("a run", began (&a, &d, "dp853") && gs_step_on (&a, 1) == 0);
  check ("a time before now is refused", gs_step_on (&a, GS_R (0.5)) != 0
         && strstr (a.r.text, "expected a time after t = 1 s; found 0.5 s"));
  check ("... one after the stop", gs_step_on (&a, 6) != 0
         && strstr (a.r.text, "a step to t = 6 s, but the experiment stops at 5 s"));
  a.r.cst[0] = -1;
  check ("a routine that fails", gs_step_on (&a, 2) != 0 && a.r.refused == 0
         && a.r.info == GS_ROUTINE_FAILED && strstr (a.r.text, "RHS"));
  a.o.rtol = 2;
  check ("a tolerance is refused", gs_step_begin (&a, &start) != 0
         && strcmp (a.r.option, "rtol") == 0);
  gs_step_close (&a);
}

int
main (void)
{
  inputs ("dp853", 1e-8, 1000);
  inputs ("rk4", 1e-9, 9000);
  copied ("dp853");
  copied ("rk4");
  thrown_back ("dp853");
#if ! defined (GSMBP_QUAD)
  inputs ("radau", 1e-8, 5000);
  inputs ("gauss", 1e-9, 20000);
  inputs ("auto", 1e-8, 4000);
  copied ("radau");
  thrown_back ("radau");
#endif
  refusals ();
  return 0;
}

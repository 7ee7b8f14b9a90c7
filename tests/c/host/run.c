/* run.c: share/engine/host/run/run.h on an oscillator q'' = -w^2 q + v, w = cst[0] = par[0], whose
 * output is its energy, against closed forms; every refusal; instants of samples. A line for each
 * check. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/run/run.h"

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

static int
rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)t;
  xd[0] = x[1];
  xd[1] = -cst[0] * cst[0] * x[0] + v[0];
  return cst[0] > 90;
}

/* what came in and what passed */
static int
rha (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  const int info = rhs (t, x, v, cst, xd);
  xd[2] = x[1] * v[0];
  xd[3] = gs_abs (x[1] * v[0]);
  return info;
}

static int
out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  (void)t, (void)v;
  y[0] = (x[1] * x[1] + cst[0] * cst[0] * x[0] * x[0]) / 2;
  return 0;
}

/* a force that jumps to 3 at t = 1; calls counts those at 1 exactly */
static int
force (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  (void)side, (void)x, (void)nx, (void)nv;
  *(int *)data += t >= 1 && t <= 1;
  v[0] = t < 1 ? 0 : 3;
  return 0;
}

static int
never (void *asked, gs_real t)
{
  return t > *(double *)asked ? GS_INTERRUPTED : 0;
}

static const double nominal[] = { 1, 1 };
static const char *const states[] = { "q", "u" };
static const int angles[] = { 0 };
static const gs_scene scene = { .name = "spring", .nq = 1, .nu = 1, .nx = 2, .nv = 1, .ny = 1,
                                .rhs = rhs, .out = out };
static const gs_description about = { .scene = &scene, .nominal = nominal, .angles = angles,
                                      .states = states, .ncst = 1, .npar = 1, .loop_method = -1,
                                      .audited = rha };
enum { TIMES = 5 };
static const gs_real times[TIMES] = { 0, GS_R (0.5), 1, GS_R (1.5), 2 }, x0[] = { 1, 0 };
static const gs_real cst[] = { 2 };
static const double par[] = { 2 };
static const gs_run_start start = { .nt = TIMES, .times = times, .x0 = x0, .par = par, .cst = cst };
static const gs_run_inputs none = { .kind = 0 };

static void
free_motion (const char *method, double error)
{
  gs_run_options o = gs_default_options ();
  gs_run_result r;
  char what[80];
  o.method = method;
  const int info = gs_run (&about, &o, &start, &none, &r);
  snprintf (what, sizeof what, "%s to its end", method);
  check (what, info == 0 && r.rows == TIMES && r.ldv == 1 && strcmp (r.method, method) == 0);
  for (int k = 0; k < TIMES; k++)
    {
      const double t = (double)times[k];
      snprintf (what, sizeof what, "%s at %g", method, t);
      near (what, (double)r.x[2 * k], cos (2 * t), error);
      near ("its speed", (double)r.x[2 * k + 1], -2 * sin (2 * t), 2 * error);
      near ("its output", (double)r.y[k], 2, 4 * error);
    }
  gs_free_result (&r);
}

/* q = cos 2t, then (3/4)(1 - cos 2(t - 1)) on top */
static void
jump (void)
{
  int calls = 0;
  gs_run_options o = gs_default_options ();
  gs_run_result r;
  const double at = 1;
  const gs_run_inputs in = { .kind = 3, .function = force, .data = &calls, .nbreaks = 1,
                             .breaks = &at };
  check ("an input that jumps", gs_run (&about, &o, &start, &in, &r) == 0);
  near ("behind its jump", (double)r.x[2 * 4], cos (4) + 0.75 * (1 - cos (2)), 1e-9);
  near ("the input at the jump is from the left", (double)r.v[2], 0, 0);
  near ("and behind it", (double)r.v[3], 3, 0);
  check ("it is never called in the jump", calls == 0);
  gs_free_result (&r);
  const gs_real both[] = { 0, 1, 2, 0, 3 };
  const gs_run_inputs table = { .kind = 1, .table = { 1, 2, 1, both } };
  check ("the same as a table", gs_run (&about, &o, &start, &table, &r) == 0);
  near ("behind the jump of a table", (double)r.x[2 * 4], cos (4) + 0.75 * (1 - cos (2)), 1e-9);
  gs_free_result (&r);
}

static void
audit (void)
{
  gs_run_options o = gs_default_options ();
  gs_run_result r;
  const gs_real three = 3;
  const gs_run_inputs in = { .kind = 0, .constants = &three };
  o.audit = 1;
  check ("an audit", gs_run (&about, &o, &start, &in, &r) == 0 && r.nx == 4);
  const double end = (double)r.x[4 * 4], work = 3 * (end - 1);
  near ("the work of the force", (double)r.x[4 * 4 + 2], work, 1e-8);
  near ("is the energy that came", (double)(r.y[4] - r.y[0]), work, 1e-8);
  gs_free_result (&r);
}

static void
ended (void)
{
  double at = 1.2;
  gs_run_options o = gs_default_options ();
  gs_run_result r;
  o.ask = never;
  o.asked = &at;
  o.maxstep = 0.1;
  const int info = gs_run (&about, &o, &start, &none, &r);
  check ("a run that is asked to end", info != 0 && r.refused == 0 && r.info == GS_INTERRUPTED
         && r.rows == 3);
  check ("what it says", strncmp (r.text, "interrupted by Ctrl-C at t = 1.2", 32) == 0);
  gs_free_result (&r);
  const gs_real wild = 100;
  gs_run_start s = start;
  s.cst = &wild;
  o = gs_default_options ();
  check ("a routine that fails", gs_run (&about, &o, &s, &none, &r) != 0
         && r.info == GS_ROUTINE_FAILED && strstr (r.text, "RHS"));
  gs_free_result (&r);
}

static void
refused (const char *what, gs_run_options o, int why, const char *option, const char *words)
{
  gs_run_result r;
  const int info = gs_run (&about, &o, &start, &none, &r);
  const int good = info != 0 && r.refused == why && strcmp (r.option, option) == 0
                   && strstr (r.text, words);
  if (good)
    printf ("ok %s is refused\n", what);
  else
    printf ("not ok %s is refused: found %d %s, %s\n", what, r.refused, r.option ? r.option : "",
            r.text);
  gs_free_result (&r);
}

static void
refusals (void)
{
  const gs_run_options fine = gs_default_options ();
  gs_run_options o = fine;
  o.method = "euler";
  refused ("an unknown method", o, GS_REFUSED_OPTION, "method", "euler");
  o = fine, o.step = -1;
  refused ("a negative step", o, GS_REFUSED_OPTION, "step", "-1");
  o = fine, o.maxstep = 1e-30;
  refused ("too many steps", o, GS_REFUSED_OPTION, "maxstep", "2e+30 steps of dp853");
  o = fine, o.maxorder = 5;
  refused ("an order of dp853", o, GS_REFUSED_OPTION, "maxorder", "one order alone, found 5");
  o = fine, o.rtol = 2;
  refused ("a tolerance", o, GS_REFUSED_OPTION, "rtol", "found 2");
  const gs_real low[] = { 1, -1 };
  o = fine, o.atol = low;
  refused ("a negative tolerance", o, GS_REFUSED_OPTION, "atol", "-1 of u");
  o = fine, o.loops = "ropes";
  refused ("an unknown way", o, GS_REFUSED_OPTION, "loops", "ropes");
  o = fine, o.loops = "index2";
  refused ("index 2 without loops", o, GS_REFUSED_OPTION, "loops", "no loops");
  o = fine, o.drift = 1;
  refused ("a drift of no constraints", o, GS_REFUSED_ROUTINE, "con", "");
  o = fine, o.maxsteps = -1;
  refused ("less than no steps", o, GS_REFUSED_OPTION, "maxsteps", "-1");
  gs_real small[] = { GS_R (1e-40), 1 };
  gs_run_result r;
  o = fine, o.atol = small;
  check ("a tolerance below rounding is raised",
         gs_run (&about, &o, &start, &none, &r) == 0 && strstr (r.warning, "atol = 1e-40 of q")
         && r.atol[0] > small[0]);
  gs_free_result (&r);
}

static void
every_second (const gs_real *cst, gs_real *period, gs_real *delay)
{
  (void)cst;
  period[0] = 1;
  delay[0] = 0;
}

static void
no_samples (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  (void)k, (void)t, (void)y, (void)xk, (void)cst, (void)v;
}

/* a run of another scene, start or inputs is refused */
static void
refused_run (const char *what, const gs_description *d, const gs_run_options *o,
             const gs_run_start *s, const gs_run_inputs *in, int why, const char *words)
{
  gs_run_result r;
  check (what, gs_run (d, o, s, in, &r) != 0 && r.refused == why && strstr (r.text, words) != NULL);
  gs_free_result (&r);
}

/* what a scene lacks for its inputs, its devices, the way of its loops */
static void
lacking (void)
{
  static const int one[] = { 1 };
  const gs_real gain[] = { 0, 1, 1, 1 }, long_times[] = { 0, GS_R (1e10) };
  gs_run_options o = gs_default_options ();
  gs_run_inputs in = { .kind = 3 };
  gs_run_start s = start;
  refused_run ("inputs of a scene that has none are refused", &about, &o, &s, &in,
               GS_REFUSED_ROUTINE, "the run needs the subroutine VIN, which spring");
  o.audit = 1;
  in = (gs_run_inputs){ .gain = { 2, 1, 1, gain } };
  refused_run ("an audit with feedback is refused", &about, &o, &s, &in, GS_REFUSED_OPTION,
               "feedback");
  gs_scene other = scene;
  gs_description d = about;
  d.scene = &other;
  o = gs_default_options ();
  in = none;
  other.nctl = other.nheld = 1;
  other.held_counts = other.again = other.held_inputs = one;
  refused_run ("a device without its subroutine is refused", &d, &o, &s, &in, GS_REFUSED_ROUTINE,
               "CTL");
  other.ctl = no_samples;
  other.ctp = every_second;
  s.nt = 2;
  s.times = long_times;
  refused_run ("1e10 samples are refused", &d, &o, &s, &in, GS_REFUSED_SAMPLES, "2e9 samples");
  other = scene;
  other.nlam = 1;
  o.loops = "svd";
  o.drift = 0;
  refused_run ("a way that projects needs PRJ", &d, &o, &start, &in, GS_REFUSED_ROUTINE,
               "the way \"svd\" needs the subroutine PRJ, which spring was emitted without");
}

/* ------------------------------------------------------------ a device that counts its samples */

static int
no_outputs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  (void)t, (void)x, (void)v, (void)cst, (void)y;
  return 0;
}

static void
count_by_three (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  (void)k, (void)t, (void)y, (void)cst;
  v[0] = xk[0] += 3;
}

/* of a period of 0.1 s: sample 3 is due at 0.3 s, and at instants that differ from it by rounding;
 * not before. Its output is held from then on; with a delay of 0.05 s it arrives at 0.35 s. */
static void
instants (void)
{
  const gs_scene s = { .nv = 1, .nctl = 1, .out = no_outputs, .ctl = count_by_three };
  const gs_real later[] = { -1e-6, -4 * GS_EPSILON, 0, 4 * GS_EPSILON, 1e-6 };
  const gs_real x[1] = { 0 }, cst[1] = { 0 };
  int wrong = 0;
  for (int i = 0; i < 10; i++)
    {
      const int delayed = i > 4, due = i % 5 > 0;
      const gs_real found = due && ! delayed ? 3 : -7;
      int is[40] = { 0 }, info;
      gs_real rs[60] = { 0 }, v[1] = { -7 };
      gs_samples a;
      is[0] = is[1] = is[3] = is[4] = 1; /* a device, a memory, an output, one pending */
      a = gs_samples_of (1, is, rs);
      a.next[0] = 3;
      a.held[0] = a.input[0] = 1;
      a.period[0] = (gs_real)1 / 10;
      a.delay[0] = delayed ? (gs_real)1 / 20 : 0;
      info = gs_sample (&s, (gs_real)3 / 10 * (1 + later[i % 5]), x, cst, v, is, rs);
      wrong += info != 0 || a.next[0] != 3 + due || v[0] != found;
      if (! delayed || ! due)
        continue;
      info = gs_sample (&s, (gs_real)7 / 20 * (1 + later[i % 5]), x, cst, v, is, rs);
      wrong += info != 0 || v[0] != 3;
    }
  check ("gs_sample: samples and delayed outputs at their instants", wrong == 0);
}

int
main (void)
{
  instants ();
  free_motion ("dp853", 1e-9);
  free_motion ("rk4", 1e-11);
#if ! defined (GSMBP_QUAD)
  free_motion ("radau", 1e-8);
  free_motion ("gauss", 1e-11);
#endif
  jump ();
  audit ();
  ended ();
  refusals ();
  lacking ();
  return 0;
}

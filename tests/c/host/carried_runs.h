/* carried_runs.h: runs of emitted scenes with columns of derivatives, by gs_integrate, for
 * carried_runs.c and its like. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include "host/adjoint.h"
#include "host/derivatives/derivatives.h"

enum { MOST = 256 };

/* a run of s from x0 with nc columns; dx0 (nx,nc) their start, null: zero */
typedef struct
{
  const gs_scene *s;
  const gs_real *cst;
  int ncst, nc;
  int col[8];
  gs_real x0[MOST], inputs[8];
  int nt, loops, on_the_way;
  gs_real tout[8], rtol;
  /* found: states with columns (MOST,nt), INFO, what the columns say */
  gs_real x[MOST * 8];
  int info, calls, lost[8], events, held;
  double tau[8], first_held[MOST];
} job;

static void
check (const char *what, int true_)
{
  printf ("%sok %s\n", true_ ? "" : "not ", what);
}

/* found is what was expected, but for the tolerance beside 1 or beside itself */
static void
close_to (const char *what, gs_real found, gs_real expected, double tolerance)
{
  const double off = (double)(gs_abs (found - expected) / (1 + gs_abs (expected)));
  if (off <= tolerance)
    printf ("ok %s within %.0e\n", what, tolerance);
  else
    printf ("not ok %s: expected %.17g, found %.17g\n", what, (double)expected, (double)found);
}

static void *
zeros (size_t n, size_t size)
{
  void *all = calloc (n + 1, size);
  if (! all)
    abort ();
  return all;
}

/* what the columns of the run say */
static void
read_columns (job *j, gs_derivatives *d)
{
  const double *numbers;
  int event;
  double time;
  for (int k = 0; k < j->nc; k++)
    j->lost[k] = gs_derivatives_lost (d, k, &event, &time);
  j->events = gs_derivatives_of_events (d, &numbers);
  for (int k = 0; k < j->nc && j->events > 0; k++)
    j->tau[k] = numbers[k];
  j->held = gs_derivatives_held (d, &numbers);
  for (int i = 0; i < 1 + j->s->nv * j->nc && j->held > 0; i++)
    j->first_held[i] = numbers[i];
}

static void *
run_job (void *given)
{
  job *j = given;
  const int nx = j->s->nx * (1 + j->nc), sets[4] = { 0 };
  const gs_plan plan = { .s = j->s, .nx = nx, .constants = j->inputs, .on_the_way = j->on_the_way,
                         .instants = 0, .events = 1000 };
  int iopt[6] = { 8, j->loops ? 2 : 1 };
  gs_real ropt[3] = { 0, j->rtol, 0 }, atol[MOST];
  int *ip = zeros ((size_t)gs_wholes (&plan), sizeof *ip);
  gs_real *rp = zeros ((size_t)gs_reals (&plan), sizeof *rp),
          *v = zeros ((size_t)(j->s->nv + 1) * 8, sizeof *v);
  const char *missing = NULL;
  for (int i = 0; i < nx; i++)
    atol[i] = j->rtol;
  gs_lay (&plan, ip, rp);
  j->info = gs_due_from (j->s, 0, j->cst, ip, rp);
  const gs_derivatives_given columns
      = { .scene = j->s, .cst = j->cst, .ncst = j->ncst, .nc = j->nc, .col = j->col, .sets = sets,
          .ip = ip, .rp = rp, .rtol = j->rtol, .atol = atol };
  gs_derivatives *d = gs_derivatives_open (&columns, &missing);
  if (! d)
    printf ("not ok the run of %s opens: expected routine %s\n", j->s->name,
            missing ? missing : "(memory)");
  else if (j->info == 0)
    {
      gs_integration run = { .nx = nx, .x0 = j->x0, .nt = j->nt, .tout = j->tout, .iopt = iopt,
                     .ropt = ropt, .atol = atol, .ip = ip, .rp = rp,
                     .cst = gs_derivatives_constants (d), .xout = j->x, .ldx = MOST, .vout = v,
                     .ldv = j->s->nv + 1, .lw = gs_room (j->s, nx, 0) };
      run.w = zeros ((size_t)run.lw, sizeof *run.w);
      j->info = gs_integrate (gs_derivatives_scene (d), &run);
      j->calls = run.istat[GS_N_RHS];
      read_columns (j, d);
      free (run.w);
    }
  gs_derivatives_close (d);
  free (ip);
  free (rp);
  free (v);
  return NULL;
}

/* the run with its columns once more, by the steps that another one has taken: its last states with
   the derivatives of these very steps, into row 1 of j->x */
static void
run_along (job *j, const gs_kept_steps *kept)
{
  const int n = j->s->nx, nx = n * (1 + j->nc);
  const gs_plan plan = { .s = j->s, .nx = nx, .constants = j->inputs };
  int *ip = zeros ((size_t)gs_wholes (&plan), sizeof *ip), istat[GS_COUNTED] = { 0 };
  gs_real *rp = zeros ((size_t)gs_reals (&plan), sizeof *rp), ropt[3] = { 0, j->rtol, 0 },
          rstat[GS_MEASURED] = { 0 }, v[32], err, *x = j->x + MOST,
          *w = zeros ((size_t)nx * 13, sizeof *w),
          *of_inputs = zeros ((size_t)gs_room (j->s, nx, 0), sizeof *of_inputs);
  gs_real p[64] = { 0 }, atol[MOST], next[MOST];
  const char *missing = NULL;
  gs_lay (&plan, ip, rp);
  for (int i = 0; i < nx; i++)
    atol[i] = j->rtol;
  const gs_derivatives_given columns
      = { .scene = j->s, .cst = j->cst, .ncst = j->ncst, .nc = j->nc, .col = j->col, .ip = ip,
          .rp = rp, .rtol = j->rtol, .atol = atol };
  gs_derivatives *d = gs_derivatives_open (&columns, &missing);
  const gs_system g = { .s = gs_derivatives_scene (d), .nx = nx, .ropt = ropt, .atol = atol,
                        .ip = ip, .rp = rp, .cst = gs_derivatives_constants (d), .v = v,
                        .w = of_inputs, .p = p, .istat = istat, .rstat = rstat };
  memcpy (v, j->inputs, sizeof j->inputs);
  memcpy (x, j->x0, (size_t)nx * sizeof *x);
  for (int k = 0; k < kept->steps; k++)
    {
      const gs_real *one = kept->numbers + (4 + 13 * n) * k;
      if (gs_rates_at (&g, one[0], 1, x, w) != 0
          || gs_step_dp853 (&g, one[0], one[1], one[3] < 0 ? -1 : 1, one[2], x, next, &err, w) != 0)
        printf ("not ok step %d can be taken again\n", k);
      memcpy (x, next, (size_t)nx * sizeof *x);
    }
  gs_derivatives_close (d);
  free (ip);
  free (rp);
  free (w);
  free (of_inputs);
}

/* state i at output time r, its derivative by column k */
static gs_real
state_of (const job *j, int r, int i)
{
  return j->x[MOST * r + i];
}

static gs_real
column_of (const job *j, int r, int k, int i)
{
  return j->x[MOST * r + j->s->nx * (k + 1) + i];
}

/* ensemble.c: many runs for the module, their arguments one by one. */
#include <stdlib.h>

#include "host/ensemble/ensemble.h"

/* made of the table by render.py */
extern const gs_description gs_loop_description;
extern int gs_loop_pre (const double *par, double *cst);

/* ask of gs_integration: what Python has written ends all runs */
static int
ask (void *over, double t)
{
  (void)t;
  return *(const volatile int *)over;
}

/* n runs as gs_rows and gs_results have them. sizes: npar, ncst, those of ip and rp, n, how many
 * parameters differ, threads, 1 if starts must be on the constraints; table (n,varied), starts
 * (n,nx), inputs (n,nv) row by row, or null pointers; by, choice as gs_loop_run; over: not 0 ends
 * all runs with that info. info as gs_run_ensemble */
int
gs_loop_ensemble (const gs_scene *s, const int *sizes, int *over, double t0, const double *x0,
                  int nt, const double *tout, int nb, const double *tbrk, const int *iopt,
                  const double *ropt, const double *atol, int *ip, double *rp, const double *cst,
                  int lw, gs_implicit_method *by, const int *choice, const double *par,
                  const int *which, const double *table, const double *starts,
                  const double *inputs, const char *const *broken, gs_results *results)
{
  const gs_implicit o = { .order = choice[0], .index2 = choice[1], .followed = choice[2],
                          .follows = choice + 3 };
  const gs_ensemble e = {
    .scene = s, .about = &gs_loop_description, .pre = gs_loop_pre, .npar = sizes[0],
    .ncst = sizes[1], .wholes = (size_t)sizes[2], .reals = (size_t)sizes[3], .check = sizes[7],
    .method = by, .implicit = &o,
    .run = { .nx = s->nx, .t0 = t0, .x0 = x0, .nt = nt, .tout = tout, .nb = nb, .tbrk = tbrk,
             .iopt = iopt, .ropt = ropt, .atol = atol, .ip = ip, .rp = rp, .cst = cst,
             .ldx = s->nx, .ldv = s->nv > 1 ? s->nv : 1, .lw = lw, .ask = ask, .asked = over }
  };
  const gs_rows rows = {
    .n = sizes[4], .par = par, .varied = sizes[5], .which = which,
    .table = { table, sizes[5], 1 }, .starts = { starts, s->nx, 1 },
    .inputs = { inputs, s->nv, 1 }, .broken = broken
  };
  const int info = gs_run_ensemble (&e, &rows, sizes[6], gs_keep_member, results, NULL);
  return info != 0 || results->no_memory ? GS_OUT_OF_MEMORY : 0;
}

/* of the structure that Python fills as well */
int
gs_loop_results_size (void)
{
  return (int)sizeof (gs_results);
}

/* n texts of gs_results */
void
gs_loop_forget (char **said, int n)
{
  for (int i = 0; i < n; i++)
    free (said[i]);
}

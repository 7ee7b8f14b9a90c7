/* run_rows.c: many runs on threads, from the options of one. */
#include <stdlib.h>
#include <string.h>

#include "host/run/run_parts.h"
#include "host/ensemble/run_rows.h"

/* the parameters of all runs, of which the way of the loops may set one; a null pointer: no
 * memory */
static gs_real *
parameters (const gs_whole_run *w)
{
  const gs_description *d = w->d;
  gs_real *par = malloc ((size_t)(d->npar + 1) * sizeof *par);
  for (int k = 0; par && k < d->npar; k++)
    par[k] = (gs_real)w->s->par[k];
  if (par && d->loop_method >= 0)
    par[d->loop_method] = gs_wanted_loop_method (w);
  return par;
}

/* ... that of row k, in par (npar), cst (ncst), period (2*nctl) and seconds (2*nctl) */
static int
pending_of_row (const gs_description *d, const gs_rows *rows, int k, gs_real *par, gs_real *cst,
                gs_real *period, double *seconds)
{
  const int n = d->scene->nctl;
  for (int i = 0; i < rows->varied; i++)
    par[rows->which[i] - 1] = rows->table.x[k * rows->table.row + i * rows->table.column];
  if (d->pre (par, cst) != 0)
    return 0;
  d->scene->ctp (cst, period, period + n);
  for (int i = 0; i < 2 * n; i++)
    seconds[i] = (double)period[i];
  return gs_pending (n, seconds, seconds + n);
}

/* the most outputs of sampled devices that are on their way at a time in any row; given: the
 * parameters (npar) of all */
static int
most_pending (const gs_description *d, const double *given, const gs_rows *rows)
{
  const int n = d->scene->nctl;
  int most = 0;
  if (n == 0 || ! d->scene->ctp || ! d->pre || ! rows->table.x)
    return 0;
  gs_real *par = calloc ((size_t)(d->npar + d->ncst + 2 * n), sizeof *par);
  double *seconds = calloc (2 * (size_t)n, sizeof *seconds);
  for (int k = 0; par && k < d->npar; k++)
    par[k] = (gs_real)given[k];
  for (int k = 0; par && seconds && k < rows->n; k++)
    {
      if (rows->broken && rows->broken[k])
        continue;
      const int own = pending_of_row (d, rows, k, par, par + d->npar, par + d->npar + d->ncst,
                                      seconds);
      most = own > most ? own : most;
    }
  free (par);
  free (seconds);
  return most;
}

int
gs_take_rows (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
              const gs_run_inputs *in, const gs_rows *rows, int threads, gs_take_member *take,
              void *to, void (*progress) (void *asked, int done), gs_run_result *r)
{
  gs_whole_run w = { .d = d, .o = o, .s = s, .in = in, .r = r,
                     .pending = most_pending (d, s->par, rows) };
  if (in->kind == 3 && in->function)
    {
      memset (r, 0, sizeof *r);
      return gs_refuse (r, GS_REFUSED_OPTION, "input", "a function cannot run on several threads");
    }
  if (! gs_prepare_run (&w))
    {
      gs_real *par = parameters (&w);
      const gs_implicit implicit = gs_prepared_implicit (&w);
      const gs_ensemble e = {
        .scene = d->scene, .about = d, .pre = d->pre, .npar = d->npar, .ncst = d->ncst,
        .wholes = (size_t)gs_wholes (&w.plan), .reals = (size_t)gs_reals (&w.plan),
        .lanes = d->lanes, .fortran_inputs = d->fortran_inputs,
        .check = ! o->project, .method = w.by, .implicit = &implicit, .run = gs_prepared_run (&w)
      };
      gs_rows all = *rows;
      all.par = par;
      r->info = par ? gs_run_ensemble (&e, &all, threads, take, to, progress) : GS_OUT_OF_MEMORY;
      r->in_lanes = gs_ensemble_in_lanes (&e);
      free (par);
    }
  gs_forget_run (&w);
  return r->refused || r->info != GS_DONE;
}

int
gs_run_rows (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
             const gs_run_inputs *in, const gs_rows *rows, int threads, gs_results *results,
             void (*progress) (void *asked, int done), gs_run_result *r)
{
  const int failed = gs_take_rows (d, o, s, in, rows, threads, gs_keep_member, results, progress,
                                   r);
  if (results->no_memory)
    r->info = GS_OUT_OF_MEMORY;
  return failed || results->no_memory;
}

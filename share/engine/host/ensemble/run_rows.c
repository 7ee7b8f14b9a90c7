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

int
gs_run_rows (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
             const gs_run_inputs *in, const gs_rows *rows, int threads, gs_results *results,
             gs_run_result *r)
{
  gs_whole_run w = { .d = d, .o = o, .s = s, .in = in, .r = r };
  if (in->kind == 3)
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
        .check = ! o->project, .method = w.by, .implicit = &implicit, .run = gs_prepared_run (&w)
      };
      gs_rows all = *rows;
      all.par = par;
      r->info = par ? gs_run_ensemble (&e, &all, threads, gs_keep_member, results, NULL)
                    : GS_OUT_OF_MEMORY;
      if (results->no_memory)
        r->info = GS_OUT_OF_MEMORY;
      free (par);
    }
  gs_forget_run (&w);
  return r->refused || r->info != GS_DONE;
}

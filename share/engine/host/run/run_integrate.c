/* run_integrate.c: a prepared run as gs_integrate takes it, by its method; why it failed. */
#include <string.h>

#include "host/failure.h"
#include "host/run/run_parts.h"

gs_integration
gs_prepared_run (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  return (gs_integration){
    .nx = r->nx, .t0 = w->s->times[0], .x0 = w->x0, .nt = r->nt, .tout = w->s->times,
    .nb = w->nb, .tbrk = w->breaks, .iopt = w->iopt, .ropt = w->ropt, .atol = w->atol,
    .ip = r->ip, .rp = r->rp, .cst = r->cst, .xout = r->x, .ldx = r->nx, .vout = r->v,
    .ldv = r->ldv, .w = w->w, .lw = w->lw, .ask = w->o->ask, .asked = w->o->asked
  };
}

gs_implicit
gs_prepared_implicit (gs_whole_run *w)
{
  return (gs_implicit){
    .order = w->order, .index2 = w->index2, .resume = w->iopt[GS_METHOD] != 0,
    .columns = w->o->ncolumns,
    .followed = w->d->nfollowed, .follows = w->d->followed, .text = w->said,
    .length = sizeof w->said
  };
}

/* by gs_integrate, or by an implicit method: from the start, or where steps were found to be bound
 * by stability */
void
gs_integrate_by (gs_whole_run *w, const gs_scene *scene, gs_integration *run)
{
  gs_run_result *r = w->r;
  const gs_implicit more = gs_prepared_implicit (w);
  r->info = more.resume ? gs_integrate (scene, run) : GS_STIFF;
  if (r->info == GS_STIFF && w->by)
    r->info = w->by (scene, run, &more);
  memcpy (r->istat, run->istat, sizeof r->istat);
  memcpy (r->rstat, run->rstat, sizeof r->rstat);
}

void
gs_tell_failure (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  const int k = r->istat[GS_N_OUTPUTS];
  gs_failed_run failed = { .d = w->d, .info = r->info, .istat = r->istat, .said = w->said,
                           .t = (double)r->rstat[GS_T_REACHED], .cst = r->cst, .par = w->s->par };
  if (k < r->nt)
    {
      failed.x = r->x + (size_t)r->nx * (size_t)k;
      failed.v = r->v + (size_t)r->ldv * (size_t)k;
    }
  gs_failure (&failed, r->text, (int)sizeof r->text);
}

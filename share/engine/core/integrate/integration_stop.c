/* gs_integration_stop: at a stop of a run: the output, the samples and events that are due there,
 * and the next stop. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

static void
output (gs_course *c)
{
  gs_integration *r = c->run;
  gs_copy (r->nx, c->x, r->xout + (ptrdiff_t)r->ldx * c->it);
  gs_copy (c->g.s->nv, c->g.v, r->vout + (ptrdiff_t)r->ldv * c->it);
  c->it++;
  r->istat[GS_N_OUTPUTS] = c->it;
}

gs_real
gs_next_break (const gs_course *c)
{
  const gs_integration *r = c->run;
  gs_real t = c->ib < r->nb ? r->tbrk[c->ib] : GS_INFINITY;
  for (int k = 0; k < c->g.s->nsw; k++)
    if (c->switches[k] > c->t && c->switches[k] < t)
      t = c->switches[k];
  return t;
}

gs_real
gs_last_break (const gs_course *c)
{
  const gs_integration *r = c->run;
  gs_real t = c->ib > 0 ? r->tbrk[c->ib - 1] : r->t0;
  for (int k = 0; k < c->g.s->nsw; k++)
    if (c->switches[k] <= c->t && c->switches[k] > t)
      t = c->switches[k];
  return t;
}

/* the output time that is ts but for rounding, else ts */
static gs_real
output_at (const gs_course *c)
{
  const gs_integration *r = c->run;
  const gs_real fuzz = 8 * gs_epsilon () * gs_abs (c->ts);
  gs_real t = c->ts;
  for (int i = c->it; i < r->nt && r->tout[i] <= c->ts + fuzz; i++)
    if (r->tout[i] >= c->ts - fuzz)
      t = r->tout[i];
  return t;
}

/* tb, tend and side: method 4 stops at every output time */
static void
next_stop (gs_course *c)
{
  const gs_integration *r = c->run;
  const gs_real eps = gs_epsilon ();
  const int it = r->iopt[GS_METHOD] == 4 ? c->it : r->nt - 1;
  c->tb = r->tout[it];
  c->side = it == r->nt - 1 ? -1 : 1;
  const gs_real next = gs_next_break (c);
  if (next <= c->tb)
    c->side = -1;
  c->tb = gs_min (c->tb, next);
  if (c->ts <= c->tb + 8 * eps * gs_abs (c->tb))
    {
      c->side = -1;
      if (c->ts < c->tb - 8 * eps * gs_abs (c->tb))
        c->tb = output_at (c);
      c->tb = gs_min (c->tb, next);
    }
  c->tend = gs_min (gs_min (r->tout[r->nt - 1], c->ts), next);
  c->until = c->tb;
  c->strict = 0;
  const gs_real soon = gs_min (c->ts, next);
  if (r->iopt[GS_METHOD] == 8 && r->beyond > 0 && c->tb >= r->tout[r->nt - 1]
      && soon > c->tb + 8 * eps * gs_abs (c->tb))
    c->until = gs_min (c->tb + r->beyond, soon);
}

int
gs_integration_stop (gs_course *c, int *acted)
{
  const gs_system *g = &c->g;
  const gs_integration *r = c->run;
  int sampled;
  *acted = 0;
  if (c->it == r->nt - 1 && c->t >= r->tout[c->it])
    {
      if (gs_event_at_end (g->s, c->t, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat)
          != 0)
        return GS_ROUTINE_FAILED;
      if (gs_ended (g->ip))
        return GS_ENDED;
    }
  if (c->t >= r->tout[c->it])
    {
      output (c);
      if (c->it >= r->nt)
        return 0;
    }
  for (; c->ib < r->nb && r->tbrk[c->ib] <= c->t; c->ib++)
    *acted = 1;
  for (int k = 0; k < g->s->nsw; k++)
    *acted |= c->switches[k] >= c->t && c->switches[k] <= c->t;
  if (gs_samples_due (g->s, c->t, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat, &c->ts,
                      &sampled)
      != 0)
    return GS_ROUTINE_FAILED;
  *acted = gs_most (*acted, sampled);
  if (gs_resolve_under_inputs (g->s, c->t, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat,
                               -1)
      != 0)
    return GS_ROUTINE_FAILED;
  if (gs_ended (g->ip))
    return GS_ENDED;
  next_stop (c);
  return 0;
}

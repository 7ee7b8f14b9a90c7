/* gs_passage_end: a good step of gs_step_passage is taken: to its end or to the next break, sample
 * or end of the run, or up to an event, onto the constraints there; the outputs within it. */
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* are the speeds not those of a motion that leads out of the position where the run begins? */
static int
does_not_lead_out (gs_course *c)
{
  const gs_system *g = &c->g;
  gs_real gap;
  gs_passage_speed_gap (g, c->t, c->x, &c->a, c->f, c->xn, &gap);
  if (! (gap > GS_R2 (1e-6, 1e-3) + GS_R (1e2) * g->ropt[1]))
    return 0;
  g->istat[GS_FAILED_INFO] = 4 - gs_most (0, c->a.begin);
  g->istat[GS_FAILED] = GS_AT_START;
  return 1;
}

/* xn at tn could not be moved onto the constraints: a shorter step, or none */
static int
shorten (gs_passage *a)
{
  if (a->share > GS_R (0.15))
    {
      a->share = GS_R (0.25) * a->share;
      a->d = GS_R (0.25) * a->d;
      return 1;
    }
  a->not_before = a->tc + a->d;
  return 0;
}

/* the stop that tn is */
static void
set_stop (gs_course *c, gs_real tn, int stops)
{
  c->tb = tn;
  c->side = 1;
  if (stops == 1 && (gs_next_break (c) <= tn || c->ts <= tn))
    c->side = -1;
}

/* the step to tn is counted, and the position, if it was passed; t = tn */
static void
count (gs_course *c, gs_real tn)
{
  const gs_system *g = &c->g;
  gs_passage *a = &c->a;
  if (a->smin < GS_R (0.01) * g->p[GS_LARGEST] && a->tmin >= c->t && a->tmin <= tn
      && a->tmin > a->counted)
    {
      g->istat[GS_N_PASSED]++;
      if (g->istat[GS_N_PASSED] == 1)
        g->rstat[GS_T_PASSED] = a->tmin;
      g->rstat[GS_T_PASSED_LAST] = a->tmin;
      a->counted = a->tmin + GS_R (0.1) * a->d;
    }
  if (tn >= a->tc + a->d)
    a->not_before = a->tc + a->d;
  if (gs_max (a->err, a->eit) > 1)
    g->istat[GS_N_LOOSE]++;
  g->rstat[GS_H_LARGEST] = gs_max (g->rstat[GS_H_LARGEST], tn - c->t);
  c->t = tn;
  g->rstat[GS_T_REACHED] = tn;
  g->istat[GS_N_STEPS]++;
  g->istat[GS_FAILED_INFO] = 0;
  g->istat[GS_FAILED] = GS_AT_NOTHING;
}

int
gs_passage_end (gs_course *c, int *taken, int *again)
{
  const gs_system *g = &c->g;
  gs_passage *a = &c->a;
  *again = 0;
  if (a->begin != 0 && does_not_lead_out (c))
    return GS_ROUTINE_FAILED;
  gs_real tn = a->tc + a->d;
  int stops = 0, event;
  if (c->tend <= tn)
    {
      tn = c->tend;
      stops = 1;
    }
  if (tn <= c->t + GS_R (0.01) * a->d && stops == 0)
    {
      a->not_before = c->t + a->d;
      return 0;
    }
  if (gs_passage_event (c, &tn, &stops, &event) != 0)
    return GS_ROUTINE_FAILED;
  if (gs_passage_onto (c, tn) != 0)
    {
      *again = shorten (a);
      return 0;
    }
  a->begin = -gs_least (1, event);
  if (gs_passage_outputs (c, tn) != 0)
    return GS_ROUTINE_FAILED;
  set_stop (c, tn, stops);
  count (c, tn);
  *taken = 1;
  if (event > 0
      && gs_resolve_under_inputs (g->s, tn, c->xn, g->nx, g->ip, g->rp, g->cst, g->v, g->w,
                                  g->istat, event)
             != 0)
    return GS_ROUTINE_FAILED;
  return event > 0 && gs_ended (g->ip) ? GS_ENDED : 0;
}

int
gs_passage_event (gs_course *c, gs_real *tn, int *stops, int *event)
{
  const gs_system *g = &c->g;
  const gs_passage *a = &c->a;
  gs_real b[12], points[12], wt[12];
  *event = 0;
  gs_gauss_points (a->ns, points, wt);
  for (;;)
    {
      gs_gauss_weights (a->ns, points, wt, (c->t - a->tc) / a->d, (*tn - a->tc) / a->d, b);
      gs_passage_path (g->nx, a->ns, g->nx, c->x, a->d, b, c->f, c->xn);
      if (g->ip[GS_EVENTS] <= 0)
        return 0;
      gs_step e = { .method = 12, .t = c->t, .h = *tn - c->t, .tn = *tn,
                    .side = *stops == 1 ? -1 : 1, .x = c->x, .xn = c->xn, .f = c->f, .tc = a->tc,
                    .d = a->d, .ns = a->ns };
      int info = gs_first_event (g, &e, event);
      *tn = e.tn;
      if (info != 0)
        return info;
      if (*event != 0)
        *stops = 0;
      if (*event >= 0)
        return 0;
      *tn = c->t + GS_R (0.1) * e.h;
    }
}

int
gs_passage_onto (gs_course *c, gs_real tn)
{
  static const gs_real nojump[3] = { 0, 0, 0 };
  const gs_system *g = &c->g;
  int iopt[6];
  memcpy (iopt, g->iopt, sizeof iopt);
  g->p[GS_STEPS] = 0;
  if (tn < c->a.tc + GS_R (0.6) * c->a.d)
    {
      iopt[GS_LOOPS] = 1;
      g->p[GS_WAY] = 0;
    }
  int info = gs_check_constraints (g->s, tn, c->xn, iopt, nojump, g->cst, g->p, g->istat, g->rstat);
  g->p[GS_WAY] = c->job;
  g->p[GS_DEPENDENT] = -1;
  return info;
}

int
gs_passage_outputs (gs_course *c, gs_real tn)
{
  const gs_system *g = &c->g;
  const gs_integration *r = c->run;
  const gs_passage *a = &c->a;
  gs_real b[12], points[12], wt[12];
  gs_gauss_points (a->ns, points, wt);
  for (; r->tout[c->it] < tn; c->it++)
    {
      const gs_real t = r->tout[c->it];
      gs_real *x = r->xout + (ptrdiff_t)r->ldx * c->it, *v = r->vout + (ptrdiff_t)r->ldv * c->it;
      gs_gauss_weights (a->ns, points, wt, (c->t - a->tc) / a->d, (t - a->tc) / a->d, b);
      gs_passage_path (g->nx, a->ns, g->nx, c->x, a->d, b, c->f, x);
      int info = gs_inputs_of_run (g->s, t, 1, x, g->nx, g->ip, g->rp, g->cst, v, g->w);
      g->istat[GS_FAILED_INFO] = info;
      g->istat[GS_FAILED] = GS_AT_INPUTS;
      if (info != 0)
        return info;
      g->istat[GS_N_OUTPUTS] = c->it + 1;
    }
  return 0;
}

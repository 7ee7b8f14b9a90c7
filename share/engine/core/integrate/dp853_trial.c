/* gs_dp853_trial: one trial step of gs_step_dp853 within a run, onto the constraints and up to an
 * event in it; the outputs within it; the length of the next one. */
#include <stddef.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"
#include "gsmbp/plan.h"

/* of gs_dense_outputs: the polynomial is not as accurate as the step */
enum { INACCURATE = 90 };

/* is the least pivot far from 0? */
static int
is_far (const gs_real *p)
{
  return p[GS_PIVOT] >= GS_R (0.25) * p[GS_LARGEST];
}

/* the length of the step and its end: no short one is left before the stop, or before the time
 * where a step may end behind it */
static gs_step
lengthen (const gs_course *c, gs_real h)
{
  const int free = c->until > c->tb && c->strict == 0 && is_far (c->g.p);
  const gs_real tb = free ? c->until : c->tb;
  gs_step e = { .method = 8, .t = c->t, .h = h, .tn = c->t + h, .side = 1,
                .x = c->x, .xn = c->xn, .f = c->f, .wanted = free ? &c->tb : NULL };
  if (c->t + GS_R (1.01) * h >= tb)
    {
      e.h = tb - c->t;
      e.tn = tb;
      e.side = free ? -1 : c->side;
    }
  else if (c->t + 2 * h > tb)
    {
      e.h = GS_R (0.5) * (tb - c->t);
      e.tn = c->t + e.h;
    }
  return e;
}

/* the step e was good: the next one, statistics, the event in it. dense: the longest step with
 * outputs within it; 0: this one has none, the rates at its end are not known. info as
 * gs_integrate */
static int
accept (gs_course *c, const gs_step *e, gs_real err, int loose, int event, gs_real dense)
{
  const gs_system *g = &c->g;
  const gs_real h = e->h;
  gs_real fac = 6;
  if (err > 0)
    fac = gs_min (fac, GS_R (0.9) * gs_pow (err, -GS_R (0.125)));
  fac = gs_max (fac, GS_R (1.0) / 3);
  if (h >= GS_R (0.99) * c->next || h * fac > c->next)
    c->next = h * fac;
  /* two events and an output between them at one time but for rounding: the next step need not be
   * as short */
  if (dense > GS_R (1e3) * gs_epsilon () * gs_abs (e->tn)
      && (c->it >= c->run->nt || c->run->tout[c->it] < e->tn + c->next))
    c->next = gs_min (c->next, dense);
  c->t = e->tn;
  g->rstat[GS_H_LEAST] = gs_min (g->rstat[GS_H_LEAST], h);
  g->rstat[GS_H_LARGEST] = gs_max (g->rstat[GS_H_LARGEST], h);
  g->rstat[GS_T_REACHED] = c->t;
  g->rstat[GS_H_NEXT] = c->next;
  g->istat[GS_N_STEPS]++;
  g->istat[GS_FAILED_INFO] = 0;
  g->istat[GS_FAILED] = GS_AT_NOTHING;
  g->istat[GS_N_LOOSE] += loose;
  c->a.begin = -gs_least (1, event);
  c->fresh = dense > 0 && e->side > 0 && g->ip[GS_EVENTS] == 0 ? 2 : 1;
  const int moved = g->ip[GS_EVENTS] > 0 && event == 0
                    && gs_hold_after_step (g->s, g->iopt[GS_METHOD], e->tn, c->xn, g->nx, g->ip,
                                           g->rp, g->cst, g->v, g->ropt[1], g->atol);
  if (g->ip[GS_EVENTS] > 0 && e->side > 0 && event <= 0 && g->s->nlam == 0 && g->s->nq == g->s->nu
      && ! moved)
    {
      c->fresh = 2;   /* gs_first_event knows the rates where the step ends */
      gs_copy (g->nx, gs_planned_events (g->nx, g->ip, g->rp).xdn, c->f + g->nx);
    }
  c->after = 1;
  c->repeated = 0;
  c->near = GS_R (0.05);
  if (is_far (g->p))
    {
      c->far = c->next;
      if (g->p[GS_WAY] > c->job)
        {
          g->p[GS_WAY] = c->job;
          g->p[GS_DEPENDENT] = -1;
        }
    }
  if (event > 0)
    {
      c->after = 0;
      if (gs_resolve_under_inputs (g->s, c->t, c->xn, g->nx, g->ip, g->rp, g->cst, g->v, g->w,
                                   g->istat, event)
          != 0)
        return GS_ROUTINE_FAILED;
      if (gs_ended (g->ip))
        return GS_ENDED;
    }
  return 0;
}

/* ... was not: failed is what failed within it, or 0; dense as accept. info as gs_integrate */
static int
reject (gs_course *c, gs_real h, gs_real err, int failed, gs_real dense)
{
  const gs_system *g = &c->g;
  gs_real fac = GS_R (0.25);
  g->istat[GS_N_REJECTED]++;
  if (failed == 0 && err <= GS_HUGE)
    fac = gs_min (GS_R (0.9), gs_max (GS_R (0.2), GS_R (0.9) * gs_pow (err, -GS_R (0.125))));
  c->next = h * fac;
  if (! (err <= GS_HUGE && failed == 0) && failed != INACCURATE
      && c->next <= GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (c->t), gs_abs (c->tb)))
    return failed != 0 ? GS_ROUTINE_FAILED : GS_RATE_NOT_FINITE;
  if (failed == INACCURATE)
    c->next = dense;
  else if (failed != 0)
    g->p[GS_DEPENDENT] = -1;
  if (failed == 4 && g->istat[GS_FAILED] == GS_AT_PRJ)
    {
      c->next = GS_R (0.7) * h;
      c->repeated++;
    }
  c->near = GS_R (0.25);
  return 0;
}

int
gs_begin_trial (gs_course *c, gs_real htry, gs_step *e)
{
  const gs_system *g = &c->g;
  const int steps = g->istat[GS_N_STEPS] + g->istat[GS_N_REJECTED], most = g->iopt[GS_MOST_STEPS];
  *e = lengthen (c, htry);
  c->last = e->h;
  int info = gs_dp853_partition (c, e->h);
  if (info != 0)
    return info;
  if (most > 0 && steps >= most)
    return GS_TOO_MANY;
  if (e->h <= 16 * gs_epsilon () * gs_max (gs_abs (c->t), gs_abs (c->tb)) && e->tn < c->tb)
    return GS_TOO_SMALL;
  return c->slow > 20000 ? GS_TOO_SMALL : 0;
}

int
gs_end_trial (gs_course *c, gs_step *e, gs_real err, int failed, int *taken)
{
  const gs_system *g = &c->g;
  const gs_real strict = err;
  *taken = 0;
  if (g->iopt[GS_WATCH] == 1 && g->p[GS_PIVOT] < GS_R (0.25) * g->p[GS_LARGEST])
    err = err * g->ropt[1] / gs_max (g->ropt[1], c->loose);
  const int loose = strict > 1 && err <= 1;

  int event = 0;
  if (g->ip[GS_EVENTS] > 0 && failed == 0 && err <= 1)
    {
      e->rows = c->run->tout[c->it] < e->tn;
      failed = gs_first_event (g, e, &event);
      if (event < 0)
        err = e->off > 1 ? gs_min (GS_R (1e10), e->off) : GS_R (1e10);
      if (failed == 10 && g->istat[GS_FAILED] == GS_AT_EVENT)
        return GS_ROUTINE_FAILED;
      if (event == -2)
        {
          c->strict = 1;
          return 0;
        }
    }
  if (failed == 0 && err <= 1)
    failed = gs_dp853_after (c, e->tn);
  gs_real dense = 0;
  if (failed == 0 && err <= 1 && c->run->tout[c->it] < e->tn)
    {
      const gs_real h = event > 0 ? e->tn - c->t : e->h;
      gs_real off = -1;
      if (g->ip[GS_EVENTS] > 0 && event == 0)
        off = e->rows_off;
      failed = gs_dense_outputs (c, e->tn, e->side, h, &off);
      if (failed != 0 && failed != INACCURATE)
        g->p[GS_STEPS] = 0;
      dense = h
              * gs_max (GS_R (0.3), GS_R (0.9) * gs_pow (gs_max (off, GS_R (1e-8)), -GS_R (0.125)));
    }
  if (failed != 0 || ! (err <= 1))
    {
      c->strict |= e->tn > c->tb && failed != 0 && failed != INACCURATE;
      return reject (c, e->h, err, failed, dense);
    }
  *taken = 1;
  if (c->it >= c->run->nt)
    c->run->last = (gs_dense){ .t = c->t, .h = e->h, .x = c->x, .xn = c->xn, .f = c->f };
  return accept (c, e, err, loose, event, dense);
}

int
gs_dp853_trial (gs_course *c, gs_real htry, int *taken)
{
  gs_step e;
  *taken = 0;
  const int info = gs_begin_trial (c, htry, &e);
  if (info != 0)
    return info;
  gs_real err;
  const int failed = gs_step_dp853 (&c->g, c->t, e.tn, e.side, e.h, c->x, c->xn, &err, c->f);
  return gs_end_trial (c, &e, err, failed, taken);
}

/* The partition that the stages need, where the least pivot is below the share near of its largest
 * value by gs_complete_state, and how many steps were very short beside those far from singular
 * positions. */
int
gs_dp853_partition (gs_course *c, gs_real h)
{
  const gs_system *g = &c->g;
  gs_real *p = g->p;
  if (g->s->nlam > 0 && g->iopt[GS_WATCH] == 1 && g->iopt[GS_LOOPS] != 1 && p[GS_WAY] < 2
      && p[GS_PIVOT] < c->near * p[GS_LARGEST])
    {
      p[GS_WAY] = 2;
      p[GS_DEPENDENT] = -1;
    }
  if (p[GS_WAY] > 0 && p[GS_DEPENDENT] < 0)
    {
      g->istat[GS_N_PARTITIONS]++;
      if (gs_partition_choose_in_run (g->s, c->t, c->x, g->cst, p, g->istat) != 0)
        return GS_ROUTINE_FAILED;
    }
  c->slow++;
  if (g->iopt[GS_WATCH] != 1 || h > GS_R (1e-4) * c->far || is_far (p))
    c->slow = 0;
  return 0;
}

/* By no jump, nor, the first five times, to where the least pivot is below the share close of its
 * largest value. */
int
gs_dp853_after (gs_course *c, gs_real tn)
{
  const gs_system *g = &c->g;
  gs_real jump[3];
  gs_largest_move (g->s->nq, g->s->nu, c->x, c->xn, g->ropt[1], g->atol, jump);
  jump[2] = 0;
  if (g->iopt[GS_WATCH] == 1 && g->iopt[GS_LOOPS] != 1 && c->repeated < 5 && tn < c->tb)
    jump[2] = c->close;
  int info
      = gs_check_constraints (g->s, tn, c->xn, g->iopt, jump, g->cst, g->p, g->istat, g->rstat);
  if (info != 0)
    g->istat[GS_N_REPEATED]++;
  return info;
}

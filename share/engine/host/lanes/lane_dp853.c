/* Steps of Dormand and Prince of the runs in lanes. */
#include "host/lanes/lanes.h"

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"
#include "gsmbp/functions.h"

static void
swap_states (gs_course *c)
{
  gs_real *x = c->x;
  c->x = c->xn;
  c->xn = x;
}

/* of a run whose rates are completed from independent coordinates (gs_complete_state) */
static void
rates_by_itself (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  l->failed = gs_rates_at (&c->g, c->t, 1, c->x, c->f);
  gs_lane_state (g, lane);
  gs_put_lane (g->f, lane, c->f, g->nx);
}

/* the rates at the states where they are not yet known */
static void
find_rates (gs_lane_group *g)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      gs_lane_run *l = &g->run[k];
      if (! l->joined)
        {
          gs_join_lane (g, k);
          g->t[k] = l->busy ? l->c.t : g->e->run.t0;
        }
      const int wanted = l->joined ? (int)g->wants[k] : l->busy ? l->c.fresh : 0;
      l->alone = wanted == 1 && l->c.g.p[GS_WAY] > 0;
      l->steps = wanted == 1 && ! l->alone;
      l->failed = 0;
      l->e.side = 1;
      g->fresh[k] = l->steps;
      some |= l->steps;
    }
  gs_activate_lanes (g);
  if (some)
    gs_stage_rates (g, g->rates, g->t, g->x, 0);
  for (int k = 0; k < GS_LANES; k++)
    if (g->run[k].alone)
      rates_by_itself (g, k);
}

/* gs_dp853_before after its call of the right-hand side. info as gs_integrate */
static int
judge_rates (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  const int nx = g->nx;
  gs_get_lane (g->f, lane, c->f, nx);
  c->g.istat[GS_N_RHS] += g->calls[lane];
  if (l->failed)
    return GS_ROUTINE_FAILED;
  if (gs_not_finite (nx, c->f) != 0)
    return GS_RATE_NOT_FINITE;
  if (c->after == 1)
    {
      gs_get_lane (g->f + 11 * nx, lane, c->f + 11 * nx, nx);
      gs_get_lane (g->xs, lane, c->f + 12 * nx, nx);
      gs_watch_stiffness (&c->g, c->t, c->last, c->x, c->f);
      if (c->g.istat[GS_IS_STIFF] > 0 && g->method == 9)
        return GS_STIFF;
    }
  if (c->next <= 0
      && gs_first_step (&c->g, c->t, gs_min (c->hmax, c->tb - c->t), c->x, c->f, &c->next) != 0)
    return GS_ROUTINE_FAILED;
  return 0;
}

/* 0 where the run ended */
static int
rates_are_found (gs_lane_group *g, int lane)
{
  gs_course *c = &g->run[lane].c;
  if (c->fresh == 0)
    return 1;
  c->fresh = 0;
  const int info = judge_rates (g, lane);
  if (info != 0)
    gs_end_lane (g, lane, info);
  return info == 0;
}

/* a passage of a singular position, if one is next; ended: 1 if the run is at its end, whose info
 * it has then. info as gs_integrate */
static int
pass (gs_lane_group *g, gs_lane_run *l, gs_real *most, int *taken, int *ended)
{
  gs_course *c = &l->c;
  const int info = gs_take_passage (c, gs_min (c->next, c->hmax), most, taken);
  *ended = 0;
  if (*taken == 1)
    {
      c->fresh = 1;
      c->after = 0;
      swap_states (c);
      gs_lane_state (g, (int)(l - g->run));
      *ended = info == 0 && c->t >= c->tb && ! gs_lane_stopped (g, l);
    }
  else if (info == 0 && c->a.begin > 0)
    {
      c->g.istat[GS_FAILED_INFO] = 3;
      c->g.istat[GS_FAILED] = GS_AT_START;
      return GS_ROUTINE_FAILED;
    }
  return info;
}

/* whether a trial step in the lane is next, of the length that it then has */
static int
is_ready (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  gs_real most = GS_HUGE;
  int taken = 0, ended = 0, info = 0;
  if (g->nlam > 0)
    info = pass (g, l, &most, &taken, &ended);
  if (info == 0 && taken == 0)
    info = gs_begin_trial (c, gs_min (gs_min (c->next, c->hmax), most), &l->e);
  if (info != 0 || ended)
    gs_end_lane (g, lane, ended ? l->m.info : info);
  else if (taken == 0 && c->g.p[GS_WAY] > 0)
    l->alone = 1;
  else if (taken == 0)
    {
      g->step[lane] = l->e.h;
      return 1;
    }
  gs_park_lane (g, lane, 0);
  return 0;
}

/* which runs are ready for a step in lanes; 0: none */
static int
begin_steps (gs_lane_group *g)
{
  gs_take_rates (g, g->method == 9 ? 100 : 500);
  gs_part_slow (g);
  if (g->projects && g->e->run.iopt[GS_WATCH] == 1)
    gs_look_ahead (g);
  gs_begin_trials (g);
  gs_part_slow (g);
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      gs_lane_run *l = &g->run[k];
      l->steps = l->joined;
      l->alone = 0;
      if (! l->joined && l->busy && rates_are_found (g, k) && is_ready (g, k))
        {
          l->steps = 1;
          g->at[k] = l->e.side;
          g->t[k] = l->c.t;
          g->tn[k] = l->e.tn;
        }
      some |= l->steps;
    }
  return some;
}

static void
make_stages (gs_lane_group *g)
{
  gs_lane t;
  gs_activate_lanes (g);
  for (int stage = 1; stage < 12; stage++)
    {
      gs_stage_states (g, stage);
      for (int k = 0; k < GS_LANES; k++)
        t[k] = stage == 11 ? g->tn[k] : g->t[k] + g->at_time[stage] * g->step[k];
      gs_stage_rates (g, g->f + stage * g->nx, t, g->xs, stage == 11);
    }
}

/* gs_dp853_trial after the step of a run that has not joined */
static void
judge_step (gs_lane_group *g, int lane, double err)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  int taken;
  const int info = gs_end_trial (c, &l->e, err, l->failed, &taken);
  if (c->fresh == 2)   /* the rates at the end of the step are known */
    gs_put_lane (g->f, lane, c->f + g->nx, g->nx);
  if (taken == 1)
    swap_states (c);
  if (info != 0)
    gs_end_lane (g, lane, info);
  else if (taken == 1 && c->t >= c->tb)
    gs_lane_keeps_on (g, lane);
  else if (taken == 1)
    gs_lane_state (g, lane);
}

static void
after_step (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  gs_get_lane (g->xn, lane, c->xn, g->nx);
  c->g.istat[GS_N_RHS] += g->calls[lane];
  /* rows within the step and events in it need all stages */
  if (c->run->tout[c->it] < l->e.tn || c->g.ip[GS_EVENTS] > 0)
    {
      gs_get_lane (g->f, lane, c->f, 12 * g->nx);
      gs_get_lane (g->xs, lane, c->f + 12 * g->nx, g->nx);
    }
  judge_step (g, lane, l->failed ? 0 : g->err[lane]);
}

static void
judge_all (gs_lane_group *g)
{
  gs_judge_trials (g);
  gs_part_failed (g);
  if (g->events > 0)
    gs_look_for_events (g);
  if (g->projects)
    gs_project_lanes (g);
  gs_end_trials (g);
  if (g->events > 0)
    gs_remember_quiet (g);
  for (int k = 0; k < GS_LANES; k++)
    if (! g->run[k].joined)
      {
        if (g->run[k].steps)
          after_step (g, k);
      }
    else if (g->r[k] > 0.5 && g->r[k] < 1.5 && g->t[k] >= g->stop[k])
      {
        gs_part_lane (g, k);
        gs_lane_keeps_on (g, k);
      }
}

/* a step whose stages are completed from independent coordinates (gs_complete_state) */
static void
by_itself (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  gs_real err = 0;
  l->failed = gs_step_dp853 (&c->g, c->t, l->e.tn, l->e.side, l->e.h, c->x, c->xn, &err, c->f);
  gs_put_lane (g->f + 11 * g->nx, lane, c->f + 11 * g->nx, g->nx);
  gs_put_lane (g->xs, lane, c->f + 12 * g->nx, g->nx);
  judge_step (g, lane, err);
}

void
gs_lanes_step_dp853 (gs_lane_group *g)
{
  find_rates (g);
  if (begin_steps (g))
    {
      make_stages (g);
      gs_estimate_errors (g);
      judge_all (g);
    }
  for (int k = 0; k < GS_LANES; k++)
    if (g->run[k].alone)
      by_itself (g, k);
}

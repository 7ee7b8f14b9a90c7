/* Steps of Runge and Kutta of the runs in lanes. */
#include "host/lanes/lanes.h"

#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"

/* the next step of a run by itself; 0: the lane has no run */
static int
begin_alone (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  const int most = c->g.iopt[GS_MOST_STEPS];
  l->e = gs_begin_equal (c, &l->way);
  if (most > 0 && c->g.istat[GS_N_STEPS] >= most)
    {
      gs_end_lane (g, lane, GS_TOO_MANY);
      return l->busy && begin_alone (g, lane);
    }
  g->step[lane] = l->e.h;
  g->t[lane] = l->e.t;
  g->good[lane] = c->g.istat[GS_N_STEPS];
  g->look[lane] = gs_next_look (l);
  g->tn[lane] = l->e.tn;
  return 1;
}

/* the runs that have not joined */
static int
begin_others (gs_lane_group *g)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      gs_lane_run *l = &g->run[k];
      l->alone = ! l->joined && l->busy && begin_alone (g, k) && l->c.g.p[GS_WAY] > 0;
      l->steps = l->busy && ! l->alone;
      some |= l->steps;
      if (l->joined)
        continue;
      g->at[k] = l->e.side;
      if (l->busy && (l->alone || g->of_time))
        gs_watch_stiffness (&l->c.g, l->c.t, l->e.h, l->c.x, l->c.f);
    }
  return some;
}

static int
begin_steps (gs_lane_group *g)
{
  for (int k = 0; k < GS_LANES; k++)
    if (g->runs[k] <= 0)   /* a run that has joined and goes on has no error */
      {
        g->run[k].failed = 0;
        gs_join_lane (g, k);
        g->t[k] = g->run[k].joined ? g->t[k] : g->e->run.t0;
        g->together = 0;
      }
  gs_begin_equals (g);
  gs_part_slow (g);
  const int all = ! gs_some_below (g->runs, 1);
  if (g->together && all)
    return 1;
  g->together = all;   /* then as they are now until one parts */
  return begin_others (g);
}

/* gs_watch_stiffness before a step, for the runs where a look is due; the rates at their states are
   known */
static void
watch_steps (gs_lane_group *g)
{
  int due[GS_LANES], state[GS_LANES], some = 0;
  double rho[GS_LANES];
  for (int k = 0; k < GS_LANES; k++)
    {
      due[k] = g->good[k] >= g->look[k] && g->active[k];
      some |= due[k];
    }
  if (! some)
    return;
  gs_lane_eigenvalues (g, due, rho, state);
  for (int k = 0; k < GS_LANES; k++)
    if (due[k])
      {
        gs_integration *r = &g->run[k].m.run;
        const int good = (int)g->good[k];
        const double h = fabs (g->step[k]);
        r->istat[GS_NEXT_LOOK] = good + gs_least (1000, gs_most (10, 9 * gs_least (1000, good)));
        if (rho[k] * h > 2.78)
          {
            r->istat[GS_IS_STIFF] = 1;
            r->istat[GS_STIFF_STATE] = state[k];
            r->rstat[GS_T_STIFF] = g->t[k];
            r->rstat[GS_R_STIFF] = rho[k];
            r->rstat[GS_H_STIFF] = h;
          }
        g->look[k] = gs_next_look (&g->run[k]);
      }
}

static void
make_stages (gs_lane_group *g)
{
  gs_lane half;
  gs_lane *x = g->x;
  for (int k = 0; k < GS_LANES; k++)
    half[k] = g->t[k] + 0.5 * g->step[k];
  const double *const t[] = { g->t, half, half, g->tn };
  gs_activate_lanes (g);
  for (int stage = 0; stage < 4; stage++)
    {
      gs_stage_rates (g, g->f + stage * g->nx, t[stage], x, stage == 3);
      if (stage == 0)
        watch_steps (g);
      x = stage == 3 ? g->xn : g->xs;
      gs_stage_rk4 (g, stage, x);
    }
}

/* gs_run_rk4 after the step of a run that has not joined */
static void
after_step (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  int info = l->failed ? GS_ROUTINE_FAILED : gs_end_equal (c, &l->e, &l->way);
  if (info == 0 && l->way.k > l->way.n)
    {
      c->t = c->tb;
      if (! gs_lane_stopped (g, l))
        {
          gs_end_lane (g, lane, l->m.info);
          return;
        }
    }
  if (info != 0)
    gs_end_lane (g, lane, info);
  else
    gs_lane_state (g, lane);
}

static void
judge_all (gs_lane_group *g)
{
  gs_judge_equals (g);
  gs_part_failed (g);
  if (g->projects)
    gs_project_lanes (g);
  gs_end_equals (g);
  const int all = ! gs_some_below (g->runs, 1);
  int ended = 0;
  for (int k = 0; k < GS_LANES; k++)
    ended |= g->number[k] > g->count[k];
  for (int k = 0; (! all || ended) && k < GS_LANES; k++)
    {
      gs_lane_run *l = &g->run[k];
      if (! all && ! l->joined && l->steps)
        {
          gs_get_lane (g->xn, k, l->c.xn, g->nx);
          l->c.g.istat[GS_N_RHS] += g->calls[k];
          after_step (g, k);
        }
      else if (g->number[k] > g->count[k] && l->joined)
        {
          gs_part_lane (g, k);
          l->c.t = l->c.tb;
          gs_lane_keeps_on (g, k);
        }
    }
}

static void
by_itself (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  l->failed = gs_step_rk4 (&c->g, l->e.t, l->e.tn, l->e.side, l->e.h, c->x, c->xn, c->f);
  after_step (g, lane);
}

void
gs_lanes_step_rk4 (gs_lane_group *g)
{
  if (begin_steps (g))
    {
      make_stages (g);
      judge_all (g);
    }
  for (int k = 0; ! g->together && k < GS_LANES; k++)
    if (g->run[k].alone)
      by_itself (g, k);
}

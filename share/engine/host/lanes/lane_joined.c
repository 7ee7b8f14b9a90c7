/* Runs that join the others of a group, and part from them. */
#include "host/lanes/lanes.h"

#include "gsmbp/partition.h"

static void
join_dp853 (gs_lane_group *g, int lane)
{
  const gs_course *c = &g->run[lane].c;
  const int *n = c->g.istat;
  g->next[lane] = c->next;
  g->longest[lane] = c->hmax;
  g->due[lane] = c->run->tout[c->it];
  g->least[lane] = c->g.rstat[GS_H_LEAST];
  g->largest[lane] = c->g.rstat[GS_H_LARGEST];
  g->others[lane] = n[GS_N_REJECTED];
  g->bound[lane] = n[GS_SEEN_STIFF];
  g->unbound[lane] = n[GS_SEEN_FREE];
  g->wants[lane] = c->fresh;
  g->after[lane] = c->after;
  g->last[lane] = c->last;
  g->near[lane] = c->near;
  g->far[lane] = c->far;
  g->then[lane] = c->g.rstat[GS_H_NEXT];
  g->stiff[lane] = n[GS_IS_STIFF];
  if (c->g.ip[GS_EVENTS] > 0)
    gs_join_events (g, lane);
}

double
gs_next_look (const gs_lane_run *l)
{
  const int *istat = l->m.run.istat;
  return istat[GS_IS_STIFF] == 0 ? istat[GS_NEXT_LOOK] : 1e300;
}

static void
join_rk4 (gs_lane_group *g, int lane)
{
  const gs_lane_run *l = &g->run[lane];
  g->from[lane] = l->way.ta;
  g->equal[lane] = l->way.h;
  g->number[lane] = l->way.k;
  g->count[lane] = l->way.n;
  g->look[lane] = gs_next_look (l);
}

void
gs_join_lane (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  const gs_course *c = &l->c;
  l->joined = l->busy && c->g.p[GS_WAY] <= 0 && gs_lane_closes (g, l)
              && (g->method != 4 || c->g.ip[GS_EVENTS] == 0);
  g->runs[lane] = l->joined;
  if (! l->joined)
    return;
  const int most = c->g.iopt[GS_MOST_STEPS];
  g->t[lane] = c->t;
  g->stop[lane] = c->tb;
  g->side[lane] = c->side;
  g->allowed[lane] = most > 0 ? most : 1e300;
  g->called[lane] = c->g.istat[GS_N_RHS];
  g->good[lane] = c->g.istat[GS_N_STEPS];
  g->moved[lane] = 0;
  g->pivot[lane] = g->highest[lane] = 0;
  if (g->nlam > 0)
    gs_join_loops (g, lane);
  if (g->method == 4)
    join_rk4 (g, lane);
  else
    join_dp853 (g, lane);
}

static void
part_dp853 (gs_lane_group *g, int lane)
{
  gs_course *c = &g->run[lane].c;
  int *n = c->g.istat;
  c->next = g->next[lane];
  c->last = g->last[lane];
  c->near = g->near[lane];
  c->far = g->far[lane];
  c->g.rstat[GS_H_LEAST] = g->least[lane];
  c->g.rstat[GS_H_LARGEST] = g->largest[lane];
  c->g.rstat[GS_H_NEXT] = g->then[lane];
  c->fresh = (int)g->wants[lane];
  c->after = (int)g->after[lane];
  c->slow = 0;
  if (g->moved[lane] > 0)
    c->repeated = c->a.begin = 0;
  n[GS_N_REJECTED] = (int)g->others[lane];
  n[GS_SEEN_STIFF] = (int)g->bound[lane];
  n[GS_SEEN_FREE] = (int)g->unbound[lane];
  if (g->events > 0)
    gs_part_events (g, lane);
}

/* the trial step of a run that parts, as gs_dp853_trial and gs_run_rk4 know it */
static void
set_step (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  const double h = l->failed ? l->e.h : g->step[lane];   /* that of the step that has failed */
  l->e = (gs_step){ .method = g->method == 4 ? 4 : 8, .t = c->t, .h = h, .tn = g->tn[lane],
                    .side = (int)g->at[lane], .x = c->x, .xn = c->xn, .f = c->f };
}

void
gs_part_lane (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  gs_course *c = &l->c;
  int *istat = c->g.istat;
  if (! l->joined)
    return;
  l->joined = 0;
  g->runs[lane] = 0;
  gs_get_lane (g->x, lane, c->x, g->nx);
  c->t = g->t[lane];
  set_step (g, lane);
  istat[GS_N_RHS] = (int)g->called[lane];
  istat[GS_N_STEPS] = (int)g->good[lane];
  if (g->moved[lane] > 0)
    {
      c->g.rstat[GS_T_REACHED] = c->t;
      if (! l->failed)   /* else they say what has just failed */
        {
          istat[GS_FAILED_INFO] = 0;
          istat[GS_FAILED] = GS_AT_NOTHING;
        }
    }
  if (g->nlam > 0)
    gs_part_loops (g, lane);
  if (g->method == 4)
    {
      l->way.k = (int)g->number[lane];
      l->way.h = g->equal[lane];
    }
  else
    part_dp853 (g, lane);
}

void
gs_part_slow (gs_lane_group *g)
{
  if (! g->failed && ! gs_some_above (g->slow, 0))
    return;
  for (int k = 0; k < GS_LANES; k++)
    if (g->run[k].joined && (g->run[k].failed || g->slow[k] > 0))
      gs_part_lane (g, k);
}

/* By themselves they say why. */
void
gs_part_failed (gs_lane_group *g)
{
  if (! g->failed && ! gs_some_above (g->r, 2))
    return;
  for (int k = 0; k < GS_LANES; k++)
    if (g->run[k].joined && (g->run[k].failed || g->r[k] > 2))
      {
        gs_part_lane (g, k);
        g->r[k] = 0;
      }
}

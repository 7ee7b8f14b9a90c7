/* Equal steps of Runge and Kutta, all lanes at once. */
#include "host/lanes/lanes.h"

#include <math.h>

/* gs_begin_equal for all lanes: slow is 1 where there may be no other step. */
void
gs_begin_equals (gs_lane_group *g)
{
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const int runs = g->runs[l] > 0, last = g->number[l] >= g->count[l];
      const int over = g->good[l] >= g->allowed[l];
      const double h = g->equal[l], begin = g->from[l] + (g->number[l] - 1) * h;
      const double later = g->from[l] + g->number[l] * h, now = g->t[l];
      const double tn = last ? g->stop[l] : later, side = g->side[l];
      g->step[l] = runs ? h : 0;
      g->t[l] = runs ? begin : now;
      g->at[l] = last ? side : 1;
      g->tn[l] = runs ? tn : now;
      g->slow[l] = runs & over ? 1 : 0;
    }
}

/* r is 1 where steps are good, 3 where a number of xn may not be finite (their moduli add up to
 * more than 1e300), 0 where there were none. */
void
gs_judge_equals (gs_lane_group *g)
{
  gs_lane s = { 0 };
  for (int i = 0; i < g->nx; i++)
    {
      const double *xn = g->xn[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        s[l] += fabs (xn[l]);
    }
  for (int l = 0; l < GS_LANES; l++)
    g->r[l] = ! (s[l] <= 1e300) && g->runs[l] > 0 ? 3 : g->runs[l];
}

/* Where r is 1 x becomes xn. */
void
gs_end_equals (gs_lane_group *g)
{
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const int good = g->r[l] > 0.5 && g->r[l] < 1.5;
      g->t[l] = good ? g->tn[l] : g->t[l];
      g->number[l] = good ? g->number[l] + 1 : g->number[l];
      g->good[l] = good ? g->good[l] + 1 : g->good[l];
      g->called[l] = good ? g->called[l] + 4 : g->called[l];
      g->moved[l] = good ? 1 : g->moved[l];
    }
  gs_take_states (g);
}

/* The states xs after right-hand side stage (from 0): for the next one, or after the step. */
void
gs_stage_rk4 (gs_lane_group *g, int stage, gs_lane *xs)
{
  const int nx = g->nx;
  gs_lane h;
  for (int l = 0; l < GS_LANES; l++)
    h[l] = stage == 3 ? g->step[l] / 6 : stage == 2 ? g->step[l] : 0.5 * g->step[l];
  for (int i = 0; i < nx; i++)
    {
      const double *x = g->x[i], *f = g->f[i + stage * nx], *f1 = g->f[i], *f2 = g->f[i + nx],
                   *f3 = g->f[i + 2 * nx];
      double *to = xs[i];
      if (stage < 3)
        {
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            to[l] = x[l] + h[l] * f[l];
        }
      else
        {
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            to[l] = x[l] + h[l] * (f1[l] + 2 * f2[l] + 2 * f3[l] + f[l]);
        }
    }
}

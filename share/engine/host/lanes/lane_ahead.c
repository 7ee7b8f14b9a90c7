/* The look ahead of runs in lanes for singular positions: gs_take_passage where there is none. */
#include "host/lanes/lanes.h"

#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"

/* places on the way ahead, and about a state whose pivot is small already */
enum { AHEAD = 9, PLACES = 13 };

/* is a singular position so near that it may lie behind as well? */
static int
is_close (const gs_lane_group *g, int lane)
{
  return g->pivot[lane] < 0.3 * g->highest[lane];
}

/* how far those can see that look; 0: none */
static int
see_far (gs_lane_group *g, const double *h)
{
  const gs_integration *all = &g->e->run;
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      g->slow[k] = 0;
      some |= g->live[k] > 0;
      g->tau[k] = g->live[k] > 0 ? 0.01 * h[k] : 0;
    }
  if (! some)
    return 0;
  gs_know_jacobians (g);
  gs_positions_ahead (g);
  gs_lane_jacobians (g, g->stage_t, g->q, g->cst, g->hn);
  gs_lane_turns (g, g->hn, g->hc, gs_lane_sizes (g));
  for (int k = 0; k < GS_LANES; k++)
    if (g->live[k] > 0)
      {
        if (g->info[k] != 0 || ! (g->turned[k] <= 0.3))
          g->slow[k] = 1;
        g->turned[k] = 1.2 * g->tau[k] / gs_max (g->turned[k], 1e-10);
      }
  for (int k = 0; k < GS_LANES; k++)
    if (g->live[k] > 0 && g->slow[k] <= 0)
      {
        const double rest = 2 * (all->tout[all->nt - 1] - g->t[k]);   /* as gs_passage_ahead */
        g->turn[k] = g->turned[k];
        g->limit[k] = gs_min (h[k], g->turned[k]);
        g->way[k] = is_close (g, k) ? g->turned[k] : gs_min (g->turned[k], rest);
        if (g->way[k] < 0.1 * g->turned[k])
          g->live[k] = 0;
      }
    else
      g->live[k] = 0;
  return 1;
}

/* the place on the way of the i-th look (from 0) of a lane, as a share of it */
static double
share_of (int close, int i)
{
  return close ? -0.6 + 1.6 / 12 * i : 0.125 * (i + 1);
}

/* the pivots along the ways ahead, after that at the state */
static void
find_pivots (gs_lane_group *g, gs_lane *pivot)
{
  int last = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      pivot[0][k] = g->pivot[k];
      last = gs_most (last, g->live[k] <= 0 ? 0 : is_close (g, k) ? PLACES : AHEAD);
    }
  for (int i = 0; i < last; i++)
    {
      for (int k = 0; k < GS_LANES; k++)
        g->tau[k] = g->live[k] > 0 ? share_of (is_close (g, k), i) * g->way[k] : 0;
      gs_positions_ahead (g);
      gs_lane_jacobians (g, g->stage_t, g->q, g->cst, g->hn);
      gs_lane_pivots (g, g->hn, gs_lane_sizes (g));
      for (int k = 0; k < GS_LANES; k++)
        pivot[i + 1][k] = g->info[k] != 0 || g->rank[k] < g->p[GS_RANK][k] ? 0 : g->lowest[k];
    }
}

/* the places of the next level of a search, at[k] on the way of one run, in all lanes */
static void
spread (gs_lane_group *g, int lane, double middle, double width, double *at)
{
  const int n = g->nq;
  for (int k = 0; k < GS_LANES; k++)
    {
      at[k] = middle + gs_least (k - 6, 6) * width;
      const double tau = at[k] * g->way[lane];
      g->stage_t[k] = g->t[lane] + tau;
      for (int j = 0; j < n; j++)
        g->q[j][k] = g->x[j][lane] + tau * (g->f[j][lane] + 0.5 * tau * g->f[n + j][lane]);
    }
}

/* the least pivot along the way of one run, as gs_passage_least_pivot finds it, by the lanes of
   all, at its place */
static double
search (gs_lane_group *g, int lane, double from, double to, double *at)
{
  double least = 1e300, width = (to - from) / 12, place[GS_LANES];
  *at = 0.5 * (from + to);
  for (int j = 0; j < g->e->ncst; j++)
    for (int k = 0; k < GS_LANES; k++)
      g->one_cst[j][k] = g->cst[j][lane];
  for (int j = 0; j < g->nlam; j++)
    for (int k = 0; k < GS_LANES; k++)
      g->rate[j][k] = gs_lane_sizes (g)[j][lane];
  for (int level = 0; level < 4; level++, width *= 0.2)
    {
      spread (g, lane, *at, width, place);
      gs_lane_jacobians (g, g->stage_t, g->q, g->one_cst, g->hn);
      gs_lane_pivots (g, g->hn, g->rate);
      for (int k = 0; k < PLACES; k++)
        {
          const double pivot = g->rank[k] < g->p[GS_RANK][lane] ? 0 : g->lowest[k];
          if (g->info[k] == 0 && pivot < least && place[k] >= from - 0.1 * width
              && place[k] <= to + 0.1 * width)
            {
              least = pivot;
              *at = place[k];
            }
        }
    }
  return least;
}

/* is there a passage to be tried? If not yet, no step leads into it. */
static int
is_passage (gs_lane_group *g, int lane, double from, double to)
{
  double at;
  const double least = search (g, lane, from, to, &at), turn = g->turned[lane], t = g->t[lane];
  if (least > 0.2 * g->highest[lane])
    return 0;
  const double middle = t + at * g->way[lane], d = 0.8 * turn, full = g->run[lane].c.a.share * d;
  if (t > middle + 0.5 * d)
    return 0;
  if (t >= middle - 1.05 * full)
    return 1;
  g->limit[lane] = gs_min (g->limit[lane], middle - full - t);
  return 0;
}

/* Between three places of which the middle one is the least the pivot is no less than a line twice
 * as steep as they are has it. */
static void
look_between (gs_lane_group *g, int lane, gs_lane *pivot)
{
  const int close = is_close (g, lane), begin = close ? 1 : 0, n = close ? PLACES : AHEAD;
  for (int i = begin; i <= n; i++)
    {
      const int first = i == begin;
      if (! close && (first || i == n))
        continue;
      const double at = pivot[i][lane];
      const double before = first ? pivot[i + 1][lane] : pivot[i - 1][lane];
      const double after = i == n ? pivot[i - 1][lane] : pivot[i + 1][lane];
      if (at > before || at > after)
        continue;
      const double share = close ? 0.2 : 0.25;
      if (! (3 * at - 2 * gs_max (before, after) > share * g->highest[lane]))
        {
          g->slow[lane] = close ? is_passage (g, lane, -0.6, 1)
                                : is_passage (g, lane, 0.125 * (i - 1), 0.125 * (i + 1));
          return;
        }
      if (! close)
        return;
    }
}

void
gs_look_ahead (gs_lane_group *g)
{
  gs_lane h, pivot[PLACES + 2];
  for (int k = 0; k < GS_LANES; k++)
    {
      g->fresh[k] = g->runs[k] > 0 && g->wants[k] <= 0;
      h[k] = gs_min (g->next[k], g->longest[k]);
      g->limit[k] = 1e300;
    }
  gs_want_look (g);
  if (see_far (g, h))
    {
      find_pivots (g, pivot);
      for (int k = 0; k < GS_LANES; k++)
        if (g->live[k] > 0)
          look_between (g, k, pivot);
    }
  gs_part_slow (g);
}

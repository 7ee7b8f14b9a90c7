/* Where a singular position may be ahead, and the pivots of Jacobians, all lanes at once. */
#include "host/lanes/lanes.h"

#include <math.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"

/* gs_passage_watch: live is 1 where it would look ahead, of the lanes that are fresh. */
void
gs_want_look (gs_lane_group *g)
{
  const double *then_t = g->p[GS_TIMES + 2], *then = g->p[GS_TIMES + 3],
               *now_t = g->p[GS_TIMES + 4], *now = g->p[GS_TIMES + 5];
  for (int l = 0; l < GS_LANES; l++)
    {
      const double h = gs_min (g->next[l], g->longest[l]);
      const int near = g->p[GS_STEPS][l] < 3 || h > 0.25 * g->turn[l]
                       || g->p[GS_PIVOT][l] < 0.25 * g->p[GS_LARGEST][l];
      const int falls = now[l] < then[l]
                        && now[l] * (now_t[l] - then_t[l])
                             < gs_max (3 * h, g->turn[l]) * (then[l] - now[l]);
      g->live[l] = (near || falls) && ! (g->t[l] < g->past[l]) && g->fresh[l] > 0;
    }
}

/* Positions q at stage_t = t + tau, by rates that are linear in time (gs_passage_linear). */
void
gs_positions_ahead (gs_lane_group *g)
{
  const int n = g->nq;
  const double *tau = g->tau;
  for (int l = 0; l < GS_LANES; l++)
    g->stage_t[l] = g->t[l] + tau[l];
  for (int i = 0; i < n; i++)
    {
      const double *x = g->x[i], *f = g->f[i], *fu = g->f[n + i];
      double *q = g->q[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        q[l] = x[l] + tau[l] * (f[l] + 0.5 * tau[l] * fu[l]);
    }
}

/* what gs_lane_pivots remembers */
typedef struct
{
  gs_lane most, column;   /* the largest column that is left, its number from 1 */
  gs_lane first, last;    /* the first one, the last one of the rank */
  gs_lane ranked;         /* 1 as long as columns are independent */
  gs_lane one;            /* one over the length of the column that is taken */
} columns;

/* s = the sum of the products of two arrays of m rows of lanes, step rows apart in the second */
static void
product (int m, gs_lane *a, gs_lane *b, double *s)
{
  for (int l = 0; l < GS_LANES; l++)
    s[l] = 0;
  for (int i = 0; i < m; i++)
    {
      const double *x = a[i], *y = b[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        s[l] += x[l] * y[l];
    }
}

/* y: the rows of hc divided by the lengths that they have had so far, g->lengths */
static void
scale (gs_lane_group *g, gs_lane *hc, gs_lane *size)
{
  const int n = g->nq, m = g->nlam;
  gs_lane most = { 0 }, by;
  for (int i = 0; i < m; i++)
    {
      gs_lane s = { 0 };
      for (int j = 0; j < n; j++)
        {
          const double *h = hc[i + m * j];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            s[l] += h[l] * h[l];
        }
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          g->lengths[i][l] = gs_max (size[i][l], sqrt (s[l]));
          most[l] = gs_max (most[l], g->lengths[i][l]);
        }
    }
  for (int i = 0; i < m; i++)
    {
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double s = most[l] > 0 ? most[l] : 1;
          g->lengths[i][l] = gs_max (g->lengths[i][l], 1e-6 * s);
          by[l] = 1 / g->lengths[i][l];
        }
      for (int j = 0; j < n; j++)
        {
          const double *h = hc[i + m * j];
          double *y = g->y[i + m * j];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            y[l] = h[l] * by[l];
        }
    }
}

/* the largest column that is left, as gs_qr_columns takes them: a lane picks its own by numbers */
static void
pick (gs_lane_group *g, columns *c, int first)
{
  const int n = g->nq, m = g->nlam;
  for (int l = 0; l < GS_LANES; l++)
    {
      c->most[l] = -1;
      c->column[l] = 0;
    }
  for (int j = 0; j < n; j++)
    {
      const double number = j + 1;
      gs_lane s;
      product (m, g->y + m * j, g->y + m * j, s);
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double most = c->most[l], column = c->column[l], now = s[l];
          const int larger = now > most * (1 + 1e-8);
          c->column[l] = larger ? number : column;
          c->most[l] = larger ? now : most;
        }
    }
  if (first)
    memcpy (c->first, c->most, sizeof (gs_lane));
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double most = c->most[l], last = c->last[l], so_far = c->ranked[l];
      const double ranked = most > 1e-14 * c->first[l] ? so_far : 0;
      const double length = ranked > 0 ? most : 1e300;
      c->ranked[l] = ranked;
      g->rank[l] += ranked;
      c->last[l] = ranked > 0 ? most : last;
      c->one[l] = 1 / sqrt (length);
    }
}

/* the column of every lane, of the length 1, out of all (modified Gram and Schmidt) */
static void
take_out (gs_lane_group *g, const columns *c)
{
  const int n = g->nq, m = g->nlam;
  for (int i = 0; i < m; i++)
    {
      double *w = g->work[i];
      for (int l = 0; l < GS_LANES; l++)
        w[l] = 0;
      for (int j = 0; j < n; j++)
        {
          const double *y = g->y[i + m * j], number = j + 1;
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            {
              const double here = y[l] * c->one[l];
              w[l] = fabs (c->column[l] - number) < 0.5 ? here : w[l];
            }
        }
    }
  for (int j = 0; j < n; j++)
    {
      gs_lane s;
      product (m, g->work, g->y + m * j, s);
      for (int i = 0; i < m; i++)
        {
          const double *w = g->work[i];
          double *y = g->y[i + m * j];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            y[l] -= s[l] * w[l];
        }
    }
}

/* gs_constraint_pivots: rank and lowest pivot of the Jacobians hc, whose rows have had the lengths
 * size so far; g->lengths becomes these with the rows of hc. */
void
gs_lane_pivots (gs_lane_group *g, gs_lane *hc, gs_lane *size)
{
  const int all = gs_least (g->nlam, g->nq);
  columns c;
  for (int l = 0; l < GS_LANES; l++)
    {
      g->rank[l] = 0;
      c.first[l] = 1;
      c.last[l] = 0;
      c.ranked[l] = 1;
    }
  scale (g, hc, size);
  for (int k = 0; k < all; k++)
    {
      pick (g, &c, k == 0);
      if (k < all - 1)
        take_out (g, &c);
    }
  for (int l = 0; l < GS_LANES; l++)
    g->lowest[l] = sqrt (c.last[l] / (c.first[l] > 0 ? c.first[l] : 1));
}

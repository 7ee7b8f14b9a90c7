/* Where gs_events_quiet looks for events within a step of gs_step_dp853, all lanes at once. Points
 * are 1 to 8, where the step ends. */
#include "host/lanes/lanes.h"

#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"

/* The states z at point j of the steps and their times stage_t: of degree 3 on the cubic polynomial
 * through both ends (gs_event_cubic), of degree 5 on that of gs_event_quintic. */
void
gs_event_states (gs_lane_group *g, int j, int degree)
{
  const int nx = g->nx;
  const double b = gs_event_point (j, 8), p = b * b * (3 - 2 * b), e = b * (1 - b), *h = g->step;
  const double more = degree == 5 ? e * e : 0;
  gs_lane q, r;
  for (int l = 0; l < GS_LANES; l++)
    {
      const double t = g->t[l] + b * h[l];
      g->stage_t[l] = j == 8 && g->at[l] < 0 ? gs_time_beside (t, -1) : t;
      q[l] = h[l] * b * (1 - b) * (1 - b);
      r[l] = h[l] * b * b * (b - 1);
    }
  for (int i = 0; i < nx; i++)
    {
      const double *x = g->x[i], *xn = g->xn[i], *fn = g->fn[i], *f1 = g->f[i],
                   *f7 = g->f[i + 6 * nx], *f10 = g->f[i + 9 * nx];
      double *z = g->z[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double s = (xn[l] - x[l]) / gs_max (h[l], 1e-300);
          const double c = (f10[l] - 1.44 * s + 0.32 * f1[l] + 0.12 * fn[l]) / (-0.096);
          const double d = (f7[l] - 1.125 * s - 0.1875 * f1[l] + 0.3125 * fn[l] - 0.1875 * c)
                           / 8.203125e-2;
          const double within = x[l] + p * (xn[l] - x[l]) + q[l] * f1[l] + r[l] * fn[l]
                                + h[l] * more * (c + d * b);
          z[l] = j < 8 ? within : xn[l];
        }
    }
}

/* what a point tells of its neighbours */
typedef struct
{
  double a, c;      /* its distance from the last point, and that one's from the one before */
  double d;         /* half of the share of the error in the middle (gs_event_cubic_error) */
  int first;        /* 1 for the first point */
  int third;        /* 1 from the third one on */
} point;

static point
point_of (int j)
{
  const double b = gs_event_point (j, 8), before = j > 1 ? gs_event_point (j - 1, 8) : 0;
  point p
      = { .a = b - before, .c = 1, .d = gs_event_cubic_error (b), .first = j == 1, .third = j > 2 };
  if (j > 1)
    p.d = gs_max (p.d, gs_event_cubic_error (before));
  if (j > 2)
    {
      p.d = gs_max (p.d, gs_event_cubic_error (gs_event_point (j - 2, 8)));
      p.c = before - gs_event_point (j - 2, 8);
    }
  else if (j > 1)
    p.c = before;
  p.d = 0.5 / p.d;
  return p;
}

/* the least of three, the largest of three */
static inline double
least_of (double a, double b, double c)
{
  return gs_min (gs_min (a, b), c);
}

static inline double
largest_of (double a, double b, double c)
{
  return gs_max (gs_max (a, b), c);
}

/* event function i at the first point */
static void
look_first (gs_lane_group *g, const point *p, int i)
{
  const double *now = g->g[i], *mark = g->mark[i];
  for (int l = 0; l < GS_LANES; l++)
    {
      const double quiet = p->d * now[l] * (2 * mark[l] - 1);
      g->older[i][l] = g->g0[i][l];
      g->old[i][l] = now[l];
      g->quiet[i][l] = fabs (now[l]) <= 1e100 ? quiet : -1e300;
    }
}

/* at a later one */
static void
look_again (gs_lane_group *g, const point *p, int i)
{
  const double w = p->a + p->c, start = p->third ? 1e300 : 0, fast = p->third ? p->a * w : 0;
  const double a = p->a, c = p->c, d = p->d;
  const double *now = g->g[i], *mark = g->mark[i], *noise = g->noise[i];
  double *old = g->old[i], *older = g->older[i], *bend = g->bend[i], *quiet = g->quiet[i];
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double v = 2 * mark[l] - 1, ga = v * older[l], gc = v * old[l], gb = v * now[l];
      const double q = (gc - ga) / c, s = (gb - gc) / a, curve = (s - q) / w;
      const double off = fabs (curve - bend[l]) * fast;
      const double near = least_of (fabs (ga), fabs (gc), fabs (gb));
      const double turn = copysign (1, q) * curve, size = fabs (curve);
      double lowest = gs_min (gb, gc);
      lowest = start > q - 2 * c * size ? gs_min (lowest, ga) : lowest;
      const double bow = 0.125 * w * w * size * (gs_min (-q, s) > 0 ? 4 : 1);
      double least = d * (lowest - bow);
      const int too_fast = 2 * off > largest_of (ga, gc, gb) - least_of (ga, gc, gb)
                           && off > noise[l] && near < 2 * off && turn < 0;
      least = fabs (now[l]) <= 1e100 && ! too_fast ? least : -1e300;
      bend[l] = curve;
      quiet[l] = gs_min (quiet[l], least);
      older[l] = old[l];
      old[l] = now[l];
    }
}

/* What gs_events_quiet sees at point j: mark is 1 where a function has been above 0 since its last
 * event, noise its rounding errors (gs_event_too_fast), bend its second divided difference; quiet
 * becomes how far the polynomials may be apart for the step to be quiet; loud 1 where a function is
 * not known. */
void
gs_look_at_events (gs_lane_group *g, int j)
{
  const point p = point_of (j);
  for (int l = 0; l < GS_LANES; l++)
    g->loud[l] = g->info[l] != 0 ? 1 : g->loud[l];
  for (int i = 0; i < g->events; i++)
    if (p.first)
      look_first (g, &p, i);
    else
      look_again (g, &p, i);
}

/* How far the polynomials are apart at point j, the largest so far, as in the middle of the step;
 * 4 is the first one. */
void
gs_events_apart (gs_lane_group *g, int j)
{
  const double d = gs_event_cubic_error (gs_event_point (j, 8));
  for (int i = 0; i < g->events; i++)
    for (int l = 0; l < GS_LANES; l++)
      {
        const double here = fabs (g->g[i][l] - g->old[i][l]) / d;
        g->apart[i][l] = gs_max (j == 4 ? 0 : g->apart[i][l], here);
      }
}

/* At the end of a step: loud is 1 where it is not quiet, as gs_events_quiet says. */
void
gs_judge_events (gs_lane_group *g)
{
  for (int i = 0; i < g->events; i++)
    for (int l = 0; l < GS_LANES; l++)
      {
        const int above = g->mark[i][l] > 0;
        const double quiet = g->quiet[i][l], apart = g->apart[i][l];
        const double needs = g->tn[l] >= g->until[i][l] ? 1 : g->needs[i][l];
        double loud = above ? g->loud[l] : gs_max (g->loud[l], needs);
        loud = quiet > apart || (! above && quiet >= apart) ? loud : 1;
        g->loud[l] = loud;
      }
}

/* gs_events_quiet: whether a step of gs_step_dp853 is quiet: no event function comes close to 0 in
 * it, beside what a polynomial through its stages may hide; else gs_event_polynomial, its
 * polynomial of order 7.
 *
 * Eight points of the polynomial of gs_event_quintic. What it is away from the cubic one of
 * gs_event_cubic, in two of them, is twice and more what it may be off; to this comes what
 * functions may fall by between points, from their second differences. A function of the user that
 * has just had its event, or one of a port that is not above 0, is not quiet. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/integrate.h"

static gs_events
plan (const gs_system *g)
{
  return gs_events_of (g->nx, g->ip + g->ip[GS_EVENTS] - 1, g->rp + g->ip[GS_EVENTS + 1] - 1);
}

/* the error of a cubic polynomial through both ends of a step, at the fraction b of it, beside that
 * in its middle */
gs_real
gs_event_cubic_error (gs_real b)
{
  b *= 1 - b;
  return 16 * (b * b);
}

/* It does not go on ever faster, as a power does from 0, and the parabola through the three points
 * before misses the last one by more than half of what they are apart, and of what the function
 * is. */
int
gs_event_too_fast (const gs_events *p, int i, int j, gs_real older, gs_real before, gs_real now,
                   gs_real c, gs_real a)
{
  gs_real *told = gs_told (p, i), *bend = told + GS_TOLD_BEND;
  const gs_real curve = ((now - before) / a - (before - older) / c) / (a + c),
               off = gs_abs (curve - *bend) * (a * (a + c)),
               low = gs_min (gs_min (older, before), now),
               high = gs_max (gs_max (older, before), now),
               least = gs_min (gs_min (gs_abs (older), gs_abs (before)), gs_abs (now));
  *bend = curve;
  return j > 2 && gs_copysign (1, before - older) * curve < 0
         && 2 * off > high - low && least < 2 * off
         && off > gs_max (told[GS_TOLD_RISEN], told[GS_TOLD_NOISE]);
}

/* what function i is at least around the last point, the j-th, and between the two before it, a
 * and c apart */
static gs_real
least (const gs_events *p, int i, int j, gs_real c, gs_real a)
{
  const gs_real sign = p->mark[i] == 0 ? -1 : 1, older = sign * p->before[i],
               before = sign * p->last[i], now = sign * p->now[i];
  gs_real low = now;
  if (j == 1)
    return low;
  const gs_real old = (before - older) / c, slope = (now - before) / a, s = a + c;
  gs_real curve = (slope - old) / s;
  /* where it rises from its beginning that does not count */
  if (j > 2 || ! (old > 2 * c * gs_abs (curve)))
    low = gs_min (low, older);
  low = gs_min (low, before);
  curve = GS_R (0.125) * (s * s) * gs_abs (curve);
  if (old < 0 && slope > 0)
    curve *= 4;
  return low - curve;
}

/* how far the polynomials of gs_event_quintic and gs_event_cubic are apart, into the plan's
   older */
static int
apart (const gs_system *g, gs_step *e, const gs_events *p)
{
  int info = 0;
  for (int i = 0; i < p->ne; i++)
    p->older[i] = 0;
  for (int j = 4; j <= 6; j += 2)
    {
      const gs_real b = gs_event_point (j, 8);
      e->method = 3;
      if ((info = gs_events_at_fraction (g, e, b, 1)) != 0)
        break;
      gs_copy (p->ne, p->now, p->last);
      e->method = 5;
      if ((info = gs_events_at_fraction (g, e, b, 1)) != 0)
        break;
      for (int i = 0; i < p->ne; i++)
        p->older[i]
            = gs_max (p->older[i], gs_abs (p->now[i] - p->last[i]) / gs_event_cubic_error (b));
    }
  return info;
}

/* the points of gs_events_quiet; 0: a function comes close to 0 in them */
static int
clear (const gs_system *g, const gs_step *e, const gs_events *p, int *info)
{
  gs_real c = 1, d;
  gs_copy (p->ne, p->g, p->last);
  gs_copy (p->ne, p->g, p->before);
  for (int j = 1; j <= 8; j++)
    {
      const gs_real b = gs_event_point (j, 8), a = j > 1 ? b - gs_event_point (j - 1, 8) : b;
      if ((*info = gs_events_at_fraction (g, e, b, j == 8 ? e->side : 1)) != 0)
        return 0;
      d = gs_event_cubic_error (b);
      if (j > 1)
        d = gs_max (d, gs_event_cubic_error (b - a));
      if (j > 2)
        d = gs_max (d, gs_event_cubic_error (b - a - c));
      for (int i = 0; i < p->ne; i++)
        {
          const gs_real sign = p->mark[i] == 0 ? -1 : 1;
          if (j > 1 && gs_is_own (p, i)
              && gs_event_too_fast (p, i, j, sign * p->before[i], sign * p->last[i],
                                    sign * p->now[i], c, a))
            return 0;
          const gs_real away = least (p, i, j, c, a), may = 2 * d * p->older[i];
          if (! (away > may || (away >= may && p->mark[i] == 0)))
            return 0;
          p->before[i] = p->last[i];
          p->last[i] = p->now[i];
        }
      c = a;
    }
  return 1;
}

int
gs_events_quiet (const gs_system *g, gs_step *e, int *quiet)
{
  const gs_events p = plan (g);
  const int method = e->method;
  *quiet = 0;
  for (int i = 0; i < p.ne; i++)
    {
      p.marks[i] = p.mark[i];
      if (p.fresh[i] != 0 || (p.mark[i] == 0 && ! gs_is_own (&p, i)))
        return 0;
    }
  if (gs_user_points (&p, e->t, e->h) > 8)
    return 0;
  int info = apart (g, e, &p);
  if (info == 0)
    *quiet = clear (g, e, &p, &info);
  e->method = method;
  return info;
}

int
gs_event_polynomial (const gs_system *g, const gs_step *e, int again, gs_real *off)
{
  const gs_events p = plan (g);
  const int nx = g->nx;
  int info = again ? gs_step_dp853 (g, e->t, e->tn, e->side, e->h, e->x, p.end, off, e->f) : 0;
  if (info != 0)
    return info;
  gs_copy (nx, p.xdn, e->f + nx);
  info = gs_dense_coefficients (g, e->t, e->h, e->x, e->f, 1, p.end);
  if (info != 0)
    return info;
  gs_dense_from_rates (nx, e->h, GS_R (7.0) / 9, e->x, e->f, e->xn, p.xdn, e->f + nx, p.z);
  *off = gs_dense_error_there (g, e->x, e->xn, p.end, p.z);
  return 0;
}

/* z += h*b**2*(1 - b)**2*(p + q*b) */
void
gs_event_quintic (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *f,
                  const gs_real *xn, const gs_real *xdn, gs_real *z)
{
  const gs_real bb = b * (1 - b), factor = h * (bb * bb);
  for (int i = 0; i < nx; i++)
    {
      const gs_real s = (xn[i] - x[i]) / h;
      const gs_real p
          = (f[i + 9 * nx] - GS_R (1.44) * s + GS_R (0.32) * f[i] + GS_R (0.12) * xdn[i])
            / -GS_R (0.096);
      const gs_real q
          = (f[i + 6 * nx] - GS_R (1.125) * s - GS_R (0.1875) * f[i] + GS_R (0.3125) * xdn[i]
             - GS_R (0.1875) * p)
            / GS_R (8.203125e-2);
      z[i] = z[i] + factor * (p + q * b);
    }
}

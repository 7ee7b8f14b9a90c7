#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <string.h>

/* a position of a curve: gs_reach_onto_curve */
typedef struct
{
  gs_real q[6], z[6], u[6], g;
} place;

/* one way along the curve from the place at; 1: it is closed */
static int
walk (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
      place at, int nb, gs_real *qs, int *ns, int *br, int *info, int *nw, gs_real *qw)
{
  const gs_real h = GS_R (0.1);
  place b, first = at;
  gs_real gbb, s, *q = at.q;
  int closed = 0;
  b.g = at.g;
  for (int k = 1; k <= 200; k++)
    {
      gbb = b.g;
      b = at;
      for (int i = 0; i < 6; i++)
        q[i] = q[i] + h * at.z[i];
      gs_reach_onto_curve (4, kind, ka, pa, r, p, q, at.z, at.u, &at.g, &s);
      if (at.g * b.g <= 0)
        *info = gs_reach_between (kind, ka, pa, r, p, b.q, b.z, b.u, 0, b.g, h, at.g, nb, qs, ns,
                                  br, *info);
      else if (gs_abs (b.g) <= gs_min (gs_abs (at.g), gs_abs (gbb)))
        *info = gs_reach_about (kind, ka, pa, r, p, b.q, b.z, b.u, b.g, h, nb, qs, ns, br, *info);
      if (*nw < 400)
        gs_copy (6, q, qw + 6 * (*nw)++);
      if (! (gs_abs (at.g) <= GS_R (1e-3)))
        return 0;
      if (closed)
        return 1;
      closed = k > 2 && gs_reach_distance (kind, q, first.q) <= GS_R (0.6) * h;
    }
  return 0;
}

/* On the curve the pose is missed in the direction only in which the tool cannot move. In steps
 * of 0.1 both ways: where what is missed changes its sign there is a solution, and two may be where
 * it is least. The end is where more than 1e-3 is missed, a step behind where the curve closes, or
 * where it has been before. */
int
gs_reach_curve (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                const gs_real *p, const gs_real *q0, int nb, gs_real *qs, int *ns, int *br,
                int info, int *nw, gs_real *qw)
{
  place first = { .g = 0 };
  gs_real s;
  memcpy (first.q, q0, sizeof first.q);
  gs_reach_onto_curve (4, kind, ka, pa, r, p, first.q, first.z, first.u, &first.g, &s);
  for (int k = 0; k < *nw; k++)
    if (gs_reach_distance (kind, first.q, qw + 6 * k) <= GS_R (0.6) * GS_R (0.1))
      return info;
  for (int way = -1; way <= 1; way += 2)
    {
      place at = first;
      for (int i = 0; i < 6; i++)
        at.z[i] = (gs_real)way * first.z[i];
      if (walk (kind, ka, pa, r, p, at, nb, qs, ns, br, &info, nw, qw))
        return info;
    }
  return info;
}

/* a step d without the least singular value: b: the columns u*s, v, sv of the Jacobian */
static void
step (const gs_real *b, const gs_real *v, const gs_real *sv, const gs_real *e, gs_real *d)
{
  gs_zero (6, d);
  for (int k = 0; k < 5; k++)
    {
      gs_real t = 0;
      for (int i = 0; i < 6; i++)
        t = t + b[i + 6 * k] * e[i];
      t = t / sv[k] / sv[k];
      if (sv[k] <= GS_R (1e-7) * sv[0])
        t = 0;
      for (int i = 0; i < 6; i++)
        d[i] = d[i] + t * v[i + 6 * k];
    }
}

/* x: what is across the five other directions */
static void
across (const gs_real *b, const gs_real *sv, gs_real *x)
{
  gs_real t, big = -1;
  int l = 0;
  for (int i = 0; i < 6; i++)
    {
      t = 1;
      for (int k = 0; k < 5; k++)
        {
          gs_real y = b[i + 6 * k] / gs_max (sv[k], GS_TINY);
          t = t - y * y;
        }
      if (t > big)
        {
          big = t;
          l = i;
        }
      x[i] = 0;
    }
  x[l] = 1;
  for (int k = 0; k < 5; k++)
    {
      gs_real y = gs_max (sv[k], GS_TINY);
      t = b[l + 6 * k] / (y * y);
      for (int i = 0; i < 6; i++)
        x[i] = x[i] - t * b[i + 6 * k];
    }
}

/* x and v6, the direction of the curve, on the side of u and z in their places; -1: v6 was
 * turned */
static gs_real
oriented (const gs_real *x, const gs_real *v6, gs_real *z, gs_real *u)
{
  gs_real t = 0, g = 0, big = 0;
  for (int i = 0; i < 6; i++)
    {
      t = t + x[i] * x[i];
      g = g + x[i] * u[i];
      big = big + v6[i] * z[i];
    }
  t = gs_copysign (1, g) / gs_sqrt (gs_max (t, GS_TINY));
  big = gs_copysign (1, big);
  for (int i = 0; i < 6; i++)
    {
      u[i] = t * x[i];
      z[i] = big * v6[i];
    }
  return big;
}

/* Newton's method without the least singular value */
void
gs_reach_onto_curve (int m, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                     const gs_real *p, gs_real *q, gs_real *z, gs_real *u, gs_real *g, gs_real *s)
{
  gs_real b[36], e[6], v[36], sv[6], d[6], x[6], miss, big = 1;
  int rank;
  for (int it = 0; it <= m && (it == 0 || big > GS_R (1e-9)); it++)
    {
      gs_arm_missed (kind, ka, pa, r, p, q, b, e, &miss);
      gs_singular_values (6, 6, b, 6, v, 6, sv, GS_R (1e-14), &rank);
      if (it == m)
        break;
      step (b, v, sv, e, d);
      big = 0;
      for (int i = 0; i < 6; i++)
        big = gs_max (big, gs_abs (d[i]));
      gs_real t = gs_min (1, GS_R (0.3) / gs_max (big, GS_TINY));
      for (int i = 0; i < 6; i++)
        q[i] = q[i] + t * d[i];
    }
  across (b, sv, x);
  const gs_real side = oriented (x, v + 30, z, u);
  *g = *s = 0;
  for (int i = 0; i < 6; i++)
    {
      *g = *g + u[i] * e[i];
      *s = *s + side * u[i] * b[i + 30];
    }
}

gs_real
gs_reach_distance (const int *kind, const gs_real *q, const gs_real *z)
{
  gs_real d = 0;
  for (int i = 0; i < 6; i++)
    {
      gs_real t = q[i] - z[i];
      if (kind[i] == 1)
        t = 2 * gs_sin (GS_R (0.5) * t);
      d = d + t * t;
    }
  return gs_sqrt (d);
}

/* eight times the place where a straight line vanishes, between positions of opposite signs, one
 * that stays counting half; then Newton's method, which is the worse where the Jacobian has no
 * digits left in the direction of the curve */
int
gs_reach_between (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                  const gs_real *p, const gs_real *qb, const gs_real *zb, const gs_real *ub,
                  gs_real a, gs_real ga, gs_real b, gs_real ge, int nb, gs_real *qs, int *ns,
                  int *br, int info)
{
  gs_real q[6], z[6], u[6], w[42], s, gm;
  int iw[6], good, side = 0;
  for (int k = 0; k < 8; k++)
    {
      gs_real t = gs_abs (ga - ge) > 0 ? a + (b - a) * (ga / (ga - ge)) : a;
      for (int i = 0; i < 6; i++)
        q[i] = qb[i] + t * zb[i];
      memcpy (z, zb, sizeof z);
      memcpy (u, ub, sizeof u);
      gs_reach_onto_curve (4, kind, ka, pa, r, p, q, z, u, &gm, &s);
      int ahead = gm * ga > 0 ? 1 : -1;
      if (ahead == side && ahead > 0)
        ge = GS_R (0.5) * ge;
      if (ahead == side && ahead < 0)
        ga = GS_R (0.5) * ga;
      *(ahead > 0 ? &a : &b) = t;
      *(ahead > 0 ? &ga : &ge) = gm;
      side = ahead;
    }
  for (int i = 0; i < 6; i++)
    if (kind[i] == 1)
      q[i] = gs_atan2 (gs_sin (q[i]), gs_cos (q[i]));
  info = gs_reach_put (6, kind, ka, pa, r, p, q, nb, qs, ns, br, info);
  gs_arm_refine (6, kind, ka, pa, r, p, q, w, iw, &good);
  return good ? gs_reach_put (6, kind, ka, pa, r, p, q, nb, qs, ns, br, info) : info;
}

/* the place of the curve that is x along zb from qb */
static place
along (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
       const gs_real *qb, const gs_real *zb, const gs_real *ub, gs_real x)
{
  place at;
  gs_real s;
  for (int i = 0; i < 6; i++)
    at.q[i] = qb[i] + x * zb[i];
  memcpy (at.z, zb, sizeof at.z);
  memcpy (at.u, ub, sizeof at.u);
  gs_reach_onto_curve (4, kind, ka, pa, r, p, at.q, at.z, at.u, &at.g, &s);
  return at;
}

/* the new place x[3] with g[3] among x[0] < x[1] < x[2], the least about x[1] */
static void
narrowed (gs_real *x, gs_real *g)
{
  int i = g[3] < g[1] ? (x[3] < x[1] ? 2 : 0) : (x[3] < x[1] ? 0 : 2);
  int from = g[3] < g[1] ? 1 : 3;
  x[i] = x[from];
  g[i] = g[from];
  if (from == 1)
    {
      x[1] = x[3];
      g[1] = g[3];
    }
}

/* the place of the least, by golden sections, until what is missed has the other sign: then a
 * solution is on each side; where it keeps its sign, and is flat to 1e-3 of itself, Newton's method
 * from both sides of the least */
int
gs_reach_about (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                const gs_real *p, const gs_real *qb, const gs_real *zb, const gs_real *ub,
                gs_real gb, gs_real h, int nb, gs_real *qs, int *ns, int *br, int info)
{
  const gs_real part = 1 - GS_R (0.61803398874989485), sign = gs_copysign (1, gb);
  gs_real x[4] = { -h, 0, h, -h }, g[4] = { 0, gs_abs (gb), 0, 0 };
  for (int k = 0; k < 30; k++)
    {
      if (k == 1)
        x[3] = h;
      else if (k > 1)
        x[3] = x[1] - x[0] > x[2] - x[1] ? x[1] - part * (x[1] - x[0])
                                         : x[1] + part * (x[2] - x[1]);
      g[3] = sign * along (kind, ka, pa, r, p, qb, zb, ub, x[3]).g;
      if (k < 2)
        g[2 * k] = g[3];
      if (k < 2 && ! (g[3] > g[1]))
        return info;
      if (k > 1 && g[3] <= 0)
        {
          info = gs_reach_between (kind, ka, pa, r, p, qb, zb, ub, x[0], sign * g[0], x[3],
                                   sign * g[3], nb, qs, ns, br, info);
          return gs_reach_between (kind, ka, pa, r, p, qb, zb, ub, x[3], sign * g[3], x[2],
                                   sign * g[2], nb, qs, ns, br, info);
        }
      if (k > 1)
        narrowed (x, g);
      if (k > 0 && gs_max (g[0], g[2]) <= GS_R (1.001) * g[1])
        break;
    }
  place at = along (kind, ka, pa, r, p, qb, zb, ub, x[1]);
  return gs_reach_beside_singular (6, kind, ka, pa, r, p, at.q, at.z, nb, qs, ns, br, info);
}

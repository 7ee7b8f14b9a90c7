#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

/* a position of a curve: gsik3 */
typedef struct
{
  double q[6], z[6], u[6], g;
} place;

/* one way along the curve from the place at; 1: it is closed */
static int
walk (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
      place at, int nb, double *qs, int *ns, int *br, int *info, int *nw, double *qw)
{
  const double h = 0.1;
  place b, first = at;
  double gbb, s, *q = at.q;
  int closed = 0;
  b.g = at.g;
  for (int k = 1; k <= 200; k++)
    {
      gbb = b.g;
      b = at;
      for (int i = 0; i < 6; i++)
        q[i] = q[i] + h * at.z[i];
      gsik3 (4, kind, ka, pa, r, p, q, at.z, at.u, &at.g, &s);
      if (at.g * b.g <= 0.0)
        *info = gsik9 (kind, ka, pa, r, p, b.q, b.z, b.u, 0.0, b.g, h, at.g, nb, qs, ns, br, *info);
      else if (fabs (b.g) <= gs_min (fabs (at.g), fabs (gbb)))
        *info = gsiql (kind, ka, pa, r, p, b.q, b.z, b.u, b.g, h, nb, qs, ns, br, *info);
      if (*nw < 400)
        memcpy (qw + 6 * (*nw)++, q, 6 * sizeof (double));
      if (! (fabs (at.g) <= 1e-3))
        return 0;
      if (closed)
        return 1;
      closed = k > 2 && gsik8 (kind, q, first.q) <= 0.6 * h;
    }
  return 0;
}

/* On the curve the pose is missed in the direction only in which the tool cannot move. In steps
 * of 0.1 both ways: where what is missed changes its sign there is a solution, and two may be where
 * it is least. The end is where more than 1e-3 is missed, a step behind where the curve closes, or
 * where it has been before. */
int
gsik2 (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *q0, int nb, double *qs, int *ns, int *br, int info, int *nw, double *qw)
{
  place first = { .g = 0.0 };
  double s;
  memcpy (first.q, q0, sizeof first.q);
  gsik3 (4, kind, ka, pa, r, p, first.q, first.z, first.u, &first.g, &s);
  for (int k = 0; k < *nw; k++)
    if (gsik8 (kind, first.q, qw + 6 * k) <= 0.6 * 0.1)
      return info;
  for (int way = -1; way <= 1; way += 2)
    {
      place at = first;
      for (int i = 0; i < 6; i++)
        at.z[i] = way * first.z[i];
      if (walk (kind, ka, pa, r, p, at, nb, qs, ns, br, &info, nw, qw))
        return info;
    }
  return info;
}

/* a step d without the least singular value: b: the columns u*s, v, sv of the Jacobian */
static void
step (const double *b, const double *v, const double *sv, const double *e, double *d)
{
  memset (d, 0, 6 * sizeof (double));
  for (int k = 0; k < 5; k++)
    {
      double t = 0.0;
      for (int i = 0; i < 6; i++)
        t = t + b[i + 6 * k] * e[i];
      t = t / sv[k] / sv[k];
      if (sv[k] <= 1e-7 * sv[0])
        t = 0.0;
      for (int i = 0; i < 6; i++)
        d[i] = d[i] + t * v[i + 6 * k];
    }
}

/* x: what is across the five other directions */
static void
across (const double *b, const double *sv, double *x)
{
  double t, big = -1.0;
  int l = 0;
  for (int i = 0; i < 6; i++)
    {
      t = 1.0;
      for (int k = 0; k < 5; k++)
        {
          double y = b[i + 6 * k] / gs_max (sv[k], 1e-300);
          t = t - y * y;
        }
      if (t > big)
        {
          big = t;
          l = i;
        }
      x[i] = 0.0;
    }
  x[l] = 1.0;
  for (int k = 0; k < 5; k++)
    {
      double y = gs_max (sv[k], 1e-300);
      t = b[l + 6 * k] / (y * y);
      for (int i = 0; i < 6; i++)
        x[i] = x[i] - t * b[i + 6 * k];
    }
}

/* x and v6, the direction of the curve, on the side of u and z in their places; -1: v6 was
 * turned */
static double
oriented (const double *x, const double *v6, double *z, double *u)
{
  double t = 0.0, g = 0.0, big = 0.0;
  for (int i = 0; i < 6; i++)
    {
      t = t + x[i] * x[i];
      g = g + x[i] * u[i];
      big = big + v6[i] * z[i];
    }
  t = copysign (1.0, g) / sqrt (gs_max (t, 1e-300));
  big = copysign (1.0, big);
  for (int i = 0; i < 6; i++)
    {
      u[i] = t * x[i];
      z[i] = big * v6[i];
    }
  return big;
}

/* Newton's method without the least singular value */
void
gsik3 (int m, const int *kind, const double *ka, const double *pa, const double *r,
       const double *p, double *q, double *z, double *u, double *g, double *s)
{
  double b[36], e[6], v[36], sv[6], d[6], x[6], miss, big = 1.0;
  int rank;
  for (int it = 0; it <= m && (it == 0 || big > 1e-9); it++)
    {
      gsikj (kind, ka, pa, r, p, q, b, e, &miss);
      gssvd (6, 6, b, 6, v, 6, sv, 1e-14, &rank);
      if (it == m)
        break;
      step (b, v, sv, e, d);
      big = 0.0;
      for (int i = 0; i < 6; i++)
        big = gs_max (big, fabs (d[i]));
      double t = gs_min (1.0, 0.3 / gs_max (big, 1e-300));
      for (int i = 0; i < 6; i++)
        q[i] = q[i] + t * d[i];
    }
  across (b, sv, x);
  const double side = oriented (x, v + 30, z, u);
  *g = *s = 0.0;
  for (int i = 0; i < 6; i++)
    {
      *g = *g + u[i] * e[i];
      *s = *s + side * u[i] * b[i + 30];
    }
}

double
gsik8 (const int *kind, const double *q, const double *z)
{
  double d = 0.0;
  for (int i = 0; i < 6; i++)
    {
      double t = q[i] - z[i];
      if (kind[i] == 1)
        t = 2.0 * sin (0.5 * t);
      d = d + t * t;
    }
  return sqrt (d);
}

/* eight times the place where a straight line vanishes, between positions of opposite signs, one
 * that stays counting half; then Newton's method, which is the worse where the Jacobian has no
 * digits left in the direction of the curve */
int
gsik9 (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *qb, const double *zb, const double *ub, double a, double ga, double b,
       double ge, int nb, double *qs, int *ns, int *br, int info)
{
  double q[6], z[6], u[6], w[42], s, gm;
  int iw[6], good, side = 0;
  for (int k = 0; k < 8; k++)
    {
      double t = fabs (ga - ge) > 0 ? a + (b - a) * (ga / (ga - ge)) : a;
      for (int i = 0; i < 6; i++)
        q[i] = qb[i] + t * zb[i];
      memcpy (z, zb, sizeof z);
      memcpy (u, ub, sizeof u);
      gsik3 (4, kind, ka, pa, r, p, q, z, u, &gm, &s);
      int ahead = gm * ga > 0.0 ? 1 : -1;
      if (ahead == side && ahead > 0)
        ge = 0.5 * ge;
      if (ahead == side && ahead < 0)
        ga = 0.5 * ga;
      *(ahead > 0 ? &a : &b) = t;
      *(ahead > 0 ? &ga : &ge) = gm;
      side = ahead;
    }
  for (int i = 0; i < 6; i++)
    if (kind[i] == 1)
      q[i] = atan2 (sin (q[i]), cos (q[i]));
  info = gsikp (6, kind, ka, pa, r, p, q, nb, qs, ns, br, info);
  gsikn (6, kind, ka, pa, r, p, q, w, iw, &good);
  return good ? gsikp (6, kind, ka, pa, r, p, q, nb, qs, ns, br, info) : info;
}

/* the place of the curve that is x along zb from qb */
static place
along (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *qb, const double *zb, const double *ub, double x)
{
  place at;
  double s;
  for (int i = 0; i < 6; i++)
    at.q[i] = qb[i] + x * zb[i];
  memcpy (at.z, zb, sizeof at.z);
  memcpy (at.u, ub, sizeof at.u);
  gsik3 (4, kind, ka, pa, r, p, at.q, at.z, at.u, &at.g, &s);
  return at;
}

/* the new place x[3] with g[3] among x[0] < x[1] < x[2], the least about x[1] */
static void
narrowed (double *x, double *g)
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
gsiql (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *qb, const double *zb, const double *ub, double gb, double h, int nb,
       double *qs, int *ns, int *br, int info)
{
  const double part = 1.0 - 0.61803398874989485, sign = copysign (1.0, gb);
  double x[4] = { -h, 0.0, h, -h }, g[4] = { 0.0, fabs (gb), 0.0, 0.0 };
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
      if (k > 1 && g[3] <= 0.0)
        {
          info = gsik9 (kind, ka, pa, r, p, qb, zb, ub, x[0], sign * g[0], x[3], sign * g[3], nb,
                        qs, ns, br, info);
          return gsik9 (kind, ka, pa, r, p, qb, zb, ub, x[3], sign * g[3], x[2], sign * g[2], nb,
                        qs, ns, br, info);
        }
      if (k > 1)
        narrowed (x, g);
      if (k > 0 && gs_max (g[0], g[2]) <= 1.001 * g[1])
        break;
    }
  place at = along (kind, ka, pa, r, p, qb, zb, ub, x[1]);
  return gsik4 (6, kind, ka, pa, r, p, at.q, at.z, nb, qs, ns, br, info);
}

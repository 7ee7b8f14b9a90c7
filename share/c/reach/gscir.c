#include "gsmbp/arith.h"
#include "gsmbp/reach.h"

#include <math.h>

/* the angle th of a root, by Newton's method on the sum itself */
static double
refined (const double *co, double size, double th)
{
  double f, fd;
  for (int i = 0; i < 4; i++)
    {
      gscif (co, th, &f, &fd);
      if (fabs (fd) > 1e-6 * size && fabs (f) <= 1e-3 * fabs (fd))
        th = th - f / fd;
    }
  return th;
}

/* The tangent of half the angle from a place where the sum is large solves an equation of degree
 * four, whose roots Aberth's iteration finds together; real ones are refined. */
void
gscir (const double *co, double *sc, double *rad)
{
  double a[5], zr[4], zi[4], far, f, fd, size = 0.0;
  for (int k = 0; k < 5; k++)
    size += fabs (co[k]);
  for (int k = 0; k < 4; k++)
    {
      sc[2 * k] = 0.0;
      sc[2 * k + 1] = 1.0;
      rad[k] = -1.0;
    }
  if (! (size > 0.0 && size <= 1e300))
    return;
  gsciq (co, size, &far, a);
  gscie (a, zr, zi);
  for (int k = 0; k < 4; k++)
    if (fabs (zi[k]) <= 1e-3 * (1.0 + zr[k] * zr[k]))
      {
        double th = refined (co, size, far + 2.0 * atan (zr[k]));
        gscif (co, th, &f, &fd);
        if (! (fabs (f) <= 1e-14 * size))
          continue;
        sc[2 * k] = sin (th);
        sc[2 * k + 1] = cos (th);
        rad[k] = gs_square (fd / size);
      }
}

void
gscif (const double *co, double th, double *f, double *fd)
{
  double s = sin (th), c = cos (th);
  double s2 = 2.0 * s * c, c2 = (c - s) * (c + s);
  *f = co[0] * c2 + co[1] * s2 + co[2] * c + co[3] * s + co[4];
  *fd = 2.0 * (co[1] * c2 - co[0] * s2) - co[2] * s + co[3] * c;
}

/* of sixteen places the one with the largest sum */
void
gsciq (const double *co, double size, double *far, double *a)
{
  const double pi = 3.1415926535897932384626433832795;
  double f, fd, big = -1.0;
  *far = 0.0;
  for (int k = 1; k <= 16; k++)
    {
      double th = 0.3 + k * pi / 8.0;
      gscif (co, th, &f, &fd);
      if (fabs (f) > big)
        {
          big = fabs (f);
          *far = th - pi;
        }
    }
  double c1 = cos (*far), s1 = sin (*far), c2 = cos (2.0 * *far), s2 = sin (2.0 * *far);
  double p = (co[0] * c2 + co[1] * s2) / size, q = (co[1] * c2 - co[0] * s2) / size;
  double r = (co[2] * c1 + co[3] * s1) / size, s = (co[3] * c1 - co[2] * s1) / size;
  double t = co[4] / size;
  a[0] = p + r + t;
  a[1] = 4.0 * q + 2.0 * s;
  a[2] = 2.0 * t - 6.0 * p;
  a[3] = 2.0 * s - 4.0 * q;
  a[4] = p - r + t;
}

/* value and derivative f = (re, im, re, im) at x + iy by Horner's rule */
static void
horner (const double *a, double x, double y, double *f)
{
  double fr = a[4], fi = 0.0, gr = 0.0, gi = 0.0;
  for (int j = 3; j >= 0; j--)
    {
      double t = gr * x - gi * y + fr;
      gi = gr * y + gi * x + fi;
      gr = t;
      t = fr * x - fi * y + a[j];
      fi = fr * y + fi * x;
      fr = t;
    }
  f[0] = fr;
  f[1] = fi;
  f[2] = gr;
  f[3] = gi;
}

/* one step of Aberth for root k; how far it moved beside its size, at least moved */
static double
aberth (const double *a, int k, double *zr, double *zi, double moved)
{
  double f[4], sr = 0.0, si = 0.0;
  horner (a, zr[k], zi[k], f);
  for (int j = 0; j < 4; j++)
    if (j != k)
      {
        double dr = zr[k] - zr[j], di = zi[k] - zi[j];
        double d = gs_max (dr * dr + di * di, 1e-300);
        sr = sr + dr / d;
        si = si - di / d;
      }
  double wr = f[2] - (f[0] * sr - f[1] * si), wi = f[3] - (f[0] * si + f[1] * sr);
  double d = wr * wr + wi * wi;
  if (! (d > 1e-290))
    return moved;
  double dr = (f[0] * wr + f[1] * wi) / d, di = (f[1] * wr - f[0] * wi) / d;
  zr[k] = zr[k] - dr;
  zi[k] = zi[k] - di;
  return gs_max (moved, (fabs (dr) + fabs (di)) / (fabs (zr[k]) + fabs (zi[k]) + 1e-30));
}

/* O. Aberth, Mathematics of Computation 27 (1973), 339-344; from a circle of the size of the
 * roots */
void
gscie (const double *a, double *zr, double *zi)
{
  double ring = 0.0;
  for (int k = 0; k < 4; k++)
    {
      double t = fabs (a[k] / a[4]);
      if (t > 0.0)
        ring = gs_max (ring, pow (t, 1.0 / (4 - k)));
    }
  ring = gs_max (ring, 1e-3);
  for (int k = 0; k < 4; k++)
    {
      zr[k] = ring * cos (1.5708 * (k + 1) + 0.4);
      zi[k] = ring * sin (1.5708 * (k + 1) + 0.4);
    }
  for (int i = 0; i < 100; i++)
    {
      double moved = 0.0;
      for (int k = 0; k < 4; k++)
        moved = aberth (a, k, zr, zi, moved);
      if (moved <= 1e-15)
        return;
    }
}

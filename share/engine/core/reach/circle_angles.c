#include "gsmbp/arith.h"
#include "gsmbp/reach.h"

/* the angle th of a root, by Newton's method on the sum itself */
static gs_real
refined (const gs_real *co, gs_real size, gs_real th)
{
  gs_real f, fd;
  for (int i = 0; i < 4; i++)
    {
      gs_circle_sum (co, th, &f, &fd);
      if (gs_abs (fd) > GS_R (1e-6) * size && gs_abs (f) <= GS_R (1e-3) * gs_abs (fd))
        th = th - f / fd;
    }
  return th;
}

/* The tangent of half the angle from a place where the sum is large solves an equation of degree
 * four, whose roots Aberth's iteration finds together; real ones are refined. */
void
gs_circle_angles (const gs_real *co, gs_real *sc, gs_real *rad)
{
  gs_real a[5], zr[4], zi[4], far, f, fd, size = 0;
  for (int k = 0; k < 5; k++)
    size += gs_abs (co[k]);
  for (int k = 0; k < 4; k++)
    {
      sc[2 * k] = 0;
      sc[2 * k + 1] = 1;
      rad[k] = -1;
    }
  if (! (size > 0 && size <= GS_HUGE))
    return;
  gs_circle_quartic (co, size, &far, a);
  gs_quartic_roots (a, zr, zi);
  for (int k = 0; k < 4; k++)
    if (gs_abs (zi[k]) <= GS_R (1e-3) * (1 + zr[k] * zr[k]))
      {
        gs_real th = refined (co, size, far + 2 * gs_atan (zr[k]));
        gs_circle_sum (co, th, &f, &fd);
        if (! (gs_abs (f) <= GS_R (1e-14) * size))
          continue;
        sc[2 * k] = gs_sin (th);
        sc[2 * k + 1] = gs_cos (th);
        rad[k] = gs_square (fd / size);
      }
}

void
gs_circle_sum (const gs_real *co, gs_real th, gs_real *f, gs_real *fd)
{
  gs_real s = gs_sin (th), c = gs_cos (th);
  gs_real s2 = 2 * s * c, c2 = (c - s) * (c + s);
  *f = co[0] * c2 + co[1] * s2 + co[2] * c + co[3] * s + co[4];
  *fd = 2 * (co[1] * c2 - co[0] * s2) - co[2] * s + co[3] * c;
}

/* of sixteen places the one with the largest sum */
void
gs_circle_quartic (const gs_real *co, gs_real size, gs_real *far, gs_real *a)
{
  const gs_real pi = GS_R (3.1415926535897932384626433832795);
  gs_real f, fd, big = -1;
  *far = 0;
  for (int k = 1; k <= 16; k++)
    {
      gs_real th = GS_R (0.3) + (gs_real)k * pi / 8;
      gs_circle_sum (co, th, &f, &fd);
      if (gs_abs (f) > big)
        {
          big = gs_abs (f);
          *far = th - pi;
        }
    }
  gs_real c1 = gs_cos (*far), s1 = gs_sin (*far), c2 = gs_cos (2 * *far), s2 = gs_sin (2 * *far);
  gs_real p = (co[0] * c2 + co[1] * s2) / size, q = (co[1] * c2 - co[0] * s2) / size;
  gs_real r = (co[2] * c1 + co[3] * s1) / size, s = (co[3] * c1 - co[2] * s1) / size;
  gs_real t = co[4] / size;
  a[0] = p + r + t;
  a[1] = 4 * q + 2 * s;
  a[2] = 2 * t - 6 * p;
  a[3] = 2 * s - 4 * q;
  a[4] = p - r + t;
}

/* value and derivative f = (re, im, re, im) at x + iy by Horner's rule */
static void
horner (const gs_real *a, gs_real x, gs_real y, gs_real *f)
{
  gs_real fr = a[4], fi = 0, gr = 0, gi = 0;
  for (int j = 3; j >= 0; j--)
    {
      gs_real t = gr * x - gi * y + fr;
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
static gs_real
aberth (const gs_real *a, int k, gs_real *zr, gs_real *zi, gs_real moved)
{
  gs_real f[4], sr = 0, si = 0;
  horner (a, zr[k], zi[k], f);
  for (int j = 0; j < 4; j++)
    if (j != k)
      {
        gs_real dr = zr[k] - zr[j], di = zi[k] - zi[j];
        gs_real d = gs_max (dr * dr + di * di, GS_TINY);
        sr = sr + dr / d;
        si = si - di / d;
      }
  gs_real wr = f[2] - (f[0] * sr - f[1] * si), wi = f[3] - (f[0] * si + f[1] * sr);
  gs_real d = wr * wr + wi * wi;
  if (! (d > GS_R2 (1e-290, 1e-37)))
    return moved;
  gs_real dr = (f[0] * wr + f[1] * wi) / d, di = (f[1] * wr - f[0] * wi) / d;
  zr[k] = zr[k] - dr;
  zi[k] = zi[k] - di;
  return gs_max (moved, (gs_abs (dr) + gs_abs (di))
                            / (gs_abs (zr[k]) + gs_abs (zi[k]) + GS_R (1e-30)));
}

/* O. Aberth, Mathematics of Computation 27 (1973), 339-344; from a circle of the size of the
 * roots */
void
gs_quartic_roots (const gs_real *a, gs_real *zr, gs_real *zi)
{
  gs_real ring = 0;
  for (int k = 0; k < 4; k++)
    {
      gs_real t = gs_abs (a[k] / a[4]);
      if (t > 0)
        ring = gs_max (ring, gs_pow (t, GS_R (1.0) / (gs_real)(4 - k)));
    }
  ring = gs_max (ring, GS_R (1e-3));
  for (int k = 0; k < 4; k++)
    {
      zr[k] = ring * gs_cos (GS_R (1.5708) * (gs_real)(k + 1) + GS_R (0.4));
      zi[k] = ring * gs_sin (GS_R (1.5708) * (gs_real)(k + 1) + GS_R (0.4));
    }
  for (int i = 0; i < 100; i++)
    {
      gs_real moved = 0;
      for (int k = 0; k < 4; k++)
        moved = aberth (a, k, zr, zi, moved);
      if (moved <= GS_R (1e-15))
        return;
    }
}

/* gs_polynomials_at: piecewise polynomials with common breaks, and their derivatives.
 *
 * Binary search, then Horner's rule for value and derivatives. Before the first and after the last
 * break the value is held and the derivatives are zero; a distance of 1e-12 of the whole range does
 * not count as outside. */

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

static int
faulty (int nc, int np, int k, gs_real t, int nd, int ldf)
{
  if (ldf < gs_most (1, nc))
    return -10;
  if (nd < 0)
    return -8;
  if (! (gs_abs (t) <= GS_HUGE))
    return -6;
  if (k < 1)
    return -3;
  if (np < 1)
    return -2;
  return nc < 0 ? -1 : 0;
}

/* the piece of t, at a break the one on its side */
static int
piece (int np, const gs_real *brk, gs_real t, int side)
{
  int lo = 0, hi = np;
  while (hi - lo > 1)
    {
      int mid = (lo + hi) / 2;
      if (t > brk[mid] || (t >= brk[mid] && side >= 0))
        lo = mid;
      else
        hi = mid;
    }
  return lo;
}

int
gs_polynomials_at (int nc, int np, int k, const gs_real *brk, const gs_real *coef, gs_real t,
                   int side, int nd, gs_real *f, int ldf)
{
  int info = faulty (nc, np, k, t, nd, ldf);
  if (info != 0)
    return info;
  gs_real tol = GS_R2 (1e-12, 1e-6) * (brk[np] - brk[0]);
  if (t < brk[0] - tol || t > brk[np] + tol)
    info = 1;
  int p = piece (np, brk, t, side);
  gs_real s = t - brk[p];
  if (info == 1)
    s = gs_min (gs_max (t, brk[0]), brk[np]) - brk[p];

  for (int i = 0; i < nc; i++)
    {
      const gs_real *c = coef + i + nc * p;
      f[i] = c[0];
      for (int j = 1; j <= nd; j++)
        f[i + ldf * j] = 0;
      for (int l = 1; l < k; l++)
        {
          for (int j = gs_least (nd, l); j >= 1; j--)
            f[i + ldf * j] = f[i + ldf * j] * s + f[i + ldf * (j - 1)];
          f[i] = f[i] * s + c[nc * np * l];
        }
    }
  gs_real fact = 1;
  for (int j = 1; j <= nd; j++)
    {
      fact = info == 1 ? 0 : fact * (gs_real)j;
      for (int i = 0; i < nc; i++)
        f[i + ldf * j] *= fact;
    }
  return info;
}

/* gs_first_step: a first step for gs_step_dp853, from the size of the first and the second
 * derivative.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.4. */

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"

static gs_real
scale (const gs_system *g, int i, gs_real x)
{
  return gs_max (g->atol[i] + g->ropt[1] * gs_abs (x), GS_R2 (1e-200, 1e-30));
}

int
gs_first_step (const gs_system *g, gs_real t, gs_real hmax, const gs_real *x, gs_real *w,
               gs_real *h)
{
  const int nx = g->nx;
  gs_real *xd = w, *other = w + nx, *z = w + 2 * nx;
  gs_real d0 = 0, d1 = 0, d2 = 0;
  for (int i = 0; i < nx; i++)
    {
      gs_real s = scale (g, i, x[i]);
      d0 += (x[i] / s) * (x[i] / s);
      d1 += (xd[i] / s) * (xd[i] / s);
    }
  *h = GS_R2 (1e-6, 1e-4);
  if (d0 > GS_R2 (1e-10, 1e-5) && d1 > GS_R2 (1e-10, 1e-5))
    *h = GS_R (0.01) * gs_sqrt (d0 / d1);
  *h = gs_min (*h, hmax);
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + *h * xd[i];
  int info = gs_rates_at (g, t + *h, -1, z, other);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      gs_real d = (other[i] - xd[i]) / scale (g, i, x[i]);
      d2 += d * d;
    }
  d2 = gs_sqrt (d2) / *h;
  gs_real s = gs_max (d2, gs_sqrt (d1)); /* not d2 where that is no number */
  if (s <= GS_R2 (1e-15, 1e-7))
    s = gs_max (GS_R2 (1e-6, 1e-4), GS_R (1e-3) * *h);
  else
    s = gs_pow (GS_R (0.01) / s, GS_R (0.125));
  *h = gs_min (gs_min (100 * *h, s), hmax);
  return 0;
}

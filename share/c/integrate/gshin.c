/* GSHIN: a first step for GSDP8, from the size of the first and the second derivative.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.4. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"

static double
scale (const gs_system *g, int i, double x)
{
  return gs_max (g->atol[i] + g->ropt[1] * fabs (x), 1e-200);
}

int
gshin (const gs_system *g, double t, double hmax, const double *x, double *w, double *h)
{
  const int nx = g->nx;
  double *xd = w, *other = w + nx, *z = w + 2 * nx;
  double d0 = 0.0, d1 = 0.0, d2 = 0.0;
  for (int i = 0; i < nx; i++)
    {
      double s = scale (g, i, x[i]);
      d0 += (x[i] / s) * (x[i] / s);
      d1 += (xd[i] / s) * (xd[i] / s);
    }
  *h = d0 > 1e-10 && d1 > 1e-10 ? 0.01 * sqrt (d0 / d1) : 1e-6;
  *h = gs_min (*h, hmax);
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + *h * xd[i];
  int info = gsfun (g, t + *h, -1, z, other);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      double d = (other[i] - xd[i]) / scale (g, i, x[i]);
      d2 += d * d;
    }
  d2 = sqrt (d2) / *h;
  double s = gs_max (d2, sqrt (d1)); /* not d2 where that is no number */
  if (s <= 1e-15)
    s = gs_max (1e-6, 1e-3 * *h);
  else
    s = pow (0.01 / s, 0.125);
  *h = gs_min (gs_min (100.0 * *h, s), hmax);
  return 0;
}

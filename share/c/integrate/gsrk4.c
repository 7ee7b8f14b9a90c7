/* GSRK4: one step of the classical Runge-Kutta method of order 4.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2. */
#include "gsmbp/integrate.h"

int
gsrk4 (const gs_system *g, double t, double tn, int side, double h, double *x, double *xn,
       double *w)
{
  const int nx = g->nx;
  const double h2 = 0.5 * h, h6 = h / 6.0, tm = t + h2;
  double *sum = w, *k = w + nx, *z = w + 2 * nx;
  int info = gsfun (g, t, 1, x, sum);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + h2 * sum[i];
  info = gsfun (g, tm, 1, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      z[i] = x[i] + h2 * k[i];
      sum[i] += 2.0 * k[i];
    }
  info = gsfun (g, tm, 1, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      z[i] = x[i] + h * k[i];
      sum[i] += 2.0 * k[i];
    }
  info = gsfun (g, tn, side, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    xn[i] = x[i] + h6 * (sum[i] + k[i]);
  return 0;
}

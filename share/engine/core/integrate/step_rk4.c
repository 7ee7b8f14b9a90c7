/* gs_step_rk4: one step of the classical Runge-Kutta method of order 4.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2. */
#include "gsmbp/integrate.h"

int
gs_step_rk4 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h, gs_real *x,
             gs_real *xn, gs_real *w)
{
  const int nx = g->nx;
  const gs_real h2 = GS_R (0.5) * h, h6 = h / 6, tm = t + h2;
  gs_real *sum = w, *k = w + nx, *z = w + 2 * nx;
  int info = gs_rates_at (g, t, 1, x, sum);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + h2 * sum[i];
  info = gs_rates_at (g, tm, 1, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      z[i] = x[i] + h2 * k[i];
      sum[i] += 2 * k[i];
    }
  info = gs_rates_at (g, tm, 1, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    {
      z[i] = x[i] + h * k[i];
      sum[i] += 2 * k[i];
    }
  info = gs_rates_at (g, tn, side, z, k);
  if (info != 0)
    return info;
  for (int i = 0; i < nx; i++)
    xn[i] = x[i] + h6 * (sum[i] + k[i]);
  return 0;
}

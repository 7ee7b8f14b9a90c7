/* gs_largest_eigenvalue: the largest eigenvalue of the right-hand side, by modulus, inputs
 * included: what bounds the step of an explicit method.
 *
 * The power method on differences of the right-hand side. Lengths are the largest entry, divided
 * by atol[i]/rtol + |x[i]|. A real eigenvalue shows itself by equal growth in succession; under a
 * pair of complex ones growth goes up and down, and its geometric mean over the last 24 of 32
 * iterations is taken.
 * An eigenvalue rho whose left vector has the part c of the first direction lets n iterations grow
 * by c*rho^n or more. Once they have grown by less than 1e-4/h^n none with h*rho above 1 is left
 * but where c is less than 1e-4, and that is the end: 0. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

/* units of the states, and a direction to begin with */
static void
begin (const gs_system *g, const gs_real *x, gs_real *dir, gs_real *z, gs_real *unit)
{
  const gs_real rtol = g->ropt[1];
  for (int i = 0; i < g->nx; i++)
    {
      z[i] = x[i];
      unit[i] = rtol > 0 ? gs_abs (x[i]) + g->atol[i] / rtol : gs_abs (x[i]) + 1;
      if (! (unit[i] > 0))
        unit[i] = 1;
      dir[i] = unit[i] * (GS_R (0.5) + gs_fmod (GS_R (0.618) * (gs_real)(i + 1), 1));
    }
}

/* the direction becomes what the right-hand side, xd at x, makes of it; growth: its length, 0 where
 * that failed */
static gs_real
turned (const gs_system *g, gs_real t, const gs_real *x, const gs_real *xd, gs_real *dir,
        gs_real *z, const gs_real *unit, int *k)
{
  const gs_real d = gs_sqrt (gs_epsilon ());
  gs_real s = 0, growth = 0;
  for (int i = 0; i < g->nx; i++)
    s = gs_max (s, gs_abs (dir[i]) / unit[i]);
  if (! (s > 0 && s <= GS_HUGE))
    return 0;
  s = d / s;
  for (int i = 0; i < g->nx; i++)
    z[i] = x[i] + s * dir[i];
  if (gs_rates_at (g, t, 1, z, dir) != 0)
    return 0;
  for (int i = 0; i < g->nx; i++)
    {
      dir[i] -= xd[i];
      s = gs_abs (dir[i]) / unit[i];
      if (s > growth)
        {
          growth = s;
          *k = i + 1;
        }
    }
  return growth / d;
}

/* the eigenvalue, counting in the statistics of g */
static gs_real
largest (const gs_system *g, gs_real t, const gs_real *x, gs_real h, gs_real *w, int *k)
{
  const int nx = g->nx;
  gs_real *xd = w, *dir = w + nx, *z = w + 2 * nx, *unit = w + 3 * nx;
  gs_real old = 0, sum = 0, part = 1;
  begin (g, x, dir, z, unit);
  if (gs_rates_at (g, t, 1, z, xd) != 0)
    return 0;
  for (int j = 1, equal = 0; j <= 32; j++)
    {
      gs_real growth = turned (g, t, x, xd, dir, z, unit, k);
      if (! (growth > 0))
        return 0;
      equal = gs_abs (growth - old) > GS_R (0.02) * growth ? 0 : equal + 1;
      old = growth;
      if (j > 8)
        sum += gs_log (growth);
      if (equal == 3)
        return growth;
      part = gs_min (GS_HUGE, part * growth * h);
      if (part < GS_R (1e-4))
        return 0;
    }
  return gs_exp (sum / 24);
}

void
gs_largest_eigenvalue (const gs_system *g, gs_real t, const gs_real *x, gs_real h, gs_real *w,
                       gs_real *rho, int *k)
{
  int istat[GS_COUNTED] = { 0 };
  gs_real rstat[GS_MEASURED] = { 0 };
  gs_system own = *g;
  own.istat = istat;
  own.rstat = rstat;
  *k = 1;
  *rho = largest (&own, t, x, h, w, k);
  g->istat[GS_N_STABILITY] += istat[GS_N_RHS];
}

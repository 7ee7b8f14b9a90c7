/* GSSTF: the largest eigenvalue of the right-hand side, by modulus, inputs included: what bounds
 * the step of an explicit method.
 *
 * The power method on differences of the right-hand side. Lengths are the largest entry, divided
 * by atol[i]/rtol + |x[i]|. A real eigenvalue shows itself by equal growth in succession; under a
 * pair of complex ones growth goes up and down, and its geometric mean over the last 24 of 32
 * iterations is taken.
 * An eigenvalue rho whose left vector has the part c of the first direction lets n iterations grow
 * by c*rho^n or more. Once they have grown by less than 1e-4/h^n none with h*rho above 1 is left
 * but where c is less than 1e-4, and that is the end: 0. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

/* units of the states, and a direction to begin with */
static void
begin (const gs_system *g, const double *x, double *dir, double *z, double *unit)
{
  const double rtol = g->ropt[1];
  for (int i = 0; i < g->nx; i++)
    {
      z[i] = x[i];
      unit[i] = rtol > 0.0 ? fabs (x[i]) + g->atol[i] / rtol : fabs (x[i]) + 1.0;
      if (! (unit[i] > 0.0))
        unit[i] = 1.0;
      dir[i] = unit[i] * (0.5 + fmod (0.618 * (i + 1), 1.0));
    }
}

/* the direction becomes what the right-hand side, xd at x, makes of it; growth: its length, 0 where
 * that failed */
static double
turned (const gs_system *g, double t, const double *x, const double *xd, double *dir, double *z,
        const double *unit, int *k)
{
  const double d = sqrt (gseps ());
  double s = 0.0, growth = 0.0;
  for (int i = 0; i < g->nx; i++)
    s = gs_max (s, fabs (dir[i]) / unit[i]);
  if (! (s > 0.0 && s <= 1e300))
    return 0.0;
  s = d / s;
  for (int i = 0; i < g->nx; i++)
    z[i] = x[i] + s * dir[i];
  if (gsfun (g, t, 1, z, dir) != 0)
    return 0.0;
  for (int i = 0; i < g->nx; i++)
    {
      dir[i] -= xd[i];
      s = fabs (dir[i]) / unit[i];
      if (s > growth)
        {
          growth = s;
          *k = i + 1;
        }
    }
  return growth / d;
}

/* the eigenvalue, counting in the statistics of g */
static double
largest (const gs_system *g, double t, const double *x, double h, double *w, int *k)
{
  const int nx = g->nx;
  double *xd = w, *dir = w + nx, *z = w + 2 * nx, *unit = w + 3 * nx;
  double old = 0.0, sum = 0.0, part = 1.0;
  begin (g, x, dir, z, unit);
  if (gsfun (g, t, 1, z, xd) != 0)
    return 0.0;
  for (int j = 1, equal = 0; j <= 32; j++)
    {
      double growth = turned (g, t, x, xd, dir, z, unit, k);
      if (! (growth > 0.0))
        return 0.0;
      equal = fabs (growth - old) > 0.02 * growth ? 0 : equal + 1;
      old = growth;
      if (j > 8)
        sum += log (growth);
      if (equal == 3)
        return growth;
      part = gs_min (1e300, part * growth * h);
      if (part < 1e-4)
        return 0.0;
    }
  return exp (sum / 24.0);
}

void
gsstf (const gs_system *g, double t, const double *x, double h, double *w, double *rho, int *k)
{
  int istat[20] = { 0 };
  double rstat[20] = { 0 };
  gs_system own = *g;
  own.istat = istat;
  own.rstat = rstat;
  *k = 1;
  *rho = largest (&own, t, x, h, w, k);
  g->istat[GS_N_STABILITY] += istat[GS_N_RHS];
}

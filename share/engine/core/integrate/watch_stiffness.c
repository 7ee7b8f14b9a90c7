/* gs_watch_stiffness: watches for steps that are bound by the stability of an explicit method: once
 * found, that is recorded and no more is done.
 *
 * Method 4: the largest eigenvalue (gs_largest_eigenvalue) before the steps 1, 11, 101, 1001, 2001
 * and so on; beyond 2.78/h the method is unstable.
 * Methods 8 and 9: two points at the end of a step, that of the last stage and the result, differ
 * mostly in the direction of the largest eigenvalue; the difference of the right-hand sides there
 * tells its size. Steps that are bound by it swing about 6.4/h; if it looks beyond 5/h at 500
 * steps (method 9: 100) with no run of 6 others between, the eigenvalue itself decides, from 4/h
 * on. Fewer steps are no loss: a system that comes to rest is soon there.
 *
 * Hairer, Wanner, Solving Ordinary Differential Equations II, section IV.2 (stiffness
 * detection). */

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"

/* have steps looked as if bound often enough? */
static int
suspect (const gs_system *g, gs_real h, const gs_real *x, const gs_real *w)
{
  const int nx = g->nx;
  const gs_real *xd = w, *xd12 = w + 11 * nx, *z = w + 12 * nx;
  int *istat = g->istat;
  gs_real a = 0, b = 0;
  for (int i = 0; i < nx; i++)
    {
      gs_real s = g->atol[i] + g->ropt[1] * gs_abs (x[i]);
      if (s > 0)
        {
          gs_real da = (xd[i] - xd12[i]) / s, db = (x[i] - z[i]) / s;
          a += da * da;
          b += db * db;
        }
    }
  if (gs_abs (h) * gs_sqrt (a) > 5 * gs_sqrt (b))
    {
      istat[GS_SEEN_STIFF]++;
      istat[GS_SEEN_FREE] = 0;
    }
  else
    {
      istat[GS_SEEN_FREE]++;
      if (istat[GS_SEEN_FREE] >= 6)
        istat[GS_SEEN_STIFF] = 0;
    }
  if (istat[GS_SEEN_STIFF] < (g->iopt[GS_METHOD] == 9 ? 100 : 500))
    return 0;
  istat[GS_SEEN_STIFF] = 0;
  return 1;
}

void
gs_watch_stiffness (const gs_system *g, gs_real t, gs_real h, const gs_real *x, gs_real *w)
{
  int *istat = g->istat;
  gs_real limit = 4;
  if (istat[GS_IS_STIFF] > 0 || istat[GS_N_STEPS] < istat[GS_NEXT_LOOK])
    return;
  if (g->iopt[GS_METHOD] == 4)
    {
      const int n = gs_least (1000, istat[GS_N_STEPS]);
      istat[GS_NEXT_LOOK] = istat[GS_N_STEPS] + gs_least (1000, gs_most (10, 9 * n));
      limit = GS_R (2.78);
    }
  else if (! suspect (g, h, x, w))
    return;
  gs_real rho;
  int k;
  gs_largest_eigenvalue (g, t, x, gs_abs (h) / limit, w + g->nx, &rho, &k);
  if (rho * gs_abs (h) <= limit)
    return;
  istat[GS_IS_STIFF] = 1;
  istat[GS_STIFF_STATE] = k;
  g->rstat[GS_T_STIFF] = t;
  g->rstat[GS_R_STIFF] = rho;
  g->rstat[GS_H_STIFF] = gs_abs (h);
}

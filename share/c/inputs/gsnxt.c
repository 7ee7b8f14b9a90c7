/* GSNXT: the next time at which a sampled device acts or gives out. */
#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

double
gsnxt (int nv, int *is, double *rs)
{
  gs_samples a = gs_samples_of (nv, is, rs);
  double t = 1e300;
  for (int i = 0; i < a.nc; i++)
    t = gs_min (t, a.next[i] * a.period[i]);
  for (int i = 0; i < a.np; i++)
    if (a.sender[i] > 0)
      t = gs_min (t, a.when[i]);
  return t;
}

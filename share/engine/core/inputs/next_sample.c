/* gs_next_sample: the next time at which a sampled device acts or gives out. */
#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

gs_real
gs_next_sample (int nv, int *is, gs_real *rs)
{
  gs_samples a = gs_samples_of (nv, is, rs);
  gs_real t = GS_HUGE;
  for (int i = 0; i < a.nc; i++)
    t = gs_min (t, (gs_real)a.next[i] * a.period[i]);
  for (int i = 0; i < a.np; i++)
    if (a.sender[i] > 0)
      t = gs_min (t, a.when[i]);
  return t;
}

#include "gsmbp/arith.h"
#include "gsmbp/loops.h"

void
gs_normalize_sets (int ns, const int *iset, gs_real *q, gs_real *err)
{
  for (int k = 0; k < ns; k++, iset += 4)
    {
      gs_real *p[4];
      for (int i = 0; i < 4; i++)
        p[i] = q + iset[i] - 1;
      const gs_real s = gs_sqrt (*p[0] * *p[0] + *p[1] * *p[1] + *p[2] * *p[2] + *p[3] * *p[3]);
      *err = gs_max (*err, gs_abs (s - 1));
      for (int i = 0; i < 4; i++)
        *p[i] /= s;
    }
}

void
gs_normalize_set (gs_real *q, gs_real *err)
{
  const gs_real s = gs_sqrt (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  *err = gs_max (*err, gs_abs (s - 1));
  for (int i = 0; i < 4; i++)
    q[i] /= s;
}

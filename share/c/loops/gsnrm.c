#include "gsmbp/arith.h"
#include "gsmbp/loops.h"

#include <math.h>

void
gsnrm (int ns, const int *iset, double *q, double *err)
{
  for (int k = 0; k < ns; k++, iset += 4)
    {
      double *p[4];
      for (int i = 0; i < 4; i++)
        p[i] = q + iset[i] - 1;
      const double s = sqrt (*p[0] * *p[0] + *p[1] * *p[1] + *p[2] * *p[2] + *p[3] * *p[3]);
      *err = gs_max (*err, fabs (s - 1.0));
      for (int i = 0; i < 4; i++)
        *p[i] /= s;
    }
}

void
gsnrq (double *q, double *err)
{
  const double s = sqrt (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  *err = gs_max (*err, fabs (s - 1.0));
  for (int i = 0; i < 4; i++)
    q[i] /= s;
}

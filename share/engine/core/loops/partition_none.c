#include "gsmbp/loops.h"
#include "gsmbp/system.h"

void
gs_partition_none (int nq, int nu, int nlam, const int *iopt, gs_real *p)
{
  gs_real *rows = gs_partition_of (nq, nu, nlam, p).rows;
  for (int i = 0; i < 24 + 8 * nu + 10 * nq + 7 * nlam + 2 * nlam * nu; i++)
    p[i] = 0;
  if (nlam > 0 && iopt[GS_LOOPS] == 3)
    p[GS_WAY] = 2;
  if (nlam > 0 && iopt[GS_LOOPS] == 6)
    p[GS_WAY] = 1;
  p[GS_DEPENDENT] = -1;
  for (int i = 0; i < nlam; i++)
    rows[i] = 1;
  for (int i = 0; i < iopt[GS_ON_SPEEDS]; i++)
    {
      rows[iopt[6 + i] - 1] = 0;
      p[GS_NONHOLONOMIC] = 1;
    }
}

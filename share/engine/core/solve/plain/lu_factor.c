#include "gsmbp/solve.h"

int
gs_lu_factor (int n, gs_real *a, int lda, int *iw)
{
  return gs_lu_pivoted (n, a, lda, iw);
}

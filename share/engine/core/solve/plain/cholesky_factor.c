#include "gsmbp/solve.h"

int
gs_cholesky_factor (int n, gs_real *a, int lda)
{
  return gs_cholesky (n, a, lda);
}

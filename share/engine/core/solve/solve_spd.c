#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

int
gs_solve_spd (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb)
{
  int info = 0;
  if (n < 0)
    info = -1;
  if (nrhs < 0)
    info = -2;
  if (lda < gs_most (1, n))
    info = -4;
  if (ldb < gs_most (1, n))
    info = -6;
  if (info == 0)
    info = gs_cholesky_factor (n, a, lda);
  if (info != 0)
    return info;
  gs_solve_triangular (n, nrhs, a, lda, b, ldb, 0);
  gs_solve_triangular (n, nrhs, a, lda, b, ldb, 1);
  return 0;
}

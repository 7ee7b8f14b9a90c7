#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

int
gs_solve_reduced (int n, int r, const gs_real *a, int lda, gs_real *b, gs_real *z)
{
  if (r == n)
    return 0;
  gs_real tol = 0;
  for (int j = 0; j < n; j++)
    tol = gs_max (tol, a[j + lda * j]);
  tol = 10 * (gs_real)n * gs_epsilon () * tol;
  int info = gs_solve_spd (n - r, 1, b + r + n * r, n, z + r, n) != 0;
  for (int j = r; j < n; j++)
    if (! (b[j + n * j] * b[j + n * j] > tol))
      info = 1;
  return info;
}

void
gs_symmetric_times (int n, const gs_real *a, int lda, const gs_real *x, gs_real *y)
{
  for (int i = 0; i < n; i++)
    y[i] = 0;
  for (int j = 0; j < n; j++)
    {
      const gs_real *col = a + lda * j;
      gs_real s = x[j], r = col[j] * s;
      for (int i = j + 1; i < n; i++)
        {
          y[i] += col[i] * s;
          r += col[i] * x[i];
        }
      y[j] += r;
    }
}

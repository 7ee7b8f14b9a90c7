#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

void
gs_solve_triangular (int n, int m, const gs_real *l, int ldl, gs_real *b, int ldb, int trans)
{
  for (int i = 0; i < n; i++)
    {
      int k = trans == 0 ? i : n - 1 - i;
      const gs_real *col = l + ldl * k;
      gs_real r = 1 / col[k];
      for (int j = 0; j < m; j++)
        {
          gs_real *x = b + ldb * j;
          if (trans == 0)
            {
              x[k] *= r;
              gs_take (n - k - 1, x[k], col + k + 1, x + k + 1);
            }
          else
            {
              gs_real s = x[k];
              for (int h = k + 1; h < n; h++)
                s -= col[h] * x[h];
              x[k] = s * r;
            }
        }
    }
}

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* U and, below the diagonal, the multipliers of L, whose unit diagonal is not stored. */
int
gs_lu_pivoted (int n, gs_real *a, int lda, int *iw)
{
  for (int k = 0; k < n; k++)
    {
      gs_real *col = a + lda * k;
      gs_real most = gs_abs (col[k]);
      int p = k;
      for (int i = k + 1; i < n; i++)
        if (gs_abs (col[i]) > most)
          {
            most = gs_abs (col[i]);
            p = i;
          }
      iw[k] = p + 1;
      if (! (most > 0))
        return k + 1;
      if (p != k)
        for (int j = 0; j < n; j++)
          gs_swap (1, a + k + lda * j, a + p + lda * j);
      gs_real s = 1 / col[k];
      for (int i = k + 1; i < n; i++)
        col[i] *= s;
      for (int j = k + 1; j < n; j++)
        gs_take (n - k - 1, a[k + lda * j], col + k + 1, a + k + 1 + lda * j);
    }
  return 0;
}

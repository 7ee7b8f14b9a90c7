#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

#include <math.h>

/* U and, below the diagonal, the multipliers of L, whose unit diagonal is not stored. */
int
gslup (int n, double *a, int lda, int *iw)
{
  for (int k = 0; k < n; k++)
    {
      double *col = a + lda * k;
      double most = fabs (col[k]);
      int p = k;
      for (int i = k + 1; i < n; i++)
        if (fabs (col[i]) > most)
          {
            most = fabs (col[i]);
            p = i;
          }
      iw[k] = p + 1;
      if (! (most > 0.0))
        return k + 1;
      if (p != k)
        for (int j = 0; j < n; j++)
          gs_swap (1, a + k + lda * j, a + p + lda * j);
      double s = 1.0 / col[k];
      for (int i = k + 1; i < n; i++)
        col[i] *= s;
      for (int j = k + 1; j < n; j++)
        gs_take (n - k - 1, a[k + lda * j], col + k + 1, a + k + 1 + lda * j);
    }
  return 0;
}

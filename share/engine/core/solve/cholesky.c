#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

/* Column by column; the strict upper triangle is not touched. */
int
gs_cholesky (int n, gs_real *a, int lda)
{
  gs_real eps = (gs_real)n * gs_epsilon ();
  for (int j = 0; j < n; j++)
    {
      gs_real *col = a + lda * j, s = col[j], d = s;
      for (int k = 0; k < j; k++)
        d -= a[j + lda * k] * a[j + lda * k];
      if (! (d > eps * s && d <= GS_HUGE))
        return j + 1;
      d = gs_sqrt (d);
      col[j] = d;
      for (int k = 0; k < j; k++)
        gs_take (n - j - 1, a[j + lda * k], a + j + 1 + lda * k, col + j + 1);
      d = 1 / d;
      for (int i = j + 1; i < n; i++)
        col[i] *= d;
    }
  return 0;
}

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

#include <math.h>

/* Rows of a and b times powers of two, so that the largest entry of a row of a is in [1,2);
 * 0, or the number of the first row that has none or is not finite. */
static int
scale (int n, int nrhs, double *a, int lda, double *b, int ldb)
{
  for (int i = 0; i < n; i++)
    {
      double big = 0.0, s = 1.0;
      for (int j = 0; j < n; j++)
        if (! (fabs (a[i + lda * j]) <= big))
          big = fabs (a[i + lda * j]);
      if (! (big > 1e-300 && big <= 1e300))
        return i + 1;
      while (s * big >= 2.0)
        s *= 0.5;
      while (s * big < 1.0)
        s *= 2.0;
      for (int j = 0; j < n; j++)
        a[i + lda * j] *= s;
      for (int j = 0; j < nrhs; j++)
        b[i + ldb * j] *= s;
    }
  return 0;
}

/* b := inv(P*L*U)*b, one column */
static void
substitute (int n, const double *a, int lda, const int *iw, double *b)
{
  for (int k = 0; k < n; k++)
    gs_swap (1, b + iw[k] - 1, b + k);
  for (int k = 0; k < n; k++)
    gs_take (n - k - 1, b[k], a + k + 1 + lda * k, b + k + 1);
  for (int k = n - 1; k >= 0; k--)
    {
      b[k] /= a[k + lda * k];
      gs_take (k, b[k], a + lda * k, b);
    }
}

/* Gauss elimination with partial pivoting of the scaled matrix. */
int
gsleq (int n, int nrhs, double *a, int lda, double *b, int ldb, int *iw)
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
    info = scale (n, nrhs, a, lda, b, ldb);
  if (info == 0)
    info = gsluf (n, a, lda, iw);
  if (info != 0)
    return info;
  for (int k = 0; k < n; k++)
    if (! (fabs (a[k + lda * k]) > 1e3 * gseps ()))
      return k + 1;
  for (int j = 0; j < nrhs; j++)
    substitute (n, a, lda, iw, b + ldb * j);
  return 0;
}

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

/* Gauss elimination with partial pivoting of the scaled matrix. */
int
gs_solve_general (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw)
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
    info = gs_lu_scaled (n, nrhs, a, lda, b, ldb, iw);
  if (info == 0)
    gs_lu_solution (n, nrhs, a, lda, b, ldb, iw);
  return info;
}

/* the power of two that brings big into [1,2), by way of [1/16,16) */
static gs_real
power (gs_real big)
{
  gs_real s = 1;
  while (s * big >= 16)
    s /= 16;
  while (s * big < GS_R (0.0625))
    s *= 16;
  while (s * big >= 2)
    s *= GS_R (0.5);
  while (s * big < 1)
    s *= 2;
  return s;
}

int
gs_lu_scaled (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw)
{
  for (int i = 0; i < n; i++)
    {
      gs_real big = 0;
      for (int j = 0; j < n; j++)
        if (! (gs_abs (a[i + lda * j]) <= big))
          big = gs_abs (a[i + lda * j]);
      if (! (big > GS_TINY && big <= GS_HUGE))
        return i + 1;
      const gs_real s = power (big);
      for (int j = 0; j < n; j++)
        a[i + lda * j] *= s;
      for (int j = 0; j < nrhs; j++)
        b[i + ldb * j] *= s;
    }
  if (n == 1)
    {
      iw[0] = 1;
      return 0;
    }
  const int info = gs_lu_factor (n, a, lda, iw);
  if (info != 0)
    return info;
  const gs_real tiny = GS_R (1e3) * gs_epsilon ();
  for (int k = 0; k < n; k++)
    if (! (gs_abs (a[k + lda * k]) > tiny))
      return k + 1;
  return 0;
}

/* Columns one by one, of four rows or more four at a time: the same operations. */
void
gs_lu_solution (int n, int nrhs, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw)
{
  if (n == 1)
    for (int j = 0; j < nrhs; j++)
      b[ldb * j] /= a[0];
  else if (n == 2)
    for (int j = 0; j < nrhs; j++, b += ldb)
      {
        const gs_real x = b[iw[0] - 1], y = (b[2 - iw[0]] - a[1] * x) / a[1 + lda];
        b[0] = (x - a[lda] * y) / a[0];
        b[1] = y;
      }
  else if (n == 3)
    gs_lu_three_rows (nrhs, a, lda, b, ldb, iw);
  else
    {
      int j = 0;
      for (; j < nrhs - 3; j += 4)
        gs_lu_four_columns (n, a, lda, b + ldb * j, ldb, iw);
      for (; j < nrhs; j++)
        gs_lu_one_column (n, a, lda, b + ldb * j, iw);
    }
}

void
gs_lu_three_rows (int nrhs, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw)
{
  const gs_real *const a2 = a + lda, *const a3 = a2 + lda;
  int p[3] = { 0, 1, 2 }; /* the rows as they were interchanged */
  for (int k = 0; k < 2; k++)
    {
      const int row = p[iw[k] - 1];
      p[iw[k] - 1] = p[k];
      p[k] = row;
    }
  for (int j = 0; j < nrhs; j++, b += ldb)
    {
      gs_real x = b[p[0]], y = b[p[1]] - a[1] * x, z = b[p[2]] - a[2] * x;
      z = (z - a2[2] * y) / a3[2];
      x -= a3[0] * z;
      y = (y - a3[1] * z) / a2[1];
      b[0] = (x - a2[0] * y) / a[0];
      b[1] = y;
      b[2] = z;
    }
}

void
gs_lu_one_column (int n, const gs_real *a, int lda, gs_real *b, const int *iw)
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

/* four columns: rows i = from ... to - 1 less a[i] times x */
static void
take_four (int from, int to, const gs_real *restrict a, const gs_real *x, gs_real *restrict b,
           int ldb)
{
  const gs_real x0 = x[0], x1 = x[1], x2 = x[2], x3 = x[3];
  for (int i = from; i < to; i++)
    {
      b[i] -= a[i] * x0;
      b[i + ldb] -= a[i] * x1;
      b[i + 2 * ldb] -= a[i] * x2;
      b[i + 3 * ldb] -= a[i] * x3;
    }
}

void
gs_lu_four_columns (int n, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw)
{
  gs_real x[4];
  for (int k = 0; k < n; k++)
    for (int j = 0; j < 4; j++)
      gs_swap (1, b + iw[k] - 1 + ldb * j, b + k + ldb * j);
  for (int k = 0; k < n; k++)
    {
      for (int j = 0; j < 4; j++)
        x[j] = b[k + ldb * j];
      take_four (k + 1, n, a + lda * k, x, b, ldb);
    }
  for (int k = n - 1; k >= 0; k--)
    {
      for (int j = 0; j < 4; j++)
        x[j] = b[k + ldb * j] /= a[k + lda * k];
      take_four (0, k, a + lda * k, x, b, ldb);
    }
}

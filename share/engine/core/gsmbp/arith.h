/* gsmbp/arith.h: what the sources of this folder share: loops over columns, triangular systems. No
 * part of the interface. */
#ifndef GSMBP_ARITH_H
#define GSMBP_ARITH_H

#include <stddef.h>
#include <string.h>

#include "gsmbp/expressions.h"
#include "gsmbp/real.h"

static inline int
gs_most (int a, int b)
{
  return a > b ? a : b;
}

static inline int
gs_least (int a, int b)
{
  return a < b ? a : b;
}

/* y := x; the two do not overlap */
static inline void
gs_copy (int n, const gs_real *x, gs_real *y)
{
  memcpy (y, x, (size_t)n * sizeof *y);
}

/* y := x; the two may overlap */
static inline void
gs_move (int n, const gs_real *x, gs_real *y)
{
  memmove (y, x, (size_t)n * sizeof *y);
}

/* y := 0 */
static inline void
gs_zero (int n, gs_real *y)
{
  memset (y, 0, (size_t)n * sizeof *y);
}

/* s + x'*y, summed from the first entry on */
static inline gs_real
gs_dot (int n, gs_real s, const gs_real *x, const gs_real *y)
{
  for (int i = 0; i < n; i++)
    s += x[i] * y[i];
  return s;
}

/* y := y - s*x; the two do not overlap */
static inline void
gs_take (int n, gs_real s, const gs_real *restrict x, gs_real *restrict y)
{
  for (int i = 0; i < n; i++)
    y[i] -= s * x[i];
}

/* x and y change places */
static inline void
gs_swap (int n, gs_real *x, gs_real *y)
{
  for (int i = 0; i < n; i++)
    {
      gs_real s = x[i];
      x[i] = y[i];
      y[i] = s;
    }
}

/* y (n,m) := H', h (m,n) */
static inline void
gs_transpose (int n, int m, const gs_real *h, int ldh, gs_real *y)
{
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++)
      y[i + n * j] = h[j + ldh * i];
}

/* x of R'*x = P'*g, R the upper triangle of order r in y, P the interchanges piv */
static inline void
gs_forward (int r, const gs_real *y, int ldy, const gs_real *piv, const gs_real *g, gs_real *x)
{
  for (int k = 0; k < r; k++)
    {
      gs_real s = g[(int)piv[k] - 1];
      for (int i = 0; i < k; i++)
        s -= y[i + ldy * k] * x[i];
      x[k] = s / y[k + ldy * k];
    }
}

/* x of R*P'*x = c; c is destroyed */
static inline void
gs_backward (int r, const gs_real *y, int ldy, const gs_real *piv, gs_real *c, gs_real *x)
{
  for (int k = r - 1; k >= 0; k--)
    {
      gs_real s = c[k] / y[k + ldy * k];
      x[(int)piv[k] - 1] = s;
      gs_take (k, s, y + ldy * k, c);
    }
}

#endif

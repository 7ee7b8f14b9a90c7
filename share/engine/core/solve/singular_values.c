#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

/* For two columns x, y of m entries: cosine c and sine s of the rotation that makes them orthogonal
 * with the longer one first; 0 if they are so (to the angle eps, or where the shorter one squared
 * is not above nothing), 1 if it only interchanges the shorter one with one that is nothing, else
 * 2. */
static int
rotation (int m, const gs_real *x, const gs_real *y, gs_real eps, gs_real nothing, gs_real *c,
          gs_real *s)
{
  gs_real p = 0, q = 0, r = 0;
  for (int i = 0; i < m; i++)
    {
      p += x[i] * x[i];
      q += y[i] * y[i];
      r += x[i] * y[i];
    }
  int vanishing = p <= nothing || q <= nothing;
  if (p <= nothing && q <= nothing)
    return 0;
  if (gs_abs (r) <= eps * gs_sqrt (p) * gs_sqrt (q) || vanishing)
    {
      *c = 0;
      *s = 1;
      return q <= p ? 0 : vanishing ? 1 : 2;
    }
  gs_real z = (q - p) / (2 * r);
  gs_real d = gs_copysign (1, z) / (gs_abs (z) + gs_sqrt (1 + z * z));
  gs_real cosine = 1 / gs_sqrt (1 + d * d), sine = -cosine * d;
  *c = q > p ? -sine : cosine;
  *s = q > p ? cosine : sine;
  return 2;
}

/* one cyclic sweep; 0 if nothing was left to turn */
static int
sweep (int m, int n, gs_real *b, int ldb, gs_real *v, int ldv, gs_real eps, gs_real nothing)
{
  int turns = 0;
  gs_real c, s;
  for (int j = 0; j < n - 1; j++)
    for (int k = j + 1; k < n; k++)
      {
        int turn = rotation (m, b + ldb * j, b + ldb * k, eps, nothing, &c, &s);
        if (turn == 0)
          continue;
        turns += turn == 2;
        gs_rotate_plane (m, b + ldb * j, b + ldb * k, c, s);
        gs_rotate_plane (n, v + ldv * j, v + ldv * k, c, s);
      }
  return turns;
}

/* One-sided Jacobi: cyclic sweeps; of two columns the longer one is kept first, so that the
 * vanishing ones gather at the end. A pair is left alone where its angle, or the shorter column
 * beside the longest of all, is nothing to working precision. The last n - rank columns of v are
 * the eigenvectors of B'*B to the eigenvalue zero.
 *
 * Golub, van Loan, Matrix Computations, section 8.6.3. */
void
gs_singular_values (int m, int n, gs_real *b, int ldb, gs_real *v, int ldv, gs_real *s, gs_real tol,
                    int *rank)
{
  gs_real eps = gs_epsilon (), big = 0;
  for (int j = 0; j < n; j++)
    {
      for (int i = 0; i < n; i++)
        v[i + ldv * j] = i == j;
      gs_real p = gs_dot (m, 0, b + ldb * j, b + ldb * j);
      if (p > big)
        big = p;
    }
  for (int k = 0; k < 60; k++)
    if (sweep (m, n, b, ldb, v, ldv, eps, eps * eps * big) == 0)
      break;
  *rank = 0;
  for (int j = 0; j < n; j++)
    {
      s[j] = gs_sqrt (gs_dot (m, 0, b + ldb * j, b + ldb * j));
      if (j < gs_least (m, n) && *rank == j && s[j] > tol * s[0])
        *rank = j + 1;
    }
}

void
gs_rotate_plane (int n, gs_real *x, gs_real *y, gs_real c, gs_real s)
{
  for (int i = 0; i < n; i++)
    {
      gs_real t = c * x[i] + s * y[i];
      y[i] = c * y[i] - s * x[i];
      x[i] = t;
    }
}

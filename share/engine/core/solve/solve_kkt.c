#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

int
gs_solve_kkt (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
              const gs_real *g, gs_real *ud, gs_real *lam, gs_real *w)
{
  int grp[1] = { 0 };
  return gs_solve_kkt_groups (n, m, a, lda, h, ldh, f, g, GS_R (5e4) * gs_epsilon (), grp, ud, lam,
                              w);
}

/* 0, or -i if argument i of gs_solve_kkt_groups is out of range */
static int
range (int n, int m, int lda, int ldh)
{
  int info = 0;
  if (n < 0)
    info = -1;
  if (m < 0)
    info = -2;
  if (lda < gs_most (1, n))
    info = -4;
  if (ldh < gs_most (1, m))
    info = -6;
  return info;
}

/* the lower triangle of l := that of A */
static void
copy_lower (int n, const gs_real *a, int lda, gs_real *l, int ldl)
{
  for (int j = 0; j < n; j++)
    for (int i = j; i < n; i++)
      l[i + ldl * j] = a[i + lda * j];
}

/* whether a pivot of the factor l of A is tiny */
static int
tiny_pivot (int n, const gs_real *a, int lda, const gs_real *l, int ldl)
{
  gs_real small = GS_R (1e4) * (gs_real)n * gs_epsilon ();
  for (int j = 0; j < n; j++)
    if (l[j + ldl * j] * l[j + ldl * j] <= small * a[j + lda * j])
      return 1;
  return 0;
}

/* A = L*L', Y = inv(L)*H' = Q*R with column pivoting; then R'*q = g, R*lam = q - Q'*inv(L)*f and ud
 * follows. Y'*Y, whose condition is the square of that of Y, is never formed. Dependent constraints
 * are left out of ud; lam is then the multiplier of least norm.
 *
 * Where a pivot of L is tiny, A is replaced by A + H'*D*H and f by f + H'*D*g, which has the same
 * solution: D is diagonal, of the size of A. Where constraints are dependent as well, g may not fit
 * all of them: lam then follows from ud and A, f alone (gs_least_multipliers). */
int
gs_solve_kkt_groups (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                     const gs_real *f, const gs_real *g, gs_real tol, const int *grp, gs_real *ud,
                     gs_real *lam, gs_real *w)
{
  int info = range (n, m, lda, ldh);
  if (info != 0)
    return info;
  gs_real *l = w, *y = l + n * n, *t = y + n * m, *z = t + m * m, *piv = z + 2 * n, *beta = piv + m,
         *siz = beta + m, *c = siz + m, *q = c + m;
  int ld = gs_most (1, n), r = 0;
  for (int j = 0; j < n; j++)
    {
      ud[j] = 0;
      z[j] = f[j];
    }
  for (int j = 0; j < m; j++)
    lam[j] = 0;

  /* A = L*L' */
  copy_lower (n, a, lda, l, ld);
  info = gs_cholesky_factor (n, l, ld);
  int tiny = info != 0 || tiny_pivot (n, a, lda, l, ld);
  if (tiny && gs_kkt_augmented (n, m, a, lda, h, ldh, g, grp, l, ld, z, y, siz, info) != 0)
    return 1;

  /* z = Q'*inv(L)*f, Y = inv(L)*H' = Q*R */
  gs_transpose (n, m, h, ldh, y);
  gs_solve_triangular (n, 1, l, ld, z, ld, 0);
  if (m > 0)
    {
      gs_solve_triangular (n, m, l, ld, y, ld, 0);
      gs_qr_groups (n, m, y, ld, tol, grp, piv, beta, siz, &r);
      gs_qr_times (n, r, y, ld, beta, z, 1);
    }

  /* R'*q = g, c = q - z; ud = inv(L')*Q*(q, the rest of z) */
  gs_forward (r, y, n, piv, g, q);
  for (int k = 0; k < r; k++)
    {
      c[k] = q[k] - z[k];
      z[k] = q[k];
    }
  if (m > 0)
    gs_qr_times (n, r, y, ld, beta, z, 0);
  gs_solve_triangular (n, 1, l, ld, z, ld, 1);
  for (int i = 0; i < n; i++)
    ud[i] = z[i];

  if (r == m)
    {
      gs_backward (r, y, n, piv, c, lam);
      return 0;
    }
  if (tiny)
    gs_least_multipliers (n, m, a, lda, h, ldh, f, tol, grp, ud, lam, w);
  else
    gs_least_norm (m, r, y, ld, piv, c, lam, t, q, beta, siz);
  return 2;
}

/* the worst pivot of the factor l beside the entries diag of the diagonal, at most 1 */
static gs_real
worst_pivot (int n, const gs_real *l, int ldl, const gs_real *diag, int inc)
{
  gs_real worst = 1;
  for (int j = 0; j < n; j++)
    worst = gs_min (worst, l[j + ldl * j] * l[j + ldl * j] / diag[inc * j]);
  return worst;
}

/* D[i]^2 = max(A[j,j])/size[i]^2, the sizes of gs_scaled_rows: a row of rounding errors must not
 * count as a constraint. */
int
gs_kkt_augmented (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                  const gs_real *g, const int *grp, gs_real *l, int ldl, gs_real *z, gs_real *y,
                  gs_real *d, int info)
{
  /* the worst pivot of A alone, the size of A */
  gs_real first = info == 0 ? worst_pivot (n, l, ldl, a, lda + 1) : 0, worst = 0, big = 0;
  for (int j = 0; j < n; j++)
    big = gs_max (big, a[j + lda * j]);
  if (! (big > 0))
    big = 1;

  /* with the constraints */
  copy_lower (n, a, lda, l, ldl);
  gs_scaled_rows (n, m, h, ldh, grp, y, d);
  for (int k = 0; k < m; k++)
    for (int j = 0; j < n; j++)
      {
        gs_real s = big * y[k + m * j];
        z[j] += s * d[k] * g[k];
        for (int i = j; i < n; i++)
          l[i + ldl * j] += s * y[k + m * i];
      }
  for (int j = 0; j < n; j++)
    z[n + j] = l[j + ldl * j];
  if (gs_cholesky_factor (n, l, ldl) == 0)
    worst = worst_pivot (n, l, ldl, z + n, 1);
  if (worst >= first && worst > GS_R (1e2) * (gs_real)n * gs_epsilon ())
    return 0;

  /* they do not help: A alone */
  copy_lower (n, a, lda, l, ldl);
  info = gs_cholesky_factor (n, l, ldl);
  if (info != 0)
    return info;
  for (int k = 0; k < m; k++)
    for (int j = 0; j < n; j++)
      z[j] -= big * y[k + m * j] * d[k] * g[k];
  return 0;
}

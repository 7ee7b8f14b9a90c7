#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* c := sign*Q'*(A*x - f), Q the reflections in y and beta */
static void
rest (int n, int r, const gs_real *a, int lda, const gs_real *x, const gs_real *f, const gs_real *y,
      const gs_real *beta, gs_real sign, gs_real *c)
{
  gs_symmetric_times (n, a, lda, x, c);
  for (int i = 0; i < n; i++)
    c[i] = sign * (c[i] - f[i]);
  gs_qr_times (n, r, y, n, beta, c, 1);
}

/* H'*P = Q*R, Q = (Q1,Q2), K = Q2; with ud = Q*(x,z): R1'*x = P'*g, and
 * R*P'*lam = Q1'*(A*ud - f). */
int
gs_solve_null_space (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                     const gs_real *f, const gs_real *g, gs_real tol, const int *grp, gs_real *ud,
                     gs_real *lam, gs_real *w)
{
  gs_real *reduced = w, *y = w + n * n, *c = y + n * m, *x = c + n, *t = x + n, *piv = t + m * m,
         *beta = piv + m, *siz = beta + m, *spare = siz + m;
  int r;
  gs_transpose (n, m, h, ldh, y);
  gs_qr_groups (n, m, y, n, tol, grp, piv, beta, siz, &r);

  /* x, and c = Q'*(f - A*Q1*x) */
  gs_forward (r, y, n, piv, g, x);
  for (int i = r; i < n; i++)
    x[i] = 0;
  for (int i = 0; i < n; i++)
    ud[i] = x[i];
  gs_qr_times (n, r, y, n, beta, ud, 0);
  rest (n, r, a, lda, ud, f, y, beta, -1, c);

  /* the reduced equations */
  for (int j = r; j < n; j++)
    {
      for (int i = 0; i < n; i++)
        ud[i] = i == j;
      gs_qr_times (n, r, y, n, beta, ud, 0);
      gs_symmetric_times (n, a, lda, ud, reduced + n * j);
      gs_qr_times (n, r, y, n, beta, reduced + n * j, 1);
    }
  if (gs_solve_reduced (n, r, a, lda, reduced, c) != 0)
    return 1;
  for (int i = 0; i < n; i++)
    ud[i] = i < r ? x[i] : c[i];
  gs_qr_times (n, r, y, n, beta, ud, 0);

  /* multipliers */
  rest (n, r, a, lda, ud, f, y, beta, 1, c);
  if (r == m)
    {
      gs_backward (r, y, n, piv, c, lam);
      return 0;
    }
  gs_least_norm (m, r, y, n, piv, c, lam, t, spare, beta, siz);
  return 2;
}

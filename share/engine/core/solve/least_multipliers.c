#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

void
gs_least_multipliers (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                      const gs_real *f, gs_real tol, const int *grp, const gs_real *ud,
                      gs_real *lam, gs_real *w)
{
  gs_real *y = w, *c = y + n * m, *t = c + n, *piv = t + m * m, *beta = piv + m, *siz = beta + m,
         *q = siz + m;
  int r;
  gs_symmetric_times (n, a, lda, ud, c);
  for (int i = 0; i < n; i++)
    c[i] -= f[i];
  gs_transpose (n, m, h, ldh, y);
  gs_qr_groups (n, m, y, n, tol, grp, piv, beta, siz, &r);
  gs_qr_times (n, r, y, n, beta, c, 1);
  gs_least_norm (m, r, y, n, piv, c, lam, t, q, beta, siz);
}

/* A size that is nothing to working precision beside the largest is replaced by that. */
void
gs_scaled_rows (int n, int m, const gs_real *h, int ldh, const int *grp, gs_real *y, gs_real *d)
{
  gs_real tol = GS_R (1e2) * gs_epsilon (), big = 0;
  for (int i = 0; i < m; i++)
    {
      gs_real s = 0;
      for (int j = 0; j < n; j++)
        s += h[i + ldh * j] * h[i + ldh * j];
      d[i] = gs_sqrt (s);
      big = gs_max (big, d[i]);
    }
  gs_group_sizes (m, grp, GS_R (1e-3), d);
  if (! (big > 0))
    big = 1;
  for (int i = 0; i < m; i++)
    {
      d[i] = 1 / (d[i] <= tol * big ? big : d[i]);
      for (int j = 0; j < n; j++)
        y[i + m * j] = d[i] * h[i + ldh * j];
    }
}

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* the reduced equations: K'*A*K in the rows and columns of b from r on, K'*z in x; c (n) is
 * workspace */
static void
reduce (int n, int r, const gs_real *a, int lda, const gs_real *v, const gs_real *z, gs_real *c,
        gs_real *b, gs_real *x)
{
  for (int j = r; j < n; j++)
    {
      gs_symmetric_times (n, a, lda, v + n * j, c);
      for (int k = j; k < n; k++)
        b[k + n * j] = gs_dot (n, 0, v + n * k, c);
      x[j] = gs_dot (n, 0, v + n * j, z);
    }
}

/* y := y + s*x */
static void
add (int n, gs_real s, const gs_real *x, gs_real *y)
{
  for (int i = 0; i < n; i++)
    y[i] += x[i] * s;
}

/* D*H*V = U*S (D scales the rows), V = (V1,V2) with S2 = 0: p = V1*inv(S1)*U1'*D*g, K = V2, and
 * lam = D*U1*inv(S1)*V1'*(A*ud - f) if the rank is full. */
int
gs_solve_zero_eigenvectors (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                            const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                            gs_real *ud, gs_real *lam, gs_real *w)
{
  /* dh: D*H, then U*S; siz: the singular values and then the reduced right side */
  gs_real *reduced = w, *v = w + n * n, *dh = v + n * n, *c = dh + n * m, *z = c + n, *siz = z + n,
         *d = siz + n;
  int r;
  gs_scaled_rows (n, m, h, ldh, grp, dh, d);
  gs_singular_values (m, n, dh, m, v, n, siz, tol, &r);

  /* p, and f - A*p */
  for (int i = 0; i < n; i++)
    ud[i] = 0;
  for (int j = 0; j < r; j++)
    {
      gs_real s = 0;
      for (int k = 0; k < m; k++)
        s += dh[k + m * j] * d[k] * g[k];
      add (n, s / siz[j] / siz[j], v + n * j, ud);
    }
  gs_symmetric_times (n, a, lda, ud, c);
  for (int i = 0; i < n; i++)
    z[i] = f[i] - c[i];

  reduce (n, r, a, lda, v, z, c, reduced, siz);
  if (gs_solve_reduced (n, r, a, lda, reduced, siz) != 0)
    return 1;
  for (int j = r; j < n; j++)
    add (n, siz[j], v + n * j, ud);

  if (r < m)
    {
      gs_least_multipliers (n, m, a, lda, h, ldh, f, tol, grp, ud, lam, w);
      return 2;
    }
  gs_symmetric_times (n, a, lda, ud, c);
  for (int k = 0; k < m; k++)
    lam[k] = 0;
  for (int j = 0; j < r; j++)
    {
      gs_real s = 0;
      for (int i = 0; i < n; i++)
        s += v[i + n * j] * (c[i] - f[i]);
      s = s / siz[j] / siz[j];
      for (int k = 0; k < m; k++)
        lam[k] += dh[k + m * j] * s * d[k];
    }
  return 0;
}

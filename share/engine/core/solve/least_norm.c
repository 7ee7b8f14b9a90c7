#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* R1' = Q2*R2, P'*lam = Q2*inv(R2')*c. */
void
gs_least_norm (int m, int r, const gs_real *y, int ldy, const gs_real *piv, const gs_real *c,
               gs_real *lam, gs_real *t, gs_real *q, gs_real *beta, gs_real *s)
{
  int lm = gs_most (1, m), r2;
  for (int k = 0; k < m; k++)
    lam[k] = 0;
  if (r == 0)
    return;
  for (int j = 0; j < r; j++)
    for (int i = 0; i < m; i++)
      t[i + m * j] = i >= j ? y[j + ldy * i] : 0;
  gs_qr_pivoted (m, r, t, lm, 0, q, beta, s, &r2);
  gs_forward (r, t, m, q, c, s);
  for (int k = r; k < m; k++)
    s[k] = 0;
  gs_qr_times (m, r, t, lm, beta, s, 0);
  for (int k = 0; k < m; k++)
    lam[(int)piv[k] - 1] = s[k];
}

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

int
gs_solve_accelerations (int way, int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                        const gs_real *f, const gs_real *g, gs_real *ud, gs_real *lam, gs_real *w)
{
  int grp[1] = { 0 };
  return gs_solve_accelerations_groups (way, n, m, a, lda, h, ldh, f, g, GS_R (5e4) * gs_epsilon (),
                                        grp, ud, lam, w);
}

/* Ways 2, 3, 4: ud = p + K*z, H*K = 0, H*p = g; K'*A*K*z = K'*(f - A*p). lam is the solution of
 * least norm of H'*lam = A*ud - f. A may be semidefinite as long as K'*A*K is definite. 3 and 4
 * divide the rows of H by their sizes first.
 *
 * 1 Ju and Hsu 1991, (25).
 * 2 Kim and Vanderploeg 1986, QR decomposition for state space representation of constrained
 *   mechanical dynamic systems.
 * 3 Walton and Steeves 1969, a new matrix theorem and its application for establishing independent
 *   coordinates.
 * 4 Kane and Levinson 1985, Dynamics, sections 2.13 and 4.4. */
int
gs_solve_accelerations_groups (int way, int n, int m, const gs_real *a, int lda, const gs_real *h,
                               int ldh, const gs_real *f, const gs_real *g, gs_real tol,
                               const int *grp, gs_real *ud, gs_real *lam, gs_real *w)
{
  int info = 0;
  if (way < 1 || way > 4)
    info = -1;
  if (n < 0)
    info = -2;
  if (m < 0)
    info = -3;
  if (lda < gs_most (1, n))
    info = -5;
  if (ldh < gs_most (1, m))
    info = -7;
  if (info != 0)
    return info;
  if (way == 1 || n == 0 || m == 0)
    info = gs_solve_kkt_groups (n, m, a, lda, h, ldh, f, g, tol, grp, ud, lam, w);
  else if (way == 2)
    info = gs_solve_null_space (n, m, a, lda, h, ldh, f, g, tol, grp, ud, lam, w);
  else if (way == 3)
    info = gs_solve_zero_eigenvectors (n, m, a, lda, h, ldh, f, g, tol, grp, ud, lam, w);
  else
    info = gs_solve_dependent_speeds (n, m, a, lda, h, ldh, f, g, tol, grp, ud, lam, w);
  if (info == 1)
    {
      for (int i = 0; i < n; i++)
        ud[i] = 0;
      for (int i = 0; i < m; i++)
        lam[i] = 0;
    }
  return info;
}

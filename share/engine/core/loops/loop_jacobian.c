#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

int
gs_loop_jacobian (int nu, int nlam, int nq, int nz, const gs_real *lm, const gs_real *lb,
                  const gs_real *lc, gs_real *k, gs_real *z, int *iw, int info)
{
  const int n = nu + nlam;
  for (int j = 0; j < nq; j++)
    for (int i = 0; i < nu; i++)
      z[i + n * j] -= lc[i + nu * j];
  for (int j = 0; j < nu; j++)
    for (int i = 0; i < nu; i++)
      {
        k[i + n * j] = lm[i + nu * j];
        z[i + n * (nq + j)] -= lb[i + nu * j];
      }
  if (info == 2)
    return info;
  info = gs_lu_scaled (n, nz, k, n, z, n, iw);
  if (info == 0)
    gs_lu_solution (n, nz, k, n, z, n, iw);
  return info;
}

int
gs_loop_jacobian_deficient (int nu, int nlam, int nz, const gs_real *lm, const gs_real *h,
                            const gs_real *phi, const int *grp, gs_real *z, gs_real *hc,
                            gs_real *ud, gs_real *lam, gs_real *w)
{
  gs_real tol;
  gs_rank_tolerance (nu, nlam, h, nlam, phi, grp, &tol, w);
  gs_copy (nlam * nu, h, hc);
  for (int j = 0; j < nz; j++, z += nu + nlam)
    {
      if (gs_solve_accelerations_groups (1, nu, nlam, lm, nu, hc, nlam, z, z + nu, tol, grp, ud,
                                         lam, w)
          == 1)
        return 1;
      gs_copy (nu, ud, z);
      gs_copy (nlam, lam, z + nu);
    }
  return 0;
}

void
gs_rate_rows (int nu, int nq, int nx, int nv, int quasi, const gs_real *z, int ldz, gs_real *a,
              int lda, gs_real *b, int ldb)
{
  for (int j = 0; j < nx; j++)
    gs_copy (nu, z + ldz * j, a + nq + lda * j);
  for (int j = 0; j < nv; j++)
    gs_copy (nu, z + ldz * (nx + j), b + nq + ldb * j);
  if (quasi == 1)
    return;
  for (int i = 0; i < nu; i++)
    {
      for (int j = 0; j < nx; j++)
        a[i + lda * j] = 0;
      a[i + lda * (nu + i)] = 1;
      for (int j = 0; j < nv; j++)
        b[i + ldb * j] = 0;
    }
}

/* few rows along them, many down the columns */
void
gs_rate_rows_through (int nr, int nl, int nz, const gs_real *by, int ldb, const gs_real *z, int ldz,
                      gs_real *a, int lda)
{
  if (nr < gs_least (nz, 6))
    for (int i = 0; i < nr; i++)
      for (int l = 0; l < nl; l++)
        for (int j = 0; j < nz; j++)
          a[i + lda * j] += by[i + ldb * l] * z[l + ldz * j];
  else
    for (int j = 0; j < nz; j++)
      for (int l = 0; l < nl; l++)
        for (int i = 0; i < nr; i++)
          a[i + lda * j] += by[i + ldb * l] * z[l + ldz * j];
}

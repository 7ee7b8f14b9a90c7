#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

#include <string.h>

int
gsjac (int nu, int nlam, int nq, int nz, const double *lm, const double *lb, const double *lc,
       double *k, double *z, int *iw, int info)
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
  info = gslqf (n, nz, k, n, z, n, iw);
  if (info == 0)
    gslqs (n, nz, k, n, z, n, iw);
  return info;
}

int
gsjdf (int nu, int nlam, int nz, const double *lm, const double *h, const double *phi,
       const int *grp, double *z, double *hc, double *ud, double *lam, double *w)
{
  double tol;
  gsrtl (nu, nlam, h, nlam, phi, grp, &tol, w);
  memcpy (hc, h, nlam * nu * sizeof (double));
  for (int j = 0; j < nz; j++, z += nu + nlam)
    {
      if (gsacr (1, nu, nlam, lm, nu, hc, nlam, z, z + nu, tol, grp, ud, lam, w) == 1)
        return 1;
      memcpy (z, ud, nu * sizeof (double));
      memcpy (z + nu, lam, nlam * sizeof (double));
    }
  return 0;
}

void
gsjrw (int nu, int nq, int nx, int nv, int quasi, const double *z, int ldz, double *a, int lda,
       double *b, int ldb)
{
  for (int j = 0; j < nx; j++)
    memcpy (a + nq + lda * j, z + ldz * j, nu * sizeof (double));
  for (int j = 0; j < nv; j++)
    memcpy (b + nq + ldb * j, z + ldz * (nx + j), nu * sizeof (double));
  if (quasi == 1)
    return;
  for (int i = 0; i < nu; i++)
    {
      for (int j = 0; j < nx; j++)
        a[i + lda * j] = 0.0;
      a[i + lda * (nu + i)] = 1.0;
      for (int j = 0; j < nv; j++)
        b[i + ldb * j] = 0.0;
    }
}

/* few rows along them, many down the columns */
void
gsjth (int nr, int nl, int nz, const double *by, int ldb, const double *z, int ldz, double *a,
       int lda)
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

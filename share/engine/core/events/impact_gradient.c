/* gs_impact_gradient, gs_impact_columns: derivatives of what happens at an event. */
#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/solve.h"

int
gs_impact_takes_part (int i, int k, const int *kind, const int *ma)
{
  return i == k || (kind[i - 1] == 2 && ma[i - 1] != 0)
         || (kind[i - 1] == 1 && ma[i - 1] == 0 && k < 0);
}

void
gs_impact_matrix (int nu, int nlam, int nh, int k, const int *kind, const int *ma,
                  const gs_real *row, const gs_real *a, const gs_real *h, gs_real *c)
{
  const int n = nu + nlam + nh;
  gs_zero (n * n, c);
  for (int j = 0; j < nu; j++)
    {
      gs_copy (nu, a + nu * j, c + n * j);
      for (int i = 0; i < nlam + nh; i++)
        if (i < nlam || gs_impact_takes_part (i - nlam + 1, k, kind, ma))
          {
            const gs_real x = i < nlam ? h[i + nlam * j] : row[i - nlam + nh * j];
            c[nu + i + n * j] = x;
            c[j + n * (nu + i)] = -x;
          }
    }
  for (int i = 0; i < nh; i++)
    if (! gs_impact_takes_part (i + 1, k, kind, ma))
      c[(n + 1) * (nu + nlam + i)] = 1;
}

int
gs_impact_gradient (int nq, int nu, int nlam, int nh, int nc, int k, const int *kind,
                    const int *mode, const int *ma, const gs_real *s, const gs_real *sd,
                    const gs_real *prm, const gs_real *x, const gs_real *ua, const gs_real *row,
                    const gs_real *a, const gs_real *h, const gs_real *phit, gs_real *c, gs_real *p,
                    gs_real *ud, int *iw, gs_real *r, int *hit)
{
  const int n = nu + nlam + nh;
  gs_zero (nu * nc, r);
  for (int i = 0; i < nu; i++)
    r[i + nu * (nq + i)] = 1;
  *hit = -1;
  if (k == 0)
    return 0;
  if (k > 0)
    {
      const gs_real *const q = prm + 4 * (k - 1);
      const gs_real side = q[1] - s[k - 1] < s[k - 1] - q[0] ? 1 : -1;
      if (kind[k - 1] == 1 || mode[k - 1] != 0 || side * sd[k - 1] <= 0)
        return 0;
    }
  int rows = nlam;
  for (int i = 0; i < nh; i++)
    rows += gs_impact_takes_part (i + 1, k, kind, ma);
  if (rows == 0)
    return 0;
  *hit = gs_most (0, k);
  gs_impact_matrix (nu, nlam, nh, k, kind, ma, row, a, h, c);
  gs_zero (n, p);
  for (int i = nu; i < n; i++)
    {
      if (i < nu + nlam)
        p[i] = -phit[i - nu];
      if (*hit > 0 && i == nu + nlam + *hit - 1 && ma[*hit - 1] == 0)
        p[i] = -prm[2 + 4 * (*hit - 1)] * sd[*hit - 1];
      for (int j = 0; j < nu; j++)
        p[i] -= c[i + n * j] * x[nq + j];
    }
  const int info = gs_solve_general (n, 1, c, n, p, n, iw) == 0 ? 0 : 2;
  gs_move (nlam + nh, p + nu, p);
  for (int i = 0; i < nu; i++)
    ud[i] = ua[i] - x[nq + i];
  return info;
}

int
gs_impact_columns (int nq, int nu, int nlam, int nxv, int nh, int np, int hit, int k,
                   const int *kind, const int *ma, const gs_real *sd, const gs_real *prm,
                   const gs_real *row, const gs_real *a, const gs_real *h, const gs_real *d,
                   const gs_real *e, gs_real *c, gs_real *b, int *iw, gs_real *r)
{
  const int n = nu + nlam + nh, nc = nq + nu + np + 1;
  for (int j = 0; j < nc; j++)
    {
      const int behind = j >= nq + nu, je = behind ? j - nu : j,
                jd = behind ? j - nq - nu + nxv : j;
      gs_real *const bj = b + n * j;
      for (int i = 0; i < n; i++)
        bj[i] = j < nq || behind ? -e[i + n * je] : i < nu ? a[i + nu * (j - nq)] : 0;
      for (int i = 0; i < nh; i++)
        if (! gs_impact_takes_part (i + 1, k, kind, ma))
          bj[nu + nlam + i] = 0;
      const int h6 = 6 * (hit - 1 + nh * jd);
      if (hit > 0 && ma[hit - 1] == 0)
        bj[nu + nlam + hit - 1] -= prm[2 + 4 * (hit - 1)] * d[h6 + 1] + sd[hit - 1] * d[h6 + 4];
    }
  gs_impact_matrix (nu, nlam, nh, k, kind, ma, row, a, h, c);
  if (gs_solve_general (n, nc, c, n, b, n, iw) != 0)
    return 2;
  for (int j = 0; j < nc; j++)
    gs_copy (nu, b + n * j, r + nu * j);
  return 0;
}

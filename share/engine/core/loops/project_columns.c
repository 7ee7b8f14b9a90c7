/* gs_project_columns: the derivatives S of states by parameters, behind the states as in
 * gs_rates_with_columns, onto the derivatives of the constraints:
 *    DP*SQ + dphi/dp = 0,  HC*SU + DV*SQ + d(HC*u + phit)/dp = 0,
 * and Euler parameters keep their norm: q'*SQ = 0. */
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

/* the right sides of the coordinates, n rows; pp: of the constraints by parameters */
static void
of_positions (int n, int nlam, int nc, const int *col, const gs_real *pp, gs_real *r)
{
  for (int k = 0; k < nc; k++)
    for (int i = 0; i < n; i++)
      r[i + n * k] = i < nlam && col[k] > 0 ? pp[i + nlam * (col[k] - 1)] : 0;
}

/* those of the speeds; pv: of the rates of the constraints by parameters; dv: by coordinates */
static void
of_speeds (int nlam, int nq, int nx, int nc, const int *col, const gs_real *pv, const gs_real *dv,
           const gs_real *x, gs_real *r)
{
  for (int k = 0; k < nc; k++)
    for (int i = 0; i < nlam; i++)
      {
        gs_real *e = r + i + nlam * k;
        *e = col[k] > 0 ? pv[i + nlam * (col[k] - 1)] : 0;
        for (int j = 0; j < nq; j++)
          *e += dv[i + nlam * j] * x[j + nx * (k + 1)];
      }
}

int
gs_project_columns (const gs_scene *s, gs_real t, int ns, const int *iset, int np, int nc,
                    const int *col, gs_real *x, const gs_real *cst, gs_real *w, int *iw)
{
  const int nx = s->nx, nq = s->nq, nu = s->nu, nlam = s->nlam, n = nlam + ns;
  /* rows by coordinates, their squares, right sides; rates by coordinates, by speeds; by
     parameters; what con leaves */
  gs_real *const d = w, *const g = d + n * nq, *const r = g + n * n, *const dv = r + n * nc,
         *const h = dv + nlam * nq, *const pp = h + nlam * nu, *const pv = pp + nlam * np,
         *const f = pv + nlam * np;
  int info = 0;
  for (int i = 0; i < n * nq; i++)
    d[i] = 0;
  if (nlam > 0)
    {
      info = s->con (t, x, x + nq, cst, f, f + nlam, h, nlam, f + 2 * nlam);
      if (info != 0)
        return info == 2 ? 9 : info;
      s->tan (t, x, cst, d, n, dv, nlam);
      s->cop (t, x, cst, pp, nlam, pv, nlam);
    }
  for (int k = 0; k < ns; k++)
    for (int j = 0; j < 4; j++)
      {
        const int place = iset[j + 4 * k] - 1;
        d[nlam + k + n * place] = x[place];
      }
  of_positions (n, nlam, nc, col, pp, r);
  info = gs_columns_onto (n, nq, nc, d, n, x + nx, nx, r, n, g, iw);
  if (info != 0 || nlam == 0)
    return info;
  of_speeds (nlam, nq, nx, nc, col, pv, dv, x, r);
  return gs_columns_onto (nlam, nu, nc, h, nlam, x + nx + nq, nx, r, nlam, g, iw);
}

int
gs_columns_onto (int m, int n, int nc, const gs_real *d, int ldd, gs_real *y, int ldy, gs_real *r,
                 int ldr, gs_real *g, int *iw)
{
  for (int i = 0; i < m; i++)
    {
      for (int j = 0; j < m; j++)
        {
          g[i + m * j] = 0;
          for (int k = 0; k < n; k++)
            g[i + m * j] += d[i + ldd * k] * d[j + ldd * k];
        }
      const int none = g[i + m * i] <= 0;
      for (int k = 0; k < nc; k++)
        {
          gs_real *e = r + i + ldr * k;
          *e = -*e;
          for (int j = 0; j < n; j++)
            *e -= d[i + ldd * j] * y[j + ldy * k];
          if (none)
            *e = 0;
        }
      if (none)
        g[i + m * i] = 1;
    }
  if (gs_solve_general (m, nc, g, m, r, ldr, iw) != 0)
    return 9;
  for (int k = 0; k < nc; k++)
    for (int i = 0; i < n; i++)
      for (int j = 0; j < m; j++)
        y[i + ldy * k] += d[j + ldd * i] * r[j + ldr * k];
  return 0;
}

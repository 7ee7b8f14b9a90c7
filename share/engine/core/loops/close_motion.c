/* gs_close_motion. Positions: Newton's method on the dependent coordinates, at most 60 steps, until
 * |phi| falls no more (below 1e-11) or is 0; above 1e-9 at the end the loops do not close.
 * Derivatives of order 1, 2, ...: one linear system, factored once, with other right sides. */
#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

int
gs_close_motion (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id, const int *ia,
                 const gs_real *cst, gs_real *res, gs_real *w, int *iw)
{
  const int nu = s->nu, m = s->nlam;
  gs_real *const h = w + m * m, *const p = h + m * nu, *const pt = p + m, *const g = pt + m,
         *const size = g + m;
  int info = gs_close_positions (s, t, qj, id, cst, res, w, h, p, pt, g, iw);
  return info != 0 ? info
                   : gs_close_derivatives (s, t, qj, r, id, ia, cst, w, h, p, pt, g, size, iw);
}

int
gs_close_positions (const gs_scene *s, gs_real t, gs_real *qj, const int *id, const gs_real *cst,
                    gs_real *res, gs_real *m, gs_real *h, gs_real *p, gs_real *pt, gs_real *g,
                    int *iw)
{
  const int n = s->nlam;
  gs_real old = 0;
  for (int k = 0;; k++)
    {
      int info = s->con (t, qj, qj + s->nu, cst, p, pt, h, n, g);
      if (info != 0)
        return info;
      if (k == 60)
        return *res > GS_R2 (1e-9, 1e-4) ? 2 : 0;
      *res = 0;
      for (int i = 0; i < n; i++)
        *res = gs_max (*res, gs_abs (p[i]));
      if (*res <= 0 || (k > 1 && *res >= old && *res <= GS_R2 (1e-11, 1e-5)))
        return 0;
      old = *res;
      gs_close_matrix (n, id, h, m);
      if (gs_solve_general (n, 1, m, n, p, n, iw) != 0)
        return 1;
      for (int i = 0; i < n; i++)
        qj[id[i] - 1] -= p[i];
    }
}

/* of order k from HC_dep*x_dep = right - HC_ind*x_ind */
int
gs_close_derivatives (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id,
                      const int *ia, const gs_real *cst, gs_real *m, gs_real *h, gs_real *p,
                      gs_real *pt, gs_real *g, gs_real *size, int *iw)
{
  const int nu = s->nu, n = s->nlam;
  if (r < 1)
    return 0;
  gs_close_matrix (n, id, h, m);
  for (int i = 0; i < n; i++)
    size[i] = 1;
  if (gs_lu_scaled (n, 1, m, n, size, n, iw) != 0)
    return 1;
  for (int k = 1; k <= r; k++)
    {
      gs_real *const qk = qj + nu * k;
      int info = 0;
      if (k == 2)
        info = s->con (t, qj, qj + nu, cst, p, pt, h, n, g);
      if (info != 0)
        return info;
      if (k == 3)
        s->gad (t, qj, cst, g);
      for (int i = 0; i < n; i++)
        {
          p[i] = k == 1 ? -pt[i] : g[i];
          for (int j = 0; j < nu - n; j++)
            p[i] -= h[i + n * (ia[j] - 1)] * qk[ia[j] - 1];
          p[i] *= size[i];
        }
      gs_lu_solution (n, 1, m, n, p, n, iw);
      for (int i = 0; i < n; i++)
        qk[id[i] - 1] = p[i];
    }
  return 0;
}

void
gs_close_matrix (int nlam, const int *id, const gs_real *h, gs_real *m)
{
  for (int j = 0; j < nlam; j++)
    gs_copy (nlam, h + nlam * (id[j] - 1), m + nlam * j);
}

/* gs_project: Newton's method M*dx = H'*lam, H*dx = -phi (gs_solve_kkt), at most 50 steps, none
 * longer than 0.5 rad or m, until |phi| is below 4 epsilon or falls no more (below 1e-11); above
 * 1e-9 at the end there is no such position. Then one such step for the speeds. */
#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

int
gs_project (const gs_scene *s, gs_real t, gs_real *x, int quasi, int ns, const int *iset,
            const gs_real *cst, gs_real *res, gs_real *w)
{
  const int nq = s->nq, nu = s->nu, m = s->nlam;
  gs_real *const h = w + nu * nu, *const p = h + m * nu, *const pt = p + m, *const g = pt + m,
         *const f = g + m, *const dx = f + nu, *const lam = dx + nu, *const q = lam + m,
         *const u = q + nq, *const dq = u + nu, *const ww = dq + nq;
  *res = 0;
  gs_normalize_sets (ns, iset, x, res);
  gs_copy (nq, x, q);
  gs_copy (nu, x + nq, u);
  int info = gs_project_position (s, t, q, u, quasi, ns, iset, cst, res, w, h, p, pt, g, f, dx, lam,
                                  ww, dq);
  if (info == 0)
    info = gs_project_speeds (s, t, q, u, cst, w, h, p, pt, f, dx, lam, ww);
  if (info != 0)
    return info;
  gs_copy (nq, q, x);
  for (int i = 0; i < nu; i++)
    x[nq + i] = u[i] + dx[i];
  return 0;
}

/* q by the step dx; one of more than half a radian (or metre) is shortened */
static void
move (const gs_scene *s, gs_real t, gs_real *q, const gs_real *dx, int quasi, const gs_real *cst,
      gs_real *dq)
{
  gs_real r = GS_R (0.5);
  for (int i = 0; i < s->nu; i++)
    r = gs_max (r, gs_abs (dx[i]));
  if (quasi == 1)
    {
      s->kin (t, q, dx, cst, dq);
      dx = dq;
    }
  for (int i = 0; i < s->nq; i++)
    q[i] += dx[i] * (GS_R (0.5) / r);
}

int
gs_project_position (const gs_scene *s, gs_real t, gs_real *q, const gs_real *u, int quasi, int ns,
                     const int *iset, const gs_real *cst, gs_real *res, gs_real *a, gs_real *h,
                     gs_real *p, gs_real *pt, gs_real *g, gs_real *f, gs_real *dx, gs_real *lam,
                     gs_real *w, gs_real *dq)
{
  const int nu = s->nu, m = s->nlam;
  gs_real old = 0, err = 0;
  for (int i = 0; i < nu; i++)
    f[i] = 0;
  for (int k = 1; k <= 50; k++)
    {
      int info = s->con (t, q, u, cst, p, pt, h, m, g);
      if (info != 0)
        return info;
      gs_real r = 0;
      for (int i = 0; i < m; i++)
        {
          r = gs_max (r, gs_abs (p[i]));
          p[i] = -p[i];
        }
      if (k == 1)
        *res = gs_max (*res, r);
      if (r <= 4 * gs_epsilon () || (k > 2 && r >= old && r <= GS_R2 (1e-11, 1e-5)))
        return 0;
      old = r;
      s->mas (t, q, cst, a, nu);
      info = gs_solve_kkt (nu, m, a, nu, h, m, f, p, dx, lam, w);
      if (info == 1)
        return info;
      move (s, t, q, dx, quasi, cst, dq);
      gs_normalize_sets (ns, iset, q, &err);
    }
  return old > GS_R2 (1e-9, 1e-4) ? 3 : 0;
}

int
gs_project_speeds (const gs_scene *s, gs_real t, const gs_real *q, const gs_real *u,
                   const gs_real *cst, gs_real *a, const gs_real *h, gs_real *p, const gs_real *pt,
                   const gs_real *f, gs_real *dx, gs_real *lam, gs_real *w)
{
  const int nu = s->nu, m = s->nlam;
  s->mas (t, q, cst, a, nu);
  for (int i = 0; i < m; i++)
    {
      p[i] = -pt[i];
      for (int j = 0; j < nu; j++)
        p[i] -= h[i + m * j] * u[j];
    }
  return gs_solve_kkt (nu, m, a, nu, h, m, f, p, dx, lam, w) == 1;
}

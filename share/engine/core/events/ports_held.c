#include "gsmbp/arith.h"
#include "gsmbp/events.h"

void
gs_ports_held (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *v, const int *mode,
               const gs_real *cst, int nh, const int *kind, const int *ipl, gs_real *vm,
               gs_real *ud, gs_real *lam, gs_real *hold, gs_real *row, gs_real *pos, gs_real *sd,
               gs_real *prm)
{
  int held = 0;
  gs_copy (s->nv, v, vm);
  for (int i = 0; i < nh; i++)
    {
      vm[ipl[i] - 1] = (gs_real)mode[i];
      hold[i] = 0;
      held |= (kind[i] == 2 && mode[i] != 0) || (kind[i] == 1 && mode[i] == 0);
    }
  if (held)
    s->stk (t, x, vm, cst, ud, lam, hold);
  s->hld (t, x, vm, cst, row, nh, pos, sd, prm);
}

int
gs_impact (const gs_scene *s, gs_real t, gs_real *x, gs_real *v, int *mode, int k,
           const gs_real *cst, int nh, const int *kind, const int *ipl, gs_real *w)
{
  const int nu = s->nu, m = s->nlam, most = gs_most (1, m);
  gs_real *const ud = w + s->nv, *const lam = ud + nu, *const hold = lam + most,
         *const row = hold + nh, *const pos = row + nh * nu, *const sd = pos + nh,
         *const prm = sd + nh, *const a = prm + 4 * nh, *const h = a + nu * nu,
         *const phit = h + (m + nh) * nu, *const u = phit + most, *const ww = u + nu;
  if (k == -3)
    {
      gs_release_port (s, t, x, v, mode, cst, nh, kind, ipl, w, ud, lam, hold, row, pos, sd, prm);
      return 0;
    }
  if (k == -4)
    {
      s->hld (t, x, v, cst, row, nh, pos, sd, prm);
      gs_correct_modes (nu, m, nh, kind, mode, row, pos, sd, prm, x + s->nq);
      return 0;
    }
  if (k == -5)
    return gs_hold_position (s, t, x, v, cst, nh, kind, mode, row, pos, sd, prm, a, h, phit, u, ww);
  gs_ports_held (s, t, x, v, mode, cst, nh, kind, ipl, w, ud, lam, hold, row, pos, sd, prm);
  int info = gs_impact_matrices (s, t, x, cst, nh, row, a, h, phit, u, ww);
  if (info != 0)
    return info;
  info
      = gs_port_reset (nu, m, nh, k, kind, mode, pos, sd, prm, hold, a, nu, h, m + nh, phit, u, ww);
  if (info != 0)
    return info;
  gs_copy (nu, u, x + s->nq);
  for (int i = 0; i < nh; i++)
    v[ipl[i] - 1] = (gs_real)mode[i];
  return 0;
}

int
gs_impact_matrices (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, int nh,
                    const gs_real *row, gs_real *a, gs_real *h, gs_real *phit, gs_real *u,
                    gs_real *w)
{
  const int nq = s->nq, nu = s->nu, m = s->nlam;
  gs_copy (nq, x, w);
  gs_copy (nu, x + nq, u);
  s->mas (t, w, cst, a, nu);
  if (m > 0)
    {
      int info = s->con (t, w, u, cst, w + nq, phit, h, m + nh, w + nq + m);
      if (info != 0)
        return info;
    }
  for (int j = 0; j < nu; j++)
    gs_copy (nh, row + nh * j, h + m + (m + nh) * j);
  return 0;
}

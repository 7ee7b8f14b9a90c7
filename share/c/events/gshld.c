#include "gsmbp/arith.h"
#include "gsmbp/events.h"

#include <string.h>

void
gshld (const gs_scene *s, double t, const double *x, const double *v, const int *mode,
       const double *cst, int nh, const int *kind, const int *ipl, double *vm, double *ud,
       double *lam, double *hold, double *row, double *pos, double *sd, double *prm)
{
  int held = 0;
  memcpy (vm, v, s->nv * sizeof (double));
  for (int i = 0; i < nh; i++)
    {
      vm[ipl[i] - 1] = mode[i];
      hold[i] = 0.0;
      held |= (kind[i] == 2 && mode[i] != 0) || (kind[i] == 1 && mode[i] == 0);
    }
  if (held)
    s->stk (t, x, vm, cst, ud, lam, hold);
  s->hld (t, x, vm, cst, row, nh, pos, sd, prm);
}

int
gsipt (const gs_scene *s, double t, double *x, double *v, int *mode, int k, const double *cst,
       int nh, const int *kind, const int *ipl, double *w)
{
  const int nu = s->nu, m = s->nlam, most = gs_most (1, m);
  double *const ud = w + s->nv, *const lam = ud + nu, *const hold = lam + most,
         *const row = hold + nh, *const pos = row + nh * nu, *const sd = pos + nh,
         *const prm = sd + nh, *const a = prm + 4 * nh, *const h = a + nu * nu,
         *const phit = h + (m + nh) * nu, *const u = phit + most, *const ww = u + nu;
  if (k == -3)
    {
      gsrsf (s, t, x, v, mode, cst, nh, kind, ipl, w, ud, lam, hold, row, pos, sd, prm);
      return 0;
    }
  if (k == -4)
    {
      s->hld (t, x, v, cst, row, nh, pos, sd, prm);
      gsrsm (nu, m, nh, kind, mode, row, pos, sd, prm, x + s->nq);
      return 0;
    }
  if (k == -5)
    return gshpj (s, t, x, v, cst, nh, kind, mode, row, pos, sd, prm, a, h, phit, u, ww);
  gshld (s, t, x, v, mode, cst, nh, kind, ipl, w, ud, lam, hold, row, pos, sd, prm);
  int info = gsipm (s, t, x, cst, nh, row, a, h, phit, u, ww);
  if (info != 0)
    return info;
  info = gsrst (nu, m, nh, k, kind, mode, pos, sd, prm, hold, a, nu, h, m + nh, phit, u, ww);
  if (info != 0)
    return info;
  memcpy (x + s->nq, u, nu * sizeof (double));
  for (int i = 0; i < nh; i++)
    v[ipl[i] - 1] = mode[i];
  return 0;
}

int
gsipm (const gs_scene *s, double t, const double *x, const double *cst, int nh,
       const double *row, double *a, double *h, double *phit, double *u, double *w)
{
  const int nq = s->nq, nu = s->nu, m = s->nlam;
  memcpy (w, x, nq * sizeof (double));
  memcpy (u, x + nq, nu * sizeof (double));
  s->mas (t, w, cst, a, nu);
  if (m > 0)
    {
      int info = s->con (t, w, u, cst, w + nq, phit, h, m + nh, w + nq + m);
      if (info != 0)
        return info;
    }
  for (int j = 0; j < nu; j++)
    memcpy (h + m + (m + nh) * j, row + nh * j, nh * sizeof (double));
  return 0;
}

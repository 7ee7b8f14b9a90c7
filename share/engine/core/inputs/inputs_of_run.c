/* gs_inputs_of_run: the inputs v at time t during a run: constants, a table, a planned motion
 * carried through the actuators, or a routine of the user; with or without linear state feedback
 * along a reference, v = v0(t) - K(t)*(x - x0(t)),
 * within limits where these are given; held outputs of sampled devices; modes of events. */
#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

/* nc components of the polynomial that the four entries of ip describe; info < 0 where it fails */
static int
polynomial (int nc, const int *ip, const gs_real *rp, gs_real t, int side, gs_real *f)
{
  int info = gs_polynomials_at (nc, ip[0], ip[1], rp + ip[2] - 1, rp + ip[3] - 1, t, side, 0, f,
                                gs_most (1, nc));
  return gs_least (0, info);
}

/* v by cmd, from the motion at t */
static int
planned (const gs_scene *s, gs_real t, int side, const gs_real *x, int nx, const int *ip,
         const gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w)
{
  const int r = ip[GS_DERIVATIVES], na = ip[GS_PLANNED], *pl = ip + GS_MOTION;
  const gs_real *brk = rp + pl[2] - 1, *coef = rp + pl[3] - 1;
  gs_real *f = w + s->nu * (r + 1), *xi = f + s->nu * (r + 1);
  int info;
  if (ip[GS_CLOSED] == 1)
    info
        = gs_follow_motion (s, t, side, r, na, ip + GS_NUMBERS, pl[0], pl[1], brk, coef, cst, w, f);
  else
    info = gs_planned_rows (t, side, s->nu, r, na, ip + GS_NUMBERS, pl[0], pl[1], brk, coef, f, w);
  const int from = ip[GS_INTERNAL] - 1;
  for (int i = 0; i < nx; i++)
    xi[i] = from >= 0 && from + i < nx ? x[from + i] : 0;
  return info != 0 ? info : s->cmd (t, w, xi, cst, v, xi + nx);
}

/* info < 0 where a polynomial fails */
static int
feedback (const gs_scene *s, gs_real t, int side, const gs_real *x, int nx, const int *ip,
          const gs_real *rp, gs_real *v, gs_real *w)
{
  const int nv = s->nv, r = ip[GS_DERIVATIVES];
  gs_real *x0 = w + 2 * s->nu * (r + 1) + 4 * nx + 20, *k = x0 + nx;
  int info = polynomial (nx, ip + GS_REFERENCE, rp, t, side, x0);
  int other = polynomial (nv * nx, ip + GS_GAIN, rp, t, side, k);
  for (int j = 0; j < nx; j++)
    for (int i = 0; i < nv; i++)
      v[i] -= k[i + nv * j] * (x[j] - x0[j]);
  if (ip[GS_LIMITS] > 0)
    {
      const gs_real *low = rp + ip[GS_LIMITS] - 1, *high = low + nv;
      for (int i = 0; i < nv; i++)
        v[i] = gs_min (gs_max (v[i], low[i]), high[i]);
    }
  return other < 0 ? other : info;
}

/* what is held, modes, what events of the user have switched */
static void
held (int nx, const int *ip, const gs_real *rp, gs_real *v)
{
  for (int i = 0; i < ip[GS_HELD]; i++)
    v[ip[ip[GS_HELD + 1] - 1 + i] - 1] = rp[ip[GS_HELD_AT] - 1 + i];
  if (ip[GS_EVENTS] <= 0)
    return;
  const int *ie = ip + ip[GS_EVENTS] - 1, ne = ie[0], *mode = ie + 10, *input = mode + ne;
  for (int i = 0; i < ne; i++)
    if (input[i] > 0)
      v[input[i] - 1] = (gs_real)mode[i];
  const int ns = ie[9], *switched = ie + 10 + 6 * ne + ns, *on = switched + ns;
  const gs_real *value = rp + ip[GS_EVENTS + 1] - 1 + 6 * ne + 3 * nx + ie[1] * (3 + 2 * nx);
  for (int i = 0; i < ns; i++)
    if (on[i] == 1)
      v[switched[i] - 1] = value[i];
}

int
gs_inputs_of_run (const gs_scene *s, gs_real t, int side, const gs_real *x, int nx, const int *ip,
                  const gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w)
{
  int info = 0;
  if (ip[GS_V0] == 0)
    for (int i = 0; i < s->nv; i++)
      v[i] = rp[ip[GS_TABLE + 3] - 1 + i];
  else if (ip[GS_V0] == 1)
    info = polynomial (s->nv, ip + GS_TABLE, rp, t, side, v);
  else if (ip[GS_V0] == 2)
    info = planned (s, t, side, x, nx, ip, rp, cst, v, w);
  else
    info = s->vin (t, side, x, nx, s->nv, s->data, v);
  if (info != 0)
    return info;
  if (ip[GS_FEEDBACK] != 0)
    info = feedback (s, t, side, x, nx, ip, rp, v, w);
  held (nx, ip, rp, v);
  return info;
}

/* columns_slopes.c: how fast the inputs change along the motion, at an instant of events. */
#include "host/derivatives/columns.h"

/* the inputs as they were before the run asked the columns, but for feedback */
static const int *
plan_of (const gs_derivatives *d)
{
  return d->own_ip ? d->own_ip : d->ip;
}

/* values (nd = 0) or rates (nd = 1) of a polynomial of n components, into to */
static void
polynomial (gs_derivatives *d, const int *where, int n, gs_real t, int side, int nd, gs_real *to)
{
  const int ld = gs_most (1, n);
  gs_real *f = d->slopes.f;
  gs_polynomials_at (n, where[0], where[1], d->rp + where[2] - 1, d->rp + where[3] - 1, t, side, nd,
                     f, ld);
  gs_copy (n, f + ld * nd, to);
}

/* inputs without feedback */
static void
without_feedback (gs_derivatives *d, gs_real t, int side, const gs_real *x, gs_real *v)
{
  const int feedback = d->own_ip[GS_FEEDBACK];
  d->own_ip[GS_FEEDBACK] = 0;
  gs_inputs_of_run (&d->inner, t, side, x, d->inner.nx, d->own_ip, d->rp, gs_columns_constants (d),
                    v, d->wi);
  d->own_ip[GS_FEEDBACK] = feedback;
}

/* rates of what is no polynomial, from one side: differences of order 4 */
static void
by_differences (gs_derivatives *d, gs_real t, int side, const gs_real *x, gs_real *rate)
{
  static const gs_real weights[] = { 25, -48, 36, -16, 3 };
  const gs_real h = (gs_real)1e-4 * gs_max (1, gs_abs (t)) * (side < 0 ? 1 : -1);
  const int nv = d->inner.nv;
  for (int k = 0; k < 5; k++)
    {
      without_feedback (d, t - (gs_real)k * h, side, x, d->slopes.v);
      for (int i = 0; i < nv; i++)
        rate[i] += weights[k] / (12 * h) * d->slopes.v[i];
    }
}

/* of a planned motion, through the states of devices, too, whose rates are f */
static void
through_devices (const gs_derivatives *d, const gs_real *f, gs_real *rate)
{
  const int from = d->own_ip[GS_INTERNAL], nv = d->inner.nv;
  for (int i = 0; i < nv; i++)
    for (int j = 0; j < d->na && from > 0; j++)
      rate[i] += d->vx[i + nv * j] * f[from - 1 + j];
}

static void
add_feedback (gs_derivatives *d, gs_real t, int side, const gs_real *x, const gs_real *v,
              const gs_real *f, gs_real *rate)
{
  const int nx = d->inner.nx, nv = d->inner.nv, *ip = d->own_ip;
  gs_real *gains = d->slopes.gains, *moves = d->slopes.moves, *wanted = d->slopes.wanted;
  polynomial (d, ip + GS_GAIN, nv * nx, t, side, 1, gains);
  polynomial (d, ip + GS_REFERENCE, nx, t, side, 1, moves);
  polynomial (d, ip + GS_REFERENCE, nx, t, side, 0, wanted);
  for (int i = 0; i < nv; i++)
    {
      const int is_free = gs_columns_is_free (d, v, i);
      if (! is_free && d->own[i])
        rate[i] = 0;
      for (int j = 0; j < nx && is_free; j++)
        rate[i] -= gains[i + nv * j] * (x[j] - wanted[j])
                   + d->gain[i + nv * j] * (f[j] - moves[j]);
    }
}

void
gs_columns_slopes (gs_derivatives *d, gs_real t, int side, const gs_real *x, const gs_real *v,
                   const gs_real *f, gs_real *rate)
{
  const int *ip = plan_of (d), nv = d->inner.nv;
  gs_zero (nv, rate);
  if (ip[GS_V0] == 1)
    polynomial (d, ip + GS_TABLE, nv, t, side, 1, rate);
  else if (ip[GS_V0] >= 2)
    by_differences (d, t, side, x, rate);
  if (ip[GS_V0] == 2)
    through_devices (d, f, rate);
  if (ip[GS_FEEDBACK] == 1)
    add_feedback (d, t, side, x, v, f, rate);
  for (int j = 0; d->has_events && j < d->events.ns; j++) /* what is switched stays as it is */
    if (d->events.on[j] == 1)
      rate[d->events.switched[j] - 1] = 0;
}

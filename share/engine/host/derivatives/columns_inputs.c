/* columns_inputs.c: inputs that depend on parameters or states in a run with columns: those that
 * are held (vp), feedback, a planned motion. Feedback is evaluated here, at the states alone, and
 * its gain kept: the gs_inputs_of_run of the run sees a vin. */
#include <stdlib.h>

#include "host/derivatives/columns.h"

/* what cmp says of the planned motion that gs_inputs_of_run has left in its workspace */
static int
planned_columns (gs_derivatives *d, gs_real t, const gs_real *x)
{
  const gs_scene *s = &d->inner;
  const int ld = gs_most (1, s->nv), at = d->own_ip[GS_INTERNAL];
  for (int i = 0; i < d->na; i++)
    d->slopes.xi[i] = at > 0 ? x[at - 1 + i] : 0;
  return s->cmp (t, d->wi, d->slopes.xi, gs_columns_constants (d), d->vx, ld, d->vm, ld);
}

int
gs_columns_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  gs_derivatives *d = (gs_derivatives *)data;
  const int *ip = d->own_ip, *gain = ip + GS_GAIN, nk = nv * d->inner.nx;
  int info = gs_inputs_of_run (&d->inner, t, side, x, d->inner.nx, ip, d->rp,
                               gs_columns_constants (d), v, d->wi);
  (void)nx;
  if (info == 0 && ip[GS_V0] == 2 && ! gs_states_alone (d))
    info = planned_columns (d, t, x);
  if (info == 0 && ip[GS_FEEDBACK] == 1)
    info = gs_least (0,
                     gs_polynomials_at (nk, gain[0], gain[1], d->rp + gain[2] - 1,
                                        d->rp + gain[3] - 1, t, side, 0, d->gain, gs_most (1, nk)));
  return info;
}

void
gs_columns_take_inputs (gs_derivatives *d)
{
  int *own = d->own_ip;
  if (d->ip[GS_V0] < 2 && d->ip[GS_FEEDBACK] != 1)
    {
      d->own_ip = 0;
      return;
    }
  for (int i = 0; i < GS_NUMBERS + d->ip[GS_PLANNED]; i++)
    own[i] = d->ip[i];
  own[GS_HELD] = own[GS_EVENTS] = 0;
  d->ip[GS_V0] = 3;
  d->ip[GS_FEEDBACK] = 0;
  for (int i = 0; i < d->inner.nv; i++)
    d->own[i] = 1;
  for (int i = 0; i < d->ip[GS_HELD]; i++)
    d->own[d->ip[d->ip[GS_HELD + 1] - 1 + i] - 1] = 0;
  for (int i = 0; d->has_events && i < d->events.ne; i++) /* events of the user have no input */
    if (d->events.input[i] > 0)
      d->own[d->events.input[i] - 1] = 0;
}

int
gs_columns_is_free (const gs_derivatives *d, const gs_real *v, int i)
{
  if (! d->own_ip || ! d->own[i])
    return 0;
  if (d->own_ip[GS_FEEDBACK] != 1 || d->own_ip[GS_LIMITS] <= 0)
    return 1;
  const gs_real *low = d->rp + d->own_ip[GS_LIMITS] - 1, *high = low + d->inner.nv;
  return v[i] > low[i] && v[i] < high[i];
}

/* derivative of input i by column k, s its states, through the planned motion */
static gs_real
planned_change (const gs_derivatives *d, const gs_real *s, int k, int i)
{
  const int at = d->own_ip[GS_INTERNAL], nv = d->inner.nv;
  gs_real sum = d->col[k] > 0 ? d->vm[i + nv * (d->col[k] - 1)] : 0;
  for (int j = 0; j < d->na && at > 0; j++)
    sum += d->vx[i + nv * j] * s[at - 1 + j];
  return sum;
}

/* and of all that a run's plan gives, feedback too */
static gs_real
given_change (const gs_derivatives *d, const gs_real *v, const gs_real *s, int k, int i)
{
  if (! gs_columns_is_free (d, v, i))
    return 0;
  gs_real sum = d->own_ip[GS_V0] == 2 ? planned_change (d, s, k, i) : 0;
  for (int j = 0; j < d->inner.nx && d->own_ip[GS_FEEDBACK] == 1; j++)
    sum -= d->gain[i + d->inner.nv * j] * s[j];
  return sum;
}

void
gs_columns_input_changes (const gs_derivatives *d, const gs_real *v, const gs_real *s, int k,
                          gs_real *dv)
{
  const int nv = d->inner.nv;
  for (int i = 0; i < nv; i++)
    dv[i] = d->vp[i + nv * k] + (d->switched[i] < HUGE_VAL ? 0 : given_change (d, v, s, k, i));
}

/* has an event of the user set input i before t? */
static int
is_set (const gs_derivatives *d, int i, double t)
{
  return t > d->switched[i] + 1e-12 * fabs (t);
}

int
gs_derivatives_followed (const gs_derivatives *d)
{
  return d->own_ip != 0;
}

void
gs_derivatives_of_inputs (gs_derivatives *d, int n, const gs_real *tout, const gs_real *xout,
                          int ldx, const gs_real *vout, int ldv, double *to)
{
  const int nv = d->inner.nv;
  for (int r = 0; r < n; r++)
    {
      const gs_real *x = xout + (ptrdiff_t)ldx * r, *given = vout + (ptrdiff_t)ldv * r;
      double *now = to + (ptrdiff_t)nv * d->nc * r;
      const int info = gs_columns_vin (tout[r], -1, x, d->inner.nx, nv, d, d->change);
      for (int k = 0; k < d->nc; k++)
        for (int i = 0; i < nv; i++)
          {
            double change = 0;
            if (! is_set (d, i, (double)tout[r]))
              change = info != 0 ? (double)NAN
                                 : (double)given_change (d, given, gs_column (d, x, k), k, i);
            now[i + nv * k] = change;
          }
    }
}

/* room for one column more; 0: there is no memory */
static int
has_room (gs_derivatives *d, int width)
{
  if (d->nheld < d->room)
    return 1;
  const int room = d->room < 16 ? 32 : 2 * d->room;
  double *held = (double *)realloc (d->held, (size_t)room * (size_t)width * sizeof *held);
  d->no_memory = d->no_memory || ! held;
  if (! held)
    return 0;
  d->held = held;
  d->room = room;
  return 1;
}

void
gs_columns_keep_inputs (gs_derivatives *d, double t)
{
  const int n = d->inner.nv * d->nc;
  if (! has_room (d, 1 + n))
    return;
  double *to = d->held + (ptrdiff_t)(1 + n) * d->nheld++;
  to[0] = t;
  for (int i = 0; i < n; i++)
    to[1 + i] = (double)d->vp[i];
}

int
gs_derivatives_held (const gs_derivatives *d, const double **columns)
{
  *columns = d->held;
  return d->no_memory ? -1 : d->nheld;
}

/* columns_events.c: when an event comes, by all columns:
 *   dtau/dp = -(g_x S- + g_p)/(g_x f- + g_t);
 * whether the motion only grazes there, whether another event comes at the same instant. */
#include "host/derivatives/columns.h"

int
gs_columns_rates_at (gs_derivatives *d, gs_real t, const gs_real *x, int side, gs_real *v,
                     gs_real *f)
{
  const gs_real *cst = gs_columns_constants (d);
  int info = gs_inputs_of_run (&d->outer, t, side, x, d->inner.nx * (1 + d->nc), d->ip, d->rp, cst,
                               v, d->w3);
  if (info == 0)
    info = d->inner.rhs (t, x, v, cst, f);
  return info == 2 || info == 3 ? 0 : info;
}

/* derivatives of event function k, and its rate along the motion: info of evp */
static int
event_slope (gs_derivatives *d, gs_real t, const gs_real *x, const gs_real *v, const int *mode,
             int k, const gs_real *f, const gs_real *slopes, gs_real *g, gs_real *rate)
{
  const gs_scene *s = &d->inner;
  const int info = s->evp (t, x, v, mode, k, gs_columns_constants (d), g);
  *rate = gs_dot (s->nx, g[s->nx + s->nv + s->nsp], g, f);
  for (int i = 0; i < s->nv; i++)
    if (slopes[i] != 0)
      *rate += g[s->nx + i] * slopes[i];
  return info;
}

/* how far a tolerance of the states moves an event function */
static gs_real
event_tolerance (const gs_derivatives *d, const gs_real *g, const gs_real *x)
{
  gs_real size = 0;
  for (int i = 0; i < d->inner.nx; i++)
    size += gs_abs (g[i]) * (d->atol[i] + d->rtol * gs_abs (x[i]));
  return size;
}

/* the time in which a state changes by a millionth of its nominal magnitude */
static gs_real
moment (const gs_derivatives *d, const gs_real *x, const gs_real *f)
{
  gs_real fast = 0;
  for (int i = 0; i < d->inner.nx; i++)
    fast = gs_max (fast, gs_abs (f[i]) * d->rtol / (d->atol[i] + d->rtol * gs_abs (x[i])));
  return fast > 0 ? (gs_real)1e-6 / fast : 0;
}

/* Does the motion only graze where the event function has the slope of d->before? Then an error of
   the size of the tolerance makes another slope of it. */
static int
is_grazing (gs_derivatives *d, gs_real t, const gs_real *x, const int *mode, int k)
{
  const gs_event_before *e = &d->before;
  const gs_real apart = moment (d, x, e->f), earlier = t - apart;
  gs_real before = 0;
  for (int i = 0; i < d->inner.nx; i++)
    d->at.y[i] = x[i] - apart * e->f[i];
  d->inner.rhs (earlier, d->at.y, e->v, gs_columns_constants (d), d->at.h);
  event_slope (d, earlier, d->at.y, e->v, mode, k, d->at.h, e->slopes, d->at.g, &before);
  const gs_real bend = apart > 0 ? gs_abs (e->rate - before) / apart : 0;
  return ! (e->rate * e->rate > event_tolerance (d, e->g, x) * bend) || ! (gs_abs (e->rate) > 0);
}

/* dtau/dp of an event function by all columns of x */
static void
event_times (gs_derivatives *d, const gs_real *x, const gs_real *v, const gs_real *g, gs_real rate,
             gs_real *tau)
{
  const int nx = d->inner.nx, nv = d->inner.nv;
  for (int k = 0; k < d->nc; k++)
    {
      const gs_real *s = gs_column (d, x, k);
      gs_real sum = gs_dot (nx, d->col[k] > 0 ? g[nx + nv + d->col[k] - 1] : 0, g, s);
      gs_columns_input_changes (d, v, s, k, d->change);
      for (int i = 0; i < nv; i++)
        sum += g[nx + i] * d->change[i];
      tau[k] = sum != 0 ? -sum / rate : 0;
    }
}

void
gs_columns_before (gs_derivatives *d, gs_real t, const gs_real *x, const int *mode, int k,
                   gs_real *tau)
{
  gs_event_before *e = &d->before;
  gs_zero (d->inner.nx + d->inner.nv + d->inner.nsp + 1, e->g);
  e->rate = 0;
  e->info = gs_columns_rates_at (d, t, x, -1, e->v, e->f);
  gs_columns_slopes (d, t, -1, x, e->v, e->f, e->slopes);
  if (e->info == 0)
    e->info = event_slope (d, t, x, e->v, mode, k, e->f, e->slopes, e->g, &e->rate);
  event_times (d, x, e->v, e->g, e->rate, tau);
  e->grazes = e->info == 0 && is_grazing (d, t, x, mode, k);
}

/* is event i just coming? value: that of its function; its derivatives are left in d->at.g */
static int
is_coming (gs_derivatives *d, gs_real t, const gs_real *x, const int *mode, int i, gs_real value,
           gs_real *rate)
{
  const gs_event_before *e = &d->before;
  const gs_real *g = d->at.g;
  gs_real size = 0;
  if (d->events.mark[i - 1] != 1
      || event_slope (d, t, x, e->v, mode, i, e->f, e->slopes, d->at.g, rate) != 0)
    return 0;
  for (int j = 0; j < d->inner.nx; j++)
    size += gs_abs (g[j] * e->f[j]);
  return *rate < (gs_real)-1e-9 * size /* else it is one by rounding errors */
         && gs_abs (value) <= 10 * event_tolerance (d, g, x)
         && value <= -10 * *rate * moment (d, x, e->f);
}

/* One that only reports matters to nobody, but has its own time. */
void
gs_columns_give_up_apart (gs_derivatives *d, gs_real t, gs_real *x, const int *mode, int k)
{
  const gs_event_before *e = &d->before;
  gs_real *tau = d->at.tau, rate = 0;
  d->inner.evt (t, x, e->v, mode, gs_columns_constants (d), d->at.values);
  for (int i = 1; i <= d->events.ne; i++)
    {
      if (i == k || ! is_coming (d, t, x, mode, i, d->at.values[i - 1], &rate))
        continue;
      event_times (d, x, e->v, d->at.g, rate, tau);
      if (! d->changes[i - 1])
        {
          d->reported[i - 1] = 1;
          gs_copy (d->nc, tau, d->reports + d->nc * (i - 1));
        }
      for (int j = 0; j < d->nc && d->changes[i - 1]; j++)
        if (! (gs_abs (tau[j] - d->tau[j]) <= (gs_real)1e-6 * gs_abs (d->tau[j])))
          gs_columns_give_up (d, x, j, t, k, GS_SEVERAL);
    }
}

/* columns_instants.c: what happens at an event to the columns: rst, and with it their jump,
 *   S+ = R_x S- + R_p + (R_x f- + R_t - f+) dtau/dp.
 * From the first event of an instant to the last S is that along the motion, S + f dtau/dp, which
 * every reset takes along. Where there is no derivative the column is given up. */
#include "host/derivatives/columns.h"

/* the first event of an instant, k: dtau/dp, and S along the motion */
static void
begin_instant (gs_derivatives *d, gs_real t, gs_real *x, const int *mode, int k)
{
  const gs_event_before *e = &d->before;
  gs_columns_before (d, t, x, mode, k, d->tau);
  if (e->info != 0)
    gs_columns_give_up_moved (d, x, t, k, GS_UNDEFINED);
  else if (e->grazes)
    gs_columns_give_up_moved (d, x, t, k, GS_GRAZES);
  else
    gs_columns_give_up_apart (d, t, x, mode, k);
  for (int j = 0; j < d->nc; j++)
    for (int i = 0; i < d->inner.nx; i++)
      gs_column_in (d, x, j)[i] += e->f[i] * d->tau[j];
}

/* behind the last one: S at a fixed time */
static void
end_instant (gs_derivatives *d, gs_real t, gs_real *x)
{
  const gs_real *f = d->at.rates;
  gs_columns_rates_at (d, t, x, 1, d->at.given, d->at.rates);
  for (int j = 0; j < d->nc; j++)
    for (int i = 0; i < d->inner.nx && d->tau[j] != 0; i++)
      gs_column_in (d, x, j)[i] -= f[i] * d->tau[j];
}

/* derivatives of the inputs v at an instant, along the motion */
static void
inputs_of_instant (gs_derivatives *d, gs_real t, const gs_real *x, const gs_real *v, int side)
{
  const int nv = d->inner.nv;
  gs_real *slopes = d->before.slopes;
  gs_columns_rates_at (d, t, x, side, d->at.given, d->at.rates);
  gs_columns_slopes (d, t, side, x, d->at.given, d->at.rates, slopes);
  for (int k = 0; k < d->nc; k++)
    {
      gs_columns_input_changes (d, v, gs_column (d, x, k), k, d->vt + nv * k);
      for (int i = 0; i < nv; i++)
        d->vt[i + nv * k] += slopes[i] * d->tau[k];
    }
}

/* before the first event of an instant */
static void
open_instant (gs_derivatives *d, gs_real t, gs_real *x, const gs_real *v, const int *mode, int k)
{
  const int cause = *d->events.cause;
  gs_zero (d->nc, d->tau);
  for (int i = 0; i < d->events.ne; i++)
    d->reported[i] = 0;
  if (d->inner.urp)
    {
      gs_columns_onto_loops (d, t, x);
      gs_copy (d->inner.nx * (1 + d->nc), x, d->at.states);
    }
  if (cause > 0)
    begin_instant (d, t, x, mode, k);
  if (d->inner.urp)
    inputs_of_instant (d, t, d->at.states, v, cause > 0 ? -1 : 1);
  d->within = 1;
}

/* dtau/dp of an event, tau, for gs_derivatives_of_events */
static void
keep_times (gs_derivatives *d, const gs_real *tau)
{
  const gs_events *e = &d->events;
  if (*e->count > e->nr || d->ntimes >= e->nr)
    return;
  double *to = d->times + (ptrdiff_t)d->nc * d->ntimes++;
  for (int k = 0; k < d->nc; k++)
    to[k] = d->why[k] != 0 ? (double)NAN : (double)tau[k];
}

/* of an event that changes nothing: it goes past the columns, even where it only grazes */
static void
report (gs_derivatives *d, gs_real t, const gs_real *x, const int *mode, int k)
{
  gs_real *tau = d->at.tau;
  if (d->within)
    tau = d->reported[k - 1] ? d->reports + d->nc * (k - 1) : d->tau;
  else if (*d->events.cause <= 0)
    gs_zero (d->nc, tau);
  else
    {
      gs_columns_before (d, t, x, mode, k, tau);
      for (int j = 0; j < d->nc; j++)
        if ((d->before.info != 0 || d->before.grazes) && tau[j] != 0)
          tau[j] = (gs_real)NAN;
    }
  keep_times (d, tau);
}

/* what an event that changes something finds before it */
static void
keep_before (gs_derivatives *d, const gs_real *x, const gs_real *v, const int *mode)
{
  gs_copy (d->inner.nx, x, d->at.x);
  gs_copy (d->inner.nv, v, d->at.v);
  for (int i = 0; i < d->inner.nev; i++)
    d->at.modes[i] = mode[i];
}

static int
change (gs_derivatives *d, gs_real t, gs_real *x, gs_real *v, int *mode, int k)
{
  const int own = k > 0 && gs_is_own (&d->events, k - 1);
  if (! d->within)
    open_instant (d, t, x, v, mode, k);
  if (k > 0)
    keep_times (d, d->tau);
  keep_before (d, x, v, mode);
  if (own)
    gs_columns_change_of (d, t, x, v, k);
  const int info = d->inner.rst (t, x, v, mode, k, gs_columns_constants (d));
  if (info != 0)
    return info;
  if (own)
    gs_columns_through_user (d, t, x, k);
  if (d->inner.rsp && ! (own && gs_columns_sets_states (d)))
    gs_columns_through_ports (d, t, own ? -1 : k, x, mode);
  return 0;
}

int
gs_columns_rst (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst)
{
  gs_derivatives *d = gs_columns_of (cst);
  if (k == -2)
    {
      if (d->within)
        end_instant (d, t, x);
      d->within = 0;
      return 0;
    }
  const int changes = k > -3 && (k <= 0 || d->changes[k - 1]); /* -3 and less: questions, and what
                                                                  moves by the errors of steps */
  if (changes)
    return change (d, t, x, v, mode, k);
  if (k > 0)
    report (d, t, x, mode, k);
  return d->inner.rst (t, x, v, mode, k, cst);
}

int
gs_derivatives_of_events (const gs_derivatives *d, const double **columns)
{
  *columns = d->times;
  return d->ntimes;
}

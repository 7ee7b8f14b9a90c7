/* columns_resets.c: what the resets of an event do to the columns: rsp of ports that are hit or
 * held, urp of what an event of the user sets. */
#include "host/derivatives/columns.h"

void
gs_columns_give_up (gs_derivatives *d, gs_real *x, int k, gs_real t, int event, int why)
{
  if (d->why[k] == 0)
    {
      d->why[k] = why;
      d->event[k] = event;
      d->lost_at[k] = (double)t;
    }
  gs_zero (d->inner.nx, gs_column_in (d, x, k));
  d->tau[k] = 0;
}

void
gs_columns_give_up_moved (gs_derivatives *d, gs_real *x, gs_real t, int event, int why)
{
  for (int k = 0; k < d->nc; k++)
    if (d->tau[k] != 0) /* no number, too */
      gs_columns_give_up (d, x, k, t, event, why);
}

/* the speeds of all columns through what ports do, whose derivatives by coordinates, speeds,
   parameters and time are r */
static void
through_impact (gs_derivatives *d, gs_real *x)
{
  const int nu = d->inner.nu, nq = d->inner.nq, nm = nq + nu;
  const gs_real *r = d->resets.r;
  gs_real *u = d->resets.u;
  for (int k = 0; k < d->nc; k++)
    {
      gs_real *s = gs_column_in (d, x, k);
      for (int i = 0; i < nu; i++)
        {
          u[i] = r[i + nu * (nm + d->inner.nsp)] * d->tau[k];
          if (d->col[k] > 0)
            u[i] += r[i + nu * (nm + d->col[k] - 1)];
          for (int j = 0; j < nm; j++)
            u[i] += r[i + nu * j] * s[j];
        }
      gs_copy (nu, u, s + nq);
    }
  gs_columns_drop_lost (d, x);
}

/* the ports at event k: they jump, or (-1) come to rest; x is the state behind it */
void
gs_columns_through_ports (gs_derivatives *d, gs_real t, int k, gs_real *x, const int *mode)
{
  const int info = d->inner.rsp (t, d->at.x, d->at.v, d->at.modes, k, x + d->inner.nq, mode,
                                 gs_columns_constants (d), d->resets.r);
  if (info == 0)
    through_impact (d, x);
  for (int j = 0; j < d->nc && info != 0; j++)
    gs_columns_give_up (d, x, j, t, gs_most (1, k), GS_UNDEFINED);
}

/* ------------------------------------------------------------------------- events of the user */

static int
rows (const gs_derivatives *d)
{
  return d->inner.nx + d->inner.nv;
}

void
gs_columns_change_of (gs_derivatives *d, gs_real t, const gs_real *x, const gs_real *v, int k)
{
  const int n = rows (d);
  gs_zero (n * (n + d->inner.nsp + 1), d->set.r);
  d->set.info = d->inner.urp (t, x, v, gs_columns_constants (d), k, d->set.r, d->set.xa);
}

int
gs_columns_sets (const gs_derivatives *d, int i)
{
  const int n = rows (d);
  for (int j = 0; j <= n + d->inner.nsp; j++)
    if (d->set.r[i + n * j] != (i == j ? 1 : 0))
      return 1;
  return 0;
}

int
gs_columns_sets_states (const gs_derivatives *d)
{
  for (int i = 0; i < d->inner.nx; i++)
    if (gs_columns_sets (d, i))
      return 1;
  return 0;
}

/* the columns and the derivatives of the inputs through what an event of the user sets */
static void
through_change (gs_derivatives *d, gs_real *x)
{
  const int n = rows (d), nx = d->inner.nx, nv = d->inner.nv, np = d->inner.nsp;
  const gs_real *r = d->set.r;
  gs_real *before = d->resets.before, *after = d->resets.after;
  for (int k = 0; k < d->nc; k++)
    {
      gs_real *s = gs_column_in (d, x, k), *dv = d->vt + nv * k;
      gs_copy (nx, s, before);
      gs_copy (nv, dv, before + nx);
      for (int i = 0; i < n; i++)
        {
          after[i] = r[i + n * (n + np)] * d->tau[k];
          if (d->col[k] > 0)
            after[i] += r[i + n * (n + d->col[k] - 1)];
          for (int j = 0; j < n; j++)
            after[i] += r[i + n * j] * before[j];
        }
      gs_copy (nx, after, s);
      gs_copy (nv, after + nx, dv);
    }
}

/* Euler parameters xa that are made of length 1, x */
static void
through_lengths (gs_derivatives *d, gs_real *x)
{
  const gs_real *xa = d->set.xa;
  for (int set = 0; set < d->nsets; set++)
    {
      const int *place = d->sets + 4 * set;
      gs_real size = 0;
      for (int i = 0; i < 4; i++)
        size += xa[place[i] - 1] * x[place[i] - 1];
      for (int k = 0; k < d->nc; k++)
        {
          gs_real *s = gs_column_in (d, x, k), along = 0;
          for (int i = 0; i < 4; i++)
            along += x[place[i] - 1] * s[place[i] - 1];
          for (int i = 0; i < 4; i++)
            s[place[i] - 1] = (s[place[i] - 1] - x[place[i] - 1] * along) / size;
        }
    }
}

/* inputs that event k switches are held from here on */
static void
hold_switched (gs_derivatives *d, gs_real t, int k)
{
  const gs_events *e = &d->events;
  const int nv = d->inner.nv;
  int any = 0;
  for (int j = 0; j < e->ns; j++)
    if (e->by[j] == k)
      {
        const int i = e->switched[j] - 1;
        if ((double)t < d->switched[i])
          d->switched[i] = (double)t;
        for (int l = 0; l < d->nc; l++)
          d->vp[i + nv * l] = d->why[l] != 0 ? 0 : d->vt[i + nv * l];
        any = 1;
      }
  if (any)
    gs_columns_keep_inputs (d, (double)t);
}

void
gs_columns_through_user (gs_derivatives *d, gs_real t, gs_real *x, int k)
{
  for (int j = 0; j < d->nc && d->set.info != 0; j++)
    gs_columns_give_up (d, x, j, t, k, GS_UNDEFINED);
  if (d->set.info != 0)
    return;
  through_change (d, x);
  through_lengths (d, x);
  gs_columns_through_loops (d, t, x, k);
  gs_columns_drop_lost (d, x);
  hold_switched (d, t, k);
}

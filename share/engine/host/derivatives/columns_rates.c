/* columns_rates.c: the right-hand side and the projection of a run with columns. */
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"
#include "host/derivatives/columns.h"

void
gs_columns_drop_lost (const gs_derivatives *d, gs_real *x)
{
  for (int k = 0; k < d->nc; k++)
    if (d->why[k] != 0)
      gs_zero (d->inner.nx, gs_column_in (d, x, k));
}

/* what the rates get through inputs that depend on parameters and states; gs_rates_with_columns
   leaves dxd/dv behind dxd/dx and dxd/dp in its workspace */
static void
add_inputs (gs_derivatives *d, const gs_real *x, const gs_real *v, gs_real *xd)
{
  const int nx = d->inner.nx;
  const gs_real *b = d->w + nx * (nx + d->inner.nsp);
  if (d->has_samples)
    gs_columns_arrivals (d);
  for (int k = 0; k < d->nc; k++)
    {
      gs_real *rate = gs_column_in (d, xd, k);
      gs_columns_input_changes (d, v, gs_column (d, x, k), k, d->change);
      for (int j = 0; j < d->inner.nv; j++)
        for (int i = 0; i < nx && d->change[j] != 0; i++)
          rate[i] += b[i + nx * j] * d->change[j];
    }
}

int
gs_columns_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  gs_derivatives *d = gs_columns_of (cst);
  const gs_scene *s = &d->inner;
  if (gs_states_alone (d))
    {
      const int info = s->rhs (t, x, v, cst, xd);
      gs_zero (s->nx * d->nc, xd + s->nx);
      return info;
    }
  const int info = gs_rates_with_columns (s, t, d->top, s->nsp, d->nc, d->col, x, v, cst, d->w, xd);
  if (d->has_samples || d->own_ip || (d->has_events && d->events.ns > 0))
    add_inputs (d, x, v, xd);
  gs_columns_drop_lost (d, xd);
  return info;
}

static int
onto_constraints (gs_derivatives *d, gs_real t, gs_real *x)
{
  return gs_project_columns (&d->inner, t, d->nsets, d->sets, d->inner.nsp, d->nc, d->col, x,
                             gs_columns_constants (d), d->w2, d->iw);
}

int
gs_columns_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  gs_derivatives *d = gs_columns_of (cst);
  int info = d->inner.prj (t, x, cst, res);
  if ((info == 0 || info == 2) && ! gs_states_alone (d))
    info = onto_constraints (d, t, x);
  gs_columns_drop_lost (d, x);
  return info;
}

void
gs_columns_onto_loops (gs_derivatives *d, gs_real t, gs_real *x)
{
  if (d->inner.nlam > 0)
    onto_constraints (d, t, x);
}

/* Two positions tell, exactly. */
int
gs_columns_plain_speeds (const gs_derivatives *d)
{
  const gs_scene *s = &d->inner;
  gs_real *q = d->w, *u = q + s->nq, *rates = u + s->nq;
  int plain = s->nq == s->nu && s->kin;
  for (int k = 1; k <= 2 && plain; k++)
    {
      for (int i = 0; i < s->nq; i++)
        {
          q[i] = (gs_real)(sin (7 * k + 3 * i) * 0.9);
          u[i] = (gs_real)(cos (5 * k + 2 * i) * 0.8);
        }
      s->kin ((gs_real)0.37 * (gs_real)k, q, u, gs_columns_constants (d), rates);
      for (int i = 0; i < s->nq; i++)
        plain = plain && rates[i] == u[i];
    }
  return plain;
}

/* program_hessian.c: the entries of the second derivatives, lower triangle, one after the other. */
#include "host/collocation/program_parts.h"

#include <string.h>

/* weights of the rates in the defects, without the durations */
static void
defect_weights (gs_program *c, const double *lambda)
{
  const int nx = c->s->nx, nq = c->s->nq, nu = c->s->nu;
  for (int k = 0; k < c->intervals; k++)
    for (int s = 0; s < c->rule.own; s++)
      for (int l = 0; l < 3; l++)
        {
          const double a = -c->h[k] * c->rule.a[s][l];
          const int at = c->points * c->phase_of[k] + gs_stage (c, k, l);
          for (int j = 0; j < nx; j++)
            {
              const double w = a * lambda[gs_defect_row (c, k, s) + j];
              if (j >= nq && j < nq + nu)
                c->speeds[nu * at + j - nq] += w;
              else
                c->bare[c->nf * at + c->nr + (j < nq ? j : j - nu)] += w;
            }
        }
}

void
gs_program_weights (gs_program *c, double factor, const double *lambda)
{
  const int all = c->nf * c->points, outputs = c->nf - c->s->ny;
  memset (c->speeds, 0, (size_t)(c->s->nu * c->points * c->nphase) * sizeof *c->speeds);
  for (int p = 0; p < c->nphase; p++)
    for (int q = 0; q < c->points; q++)
      for (int i = 0; i < c->nf; i++)
        c->bare[all * p + c->nf * q + i] = factor * c->goals[i] * c->weights[c->nphase * q + p];
  defect_weights (c, lambda);
  for (int k = 0; k < all; k++)
    {
      c->w[k] = 0;
      for (int p = 0; p < c->nphase; p++)
        c->w[k] += c->duration[p] * c->bare[all * p + k];
    }
  for (int i = 0; i < c->nf; i++)
    c->w[all - c->nf + i] += factor * c->finals[i];
  for (int q = c->first; q < c->points; q++)
    {
      for (int i = 0; i < c->nr; i++)
        c->w[c->nf * q + i] += lambda[gs_residual_row (c, q, i)];
      for (int i = 0; i < c->p->nbounded; i++)
        c->w[c->nf * q + outputs + c->p->bounded[i]] += lambda[gs_path_row (c, q, i)];
    }
}

static void
lower_entry (gs_entries *e, int a, int b, double value)
{
  gs_entry (e, a > b ? a : b, a > b ? b : a, value);
}

static void
curved (gs_program *c, int q, gs_entries *e)
{
  const gs_scene *s = c->s;
  gs_real *h = c->hess + c->d->nhessian * q;
  if (e->values)
    s->dah (c->t[q], c->x + s->nx * q, c->ud + s->nu * q, c->lam + s->nlam * q, c->v + s->nv * q,
            c->cst, c->w + c->nf * q, h);
  for (int k = 0; k < c->d->nhessian; k++)
    {
      const int a = c->d->hessian[2 * k], b = c->d->hessian[2 * k + 1];
      const double factor = (a == 0 ? c->tau[q] : 1) * (b == 0 ? c->tau[q] : 1);
      lower_entry (e, gs_column (c, q, a), gs_column (c, q, b), factor * (double)h[k]);
    }
}

/* the duration of the phase p and the functions at the point q, which are multiplied by it */
static void
crossed (const gs_program *c, int p, int q, gs_entries *e)
{
  const int column = gs_duration_column (c, p), nu = c->s->nu, at = c->points * p + q;
  for (int a = 0; a < c->d->njacobian; a++)
    {
      const int i = c->d->jacobian[2 * a], l = c->d->jacobian[2 * a + 1];
      if (i >= c->nr)
        lower_entry (e, column, gs_column (c, q, l),
                     (l == 0 ? 2 * c->tau[q] : 1) * (double)c->g[c->d->njacobian * q + a]
                         * c->bare[c->nf * at + i]);
    }
  for (int j = 0; j < nu; j++)
    gs_entry (e, column, c->nz * q + c->s->nx + j, c->speeds[nu * at + j]);
}

/* what the goal integrates of the unknowns of the point q in the phase p */
static void
integrated (const gs_program *c, double factor, int p, int q, gs_entries *e)
{
  const double weight = factor * c->weights[c->nphase * q + p];
  for (int k = 0; k < c->p->nproducts; k++)
    {
      const gs_cost_product *one = c->p->products + k;
      gs_entry (e, c->nz * q + one->a, c->nz * q + one->b,
                (one->a == one->b ? 2 : 1) * one->weight * c->duration[p] * weight);
    }
  for (int l = 0; l < c->nz; l++)
    if (c->in_integrand[l])
      gs_entry (e, gs_duration_column (c, p), c->nz * q + l, weight * gs_own_slope (c, l, q));
}

void
gs_program_hessian (gs_program *c, double factor, gs_entries *e)
{
  for (int q = 0; q < c->points; q++)
    {
      curved (c, q, e);
      for (int p = 0; p < c->nphase; p++)
        if (c->weights[c->nphase * q + p] != 0)
          {
            integrated (c, factor, p, q, e);
            crossed (c, p, q, e);
          }
    }
  for (int k = 0; k < c->nform; k++)
    gs_entry (e, c->form[k].row, c->form[k].column, factor * c->form_weight * c->form[k].k);
}

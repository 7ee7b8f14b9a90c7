/* program_values.c: the functions of the scene at all points; goal, gradient, equations. */
#include "host/collocation/program_parts.h"

#include <string.h>

/* the constants of other parameters */
static int
take_parameters (gs_program *c, const double *p)
{
  for (int k = 0; k < c->np; k++)
    c->par[c->d->unknown[k]] = p[k];
  return c->np == 0 || c->d->pre (c->par, c->cst) == 0;
}

static void
copied (int n, const double *from, gs_real *to)
{
  for (int k = 0; k < n; k++)
    to[k] = from[k];
}

int
gs_program_move (gs_program *c, const double *z)
{
  const gs_scene *s = c->s;
  if (c->known && memcmp (c->z, z, (size_t)c->n * sizeof *z) == 0)
    return c->good;
  memcpy (c->z, z, (size_t)c->n * sizeof *z);
  c->known = 1;
  c->has_f = c->has_g = 0;
  const double *last = z + c->points * c->nz;
  memcpy (c->duration, last, (size_t)c->nphase * sizeof *last);
  double before = c->p->t0;
  for (int q = 0; q < c->points; q++, z += c->nz)
    {
      if (q > 0 && c->phase[q] != c->phase[q - 1])
        before += c->duration[c->phase[q - 1]];
      c->t[q] = before + c->duration[c->phase[q]] * c->tau[q];
      copied (s->nx, z, c->x + s->nx * q);
      copied (s->nu, z + s->nx, c->ud + s->nu * q);
      copied (s->nlam, z + s->nx + s->nu, c->lam + s->nlam * q);
      copied (s->nv, z + c->nz - s->nv, c->v + s->nv * q);
    }
  c->good = take_parameters (c, last + c->nphase);
  return c->good;
}

double
gs_rate_at (const gs_program *c, int j, int q)
{
  const gs_scene *s = c->s;
  if (j >= s->nq && j < s->nq + s->nu)
    return (double)c->ud[s->nu * q + j - s->nq];
  return (double)c->f[c->nf * q + c->nr + (j < s->nq ? j : j - s->nu)];
}

/* of each defect what it has by its duration */
static void
sum_rates (gs_program *c)
{
  const int nx = c->s->nx;
  for (int k = 0; k < c->intervals; k++)
    for (int i = 0; i < c->rule.own; i++)
      for (int j = 0; j < nx; j++)
        {
          double sum = 0;
          for (int l = 0; l < 3; l++)
            sum -= c->h[k] * c->rule.a[i][l] * gs_rate_at (c, j, gs_stage (c, k, l));
          c->sums[nx * (c->rule.own * k + i) + j] = sum;
        }
}

void
gs_program_functions (gs_program *c)
{
  const gs_scene *s = c->s;
  if (c->has_f)
    return;
  for (int q = 0; q < c->points; q++)
    s->dae (c->t[q], c->x + s->nx * q, c->ud + s->nu * q, c->lam + s->nlam * q, c->v + s->nv * q,
            c->cst, c->f + c->nf * q);
  sum_rates (c);
  c->has_f = 1;
}

void
gs_program_slopes (gs_program *c)
{
  const gs_scene *s = c->s;
  if (c->has_g)
    return;
  for (int q = 0; q < c->points; q++)
    s->daj (c->t[q], c->x + s->nx * q, c->ud + s->nu * q, c->lam + s->nlam * q, c->v + s->nv * q,
            c->cst, c->g + c->d->njacobian * q);
  c->has_g = 1;
}

double
gs_integral_weight (const gs_program *c, int q)
{
  double sum = 0;
  for (int p = 0; p < c->nphase; p++)
    sum += c->duration[p] * c->weights[c->nphase * q + p];
  return sum;
}

double
gs_own_integrand (const gs_program *c, int q)
{
  const gs_motion_problem *p = c->p;
  const double *z = c->z + c->nz * q;
  double sum = 0;
  for (int l = 0; l < c->nz; l++)
    if (c->in_integrand[l])
      sum += p->linear[l] * z[l];
  for (int k = 0; k < p->nproducts; k++)
    sum += p->products[k].weight * z[p->products[k].a] * z[p->products[k].b];
  return sum;
}

double
gs_own_slope (const gs_program *c, int l, int q)
{
  const gs_motion_problem *p = c->p;
  const double *z = c->z + c->nz * q;
  double sum = p->linear[l];
  for (int k = 0; k < p->nproducts; k++)
    {
      const gs_cost_product *one = p->products + k;
      sum += one->weight * ((one->a == l ? z[one->b] : 0) + (one->b == l ? z[one->a] : 0));
    }
  return sum;
}

/* what the goal integrates at the point q */
static double
integrand (const gs_program *c, int q)
{
  double sum = gs_own_integrand (c, q);
  for (int i = 0; i < c->nf; i++)
    if (c->goals[i] != 0)
      sum += c->goals[i] * (double)c->f[c->nf * q + i];
  return sum;
}

double
gs_program_goal (const gs_program *c)
{
  const int last = c->points - 1;
  double sum = 0, rough = 0;
  for (int p = 0; p < c->nphase; p++)
    sum += c->p->time_weight * c->duration[p];
  for (int q = 0; q < c->points; q++)
    sum += gs_integral_weight (c, q) * integrand (c, q);
  for (int i = 0; i < c->nf; i++)
    if (c->finals[i] != 0)
      sum += c->finals[i] * (double)c->f[c->nf * last + i];
  for (int j = 0; j < c->s->nx; j++)
    sum += c->p->final_states[j] * c->z[c->nz * last + j];
  for (int k = 0; k < c->nform; k++)
    {
      const gs_form_entry *one = c->form + k;
      rough += (one->row == one->column ? 0.5 : 1) * one->k * c->z[one->row] * c->z[one->column];
    }
  return sum + c->form_weight * rough;
}

/* of the point q: what its functions make of the goal */
static void
point_gradient (const gs_program *c, int q, double *g)
{
  const double weight = gs_integral_weight (c, q);
  const gs_real *slopes = c->g + c->d->njacobian * q;
  for (int l = 0; l < c->nz; l++)
    if (c->in_integrand[l])
      g[c->nz * q + l] += weight * gs_own_slope (c, l, q);
  for (int e = 0; e < c->d->njacobian; e++)
    {
      const int i = c->d->jacobian[2 * e], l = c->d->jacobian[2 * e + 1];
      const double k = c->goals[i] * weight + (q == c->points - 1 ? c->finals[i] : 0);
      if (k != 0)
        g[gs_column (c, q, l)] += k * (l == 0 ? c->tau[q] : 1) * (double)slopes[e];
    }
  const double here = integrand (c, q);
  for (int p = 0; p < c->nphase; p++)
    g[gs_duration_column (c, p)] += c->weights[c->nphase * q + p] * here;
}

void
gs_program_gradient (const gs_program *c, double *g)
{
  memset (g, 0, (size_t)c->n * sizeof *g);
  for (int q = 0; q < c->points; q++)
    point_gradient (c, q, g);
  for (int p = 0; p < c->nphase; p++)
    g[gs_duration_column (c, p)] += c->p->time_weight;
  for (int j = 0; j < c->s->nx; j++)
    g[c->nz * (c->points - 1) + j] += c->p->final_states[j];
  for (int k = 0; k < c->nform; k++)
    {
      const gs_form_entry *one = c->form + k;
      g[one->row] += c->form_weight * one->k * c->z[one->column];
      if (one->row != one->column)
        g[one->column] += c->form_weight * one->k * c->z[one->row];
    }
}

void
gs_program_equations (gs_program *c, double *g)
{
  const int nx = c->s->nx, outputs = c->nf - c->s->ny;
  for (int q = c->first; q < c->points; q++)
    {
      for (int i = 0; i < c->nr; i++)
        g[gs_residual_row (c, q, i)] = (double)c->f[c->nf * q + i];
      for (int i = 0; i < c->p->nbounded; i++)
        g[gs_path_row (c, q, i)] = (double)c->f[c->nf * q + outputs + c->p->bounded[i]];
    }
  for (int k = 0; k < c->intervals; k++)
    for (int s = 0; s < c->rule.own; s++)
      for (int j = 0; j < nx; j++)
        g[gs_defect_row (c, k, s) + j]
            = c->z[c->nz * gs_own_point (c, k, s) + j] - c->z[c->nz * gs_left (c, k) + j]
              + c->duration[c->phase_of[k]] * c->sums[nx * (c->rule.own * k + s) + j];
}

/* program_jacobian.c: the entries of the derivatives of the equations, one after the other. */
#include "host/collocation/program_parts.h"

/* the derivatives of the functions of an equation at a point: residuals, outputs with bounds */
static void
entries_of_point (const gs_program *c, int q, gs_entries *e)
{
  const gs_motion_problem *p = c->p;
  const int outputs = c->nf - c->s->ny;
  for (int a = 0; a < c->d->njacobian; a++)
    {
      const int i = c->d->jacobian[2 * a], l = c->d->jacobian[2 * a + 1];
      const double value = (l == 0 ? c->tau[q] : 1) * (double)c->g[c->d->njacobian * q + a];
      if (i < c->nr)
        gs_entry (e, gs_residual_row (c, q, i), gs_column (c, q, l), value);
      for (int b = 0; i >= outputs && b < p->nbounded; b++)
        if (p->bounded[b] == i - outputs)
          gs_entry (e, gs_path_row (c, q, b), gs_column (c, q, l), value);
    }
}

/* those of the rates at the point q, times k, in a defect that begins with the equation row */
static void
entries_of_rates (const gs_program *c, int q, double k, int row, gs_entries *e)
{
  const gs_scene *s = c->s;
  for (int a = 0; a < c->d->njacobian; a++)
    {
      const int i = c->d->jacobian[2 * a], l = c->d->jacobian[2 * a + 1];
      if (c->state_of[i] >= 0)
        gs_entry (e, row + c->state_of[i], gs_column (c, q, l),
                  k * (l == 0 ? c->tau[q] : 1) * (double)c->g[c->d->njacobian * q + a]);
    }
  for (int j = 0; j < s->nu; j++)
    gs_entry (e, row + s->nq + j, c->nz * q + s->nx + j, k);
}

static void
entries_of_defect (const gs_program *c, int k, int s, gs_entries *e)
{
  const int row = gs_defect_row (c, k, s), nx = c->s->nx, p = c->phase_of[k];
  for (int j = 0; j < nx; j++)
    {
      gs_entry (e, row + j, c->nz * gs_own_point (c, k, s) + j, 1);
      gs_entry (e, row + j, c->nz * gs_left (c, k) + j, -1);
      gs_entry (e, row + j, gs_duration_column (c, p),
                c->sums[nx * (c->rule.own * k + s) + j]);
    }
  for (int j = 0; j < 3; j++)
    entries_of_rates (c, gs_stage (c, k, j), -c->duration[p] * c->h[k] * c->rule.a[s][j], row, e);
}

void
gs_program_jacobian (gs_program *c, gs_entries *e)
{
  for (int q = c->first; q < c->points; q++)
    entries_of_point (c, q, e);
  for (int k = 0; k < c->intervals; k++)
    for (int s = 0; s < c->rule.own; s++)
      entries_of_defect (c, k, s, e);
}

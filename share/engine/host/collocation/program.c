/* program.c: a program laid out: points, weights, memory. */
#include "host/collocation/program_parts.h"

#include <math.h>

gs_collocation_rule
gs_collocation_rule_of (int method)
{
  const double s = sqrt (6);
  if (method == GS_LOBATTO)
    return (gs_collocation_rule){ 4, 2, { 0, 0.5, 1 },
                                  { { 5 / 24., 1 / 3., -1 / 24. }, { 1 / 6., 2 / 3., 1 / 6. } } };
  return (gs_collocation_rule){
    5, 3, { (4 - s) / 10, (4 + s) / 10, 1 },
    { { (88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225 },
      { (296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225 },
      { (16 - s) / 36, (16 + s) / 36, 1 / 9. } }
  };
}

static void
take_sizes (gs_program *c, const gs_mesh *mesh)
{
  const gs_scene *s = c->s;
  c->intervals = mesh->n;
  c->points = c->rule.own * mesh->n + 1;
  c->first = c->rule.own == 3;
  c->nz = s->nx + s->nu + s->nlam + s->nv;
  for (int k = 0; k < mesh->n; k++)
    if (mesh->phase[k] >= c->nphase)
      c->nphase = mesh->phase[k] + 1;
  c->np = c->d->nunknown;
  c->nr = c->d->nresiduals;
  c->nf = c->nr + s->nx - s->nu + s->ny;
  c->n = c->points * c->nz + c->nphase + c->np;
  c->m = (c->nr + c->p->nbounded) * (c->points - c->first) + s->nx * c->rule.own * mesh->n;
}

static void
take_room (gs_program *c)
{
  gs_room *r = &c->room;
  const gs_scene *s = c->s;
  const ptrdiff_t n = c->points;
  c->phase = gs_room_places (r, n);
  c->phase_of = gs_room_places (r, c->intervals);
  c->h = gs_room_numbers (r, c->intervals);
  c->begin = gs_room_numbers (r, c->intervals);
  c->tau = gs_room_numbers (r, n);
  c->weights = gs_room_numbers (r, n * c->nphase);
  c->goals = gs_room_numbers (r, c->nf);
  c->finals = gs_room_numbers (r, c->nf);
  c->state_of = gs_room_places (r, c->nf);
  c->in_integrand = gs_room_places (r, c->nz);
  c->z = gs_room_numbers (r, c->n);
  c->duration = gs_room_numbers (r, c->nphase);
  c->sums = gs_room_numbers (r, (ptrdiff_t)s->nx * c->rule.own * c->intervals);
  c->cst = gs_room_reals (r, c->d->ncst);
  c->par = gs_room_reals (r, c->d->npar);
  c->t = gs_room_reals (r, n);
  c->x = gs_room_reals (r, n * s->nx);
  c->ud = gs_room_reals (r, n * s->nu);
  c->lam = gs_room_reals (r, n * s->nlam);
  c->v = gs_room_reals (r, n * s->nv);
  c->f = gs_room_reals (r, n * c->nf);
  c->w = gs_room_reals (r, n * c->nf);
  c->g = gs_room_reals (r, n * c->d->njacobian);
  c->hess = gs_room_reals (r, n * c->d->nhessian);
  c->bare = gs_room_numbers (r, n * c->nf * c->nphase);
  c->speeds = gs_room_numbers (r, n * s->nu * c->nphase);
}

static void
place_points (gs_program *c, const gs_mesh *mesh)
{
  const gs_collocation_rule *r = &c->rule;
  for (int k = 0; k < mesh->n; k++)
    {
      c->phase_of[k] = mesh->phase[k];
      c->begin[k] = mesh->begin[k];
      c->h[k] = mesh->end[k] - mesh->begin[k];
      for (int s = 0; s < r->own; s++)
        {
          c->phase[gs_own_point (c, k, s)] = mesh->phase[k];
          c->tau[gs_own_point (c, k, s)] = mesh->begin[k] + r->c[3 - r->own + s] * c->h[k];
        }
      for (int j = 0; j < 3; j++)
        c->weights[mesh->phase[k] + c->nphase * gs_stage (c, k, j)]
            += c->h[k] * r->a[r->own - 1][j];
    }
}

static void
place_functions (gs_program *c)
{
  const gs_scene *s = c->s;
  const gs_motion_problem *p = c->p;
  for (int i = 0; i < c->nf; i++)
    {
      const int j = i - c->nr;
      c->state_of[i] = j < 0 || j >= s->nx - s->nu ? -1 : j < s->nq ? j : j + s->nu;
    }
  for (int i = 0; i < s->ny; i++)
    {
      c->goals[c->nf - s->ny + i] = p->output_weights[i];
      c->finals[c->nf - s->ny + i] = p->final_outputs[i];
    }
  for (int l = 0; l < c->nz; l++)
    c->in_integrand[l] = p->linear[l] != 0;
  for (int k = 0; k < p->nproducts; k++)
    c->in_integrand[p->products[k].a] = c->in_integrand[p->products[k].b] = 1;
  for (int k = 0; k < c->d->npar; k++)
    c->par[k] = p->par[k];
  for (int k = 0; k < c->d->ncst; k++)
    c->cst[k] = p->cst[k];
}

gs_program *
gs_program_new (const gs_description *d, const gs_motion_problem *p, const gs_mesh *mesh)
{
  gs_program *c = (gs_program *)calloc (1, sizeof *c);
  if (! c)
    return NULL;
  c->d = d;
  c->s = d->scene;
  c->p = p;
  c->rule = gs_collocation_rule_of (mesh->method);
  c->form_weight = 1;
  take_sizes (c, mesh);
  take_room (c);
  if (! c->room.full)
    {
      place_points (c, mesh);
      place_functions (c);
      c->nform = gs_roughness (c, NULL);
      c->form = (gs_form_entry *)gs_room_take (&c->room, c->nform, sizeof *c->form);
    }
  if (c->room.full)
    {
      gs_program_free (c);
      return NULL;
    }
  gs_roughness (c, c->form);
  return c;
}

void
gs_program_free (gs_program *c)
{
  if (c)
    gs_room_free (&c->room);
  free (c);
}

gs_program_sizes
gs_program_size (const gs_program *c)
{
  gs_program_sizes s = { c->points, c->nphase, c->n, c->m, 0, 0, c->nf * c->points };
  gs_program probe = *c;
  gs_entries jacobian = { 0 }, hessian = { 0 };
  gs_program_jacobian (&probe, &jacobian);
  gs_program_hessian (&probe, 1, &hessian);
  s.jacobian = jacobian.n;
  s.hessian = hessian.n;
  return s;
}

void
gs_program_places (gs_program *c, int part, int *rows, int *columns)
{
  gs_entries e = { 0, rows, columns, NULL };
  if (part == GS_JACOBIAN)
    gs_program_jacobian (c, &e);
  else
    gs_program_hessian (c, 1, &e);
}

int
gs_program_evaluate (void *program, int part, const double *z, double factor,
                     const double *lambda, double *out)
{
  gs_program *c = (gs_program *)program;
  gs_entries e = { 0, NULL, NULL, out };
  if (! gs_program_move (c, z))
    return 0;
  gs_program_functions (c);
  if (part == GS_GRADIENT || part == GS_JACOBIAN || part == GS_HESSIAN)
    gs_program_slopes (c);
  if (part == GS_GOAL)
    *out = gs_program_goal (c);
  else if (part == GS_GRADIENT)
    gs_program_gradient (c, out);
  else if (part == GS_EQUATIONS)
    gs_program_equations (c, out);
  else if (part == GS_JACOBIAN)
    gs_program_jacobian (c, &e);
  else if (part == GS_HESSIAN)
    {
      gs_program_weights (c, factor, lambda);
      gs_program_hessian (c, factor, &e);
    }
  else
    for (int k = 0; k < c->nf * c->points; k++)
      out[k] = (double)c->f[k];
  return 1;
}

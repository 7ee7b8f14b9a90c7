/* mesh_errors.c: how far the states of a solution are from the motion of the machine between its
 * points, finer meshes. Source: Betts (2010), section 4.7. */
#include <math.h>

#include "host/collocation/collocation_parts.h"

void
gs_stage_basis (const gs_collocation_rule *r, double x, double *values, double *integrals)
{
  for (int k = 0; k < 3; k++)
    {
      const double a = r->c[(k + 1) % 3], b = r->c[(k + 2) % 3];
      const double scale = (r->c[k] - a) * (r->c[k] - b);
      values[k] = (x - a) * (x - b) / scale;
      integrals[k] = x * (x * x / 3 - (a + b) * x / 2 + a * b) / scale;
    }
}

/* a place at, from 0 to 1, in interval k: |rate of the polynomial - rate of the machine|, times
 * weight, to errors (nx) */
static void
error_at (const gs_solution *s, int k, double at, double weight, gs_real *room, double *errors)
{
  const gs_program *c = s->c;
  const gs_scene *scene = c->s;
  const int nx = scene->nx, nv = scene->nv;
  const double h = c->h[k] * gs_phase_duration (s, c->phase_of[k]);
  gs_real *x = room, *xd = x + nx, *v = xd + nx;
  double values[3], integrals[3];
  gs_stage_basis (&c->rule, at, values, integrals);
  for (int j = 0; j < nx; j++)
    x[j] = gs_point (s, gs_left (c, k))[j];
  for (int j = 0; j < nv; j++)
    v[j] = 0;
  for (int l = 0; l < 3; l++)
    {
      const int q = gs_stage (c, k, l);
      for (int j = 0; j < nx; j++)
        x[j] += h * integrals[l] * gs_rate_at (c, j, q);
      for (int j = 0; j < nv; j++)
        v[j] += values[l] * gs_point (s, q)[c->nz - nv + j];
    }
  scene->rhs (s->t[gs_left (c, k)] + h * at, x, v, c->cst, xd);
  for (int j = 0; j < nx; j++)
    {
      double rate = 0;
      for (int l = 0; l < 3; l++)
        rate += values[l] * gs_rate_at (c, j, gs_stage (c, k, l));
      errors[j] += h * weight * fabs (rate - (double)xd[j]);
    }
}

void
gs_mesh_errors (gs_search *w, gs_solution *s)
{
  /* Gauss's formula of 4 points */
  static const double places[] = { 0.8611363115940526, 0.3399810435848563 };
  static const double weights[] = { 0.3478548451374538, 0.6521451548625461 };
  const gs_program *c = s->c;
  const int nx = c->s->nx;
  gs_real *room = gs_room_reals (&w->room, 2 * nx + c->s->nv);
  double *largest = gs_room_numbers (&w->room, nx), *errors = gs_room_numbers (&w->room, nx);
  if (gs_search_bad (w))
    return;
  gs_program_move (s->c, s->r.x);
  gs_program_functions (s->c);
  for (int q = 0; q < c->points; q++)
    for (int j = 0; j < nx; j++)
      largest[j] = fmax (largest[j], fabs (gs_point (s, q)[j]));
  s->error = 0;
  for (int k = 0; k < c->intervals; k++)
    {
      for (int j = 0; j < nx; j++)
        errors[j] = 0;
      for (int i = 0; i < 4; i++)
        error_at (s, k, (1 + (i % 2 ? 1 : -1) * places[i / 2]) / 2, weights[i / 2] / 2, room,
                  errors);
      s->errors[k] = 0;
      for (int j = 0; j < nx; j++)
        s->errors[k] = isfinite (errors[j]) ? fmax (s->errors[k], errors[j] / (1 + largest[j]))
                                            : HUGE_VAL;
      s->error = fmax (s->error, s->errors[k]);
    }
}

/* in how many parts interval k is cut */
static int
parts_of (const gs_search *w, const gs_solution *s, int k)
{
  const double more = pow (2 * s->errors[k] / w->o->accuracy, 1. / (s->c->rule.order + 1));
  return more > 1 ? (int)fmin (ceil (more), 5) : 1;
}

gs_mesh
gs_finer_mesh (gs_search *w, const gs_solution *s)
{
  int n = 0;
  for (int k = 0; k < s->mesh.n; k++)
    n += parts_of (w, s, k);
  int *phase = gs_room_places (&w->room, n);
  double *begin = gs_room_numbers (&w->room, n), *end = gs_room_numbers (&w->room, n);
  const gs_mesh mesh = { s->mesh.method, n, phase, begin, end };
  for (int k = 0, i = 0; ! gs_search_bad (w) && k < s->mesh.n; k++)
    {
      const int parts = parts_of (w, s, k);
      const double a = s->mesh.begin[k], h = (s->mesh.end[k] - a) / parts;
      for (int j = 0; j < parts; j++, i++)
        {
          phase[i] = s->mesh.phase[k];
          begin[i] = a + j * h;
          end[i] = j == parts - 1 ? s->mesh.end[k] : a + (j + 1) * h;
        }
    }
  return mesh;
}

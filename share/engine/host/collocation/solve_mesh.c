/* solve_mesh.c: the program of a mesh solved: bounds, where it begins, what was found. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "host/collocation/collocation_parts.h"
#include "host/collocation/eliminate.h"

double
gs_time_left (const gs_search *w)
{
  return w->o->timeout > 0 ? w->o->timeout - (gs_wall_clock () - w->began) : HUGE_VAL;
}

double
gs_whole_duration (const gs_solution *s)
{
  double sum = 0;
  for (int p = 0; p < s->c->nphase; p++)
    sum += gs_phase_duration (s, p);
  return sum;
}

/* ------------------------------------------------------------------------------------- bounds */

static void
fixed (int n, const double *x, double *low, double *high)
{
  for (int k = 0; k < n; k++)
    if (! isnan (x[k]))
      low[k] = high[k] = x[k];
}

static void
bound_points (gs_solution *s)
{
  const gs_program *c = s->c;
  const gs_motion_problem *p = &s->p;
  const int nx = c->s->nx, nv = c->s->nv, nz = c->nz;
  for (int q = 0; q < c->points; q++)
    for (int l = 0; l < nz; l++)
      {
        s->low[nz * q + l] = p->low[l];
        s->high[nz * q + l] = p->high[l];
      }
  double *low = s->low + nz * (c->points - 1), *high = s->high + nz * (c->points - 1);
  fixed (nx, p->x0, s->low, s->high);
  fixed (nx, p->xf, low, high);
  for (int j = 0; j < nx; j++)
    {
      low[j] = fmax (low[j], p->last_low[j]);
      high[j] = fmin (high[j], p->last_high[j]);
    }
  for (int q = 0; p->held && q < c->points; q++)
    for (int j = 0; j < nv; j++)
      s->low[nz * (q + 1) - nv + j] = s->high[nz * (q + 1) - nv + j]
          = p->held[nv * c->phase[q] + j];
  if (! p->held && c->first > 0) /* nothing is asked of these at the start */
    for (int l = nx; l < nz; l++)
      s->low[l] = s->high[l] = 0;
}

static void
bound_program (gs_solution *s)
{
  const gs_program *c = s->c;
  const gs_motion_problem *p = &s->p;
  bound_points (s);
  for (int k = 0; k < c->nphase; k++)
    {
      s->low[gs_duration_column (c, k)] = p->duration[0];
      s->high[gs_duration_column (c, k)] = p->duration[1];
    }
  for (int k = 0; k < c->np; k++)
    {
      s->low[c->n - c->np + k] = p->unknown_low[k];
      s->high[c->n - c->np + k] = p->unknown_high[k];
    }
  for (int q = c->first; q < c->points; q++)
    for (int i = 0; i < p->nbounded; i++)
      {
        s->glow[gs_path_row (c, q, i)] = p->output_low[i];
        s->ghigh[gs_path_row (c, q, i)] = p->output_high[i];
      }
}

/* ------------------------------------------------------------------------- where it begins */

/* the times of the points where phases have these durations */
static void
times_of (const gs_program *c, double t0, const double *duration, double *t)
{
  for (int q = 0; q < c->points; q++)
    {
      if (q > 0 && c->phase[q] != c->phase[q - 1])
        t0 += duration[c->phase[q - 1]];
      t[q] = t0 + duration[c->phase[q]] * c->tau[q];
    }
}

static void
begin_at (const gs_solution *s, const gs_guess *g, double *x0)
{
  const gs_program *c = s->c;
  const int last = c->points - 1;
  times_of (c, 0, g->duration, s->at);
  for (int q = 0, k = 0; q <= last; q++)
    {
      const double at = fmin (s->at[q] / s->at[last], 1);
      while (k < g->n - 2 && at > g->t[k + 1])
        k++;
      const double share = fmin (1, fmax (0, (at - g->t[k]) / (g->t[k + 1] - g->t[k])));
      const double *a = g->z + c->nz * k, *b = a + c->nz;
      for (int l = 0; l < c->nz; l++)
        x0[c->nz * q + l] = a[l] + share * (b[l] - a[l]);
    }
  memcpy (x0 + c->nz * c->points, g->duration, (size_t)c->nphase * sizeof *x0);
  for (int k = 0; k < c->np; k++)
    x0[c->n - c->np + k] = g->unknown[k];
  for (int k = 0; k < c->n; k++)
    x0[k] = fmax (s->low[k], fmin (s->high[k], x0[k]));
}

gs_guess
gs_guess_of (const gs_solution *s)
{
  const double *last = s->r.x + s->c->nz * s->c->points;
  return (gs_guess){ s->c->points, s->at, s->r.x, last, last + s->c->nphase };
}

/* --------------------------------------------------------------------------------- solved */

static void *
copied (gs_room *r, const void *from, int n, size_t bytes)
{
  void *to = gs_room_take (r, n, bytes);
  if (to && from && n > 0)
    memcpy (to, from, (size_t)n * bytes);
  return to;
}

/* a solution with problem, mesh and program of its own */
static gs_solution *
new_solution (gs_search *w, const gs_motion_problem *p, const gs_mesh *mesh)
{
  gs_solution *s = (gs_solution *)gs_room_take (&w->room, 1, sizeof *s);
  if (! s)
    return NULL;
  int phases = 1;
  for (int k = 0; k < mesh->n; k++)
    phases = mesh->phase[k] >= phases ? mesh->phase[k] + 1 : phases;
  gs_room *r = &s->room;
  s->before = w->solutions;
  w->solutions = s;
  s->p = *p;
  s->p.arcs = (gs_smooth_arc *)copied (r, p->arcs, p->narcs, sizeof *p->arcs);
  if (p->held)
    s->p.held = (double *)copied (r, p->held, w->d->scene->nv * phases, sizeof (double));
  s->mesh = (gs_mesh){ mesh->method, mesh->n, (int *)copied (r, mesh->phase, mesh->n, sizeof (int)),
                       (double *)copied (r, mesh->begin, mesh->n, sizeof (double)),
                       (double *)copied (r, mesh->end, mesh->n, sizeof (double)) };
  s->c = r->full ? NULL : gs_program_new (w->d, &s->p, &s->mesh);
  if (! s->c)
    {
      w->bad = 1;
      return NULL;
    }
  s->size = gs_program_size (s->c);
  double **numbers[] = { &s->low, &s->high, &s->r.x, &s->r.zl, &s->r.zu, &s->t, &s->at, &s->glow,
                         &s->ghigh, &s->r.g, &s->r.lambda, &s->errors };
  for (int k = 0; k < 12; k++)
    *numbers[k] = gs_room_numbers (r, k < 5   ? s->size.n
                                      : k < 7 ? s->size.points
                                      : k < 11 ? s->size.m : mesh->n);
  return s;
}

/* what the solver has found at s->r */
static void
take_found (gs_search *w, gs_solution *s)
{
  const gs_program *c = s->c;
  const double *duration = s->r.x + c->nz * c->points;
  times_of (c, s->p.t0, duration, s->t);
  for (int q = 0; q < c->points; q++)
    s->at[q] = (s->t[q] - s->t[0]) / (s->t[c->points - 1] - s->t[0]);
  if (s->r.limit && gs_time_left (w) <= 0)
    s->stopped = GS_TIMED_OUT;
  else if (s->r.interrupted)
    s->stopped = GS_INTERRUPTED;
  s->c->form_weight = 0;
  gs_program_evaluate (s->c, GS_GOAL, s->r.x, 1, NULL, &s->r.goal);
}

gs_solution *
gs_solve_mesh (gs_search *w, const gs_motion_problem *p, const gs_mesh *mesh, const gs_guess *guess)
{
  gs_solution *s = new_solution (w, p, mesh);
  if (! s)
    return NULL;
  const gs_program_sizes n = s->size;
  int *places[4];
  for (int k = 0; k < 4; k++)
    places[k] = gs_room_places (&s->room, k < 2 ? n.jacobian : n.hessian);
  double *x0 = gs_room_numbers (&s->room, n.n);
  if (s->room.full)
    {
      w->bad = 1;
      return NULL;
    }
  bound_program (s);
  begin_at (s, guess, x0);
  gs_program_places (s->c, GS_JACOBIAN, places[0], places[1]);
  gs_program_places (s->c, GS_HESSIAN, places[2], places[3]);
  const gs_nlp nlp = { n.n, n.m, x0, s->low, s->high, s->glow, s->ghigh, n.jacobian, n.hessian,
                       places[0], places[1], places[2], places[3], s->c, gs_program_evaluate };
  /* of MUMPS: scaling and order (AMD) are some ten times as fast on these programs as what it does
     by itself; of the barrier: what takes fewer iterations from afar, from the mesh before */
  const gs_nlp_word words[] = { { "mumps_scaling", NULL, 8, 1 },
                                { "mumps_pivot_order", NULL, 0, 1 },
                                { "mu_strategy", s->before ? "adaptive" : "monotone", 0, 0 } };
  const gs_nlp_options options
      = { w->o->tolerance, HUGE_VAL, fmax (1e-3, fmin (w->o->seconds, gs_time_left (w))),
          w->o->iterations, 3, words, w->o->ask, w->o->asked };
  const gs_scene *scene = w->d->scene;
  const gs_program *c = s->c;
  /* accelerations and multipliers by the equations of motion */
  const gs_determined rates
      = { c->nr == scene->nu + scene->nlam ? c->points - c->first : 0, c->nr,
          c->nz * c->first + scene->nx, c->nz, gs_residual_row (c, c->first, 0), c->nr };
  w->bad = gs_solve_eliminated (w->o->solver, &nlp, &rates, &options, &s->r);
  if (w->bad)
    {
      snprintf (w->refused, sizeof w->refused, "%s", s->r.ended);
      return NULL;
    }
  take_found (w, s);
  return s;
}

/* polish.c: a solution whose inputs jump between their limits, solved once more with the durations
 * between the jumps as unknowns and the inputs held at their limits. It stays as it is where its
 * inputs do otherwise, where the scene depends on time, or where the other solution is none, or
 * against the minimum principle. */
#include <math.h>
#include <string.h>

#include "host/collocation/collocation_parts.h"

/* the time alone is least, and nothing else depends on it */
static int
may_polish (const gs_search *w, const gs_solution *s)
{
  const gs_description *d = w->d;
  const gs_motion_problem *p = &s->p;
  const gs_scene *scene = d->scene;
  int other = ! s->r.solved || ! w->o->polish || p->nbounded > 0 || s->c->nphase > 1
              || ! (p->time_weight > 0) || p->nproducts > 0;
  for (int e = 0; e < d->njacobian; e++)
    other |= d->jacobian[2 * e + 1] == 0 && d->jacobian[2 * e] < s->c->nf - scene->ny;
  for (int j = 0; j < scene->ny; j++)
    other |= p->output_weights[j] != 0 || p->final_outputs[j] != 0;
  for (int j = 0; j < scene->nx; j++)
    other |= p->final_states[j] != 0;
  for (int l = 0; l < s->c->nz; l++)
    other |= p->linear[l] != 0;
  for (int l = s->c->nz - scene->nv; l < s->c->nz; l++)
    other |= ! isfinite (p->low[l]) || ! isfinite (p->high[l]);
  return ! other;
}

/* the inputs of each phase, at a limit each, levels (nv,n), and where they begin (of the duration
 * 1): n; 0 where more than one point in eight lies between the limits */
static int
phases_of (const gs_solution *s, double *levels, double *begins)
{
  const gs_program *c = s->c;
  const int nv = c->s->nv, stages = c->points - c->first;
  const double *low = s->p.low + c->nz - nv, *high = s->p.high + c->nz - nv;
  int between = 0, n = 0;
  for (int q = c->first; q < c->points; q++)
    {
      const double *v = gs_point (s, q) + c->nz - nv;
      double *now = levels + nv * n;
      int inner = 0, changed = q == c->first;
      for (int j = 0; j < nv; j++)
        {
          const double share = (v[j] - low[j]) / (high[j] - low[j]);
          inner |= share > 0.05 && share < 0.95;
          now[j] = share > 0.5 ? high[j] : low[j];
          changed |= n > 0 && now[j] != now[j - nv];
        }
      between += inner;
      if (changed)
        begins[n++] = q == c->first ? 0 : (s->at[q - 1] + s->at[q]) / 2;
    }
  return 8 * between > stages ? 0 : n;
}

/* the intervals of S cut at the beginnings of n phases, four or more in each */
static gs_mesh
pieces (gs_search *w, const gs_solution *s, int n, const double *begins)
{
  const gs_program *c = s->c;
  const int most = c->intervals + 6 * n;
  int *phase = gs_room_places (&w->room, most), m = 0;
  double *begin = gs_room_numbers (&w->room, most), *end = gs_room_numbers (&w->room, most);
  for (int p = 0; ! gs_search_bad (w) && p < n; p++)
    {
      const double a = begins[p], b = p < n - 1 ? begins[p + 1] : 1;
      const int first = m;
      double last = 0;
      for (int k = 0; k <= c->intervals; k++)
        {
          const double inner = (s->at[gs_left (c, k)] - a) / (b - a);
          if (k < c->intervals && ! (inner > 0.02 && inner < 0.98))
            continue;
          begin[m] = last;
          end[m] = last = k < c->intervals ? inner : 1;
          phase[m++] = p;
        }
      if (m - first < 4)
        for (m = first; m < first + 4; m++)
          {
            phase[m] = p;
            begin[m] = (m - first) / 4.;
            end[m] = (m - first + 1) / 4.;
          }
    }
  return (gs_mesh){ GS_RADAU_IIA, m, phase, begin, end };
}

/* the minimum principle: no input gains by leaving its limit; what each would gain are the
 * multipliers of these limits, which the solver has none of where inputs are held */
static int
is_optimal (gs_search *w, gs_solution *s, const double *levels)
{
  const gs_program *c = s->c;
  const int nv = c->s->nv;
  double *g = gs_room_numbers (&w->room, c->n), most = 0, least = 0;
  double *values = gs_room_numbers (&w->room, s->size.jacobian);
  int *rows = gs_room_places (&w->room, s->size.jacobian);
  int *columns = gs_room_places (&w->room, s->size.jacobian);
  if (gs_search_bad (w))
    return 0;
  gs_program_evaluate (s->c, GS_GRADIENT, s->r.x, 1, NULL, g);
  gs_program_evaluate (s->c, GS_JACOBIAN, s->r.x, 1, NULL, values);
  gs_program_places (s->c, GS_JACOBIAN, rows, columns);
  for (int e = 0; e < s->size.jacobian; e++)
    g[columns[e]] += values[e] * s->r.lambda[rows[e]];
  for (int q = c->first; q < c->points; q++)
    for (int j = 0; j < nv; j++)
      {
        const int l = c->nz - nv + j;
        const double gain = g[c->nz * q + l];
        const double one = gain
                           * (levels[nv * c->phase[q] + j] == s->p.high[l] ? -1 : 1);
        most = fmax (most, fabs (one));
        least = fmin (least, one);
        s->r.zl[c->nz * q + l] = fmax (0, gain);
        s->r.zu[c->nz * q + l] = fmax (0, -gain);
      }
  return least >= -1e-3 * most;
}

/* solved on finer and finer meshes; null: it is no solution, or none that is as quick */
static gs_solution *
solve_phases (gs_search *w, const gs_solution *s, const gs_motion_problem *p, gs_mesh mesh,
              const double *durations, int *stopped)
{
  gs_guess guess = gs_guess_of (s);
  guess.duration = durations;
  for (int k = 0; k <= w->o->refinements; k++)
    {
      gs_solution *new = gs_solve_mesh (w, p, &mesh, &guess);
      if (! new)
        return NULL;
      const double whole = gs_whole_duration (new);
      *stopped = new->stopped;
      if (! new->r.solved || whole > gs_whole_duration (s) * (1 + 1e-3)
          || whole < s->p.duration[0])
        return NULL;
      gs_mesh_errors (w, new);
      if (gs_search_bad (w) || new->error <= w->o->accuracy)
        return new;
      mesh = gs_finer_mesh (w, new);
      guess = gs_guess_of (new);
    }
  return NULL;
}

gs_solution *
gs_polish (gs_search *w, const gs_solution *s, double **switches, int *n, int *stopped)
{
  const int nv = w->d->scene->nv;
  *n = *stopped = 0;
  if (! may_polish (w, s))
    return NULL;
  double *levels = gs_room_numbers (&w->room, (ptrdiff_t)nv * (s->c->points + 1));
  double *begins = gs_room_numbers (&w->room, s->c->points);
  double *durations = gs_room_numbers (&w->room, s->c->points);
  const int phases = gs_search_bad (w) ? 0 : phases_of (s, levels, begins);
  if (phases < 2)
    return NULL;
  const gs_mesh mesh = pieces (w, s, phases, begins);
  for (int k = 0; k < phases; k++)
    durations[k] = ((k < phases - 1 ? begins[k + 1] : 1) - begins[k]) * gs_whole_duration (s);
  gs_motion_problem p = s->p;
  p.narcs = 0;
  p.held = levels;
  p.duration[0] = 0;
  gs_solution *new = gs_search_bad (w) ? NULL
                                       : solve_phases (w, s, &p, mesh, durations, stopped);
  if (! new || ! is_optimal (w, new, levels))
    return NULL;
  *switches = begins;
  for (double at = p.t0; *n < phases - 1; ++*n)
    begins[*n] = at += gs_phase_duration (new, *n);
  return new;
}

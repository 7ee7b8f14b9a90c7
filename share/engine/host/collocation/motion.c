/* motion.c: a solution as the caller gets it. */
#include <math.h>
#include <string.h>

#include "host/collocation/collocation_parts.h"

/* Radau's rule has nothing at the start: the polynomial of the first interval there */
static void
extrapolate (const gs_solution *s, double *z)
{
  const gs_program *c = s->c;
  double values[3], integrals[3];
  if (c->first == 0)
    return;
  gs_stage_basis (&c->rule, 0, values, integrals);
  for (int l = c->s->nx; l < c->nz; l++)
    {
      z[l] = 0;
      for (int j = 0; j < 3; j++)
        z[l] += values[j] * gs_point (s, gs_stage (c, 0, j))[l];
    }
}

static void
take_points (gs_search *w, const gs_solution *s, gs_room *room, gs_motion *r)
{
  const gs_program *c = s->c;
  const gs_scene *d = c->s;
  const int n = c->points, nz = c->nz;
  double *z = gs_room_numbers (room, (ptrdiff_t)n * nz);
  double *const parts[] = { r->x, r->ud, r->lambda, r->v };
  const int sizes[] = { d->nx, d->nu, d->nlam, d->nv };
  gs_real *y = gs_room_reals (&w->room, d->ny + nz);
  if (! z || ! y)
    return;
  memcpy (z, s->r.x, (size_t)(n * nz) * sizeof *z);
  extrapolate (s, z);
  for (int q = 0; q < n; q++)
    for (int k = 0, at = 0; k < 4; at += sizes[k++])
      memcpy (parts[k] + sizes[k] * q, z + nz * q + at, (size_t)sizes[k] * sizeof *z);
  for (int q = 0; q < n; q++)
    for (int i = 0; i < d->ny; i++)
      r->y[d->ny * q + i] = (double)c->f[c->nf * (q + 1) - d->ny + i];
  if (c->first > 0 && d->out) /* they are those of inputs that are none */
    {
      for (int l = 0; l < nz; l++)
        y[d->ny + l] = z[l];
      d->out (s->t[0], y + d->ny, y + d->ny + nz - d->nv, c->cst, y);
      for (int i = 0; i < d->ny; i++)
        r->y[i] = (double)y[i];
    }
}

/* polynomials of order 2 through the stages */
static void
take_inputs (const gs_solution *s, gs_motion *r)
{
  const gs_program *c = s->c;
  const double *p = c->rule.c;
  const int nv = c->s->nv, n = c->intervals;
  r->pieces = n;
  for (int k = 0; k <= n; k++)
    r->breaks[k] = s->t[gs_left (c, k)];
  for (int k = 0; k < n; k++)
    for (int j = 0; j < nv; j++)
      {
        const double h = r->breaks[k + 1] - r->breaks[k];
        double slopes[2], v[3];
        for (int i = 0; i < 3; i++)
          v[i] = r->v[nv * gs_stage (c, k, i) + j];
        for (int i = 0; i < 2; i++)
          slopes[i] = (v[i + 1] - v[i]) / (p[i + 1] - p[i]);
        const double a = (slopes[1] - slopes[0]) / (p[2] - p[0]);
        const double b = slopes[0] - a * (p[0] + p[1]);
        r->input[nv * k + j] = a / (h * h);
        r->input[nv * (n + k) + j] = b / h;
        r->input[nv * (2 * n + k) + j] = v[0] - p[0] * (b + a * p[0]);
      }
}

/* are the speeds the rates of the coordinates? */
static int
plain_speeds (const gs_solution *s)
{
  const gs_scene *d = s->c->s;
  int plain = d->nq == d->nu;
  for (int q = 0; plain && q < s->c->points; q++)
    for (int j = 0; j < d->nq; j++)
      plain = plain && gs_rate_at (s->c, j, q) == gs_point (s, q)[d->nq + j];
  return plain;
}

/* polynomials of order 5 with places, speeds and accelerations of the points */
static void
take_plan (const gs_solution *s, const gs_motion_guess *given, gs_motion *r)
{
  const gs_scene *d = s->c->s;
  const int n = d->nlam > 0 ? given->nactuated : d->nq, m = s->c->points - 1;
  r->nplanned = plain_speeds (s) ? n : 0;
  for (int i = 0; i < r->nplanned; i++)
    {
      const int j = d->nlam > 0 ? given->actuated[i] : i;
      r->planned[i] = j;
      for (int k = 0; k < m; k++)
        {
          const double h = s->t[k + 1] - s->t[k];
          const double *xa = r->x + d->nx * k, *xb = xa + d->nx;
          const double a = r->ud[d->nu * k + j], q = xa[j], u = xa[d->nq + j];
          const double e = xb[j] - (q + u * h + a * h * h / 2); /* what higher terms give */
          const double f = xb[d->nq + j] - (u + a * h), g = r->ud[d->nu * (k + 1) + j] - a;
          const double terms[] = { (12 * e - 6 * f * h + g * h * h) / (2 * pow (h, 5)),
                                   (-15 * e + 7 * f * h - g * h * h) / pow (h, 4),
                                   (20 * e - 8 * f * h + g * h * h) / (2 * pow (h, 3)), a / 2, u,
                                   q };
          for (int l = 0; l < 6; l++)
            r->motion[n * (m * l + k) + i] = terms[l];
        }
    }
}

static void *
kept (gs_room *room, const void *from, int n, size_t size)
{
  void *to = gs_room_take (room, n, size);
  if (to && n > 0)
    memcpy (to, from, (size_t)n * size);
  return to;
}

static void
take_lists (const gs_found *f, gs_room *room, gs_motion *r)
{
  r->nmeshes = f->nmeshes;
  r->meshes = (gs_mesh_report *)kept (room, f->meshes, f->nmeshes, sizeof *f->meshes);
  r->nactive = f->nactive;
  r->active = (gs_active_bound *)kept (room, f->active, f->nactive, sizeof *f->active);
  r->nswitches = f->nswitches;
  r->switches = (double *)kept (room, f->switches, f->nswitches, sizeof (double));
  r->arcs = (gs_singular_arc *)gs_room_take (room, f->narcs, sizeof *f->arcs);
  for (int k = 0; r->arcs && k < f->narcs; k++)
    if (! f->arcs[k].held)
      r->arcs[r->narcs++] = f->arcs[k];
}

void
gs_take_motion (gs_search *w, gs_solution *s, const gs_motion_guess *given, const gs_found *found,
                gs_motion *r)
{
  const gs_program *c = s->c;
  const gs_scene *d = c->s;
  const ptrdiff_t n = c->points;
  gs_room *room = (gs_room *)calloc (1, sizeof *room);
  r->room = room;
  if (! room)
    {
      w->bad = 1;
      return;
    }
  double **arrays[] = { &r->t, &r->x, &r->v, &r->ud, &r->lambda, &r->y, &r->costates, &r->unknown,
                        &r->breaks, &r->input, &r->motion };
  const ptrdiff_t sizes[] = { n, n * d->nx, n * d->nv, n * d->nu, n * d->nlam, n * d->ny,
                              n * d->nx, c->np, n, 3 * n * d->nv, 6 * n * d->nq };
  for (int k = 0; k < 11; k++)
    *arrays[k] = gs_room_numbers (room, sizes[k]);
  r->planned = gs_room_places (room, d->nq);
  take_lists (found, room, r);
  if (room->full || gs_search_bad (w))
    {
      w->bad = 1;
      return;
    }
  gs_program_move (s->c, s->r.x);
  gs_program_functions (s->c);
  r->n = c->points;
  r->goal = s->r.goal;
  r->duration = gs_whole_duration (s);
  r->error = s->error;
  memcpy (r->t, s->t, (size_t)n * sizeof *r->t);
  memcpy (r->unknown, s->r.x + c->n - c->np, (size_t)c->np * sizeof *r->unknown);
  take_points (w, s, room, r);
  take_inputs (s, r);
  take_plan (s, given, r);
  gs_costates (s, r->costates);
}

void
gs_motion_free (gs_motion *r)
{
  gs_room *room = (gs_room *)r->room;
  if (room)
    gs_room_free (room);
  free (room);
  r->room = NULL;
}

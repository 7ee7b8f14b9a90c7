/* run_slopes.c: derivatives of the inputs and outputs of a run by its columns; not a number where a
 * column was lost. */
#include <math.h>
#include <stdlib.h>

#include "host/output_rows.h"
#include "host/run/run_parts.h"

/* those of inputs that sampled devices and events hold, in n columns from a time on each */
static void
add_held (gs_run_result *r, int size, const double *held, int n)
{
  for (int i = 0; i < r->rows; i++)
    {
      const double t = (double)r->times[i];
      const double *last = NULL;
      for (int k = 0; k < n; k++)
        {
          const double *from = held + (ptrdiff_t)(1 + size) * k;
          if (from[0] < t - 1e-12 * fabs (t) || (i == 0 && from[0] <= t))
            last = from;
        }
      for (int k = 0; k < size && last; k++)
        r->dv[(ptrdiff_t)size * i + k] += last[1 + k];
    }
}

/* what an output and its parts are made of at one row */
typedef struct
{
  gs_real *a, *b, *c, *d, *p;
} parts;

/* the derivatives dy (ny,nc) of the outputs in row i: C*S + D*dv and what parameters do by
 * themselves */
static void
of_outputs (const gs_whole_run *w, gs_real t, int i, const parts *m, double *dy)
{
  const gs_scene *s = w->d->scene;
  const gs_run_result *r = w->r;
  const int nc = w->o->ncolumns, ny = s->ny;
  const gs_real *x = r->x + (ptrdiff_t)r->nx * i, *v = r->v + (ptrdiff_t)r->ldv * i;
  const int info = s->jac (t, x, v, r->cst, m->a, s->nx, m->b, s->nx, m->c, ny, m->d, ny);
  const int worse = s->oup (t, x, v, r->cst, m->p, ny);
  if ((info != 0 && info != 2) || (worse != 0 && worse != 2))
    return;
  for (int k = 0; k < nc; k++)
    for (int j = 0; j < ny; j++)
      {
        const int of = w->o->columns[k];
        const double *dv = r->dv + (ptrdiff_t)s->nv * (nc * i + k);
        double sum = of > 0 ? (double)m->p[j + ny * (of - 1)] : 0;
        for (int l = 0; l < s->nx; l++)
          sum += (double)(m->c[j + ny * l] * x[s->nx * (k + 1) + l]);
        for (int l = 0; l < s->nv; l++)
          sum += (double)m->d[j + ny * l] * dv[l];
        dy[j + ny * k] = sum;
      }
}

/* ... in all rows; where the scene lacks a routine they stay as they are */
static void
all_outputs (const gs_whole_run *w, const parts *m)
{
  const gs_scene *s = w->d->scene;
  const gs_run_result *r = w->r;
  gs_real switches[s->nsw + 1];
  if (s->nsw > 0)
    s->swi (r->cst, switches);
  for (int i = 0; i < r->rows && s->ny > 0 && s->jac && s->oup; i++)
    of_outputs (w, gs_row_time (r->times, i, r->istat[GS_N_OUTPUTS], s->nsw, switches), i, m,
                r->dy + (ptrdiff_t)s->ny * w->o->ncolumns * i);
}

/* no derivatives by column k from row i on */
static void
lose (gs_whole_run *w, int k, int i)
{
  const gs_scene *s = w->d->scene;
  const int nc = w->o->ncolumns;
  gs_run_result *r = w->r;
  for (; i < r->rows; i++)
    {
      for (int j = 0; j < s->nx; j++)
        r->x[(ptrdiff_t)r->nx * i + s->nx * (k + 1) + j] = (gs_real)NAN;
      for (int j = 0; j < s->nv; j++)
        r->dv[(ptrdiff_t)s->nv * (nc * i + k) + j] = NAN;
      for (int j = 0; j < s->ny; j++)
        r->dy[(ptrdiff_t)s->ny * (nc * i + k) + j] = NAN;
    }
}

static void
lose_columns (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  for (int k = 0; k < w->o->ncolumns; k++)
    {
      int event = 0, i = 0;
      double t = 0;
      if (! gs_derivatives_lost (r->derivatives, k, &event, &t))
        continue;
      while (i < r->rows && (double)r->times[i] < t)
        i++;
      lose (w, k, i);
      gs_derivatives_drop_times (r->derivatives, k, t);
    }
}

int
gs_take_slopes (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  gs_run_result *r = w->r;
  const double *held = NULL;
  const int size = s->nv * w->o->ncolumns, n = gs_derivatives_held (r->derivatives, &held);
  const int nx = s->nx, nv = s->nv, ny = s->ny;
  gs_real *room = calloc ((size_t)((nx + ny) * (nx + nv) + ny * s->nsp + 1), sizeof *room);
  if (n < 0 || ! room)
    {
      free (room);
      return GS_OUT_OF_MEMORY;
    }
  const parts m = { room, room + nx * nx, room + nx * (nx + nv), room + nx * (nx + nv) + ny * nx,
                    room + (nx + ny) * (nx + nv) };
  for (ptrdiff_t k = 0; k < (ptrdiff_t)ny * w->o->ncolumns * r->nt; k++)
    r->dy[k] = NAN;
  if (gs_derivatives_followed (r->derivatives))
    gs_derivatives_of_inputs (r->derivatives, r->rows, r->times, r->x, r->nx, r->v, r->ldv, r->dv);
  add_held (r, size, held, n);
  all_outputs (w, &m);
  lose_columns (w);
  free (room);
  return 0;
}

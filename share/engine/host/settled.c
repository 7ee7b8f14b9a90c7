/* settled.c: states that start where their rates vanish: filters of sensors, observers. */
#include <stdlib.h>
#include <string.h>

#include "gsmbp/functions.h"
#include "gsmbp/solve.h"
#include "host/start.h"

enum { TURNS = 20 };

typedef struct
{
  const gs_description *d;
  gs_real t;
  const gs_real *cst;
  gs_real *x, *moved, *xd, *v;   /* nx, nx, nx, nv */
  gs_real *f, *slope;            /* nsettled; squared */
  int *order;                    /* nsettled */
} settling;

/* 2: constraints are dependent, 3: angles are close to their singularity: results are usable */
static int
rates (const settling *w, const gs_real *x)
{
  const int info = w->d->scene->rhs (w->t, x, w->v, w->cst, w->xd);
  return info == 0 || info == 2 || info == 3;
}

/* the rates of the settled states, and their Jacobian by these, by differences; 0 if it fails */
static int
linearize (const settling *w)
{
  const gs_description *d = w->d;
  const int n = d->nsettled;
  if (! rates (w, w->x))
    return 0;
  for (int i = 0; i < n; i++)
    w->f[i] = w->xd[d->settled[i]];
  for (int k = 0; k < n; k++)
    {
      const int own = d->settled[k];
      memcpy (w->moved, w->x, (size_t)d->scene->nx * sizeof *w->x);
      w->moved[own] += GS_R (1e-3) * (gs_real)d->nominal[own];
      const gs_real h = w->moved[own] - w->x[own];
      if (! rates (w, w->moved))
        return 0;
      for (int i = 0; i < n; i++)
        w->slope[i + n * k] = (w->xd[d->settled[i]] - w->f[i]) / h;
    }
  return gs_not_finite (n, w->f) == 0 && gs_not_finite (n * n, w->slope) == 0;
}

/* Newton's method; 1 if it has found where the rates vanish */
static int
find (const settling *w)
{
  const gs_description *d = w->d;
  const int n = d->nsettled;
  for (int turn = 0; turn < TURNS; turn++)
    {
      if (! linearize (w) || gs_solve_general (n, 1, w->slope, n, w->f, n, w->order) != 0)
        return 0;
      int small = 1;
      for (int i = 0; i < n; i++)
        {
          gs_real *y = w->x + d->settled[i];
          *y -= w->f[i];
          small &= gs_abs (w->f[i])
                   <= GS_R (1e-12) * ((gs_real)d->nominal[d->settled[i]] + gs_abs (*y));
        }
      if (small)
        return 1;
    }
  return 0;
}

/* the state on the constraints, if that can be */
static void
close_state (const settling *w, const gs_real *x)
{
  const gs_scene *s = w->d->scene;
  gs_real res;
  memcpy (w->x, x, (size_t)s->nx * sizeof *x);
  memcpy (w->moved, x, (size_t)s->nx * sizeof *x);
  if (s->prj && s->prj (w->t, w->moved, w->cst, &res) == 0 && gs_not_finite (s->nx, w->moved) == 0)
    memcpy (w->x, w->moved, (size_t)s->nx * sizeof *x);
}

void
gs_settle_states (const gs_description *d, gs_real t, const gs_real *cst, const int *fixed,
                  gs_real *x)
{
  const size_t n = (size_t)d->nsettled, nx = (size_t)d->scene->nx, nv = (size_t)d->scene->nv;
  if (n == 0 || ! d->scene->rhs)
    return;
  gs_real *room = calloc (3 * nx + nv + n + n * n, sizeof *room);
  int *order = malloc (n * sizeof *order);
  if (room && order)
    {
      const settling w = { d, t, cst, room, room + nx, room + 2 * nx, room + 3 * nx,
                           room + 3 * nx + nv, room + 3 * nx + nv + n, order };
      close_state (&w, x);
      const int found = find (&w);
      for (size_t i = 0; i < n && found; i++)
        if (! (fixed && fixed[d->settled[i]]))
          x[d->settled[i]] = w.x[d->settled[i]];
    }
  free (room);
  free (order);
}

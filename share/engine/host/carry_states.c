/* carry_states.c: internal states of devices along a planned motion, by extrapolation of the
 * linearly implicit Euler method, which stiff ones let take long steps. Source: Hairer and Wanner,
 * Solving Ordinary Differential Equations II, section IV.9. */
#include <math.h>
#include <stdlib.h>

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"
#include "host/planned_parts.h"
#include "host/text.h"

enum { COLUMNS = 8 }; /* of the table: the order */

/* far below what a plot or a table of the command shows */
static const double relative = 1e-11, absolute = 1e-13;

/* n internal states; arrays are room */
typedef struct
{
  gs_plan_way *w;
  int n, *pivots, info;
  gs_real *devices, *f, *moved, *jacobian, *matrix, *y, *table;
} carried;

/* the rates f at t in the states y; 0: there are none */
static int
rates (carried *c, gs_real t, const gs_real *y, gs_real *f)
{
  gs_plan_way *w = c->w;
  const gs_description *d = w->d;
  const int first = d->scene->nq + d->scene->nu + 1;
  if (! gs_planned_to (w, &w->inner, t, 1))
    return 0;
  for (int k = 0; k < c->n; k++)
    c->devices[d->followed[k] - first] = y[k];
  c->info = d->scene->cmd (t, w->inner.qj, c->devices, w->a->cst, w->v, w->xid);
  int good = c->info == 0;
  for (int k = 0; k < c->n; k++)
    {
      f[k] = w->xid[d->followed[k] - first];
      good = good && isfinite ((double)f[k]);
    }
  return good;
}

/* the Jacobian (n,n) at t in the states y, by differences */
static int
slopes (carried *c, gs_real t, const gs_real *y)
{
  const gs_description *d = c->w->d;
  const int n = c->n;
  if (! rates (c, t, y, c->f))
    return 0;
  gs_copy (n, y, c->y);
  for (int k = 0; k < n; k++)
    {
      const double size = fmax (fabs ((double)y[k]), d->nominal[d->followed[k] - 1]);
      const gs_real step = (gs_real)(1e-7 * size);
      c->y[k] = y[k] + step;
      if (! rates (c, t, c->y, c->moved))
        return 0;
      for (int i = 0; i < n; i++)
        c->jacobian[i + n * k] = (c->moved[i] - c->f[i]) / step;
      c->y[k] = y[k];
    }
  return 1;
}

/* from y at t by steps of the length h, so many, into z */
static int
small_steps (carried *c, gs_real t, gs_real h, int steps, const gs_real *y, gs_real *z)
{
  const int n = c->n;
  gs_copy (n, y, z);
  for (int s = 1; s <= steps; s++)
    {
      if (! rates (c, t + (gs_real)s * h, z, c->f))
        return 0;
      for (int i = 0; i < n * n; i++)
        c->matrix[i] = (gs_real)(i % (n + 1) == 0) - h * c->jacobian[i];
      for (int i = 0; i < n; i++)
        c->f[i] *= h;
      if (gs_solve_general (n, 1, c->matrix, n, c->f, n, c->pivots) != 0)
        return 0;
      for (int i = 0; i < n; i++)
        z[i] += c->f[i];
    }
  return 1;
}

/* the states y from t on by h, into c->y; its error beside what is allowed; INFINITY: none */
static double
extrapolated (carried *c, gs_real t, gs_real h, const gs_real *y, double size)
{
  const int n = c->n;
  gs_real *row = c->table; /* (n,COLUMNS): of the table the last row */
  double worst = 0;
  if (! slopes (c, t, y))
    return INFINITY;
  for (int j = 1; j <= COLUMNS; j++)
    {
      if (! small_steps (c, t, h / (gs_real)j, j, y, c->y))
        return INFINITY;
      for (int i = 0; i < n; i++)
        {
          gs_real now = c->y[i];
          for (int k = 0; k < j - 1; k++)
            {
              const gs_real before = row[i + n * k];
              row[i + n * k] = now;
              now += (now - before) * (gs_real)(j - k - 1) / (gs_real)(k + 1);
            }
          row[i + n * (j - 1)] = now;
        }
    }
  for (int i = 0; i < n; i++)
    {
      const gs_real last = row[i + n * (COLUMNS - 1)], one = row[i + n * (COLUMNS - 2)];
      const double off = fabs ((double)(last - one));
      const double allowed = absolute * size + relative * fabs ((double)last);
      worst = ! (off / allowed <= worst) ? off / allowed : worst;
      c->y[i] = last;
    }
  return isnan (worst) ? INFINITY : worst;
}

static int
give_up (carried *c, gs_real from, gs_real to)
{
  gs_plan_way *w = c->w;
  char text[600];
  const char *meaning = c->info && w->d->meaning ? w->d->meaning ("cmd", c->info) : NULL;
  snprintf (text, sizeof text, "%.500s",
            w->text[0] ? w->text : meaning ? meaning : "too small steps");
  gs_writer s = { w->text, w->size, 0 };
  gs_put (&s, "the internal states cannot be integrated from t = %.9g s to %.9g s: %s",
          (double)from, (double)to, text);
  return 3;
}

static int
integrate (carried *c, gs_real from, gs_real to, gs_real *y)
{
  const int n = c->n;
  gs_real t = from, h = (to - from) / 4;
  double size = 1;
  c->w->text[0] = 0;
  for (int i = 0; i < n; i++)
    size = fmax (size, fabs ((double)y[i]));
  if (! gs_planned_to (c->w, &c->w->inner, from, 1))
    return give_up (c, from, to);
  while (gs_abs (to - t) > 0)
    {
      const int last = gs_abs (h) >= gs_abs (to - t);
      h = last ? to - t : h;
      c->w->text[0] = 0;
      const double error = extrapolated (c, t, h, y, size);
      if (error <= 1)
        {
          t = last ? to : t + h;
          gs_copy (n, c->y, y);
        }
      else if (! (gs_abs (h) > (gs_real)(1e-12 * fmax (1, fabs ((double)to)))))
        return give_up (c, from, to);
      const double factor = error < INFINITY ? 0.8 * pow (fmax (error, 1e-12), -1. / COLUMNS) : 0.2;
      h *= (gs_real)fmin (4, fmax (0.2, factor));
    }
  c->w->text[0] = 0;
  return 0;
}

int
gs_carry_states (gs_plan_way *w, gs_real from, gs_real to, gs_real *devices)
{
  const gs_description *d = w->d;
  const int n = d->nfollowed, all = d->scene->nx - d->scene->nq - d->scene->nu;
  const int first = d->scene->nq + d->scene->nu + 1;
  carried c = { .w = w, .n = n };
  gs_real *room = calloc ((size_t)(all + n * (2 * n + COLUMNS + 4) + 1), sizeof *room);
  c.pivots = calloc ((size_t)n + 1, sizeof *c.pivots);
  int bad = 1;
  if (room && c.pivots)
    {
      gs_real *y = room + all;
      c.devices = room;
      c.f = y + n;
      c.moved = c.f + n;
      c.y = c.moved + n;
      c.jacobian = c.y + n;
      c.matrix = c.jacobian + n * n;
      c.table = c.matrix + n * n;
      gs_copy (all, devices, c.devices);
      for (int k = 0; k < n; k++)
        y[k] = devices[d->followed[k] - first];
      bad = integrate (&c, from, to, y);
      for (int k = 0; ! bad && k < n; k++)
        devices[d->followed[k] - first] = y[k];
    }
  free (c.pivots);
  free (room);
  return bad;
}

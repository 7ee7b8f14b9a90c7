/* rest_newton.c: equations of rest and of steady motions; Newton's method, damped. */
#include "gsmbp/functions.h"
#include "host/linear/linear_parts.h"

enum { TURNS = 200 };

int
gs_rest_unknowns (const gs_rest *p)
{
  return p->nown + p->ninputs;
}

int
gs_rest_equations (const gs_rest *p)
{
  return p->nrows + (p->moves ? 2 : 1) * p->w->s->nlam + p->w->d->nsets;
}

void
gs_rest_put (const gs_rest *p, const gs_real *z)
{
  for (int i = 0; i < p->nown; i++)
    p->x[p->own[i]] = z[i];
  for (int i = 0; i < p->ninputs; i++)
    p->v[p->inputs[i]] = z[p->nown + i];
}

static void
no_numbers (int n, gs_real *f)
{
  for (int i = 0; i < n; i++)
    f[i] = (gs_real)NAN;
}

static int
usable (int info)
{
  return info == 0 || info == 2;
}

/* the rows of the rates; xd: (nx) */
static void
rates_of (const gs_rest *p, gs_real t, gs_real *xd, gs_real *f)
{
  const gs_work *w = p->w;
  if (! usable (w->s->rhs (t, p->x, p->v, w->cst, xd)))
    no_numbers (w->s->nx, xd);
  for (int i = 0; i < p->nrows; i++)
    f[i] = xd[p->rows[i]];
}

/* constraints, and their rates where speeds are not zero; u: (nu) */
static void
constraints_of (const gs_rest *p, gs_real t, gs_real *u, gs_real *phi, gs_real *h, gs_real *f)
{
  const gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nlam;
  if (p->moves)
    gs_copy (s->nu, p->x + s->nq, u);
  if (! usable (s->con (t, p->x, u, w->cst, phi, phi + n, h, n, phi + 2 * n)))
    no_numbers (3 * n, phi);
  gs_copy (n, phi, f);
  for (int i = 0; i < n && p->moves; i++)
    {
      f[n + i] = phi[n + i];
      for (int j = 0; j < s->nu; j++)
        f[n + i] += h[i + n * j] * u[j];
    }
}

static void
lengths_of (const gs_rest *p, gs_real *f)
{
  for (int k = 0; k < p->w->d->nsets; k++)
    {
      f[k] = -1;
      for (int i = 0; i < 4; i++)
        f[k] += p->x[p->w->d->sets[4 * k + i]] * p->x[p->w->d->sets[4 * k + i]];
    }
}

/* derivatives of the rates */
static void
rate_slopes (const gs_rest *p, gs_real t, int ne, gs_real *jacobian)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int ny = gs_most (1, s->ny);
  gs_real *a = gs_numbers (w, (s->nx + ny) * (s->nx + s->nv));
  if (! a)
    return;
  gs_real *b = a + s->nx * s->nx, *c = b + s->nx * s->nv, *d = c + ny * s->nx;
  if (! usable (s->jac (t, p->x, p->v, w->cst, a, s->nx, b, s->nx, c, ny, d, ny)))
    no_numbers (s->nx * (s->nx + s->nv), a);
  for (int i = 0; i < p->nrows; i++)
    {
      for (int j = 0; j < p->nown; j++)
        jacobian[i + ne * j] = a[p->rows[i] + s->nx * p->own[j]];
      for (int j = 0; j < p->ninputs; j++)
        jacobian[i + ne * (p->nown + j)] = b[p->rows[i] + s->nx * p->inputs[j]];
    }
}

/* derivatives of constraints and their rates; h: the Jacobian of the constraints by speeds */
static void
constraint_slopes (const gs_rest *p, gs_real t, const gs_real *h, int ne, gs_real *jacobian)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nlam;
  gs_real *dp = gs_numbers (w, 2 * n * s->nq), *dv = dp ? dp + n * s->nq : dp;
  if (! dp)
    return;
  s->tan (t, p->x, w->cst, dp, n, dv, n);
  for (int j = 0; j < p->nown; j++)
    for (int i = 0; i < n; i++)
      {
        const int k = p->own[j];
        gs_real *to = jacobian + p->nrows + i + ne * j;
        to[0] = k < s->nq ? dp[i + n * k] : 0;
        if (p->moves)
          to[n] = k < s->nq ? dv[i + n * k] : k < s->nq + s->nu ? h[i + n * (k - s->nq)] : 0;
      }
}

static void
length_slopes (const gs_rest *p, int first, int ne, gs_real *jacobian)
{
  for (int k = 0; k < p->w->d->nsets; k++)
    for (int j = 0; j < p->nown; j++)
      jacobian[first + k + ne * j]
          = gs_is_among (p->own[j], 4, p->w->d->sets + 4 * k) ? 2 * p->x[p->own[j]] : 0;
}

void
gs_rest_at (const gs_rest *p, const gs_real *z, gs_real t, gs_real *f, gs_real *jacobian)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const gs_scene *s = w->s;
  const int ne = gs_rest_equations (p), last = ne - w->d->nsets;
  gs_real *xd = gs_numbers (w, s->nx), *u = gs_numbers (w, s->nu);
  gs_real *phi = gs_numbers (w, 3 * s->nlam), *h = gs_numbers (w, s->nlam * s->nu);
  no_numbers (ne, f);
  if (xd && u && phi && h)
    {
      gs_rest_put (p, z);
      if (p->nrows > 0)
        rates_of (p, t, xd, f);
      if (s->nlam > 0)
        constraints_of (p, t, u, phi, h, f + p->nrows);
      lengths_of (p, f + last);
      if (jacobian)
        {
          gs_zero (ne * gs_rest_unknowns (p), jacobian);
          if (p->nrows > 0)
            rate_slopes (p, t, ne, jacobian);
          if (s->nlam > 0)
            constraint_slopes (p, t, h, ne, jacobian);
          length_slopes (p, last, ne, jacobian);
        }
    }
  gs_work_back (w, begin);
}

/* ------------------------------------------------------------------------------ Newton's method */

gs_real
gs_rest_bound (const gs_rest *p, const gs_real *step)
{
  const gs_description *d = p->w->d;
  gs_real part = 1;
  for (int i = 0; i < gs_rest_unknowns (p); i++)
    {
      const int k = i < p->nown ? p->own[i] : d->scene->nx;
      gs_real most = 10;
      if (k < d->scene->nq && d->angles[k])
        most = GS_R (0.5);
      if (gs_is_among (k, 4 * d->nsets, d->sets))
        most = GS_R (0.25);
      if (gs_abs (step[i]) * part > most)
        part = most / gs_abs (step[i]);
    }
  return part;
}

/* Newton's correction in units of the usual sizes: row (equations) sizes of these, inverse
 * (unknowns, equations), which leaves out what moves nothing */
typedef struct
{
  int n, ne;
  gs_real *row, *inverse, *f, *scaled;
} corrector;

/* 0: there is none at z */
static int
find_corrector (const gs_rest *p, const gs_real *z, corrector *c)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  gs_real *k = gs_numbers (w, c->ne * c->n);
  int good = k != NULL;
  if (k)
    {
      gs_rest_at (p, z, p->w->t, c->f, k);
      for (int i = 0; i < c->ne; i++)
        {
          c->row[i] = 0;
          for (int j = 0; j < c->n; j++)
            c->row[i] += gs_abs (k[i + c->ne * j]) * p->size[j];
          if (! (c->row[i] > 0))
            c->row[i] = 1;
        }
      for (int j = 0; j < c->n; j++)
        for (int i = 0; i < c->ne; i++)
          k[i + c->ne * j] *= p->fixed && p->fixed[j] ? 0 : p->size[j] / c->row[i];
      good = gs_not_finite (c->ne * c->n, k) == 0 && gs_not_finite (c->ne, c->f) == 0;
      if (good)
        gs_pseudo_inverse (w, c->ne, c->n, k, GS_R (1e-12), c->inverse);
      for (int j = 0; good && p->fixed && j < c->n; j++)
        for (int i = 0; i < c->ne && p->fixed[j]; i++)
          c->inverse[j + c->n * i] = 0;
    }
  gs_work_back (w, begin);
  return good;
}

/* the correction at z by a corrector of a state close by; its length */
static gs_real
correction (const gs_rest *p, const corrector *c, const gs_real *z, gs_real *step)
{
  gs_rest_at (p, z, p->w->t, c->f, NULL);
  for (int i = 0; i < c->ne; i++)
    c->scaled[i] = -c->f[i] / c->row[i];
  gs_product (c->n, c->ne, 1, c->inverse, c->scaled, step);
  return gs_sqrt (gs_dot (c->n, 0, step, step));
}

static gs_real
largest (int n, const gs_real *x)
{
  gs_real most = 0;
  for (int i = 0; i < n; i++)
    most = gs_max (most, gs_abs (x[i]));
  return most;
}

/* next := z with as much of the step as makes it shorter; 0: no part of it does. other: (n) */
static int
damped (const gs_rest *p, const corrector *c, const gs_real *z, const gs_real *step, gs_real length,
        gs_real *damping, gs_real *next, gs_real *other)
{
  const gs_real most = largest (c->n, step), part = gs_rest_bound (p, step);
  gs_real h = 4 * *damping < 1 ? 4 * *damping : 1;
  h = part < h ? part : h;
  for (; h > GS_R (1e-9); h /= 2)
    {
      for (int i = 0; i < c->n; i++)
        next[i] = z[i] + h * step[i] * p->size[i];
      *damping = h;
      if (correction (p, c, next, other) <= (1 - h / 4) * length
          || (h >= 1 && most < GS_R (1e-7)))
        return 1;
    }
  return 0;
}

static void
iterate (const gs_rest *p, corrector *c, gs_real *z, gs_real *step, gs_real *next, gs_real *other)
{
  gs_real damping = 1;
  for (int turn = 0; turn < TURNS && find_corrector (p, z, c); turn++)
    {
      const gs_real length = correction (p, c, z, step);
      if (! (length > 0) || ! damped (p, c, z, step, length, &damping, next, other))
        return;
      if (largest (c->n, step) < GS_R (1e-7) && correction (p, c, next, other) >= length / 2)
        return;   /* rounding: nothing is gained any more */
      gs_copy (c->n, next, z);
    }
}

void
gs_rest_newton (const gs_rest *p, gs_real *z)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const int n = gs_rest_unknowns (p), ne = gs_rest_equations (p);
  corrector c = { n, ne, gs_numbers (w, ne), gs_numbers (w, n * ne), gs_numbers (w, ne),
                  gs_numbers (w, ne) };
  gs_real *step = gs_numbers (w, n), *next = gs_numbers (w, n), *other = gs_numbers (w, n);
  if (c.row && c.inverse && c.f && c.scaled && step && next && other)
    iterate (p, &c, z, step, next, other);
  gs_work_back (w, begin);
  gs_rest_put (p, z);
}

/* ------------------------------------------------------------------------- what follows from it */

/* unknowns of x that follow from the constraints alone: how many; the last one below end */
static int
list_others (const gs_scene *s, const gs_free_velocities *f, int end, int *own)
{
  int n = 0;
  for (int i = 0; i < end; i++)
    if (i < s->nq ? ! gs_is_among (i, f->nq, f->q) : ! gs_is_among (i - s->nq, f->nu, f->u))
      own[n++] = i;
  return n;
}

/* x with the others that stand below end; the largest equation that is left */
static gs_real
follow (gs_work *w, const gs_free_velocities *f, int end, gs_real *x)
{
  const gs_scene *s = w->s;
  gs_block *begin = w->blocks;
  int *own = gs_places (w, end);
  gs_real *size = gs_numbers (w, end), *z = gs_numbers (w, end), *v = gs_numbers (w, s->nv);
  gs_real *left = gs_numbers (w, 2 * s->nlam + w->d->nsets), most = (gs_real)HUGE_VAL;
  if (own && size && z && v && left)
    {
      const int n = list_others (s, f, end, own);
      const gs_rest p = { w, x, v, n, 0, 0, own, NULL, NULL, NULL, size, end > s->nq };
      for (int i = 0; i < n; i++)
        {
          size[i] = (gs_real)w->d->nominal[own[i]];
          z[i] = x[own[i]];
        }
      gs_rest_newton (&p, z);
      gs_rest_at (&p, z, w->t, left, NULL);
      const int ne = gs_rest_equations (&p);
      most = gs_not_finite (ne, left) ? (gs_real)HUGE_VAL : largest (ne, left);
    }
  gs_work_back (w, begin);
  return most;
}

void
gs_follow_rest (gs_work *w, gs_real t, const gs_free_velocities *f, gs_real *x)
{
  const gs_scene *s = w->s;
  const gs_real now = w->t;
  w->t = t;
  if (s->nlam > 0 || s->nq > s->nu)
    follow (w, f, s->nq + s->nu, x);
  w->t = now;
}

int
gs_close_rest (gs_work *w, const gs_free_velocities *held, gs_real *x)
{
  return follow (w, held, w->s->nq, x) <= GS_R (1e-10);
}

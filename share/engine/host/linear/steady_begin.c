/* steady_begin.c: unknowns and equations of a steady motion, in which coordinates run on. */
#include "host/linear/trim_parts.h"

/* the state with the speeds that follow from those that are free */
static int
with_dependent_speeds (gs_work *w, const gs_free_velocities *f, gs_real *x)
{
  const gs_scene *s = w->s;
  const int n = s->nlam, m = n + f->nu;
  gs_block *begin = w->blocks;
  if (n == 0)
    return 0;
  gs_real *phi = gs_numbers (w, 3 * n), *h = gs_numbers (w, n * s->nu);
  gs_real *a = gs_numbers (w, m * s->nu), *b = gs_numbers (w, m);
  gs_real *inverse = gs_numbers (w, s->nu * m);
  if (phi && h && a && b && inverse)
    {
      const int info
          = s->con (w->t, x, x + s->nq, w->cst, phi, phi + n, h, n, phi + 2 * n);
      if (info != 0 && info != 2)
        gs_work_failed (w, GS_LINEAR_FAILED, "con", info);
      for (int i = 0; i < n; i++)
        {
          gs_put_row (s->nu, h, n, i, a, m, i);
          b[i] = -phi[n + i];
        }
      for (int i = 0; i < f->nu; i++)
        {
          a[n + i + m * f->u[i]] = 1;
          b[n + i] = x[s->nq + f->u[i]];
        }
      gs_pseudo_inverse (w, m, s->nu, a, GS_R (1e-13), inverse);
      gs_product (s->nu, m, 1, inverse, b, x + s->nq);
    }
  gs_work_back (w, begin);
  return w->told->verdict;
}

static void
run (gs_trim_problem *p, int q)
{
  if (! gs_is_among (q, p->nrunning, p->running))
    p->running[p->nrunning++] = q;
}

/* coordinates on which neither rates nor constraints depend */
static int
run_without_effect (gs_trim_problem *p)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nlam;
  gs_real *a = gs_numbers (w, s->nx * s->nx), *dp = gs_numbers (w, n * s->nq);
  gs_real *dv = gs_numbers (w, n * s->nq);
  if (! a || ! dp || ! dv
      || gs_jacobian_there (w, p->rest.x, p->rest.v, a, NULL, NULL, NULL) != 0)
    return w->told->verdict;
  if (n > 0)
    s->tan (w->t, p->rest.x, w->cst, dp, n, dv, n);
  for (int j = 0; j < s->nq; j++)
    {
      int any = gs_is_among (j, 4 * w->d->nsets, w->d->sets);
      for (int i = s->nq; i < s->nx; i++)
        any |= a[i + s->nx * j] != 0;
      for (int i = 0; i < n; i++)
        any |= dp[i + n * j] != 0 || dv[i + n * j] != 0;
      if (! any)
        run (p, j);
    }
  return 0;
}

/* coordinates that move with time alone, while the free speeds are zero */
static int
run_driven (gs_trim_problem *p)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  gs_real *x = gs_numbers (w, s->nx), *xd = gs_numbers (w, s->nx);
  if (s->nlam == 0)
    return 0;
  if (! x || ! xd)
    return w->told->verdict;
  gs_copy (s->nx, p->rest.x, x);
  for (int i = 0; i < p->free.nu; i++)
    x[s->nq + p->free.u[i]] = 0;
  if (with_dependent_speeds (w, &p->free, x) != 0
      || gs_rates_there (w, w->t, x, p->rest.v, xd) != 0)
    return w->told->verdict;
  for (int i = 0; i < s->nq; i++)
    if (gs_abs (xd[i]) > GS_R (1e-12) * (gs_real)w->d->nominal[i])
      run (p, i);
  return 0;
}

/* does state i stay as it is: kept, not freed, and not what follows from the constraints */
static int
is_fixed (const gs_trim_problem *p, int i)
{
  const gs_scene *s = p->w->s;
  const gs_trim_asked *o = p->asked;
  const int held = gs_is_among (i, o->nhold, o->hold);
  if (i < s->nq)
    return gs_is_among (i, p->free.nq, p->free.q)
           && (held || gs_is_among (i, p->nrunning, p->running));
  int kept = held;
  for (int k = 0; k < o->nrunning; k++)
    kept |= i == s->nq + o->running[2 * k + 1];
  return kept && ! gs_is_among (i, o->nspeeds, o->speeds)
         && (i >= s->nq + s->nu || gs_is_among (i - s->nq, p->free.nu, p->free.u));
}

/* what follows from the constraints stays an unknown */
static void
list_unknowns (gs_trim_problem *p)
{
  const gs_scene *s = p->w->s;
  gs_rest *r = &p->rest;
  for (int i = 0; i < s->nx; i++)
    {
      if (! is_fixed (p, i))
        p->own[r->nown++] = i;
      if (i < s->nq ? ! gs_is_among (i, p->nrunning, p->running)
                    : i >= s->nq + s->nu || gs_is_among (i - s->nq, p->free.nu, p->free.u))
        p->rows[r->nrows++] = i;
    }
}

int
gs_steady_begin (gs_trim_problem *p)
{
  gs_work *w = p->w;
  const gs_trim_asked *o = p->asked;
  int *speeds = gs_places (w, o->nrunning);
  p->free.q = gs_places (w, w->s->nq);
  p->free.u = gs_places (w, w->s->nu);
  if (! speeds || ! p->free.q || ! p->free.u)
    return w->told->verdict;
  for (int k = 0; k < o->nrunning; k++)
    {
      run (p, o->running[2 * k]);
      speeds[k] = o->running[2 * k + 1];
    }
  if (gs_find_free_velocities (w, p->rest.x, o->nrunning, speeds, &p->free) != 0
      || with_dependent_speeds (w, &p->free, p->rest.x) != 0 || run_without_effect (p) != 0
      || run_driven (p) != 0)
    return w->told->verdict;
  list_unknowns (p);
  return 0;
}

/* dropped.c: coordinates that run steadily, on which nothing depends, taken out of a model. */
#include "host/linear/linear_parts.h"

typedef struct
{
  int n;
  const int *own;    /* n states */
  const gs_real *a;  /* (n,n): the Jacobian of their rates */
  int *depends, *keep; /* (n,n), n */
  gs_real *size;     /* n: usual magnitudes */
} dropping;

static int
is_coordinate (const gs_work *w, int state)
{
  return state < w->s->nq;
}

/* of the coordinates those that are asked for are not kept */
static int
mark_asked (gs_work *w, const gs_linear_place *at, const gs_linear_asked *asked, dropping *p)
{
  gs_real *xd = gs_numbers (w, w->s->nx);
  if (! xd || (asked->running && gs_rates_there (w, w->t, at->x, at->v, xd) != 0))
    return w->told->verdict;
  for (int i = 0; i < p->n; i++)
    {
      const int k = p->own[i];
      const int runs = is_coordinate (w, k)
                       && gs_abs (xd[k]) > GS_R (1e-9) * (gs_real)w->d->nominal[k];
      p->keep[i] = asked->running ? ! runs : ! gs_is_among (k, asked->ndrop, asked->drop);
    }
  return 0;
}

/* which rates depend on which states, beside rounding */
static void
mark_dependences (const gs_work *w, dropping *p)
{
  const int n = p->n;
  gs_real all = 0, row;
  for (int turn = 0; turn < 2; turn++)
    for (int i = 0; i < n; i++)
      {
        const int mechanical = p->own[i] < w->s->nq + w->s->nu;
        row = 0;
        for (int j = 0; j < n; j++)
          row = gs_max (row, gs_abs (p->a[i + n * j]) * p->size[j]);
        if (turn == 0 && mechanical)
          all = gs_max (all, row);
        gs_real least = gs_max (GS_R (1e-9) * row, GS_R (1e-18) * p->size[i]);
        if (mechanical)
          least = gs_max (least, GS_R (1e-11) * all);
        for (int j = 0; j < n; j++)
          p->depends[i + n * j] = gs_abs (p->a[i + n * j]) * p->size[j] > least;
      }
}

/* does a state that is kept depend on state j */
static int
kept_depends (const dropping *p, int j)
{
  for (int i = 0; i < p->n; i++)
    if (p->keep[i] && p->depends[i + p->n * j])
      return 1;
  return 0;
}

static int
depends_on_dropped (const dropping *p, int i)
{
  for (int j = 0; j < p->n; j++)
    if (! p->keep[j] && p->depends[i + p->n * j])
      return 1;
  return 0;
}

/* coordinates that depend on what is dropped, and carry nothing else along */
static void
drop_followers (gs_work *w, dropping *p)
{
  int *more = gs_places (w, p->n), many = 1;
  while (more && many > 0)
    {
      many = 0;
      for (int j = 0; j < p->n; j++)
        if (p->keep[j] && is_coordinate (w, p->own[j]) && depends_on_dropped (p, j)
            && ! kept_depends (p, j))
          more[many++] = j;
      for (int k = 0; k < many; k++)
        p->keep[more[k]] = 0;
    }
}

static int
refuse_any (gs_work *w, const dropping *p)
{
  const int n = p->n;
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n && ! p->keep[j]; i++)
      if (p->keep[i] && p->depends[i + n * j])
        {
          gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
          gs_put (&said, "%s cannot be dropped: the rate of %s depends on it; only what nothing "
                  "depends on can be (a coordinate that is ignorable)",
                  w->d->states[p->own[j]], w->d->states[p->own[i]]);
          return w->told->verdict;
        }
  return 0;
}

static int
refuse_changed (gs_work *w, const dropping *p, int i, int j)
{
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  int many = 0;
  for (int k = 0; k < p->n; k++)
    if (! p->keep[k])
      gs_put (&said, "%s%s", many++ ? ", " : "", w->d->states[p->own[k]]);
  gs_put (&said, " cannot be dropped: what the rate of %s has of %s changes with it, the motion is "
          "not steady there", w->d->states[p->own[i]], w->d->states[p->own[j]]);
  return w->told->verdict;
}

/* the state where what is dropped has moved, with what follows */
static int
further_on (gs_work *w, const gs_linear_place *at, const dropping *p, gs_real *y)
{
  const gs_scene *s = w->s;
  gs_free_velocities f = { 0, 0, gs_places (w, s->nq), gs_places (w, s->nu) };
  if (! f.q || ! f.u)
    return w->told->verdict;
  gs_copy (s->nx, at->x, y);
  for (int i = 0; i < p->n; i++)
    {
      const int k = p->own[i];
      if (! p->keep[i])
        y[k] += GS_R (0.618) * p->size[i];
      if (k < s->nq)
        f.q[f.nq++] = k;
      else if (k < s->nq + s->nu)
        f.u[f.nu++] = k - s->nq;
    }
  gs_follow_rest (w, w->t, &f, y);
  return w->told->verdict;
}

/* the Jacobian of the same states there: e (n,n) */
static int
jacobian_further_on (gs_work *w, const gs_linear_place *at, const dropping *p, gs_real *e)
{
  const gs_scene *s = w->s;
  gs_real *y = gs_numbers (w, s->nx), *a = gs_numbers (w, s->nx * s->nx);
  gs_real *tangent = gs_numbers (w, s->nx * s->nx), *rows = gs_numbers (w, p->n * s->nx);
  int *own = gs_places (w, s->nx), n;
  if (! y || ! a || ! tangent || ! rows || ! own || further_on (w, at, p, y) != 0
      || gs_loop_tangent (w, y, p->own, p->n, 0, NULL, tangent, own, &n) != 0
      || gs_jacobian_there (w, y, at->v, a, NULL, NULL, NULL) != 0)
    return w->told->verdict;
  for (int i = 0; i < n; i++)
    gs_put_row (s->nx, a, s->nx, own[i], rows, n, i);
  gs_product (n, s->nx, n, rows, tangent, e);
  return 0;
}

/* that Jacobian must be the same */
static int
check_further_on (gs_work *w, const gs_linear_place *at, const dropping *p)
{
  const int n = p->n;
  gs_real *e = gs_numbers (w, n * n), *limit = gs_numbers (w, n);
  if (! e || ! limit || jacobian_further_on (w, at, p, e) != 0)
    return w->told->verdict;
  for (int i = 0; i < n; i++)
    {
      for (int j = 0; j < n; j++)
        if (p->keep[j])
          limit[i] = gs_max (limit[i], gs_abs (p->a[i + n * j]) * p->size[j]);
      limit[i] = GS_R (1e-7) * gs_max (limit[i], p->size[i]);
    }
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++)
      if (p->keep[i] && p->keep[j]
          && gs_abs (e[i + n * j] - p->a[i + n * j]) * p->size[j] > limit[i])
        return refuse_changed (w, p, i, j);
  return 0;
}

int
gs_without_states (gs_work *w, const gs_linear_place *at, const gs_linear_asked *asked, int n,
                   const int *own, const gs_real *a, int *keep)
{
  gs_block *begin = w->blocks;
  dropping p = { n, own, a, gs_places (w, n * n), keep, gs_numbers (w, n) };
  if (p.depends && p.size && mark_asked (w, at, asked, &p) == 0)
    {
      for (int i = 0; i < n; i++)
        p.size[i] = (gs_real)w->d->nominal[own[i]];
      mark_dependences (w, &p);
      drop_followers (w, &p);
      if (w->told->verdict == 0 && refuse_any (w, &p) == 0)
        check_further_on (w, at, &p);
    }
  gs_work_back (w, begin);
  return w->told->verdict;
}

/* trim_solve.c: equilibria by Newton's method, by Levenberg's, by the motion itself. */
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"
#include "host/linear/trim_parts.h"

enum { TURNS = 200, STEPS = 300 };

void
gs_trim_rows (const gs_trim_problem *p, const gs_real *jacobian, gs_real *row)
{
  const int ne = gs_rest_equations (&p->rest);
  for (int i = 0; i < ne; i++)
    {
      row[i] = 0;
      for (int j = 0; j < gs_rest_unknowns (&p->rest); j++)
        row[i] += gs_abs (jacobian[i + ne * j]) * p->size[j];
    }
}

gs_real
gs_trim_worst (const gs_trim_problem *p, const gs_real *z, gs_real t, gs_real tolerance,
               gs_real *beside, gs_real *f)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *jacobian = gs_numbers (w, ne * n), *found = gs_numbers (w, ne), worst = 0;
  if (! jacobian || ! found)
    return (gs_real)HUGE_VAL;
  gs_rest_at (&p->rest, z, t, found, jacobian);
  for (int i = 0; i < ne; i++)
    {
      gs_real rounding = 0;
      for (int j = 0; j < n; j++)
        rounding += gs_abs (jacobian[i + ne * j]) * gs_max (gs_abs (z[j]), p->size[j]);
      /* where derivatives are infinite (lost rank) rounding hides nothing */
      rounding *= 1000 * gs_epsilon ();
      if (rounding > GS_R (1e-3) * p->usual[i])
        rounding = GS_R (1e-3) * p->usual[i];
      gs_real one = gs_abs (found[i]) / gs_max (tolerance * p->usual[i], rounding);
      if (gs_not_finite (1, &one) != 0)
        one = (gs_real)HUGE_VAL;
      worst = gs_max (worst, one);
      if (beside)
        beside[i] = one;
      if (f)
        f[i] = found[i];
    }
  gs_work_back (w, begin);
  return worst;
}

/* -------------------------------------------------------------------------- Levenberg's method */

/* at z: equations g and derivatives k in usual sizes, above mu times the unit matrix; 0: they are
 * not finite. k (ne + n, n), row (ne) */
static int
scaled (const gs_trim_problem *p, const gs_real *z, gs_real mu, gs_real *jacobian, gs_real *k,
        gs_real *g, gs_real *row)
{
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest), m = ne + n;
  gs_rest_at (&p->rest, z, p->w->t, g, jacobian);
  gs_trim_rows (p, jacobian, row);
  gs_zero (m * n, k);
  for (int i = 0; i < ne; i++)
    {
      row[i] = gs_max (row[i], p->usual[i]);
      g[i] /= row[i];
      for (int j = 0; j < n; j++)
        k[i + m * j] = jacobian[i + ne * j] * p->size[j] / row[i];
    }
  for (int j = 0; j < n; j++)
    k[ne + j + m * j] = gs_sqrt (mu);
  return gs_not_finite (m * n, k) == 0 && gs_not_finite (ne, g) == 0;
}

/* the length of the equations at z in the sizes row */
static gs_real
length (const gs_trim_problem *p, const gs_real *z, const gs_real *row, gs_real *f)
{
  const int ne = gs_rest_equations (&p->rest);
  gs_rest_at (&p->rest, z, p->w->t, f, NULL);
  for (int i = 0; i < ne; i++)
    f[i] /= row[i];
  return gs_sqrt (gs_dot (ne, 0, f, f));
}

/* least squares in scaled equations, where Newton's method stands still: regularized, so that a
 * derivative that vanishes does no harm */
static void
levenberg (gs_trim_problem *p, gs_real *z)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest), m = ne + n;
  gs_real *jacobian = gs_numbers (w, ne * n), *k = gs_numbers (w, m * n), *g = gs_numbers (w, m);
  gs_real *row = gs_numbers (w, ne), *f = gs_numbers (w, ne), *inverse = gs_numbers (w, n * m);
  gs_real *step = gs_numbers (w, n), *next = gs_numbers (w, n), mu = GS_R (1e-3), most = 1;
  for (int turn = 0; turn < TURNS && mu <= GS_R (1e12) && ! (most < GS_R (1e-8)); turn++)
    {
      if (w->told->verdict || ! scaled (p, z, mu, jacobian, k, g, row))
        break;
      gs_pseudo_inverse (w, m, n, k, gs_epsilon (), inverse);
      gs_product (n, m, 1, inverse, g, step);
      most = 0;
      for (int j = 0; j < n; j++)
        {
          step[j] = -step[j];
          most = gs_max (most, gs_abs (step[j]));
        }
      const gs_real part = gs_rest_bound (&p->rest, step);
      for (int j = 0; j < n; j++)
        next[j] = z[j] + part * step[j] * p->size[j];
      const int better = length (p, next, row, f) < gs_sqrt (gs_dot (ne, 0, g, g));
      if (better)
        gs_copy (n, next, z);
      mu *= better ? GS_R (0.2) : 4;
    }
  gs_work_back (w, begin);
  gs_rest_newton (&p->rest, z);
}

/* -------------------------------------------------------------------------- the motion itself */

/* an implicit Euler step in n states that move, by usual sizes: f becomes it */
typedef struct
{
  int n, *moving, *order;
  gs_real *a, *k, *f, *xd, h, least, before;
} euler;

/* rates f and Jacobian k at x in usual sizes: the length of f, 0 where it is not finite */
static gs_real
euler_rates (gs_trim_problem *p, euler *e, const gs_real *x)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const double *nominal = w->d->nominal;
  const int info = s->rhs (w->t, x, p->rest.v, w->cst, e->xd);
  if ((info != 0 && info != 2)
      || gs_jacobian_there (w, x, p->rest.v, e->a, NULL, NULL, NULL) != 0)
    {
      w->told->verdict = 0;
      return 0;
    }
  for (int i = 0; i < e->n; i++)
    {
      const int r = e->moving[i];
      e->f[i] = e->xd[r] / (gs_real)nominal[r];
      for (int j = 0; j < e->n; j++)
        e->k[i + e->n * j] = e->a[r + s->nx * e->moving[j]] * (gs_real)nominal[e->moving[j]]
                             / (gs_real)nominal[r];
    }
  if (gs_not_finite (e->n * e->n, e->k) != 0 || gs_not_finite (e->n, e->f) != 0)
    return 0;
  return gs_sqrt (gs_dot (e->n, 0, e->f, e->f));
}

/* one step of x; 0: there is no other */
static int
euler_step (gs_trim_problem *p, euler *e, int turn, gs_real *x)
{
  const gs_scene *s = p->w->s;
  const gs_real now = euler_rates (p, e, x);
  gs_real residual, most = 0;
  if (! (now > 0))
    return 0;
  if (turn == 0)
    e->h = e->least = GS_R (0.3) / now;
  else
    {
      const gs_real grow = gs_max (GS_R (0.5), e->before / now);
      e->h = gs_max (e->least, e->h * (grow < 2 ? grow : 2));
    }
  e->before = now;
  for (int i = 0; i < e->n * e->n; i++)
    e->k[i] = (i % (e->n + 1) == 0 ? 1 / e->h : 0) - e->k[i];
  if (gs_solve_general (e->n, 1, e->k, e->n, e->f, e->n, e->order) != 0)
    return 0;
  for (int i = 0; i < e->n; i++)
    if (e->moving[i] < s->nq)
      most = gs_max (most, gs_abs (e->f[i]));
  for (int i = 0; i < e->n; i++)
    x[e->moving[i]] += (gs_real)p->w->d->nominal[e->moving[i]] * e->f[i] / gs_max (1, 2 * most);
  if ((s->nlam > 0 || s->nq > s->nu) && s->prj)
    s->prj (p->w->t, x, p->w->cst, &residual);
  return 1;
}

static int
is_held (const gs_trim_problem *p, int i)
{
  const gs_scene *s = p->w->s;
  const gs_trim_asked *o = p->asked;
  return gs_is_among (i, o->nhold, o->hold)
         || (s->nq == s->nu && i >= s->nq && i < s->nq + s->nu
             && gs_is_among (i - s->nq, o->nhold, o->hold));
}

/* the motion by implicit Euler steps that grow as it comes to rest: it ends in a stable
 * equilibrium */
static void
transient (gs_trim_problem *p, gs_real *z)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const gs_scene *s = w->s;
  if (p->rest.nown == 0 || p->rest.moves)
    return;   /* no state may move, or some go on moving */
  gs_real *x = gs_numbers (w, s->nx);
  euler e = { 0, gs_places (w, s->nx), gs_places (w, s->nx), gs_numbers (w, s->nx * s->nx),
              gs_numbers (w, s->nx * s->nx), gs_numbers (w, s->nx), gs_numbers (w, s->nx), 0, 0,
              0 };
  if (w->told->verdict == 0)
    {
      gs_rest_put (&p->rest, z);
      gs_copy (s->nx, p->rest.x, x);
      for (int i = 0; i < s->nx; i++)
        if (! is_held (p, i))
          e.moving[e.n++] = i;
      for (int turn = 0; turn < STEPS && euler_step (p, &e, turn, x); turn++)
        ;
      for (int i = 0; i < p->rest.nown; i++)
        z[i] = x[p->own[i]];
    }
  gs_work_back (w, begin);
  gs_rest_newton (&p->rest, z);
}

/* ----------------------------------------------------------------------------------- solutions */

void
gs_trim_solve (gs_trim_problem *p, gs_real *z, int *way)
{
  const int n = gs_rest_unknowns (&p->rest);
  const gs_real tolerance = (gs_real)p->asked->tolerance;
  gs_real *other = gs_numbers (p->w, n), best;
  *way = GS_TRIM_NEWTON;
  gs_copy (n, p->z, z);
  if (! other || n == 0)   /* all is held: it is an equilibrium, or none */
    return;
  best = gs_trim_worst (p, z, p->w->t, tolerance, NULL, NULL);
  for (int k = GS_TRIM_NEWTON; k <= GS_TRIM_TRANSIENT; k++)
    {
      gs_copy (n, p->z, other);
      if (k == GS_TRIM_NEWTON)
        gs_rest_newton (&p->rest, other);
      else if (k == GS_TRIM_LEVENBERG)
        levenberg (p, other);
      else
        transient (p, other);
      const gs_real now = gs_trim_worst (p, other, p->w->t, tolerance, NULL, NULL);
      if (now < best)
        {
          best = now;
          gs_copy (n, other, z);
        }
      *way = k;
      if (best <= 1)
        break;
    }
}

int
gs_trim_free (const gs_trim_problem *p, const gs_real *z, gs_real *basis)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *k = gs_numbers (w, ne * n), *row = gs_numbers (w, ne), *f = gs_numbers (w, ne);
  gs_real most = 0;
  int columns = 0;
  if (k && row && f)
    {
      gs_rest_at (&p->rest, z, w->t, f, k);
      gs_trim_rows (p, k, row);
      for (int i = 0; i < ne; i++)
        most = gs_max (most, row[i]);
      for (int i = 0; i < ne; i++)
        {
          if (! (row[i] > GS_R (1e-20) * most))
            row[i] = 1;   /* a row of noise is none */
          for (int j = 0; j < n; j++)
            k[i + ne * j] *= p->size[j] / row[i];
        }
      columns = gs_null_space (w, ne, n, k, GS_R (1e-12) * gs_norm (w, ne, n, k), basis);
    }
  gs_work_back (w, begin);
  return columns;
}

/* is unknown k the state of a device whose rate depends on nothing that may change */
static int
is_undriven (const gs_trim_problem *p, const gs_real *jacobian, int k)
{
  const gs_rest *r = &p->rest;
  const int ne = gs_rest_equations (r);
  if (k >= r->nown || p->own[k] < p->w->s->nq + p->w->s->nu)
    return 0;
  for (int i = 0; i < r->nrows; i++)
    for (int j = 0; j < gs_rest_unknowns (r) && p->rows[i] == p->own[k]; j++)
      if (jacobian[i + ne * j] != 0)
        return 0;
  return 1;
}

/* unknowns that are left as in the guess: those that nothing drives (an integrator without gain),
 * then the others, as many as are independent: how many */
static int
choose_kept (const gs_trim_problem *p, const gs_real *z, int columns, const gs_real *basis,
             int *kept)
{
  gs_work *w = p->w;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *jacobian = gs_numbers (w, ne * n), *f = gs_numbers (w, ne);
  gs_real *part = gs_numbers (w, (columns + 1) * columns);
  int many = 0;
  if (! jacobian || ! f || ! part)
    return 0;
  gs_rest_at (&p->rest, z, w->t, f, jacobian);
  for (int turn = 1; turn >= 0; turn--)
    for (int k = 0; k < n && many < columns; k++)
      if (is_undriven (p, jacobian, k) == turn)
        {
          kept[many] = k;
          for (int i = 0; i <= many; i++)
            gs_put_row (columns, basis, n, kept[i], part, many + 1, i);
          many += gs_rank (w, many + 1, columns, part, GS_R (1e-6)) > many;
        }
  return many;
}

void
gs_trim_nearest (gs_trim_problem *p, int columns, const gs_real *basis, gs_real *z)
{
  gs_work *w = p->w;
  gs_block *begin = w->blocks;
  const int n = gs_rest_unknowns (&p->rest);
  gs_real *y = gs_numbers (w, n);
  int *kept = gs_places (w, n);
  const int many = y && kept ? choose_kept (p, z, columns, basis, kept) : 0;
  if (many > 0)
    {
      gs_copy (n, z, y);
      for (int i = 0; i < many; i++)
        {
          y[kept[i]] = p->z[kept[i]];
          p->fixed[kept[i]] = 1;
        }
      gs_rest_newton (&p->rest, y);
      if (gs_trim_worst (p, y, w->t, (gs_real)p->asked->tolerance, NULL, NULL) <= 1)
        gs_copy (n, y, z);
      else
        for (int i = 0; i < many; i++)
          p->fixed[kept[i]] = 0;
    }
  gs_work_back (w, begin);
}

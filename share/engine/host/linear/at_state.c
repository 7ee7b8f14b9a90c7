/* at_state.c: what the routines of the scene give at a state. */
#include "gsmbp/functions.h"
#include "host/linear/linear_parts.h"

/* 0 where the results are good, also those of dependent constraints, which are told */
static int
usable (gs_work *w, const char *routine, int info)
{
  if (info == 2)
    {
      w->told->routine = routine;
      w->told->info = info;
    }
  return info == 0 || info == 2 ? 0 : gs_work_failed (w, GS_LINEAR_FAILED, routine, info);
}

int
gs_rates_there (gs_work *w, gs_real t, const gs_real *x, const gs_real *v, gs_real *xd)
{
  if (! w->s->rhs)
    return gs_work_failed (w, GS_LINEAR_ABSENT, "rhs", 0);
  return usable (w, "rhs", w->s->rhs (t, x, v, w->cst, xd));
}

int
gs_jacobian_there (gs_work *w, const gs_real *x, const gs_real *v, gs_real *a, gs_real *b,
                   gs_real *c, gs_real *d)
{
  const gs_scene *s = w->s;
  gs_block *begin = w->blocks;
  if (! s->jac)
    return gs_work_failed (w, GS_LINEAR_ABSENT, "jac", 0);
  const int ny = gs_most (1, s->ny);
  gs_real *rest = b && c && d ? NULL : gs_numbers (w, (s->nx + ny) * (s->nx + s->nv));
  if (! rest && ! (b && c && d))
    return w->told->verdict;
  gs_real *const rc = b ? rest : rest + s->nx * s->nv, *const rd = c ? rc : rc + ny * s->nx;
  const int info = s->jac (w->t, x, v, w->cst, a, s->nx, b ? b : rest, s->nx, c ? c : rc, ny,
                           d ? d : rd, ny);
  gs_work_back (w, begin);
  return usable (w, "jac", info);
}

int
gs_slopes_there (gs_work *w, const gs_real *x, const gs_real *v, gs_real *p, gs_real *a, gs_real *b,
                 gs_real *xd)
{
  const gs_scene *s = w->s;
  if (! s->rhp)
    return gs_work_failed (w, GS_LINEAR_ABSENT, "rhp", 0);
  return usable (w, "rhp", s->rhp (w->t, x, v, w->cst, p, s->nx, a, s->nx, b, s->nx, xd));
}

int
gs_first_not_finite (int m, int n, const gs_real *a, int *row, int *column)
{
  int found = 0;
  for (int k = 0; k < m * n; k++)
    {
      const int infinite = ! (a[k] == a[k]) ? 0 : gs_not_finite (1, a + k) != 0;
      if (gs_not_finite (1, a + k) == 0 || (found && ! infinite))
        continue;
      *row = k % m;
      *column = k / m;
      found = 1;
      if (infinite)
        return 1;
    }
  return found;
}

/* rows of Euler parameters: half the derivative of the square of their length */
static void
orientation_rows (const gs_work *w, const gs_real *x, gs_constraint_rows *rows)
{
  for (int k = 0; k < w->d->nsets; k++)
    for (int i = 0; i < 4; i++)
      {
        const int place = w->d->sets[4 * k + i];
        rows->p[k + rows->np * place] = x[place];
        rows->k[k + rows->nk * place] = x[place];
      }
}

/* rows of loops, behind those */
static int
loop_rows (gs_work *w, const gs_real *x, gs_constraint_rows *rows)
{
  const gs_scene *s = w->s;
  const int n = s->nlam, first = w->d->nsets;
  gs_real *dp = gs_numbers (w, n * s->nq), *dv = gs_numbers (w, n * s->nq);
  gs_real *phi = gs_numbers (w, 3 * n), *h = gs_numbers (w, n * s->nu);
  if (! s->tan || ! s->con)
    return gs_work_failed (w, GS_LINEAR_ABSENT, s->tan ? "con" : "tan", 0);
  if (! dp || ! dv || ! phi || ! h)
    return w->told->verdict;
  s->tan (w->t, x, w->cst, dp, n, dv, n);
  if (usable (w, "con", s->con (w->t, x, x + s->nq, w->cst, phi, phi + n, h, n, phi + 2 * n)))
    return w->told->verdict;
  for (int i = 0; i < n; i++)
    {
      gs_put_row (s->nq, dp, n, i, rows->p, rows->np, first + i);
      gs_put_row (s->nq, dp, n, i, rows->k, rows->nk, first + i);
      gs_put_row (s->nq, dv, n, i, rows->k, rows->nk, first + n + i);
      gs_put_row (s->nu, h, n, i, rows->h, rows->nh, i);
      gs_put_row (s->nu, h, n, i, rows->k + rows->nk * s->nq, rows->nk, first + n + i);
    }
  return 0;
}

static void
held_rows (const gs_work *w, int nheld, const int *held, gs_constraint_rows *rows)
{
  for (int k = 0; k < nheld; k++)
    {
      const int q = held[2 * k], u = held[2 * k + 1];
      rows->p[rows->np - nheld + k + rows->np * q] = 1;
      rows->h[rows->nh - nheld + k + rows->nh * u] = 1;
      rows->k[rows->nk - 2 * nheld + 2 * k + rows->nk * q] = 1;
      rows->k[rows->nk - 2 * nheld + 2 * k + 1 + rows->nk * (w->s->nq + u)] = 1;
    }
}

int
gs_constraints_there (gs_work *w, const gs_real *x, int nheld, const int *held,
                      gs_constraint_rows *rows)
{
  const gs_scene *s = w->s;
  rows->np = w->d->nsets + s->nlam + nheld;
  rows->nh = s->nlam + nheld;
  rows->nk = w->d->nsets + 2 * (s->nlam + nheld);
  rows->p = gs_numbers (w, rows->np * s->nq);
  rows->h = gs_numbers (w, rows->nh * s->nu);
  rows->k = gs_numbers (w, rows->nk * s->nx);
  if (! rows->p || ! rows->h || ! rows->k)
    return w->told->verdict;
  orientation_rows (w, x, rows);
  if (s->nlam > 0 && loop_rows (w, x, rows) != 0)
    return w->told->verdict;
  held_rows (w, nheld, held, rows);
  return 0;
}

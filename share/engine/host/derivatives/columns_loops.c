/* columns_loops.c: what an event of the user sets in a closed chain: the other coordinates and
 * speeds follow from the constraints. Where these leave a choice, which the projection of the state
 * decides, there are no derivatives: columns are given up. */
#include "host/derivatives/columns.h"

/* rows A*S + b = 0 of nlam constraints on n states from place from on */
typedef struct
{
  int from, n;
  const gs_real *a, *b; /* (nlam,n), (nlam,nc) */
} loop_rows;

/* a small dense system A*y + r = 0 of m rows and n unknowns for several right sides: rows of
   n + sides numbers */
typedef struct
{
  int m, n, sides;
  gs_real *a;
  int *where, *used; /* of each unknown its row, -1: none yet; of each row whether it is taken */
} small_system;

static gs_real *
at (const small_system *y, int i, int j)
{
  return y->a + i * (y->n + y->sides) + j;
}

/* ------------------------------------------------------------------------------- the system */

/* the largest number in rows and columns that are not taken, 0: none */
static gs_real
find_pivot (const small_system *y, int *row, int *column)
{
  gs_real most = 0;
  for (int i = 0; i < y->m; i++)
    for (int j = 0; j < y->n && ! y->used[i]; j++)
      if (y->where[j] < 0 && gs_abs (*at (y, i, j)) > most)
        {
          most = gs_abs (*at (y, i, j));
          *row = i;
          *column = j;
        }
  return most;
}

static void
eliminate (const small_system *y, int row, int column)
{
  for (int i = 0; i < y->m; i++)
    {
      const gs_real f = i == row ? 0 : *at (y, i, column) / *at (y, row, column);
      for (int j = 0; j < y->n + y->sides && f != 0; j++)
        *at (y, i, j) -= f * *at (y, row, j);
    }
}

/* how many columns of A are independent; solved where all of them are */
static int
solve (const small_system *y)
{
  gs_real first = 0;
  for (int i = 0; i < y->m; i++)
    y->used[i] = 0;
  for (int j = 0; j < y->n; j++)
    y->where[j] = -1;
  for (int k = 0; k < y->n; k++)
    {
      int row = -1, column = -1;
      const gs_real most = find_pivot (y, &row, &column);
      first = gs_max (first, most);
      if (! (most > (gs_real)1e-9 * first))
        return k;
      y->used[row] = 1;
      y->where[column] = row;
      eliminate (y, row, column);
    }
  return y->n;
}

/* -------------------------------------------------------------------------------- the columns */

/* do the rows hold for all columns? */
static int
rows_hold (const gs_derivatives *d, const gs_real *x, const loop_rows *r)
{
  const int m = d->inner.nlam;
  for (int k = 0; k < d->nc; k++)
    for (int i = 0; i < m; i++)
      {
        gs_real sum = r->b[i + m * k], size = gs_abs (sum);
        for (int j = 0; j < r->n; j++)
          {
            const gs_real part = r->a[i + m * j] * gs_column (d, x, k)[r->from + j];
            sum += part;
            size += gs_abs (part);
          }
        if (gs_abs (sum) > (gs_real)1e-9 * size)
          return 0;
      }
  return 1;
}

/* the system of what the event has not set, the y->n unknowns in d->loops.free */
static void
fill_system (const gs_derivatives *d, const gs_real *x, const loop_rows *r, const small_system *y)
{
  const int m = d->inner.nlam;
  for (int i = 0; i < m; i++)
    {
      for (int j = 0; j < y->n; j++)
        *at (y, i, j) = r->a[i + m * d->loops.free[j]];
      for (int k = 0; k < d->nc; k++)
        {
          gs_real *side = at (y, i, y->n + k);
          *side = r->b[i + m * k];
          for (int j = 0; j < r->n; j++)
            if (d->loops.set[r->from + j])
              *side += r->a[i + m * j] * gs_column (d, x, k)[r->from + j];
        }
    }
}

/* that of the rows */
static small_system
system_of (gs_derivatives *d, const gs_real *x, const loop_rows *r)
{
  small_system y = { d->inner.nlam, 0, d->nc, d->loops.system, d->loops.where, d->loops.used };
  for (int j = 0; j < r->n; j++)
    if (! d->loops.set[r->from + j])
      d->loops.free[y.n++] = j;
  fill_system (d, x, r, &y);
  return y;
}

/* what the event has not set follows from the rows; 0: these leave a choice */
static int
follow (gs_derivatives *d, gs_real *x, const loop_rows *r)
{
  const small_system y = system_of (d, x, r);
  if (solve (&y) < y.n)
    return 0;
  for (int k = 0; k < d->nc; k++)
    for (int j = 0; j < y.n; j++)
      gs_column_in (d, x, k)[r->from + d->loops.free[j]]
          = -*at (&y, y.where[j], y.n + k) / *at (&y, y.where[j], j);
  return 1;
}

/* ------------------------------------------------------------------------ the rows at a state */

static int
read_rows (gs_derivatives *d, gs_real t, const gs_real *x)
{
  const gs_scene *s = &d->inner;
  const gs_real *cst = gs_columns_constants (d), *u = x + s->nq;
  const gs_loop_rows *r = &d->rows;
  const int m = s->nlam, info = s->con (t, x, u, cst, r->phi, r->phit, r->hc, m, r->gam);
  s->tan (t, x, cst, r->dp, m, r->dv, m);
  s->cop (t, x, cst, r->pp, m, r->pv, m);
  if (s->kin)
    s->kin (t, x, u, cst, r->qdot);
  else
    gs_copy (s->nu, u, r->qdot);
  return info;
}

/* what is next to S in the rows on coordinates, or on speeds, along the motion: d->loops.b */
static void
next_to_columns (gs_derivatives *d, const gs_real *x, int speeds)
{
  const int m = d->inner.nlam, nq = d->inner.nq;
  const gs_loop_rows *r = &d->rows;
  const gs_real *by = speeds ? r->pv : r->pp;
  for (int k = 0; k < d->nc; k++)
    for (int i = 0; i < m; i++)
      {
        gs_real sum = d->col[k] > 0 ? by[i + m * (d->col[k] - 1)] : 0,
                by_time = speeds ? -r->gam[i] : r->phit[i];
        for (int j = 0; j < nq && speeds; j++)
          {
            by_time -= r->dv[i + m * j] * r->qdot[j];
            sum += r->dv[i + m * j] * gs_column (d, x, k)[j];
          }
        d->loops.b[i + m * k] = sum + by_time * d->tau[k];
      }
}

/* has the projection moved the n states from place from on? */
static int
is_moved (const gs_derivatives *d, const gs_real *x, int from, int n)
{
  const gs_real *xa = d->set.xa;
  for (int i = from; i < from + n; i++)
    if (! (gs_abs (x[i] - xa[i]) <= (gs_real)1e-9 * (1 + gs_abs (xa[i]))))
      return 1;
  return 0;
}

/* do coordinates or speeds follow from what the event has set? */
static int
fit (gs_derivatives *d, gs_real *x, int speeds)
{
  const int from = speeds ? d->inner.nq : 0, n = speeds ? d->inner.nu : d->inner.nq;
  const loop_rows r = { from, n, speeds ? d->rows.hc : d->rows.dp, d->loops.b };
  const int moved = is_moved (d, x, from, n);
  int set = 0;
  next_to_columns (d, x, speeds);
  for (int i = 0; i < from + n; i++)
    set = set || d->loops.set[i];
  return (! moved && ! set) || (! moved && rows_hold (d, x, &r)) || follow (d, x, &r);
}

/* coordinates or speeds of the start, as gs_derivatives_start */
static int
start_rows (gs_derivatives *d, gs_real *x, int speeds)
{
  const int from = speeds ? d->inner.nq : 0, n = speeds ? d->inner.nu : d->inner.nq;
  const loop_rows r = { from, n, speeds ? d->rows.hc : d->rows.dp, d->loops.b };
  next_to_columns (d, x, speeds);
  if (! follow (d, x, &r))
    return GS_START_CHOICE;
  next_to_columns (d, x, speeds);
  return rows_hold (d, x, &r) ? 0 : GS_START_CONTRADICTION;
}

int
gs_derivatives_start (gs_derivatives *d, gs_real t, gs_real *x, const int *fixed)
{
  if (d->inner.nlam == 0)
    return 0;
  if (d->inner.nq != d->inner.nu || read_rows (d, t, x) != 0)
    return GS_START_UNDEFINED;
  for (int i = 0; i < d->inner.nq; i++)
    d->loops.set[i] = d->loops.set[d->inner.nq + i] = fixed[i];
  const int found = start_rows (d, x, 0);
  return found != 0 ? found : start_rows (d, x, 1);
}

int
gs_derivatives_freedoms (gs_derivatives *d, gs_real t, const gs_real *x)
{
  const loop_rows r = { d->inner.nq, d->inner.nu, d->rows.hc, d->loops.b };
  if (read_rows (d, t, x) != 0)
    return 0;
  for (int i = 0; i < d->inner.nx; i++)
    d->loops.set[i] = 0;
  const small_system y = system_of (d, x, &r);
  return d->inner.nu - solve (&y);
}

void
gs_columns_through_loops (gs_derivatives *d, gs_real t, gs_real *x, int k)
{
  if (d->inner.nlam == 0 || ! gs_columns_sets_states (d))
    return;
  for (int i = 0; i < d->inner.nx; i++)
    d->loops.set[i] = gs_columns_sets (d, i);
  const int info = read_rows (d, t, x);
  if (info == 0 && fit (d, x, 0) && fit (d, x, 1))
    return;
  for (int j = 0; j < d->nc; j++)
    gs_columns_give_up (d, x, j, t, k, info != 0 ? GS_UNDEFINED : GS_CHOICE);
}

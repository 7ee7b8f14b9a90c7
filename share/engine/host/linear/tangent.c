/* tangent.c: the deviations that constraints allow, by independent states. */
#include "gsmbp/solve.h"
#include "host/linear/linear_parts.h"

/* tangent (nx,n) := basis (nx,n) / its rows own, which become those of the unit matrix; 0 if these
 * are dependent */
static int
by_own (gs_work *w, int n, const int *own, const gs_real *basis, gs_real *tangent)
{
  const int nx = w->s->nx;
  gs_real *square = gs_numbers (w, n * n), *turned = gs_numbers (w, n * nx);
  int *order = gs_places (w, n);
  if (! square || ! turned || ! order)
    return 0;
  for (int i = 0; i < nx; i++)
    gs_put_row (n, basis, nx, i, turned + n * i, 1, 0);
  for (int i = 0; i < n; i++)
    gs_put_row (n, basis, nx, own[i], square + n * i, 1, 0);
  if (n > 0 && gs_solve_general (n, nx, square, n, turned, n, order) != 0)
    return 0;
  for (int i = 0; i < nx; i++)
    gs_put_row (n, turned + n * i, 1, 0, tangent, nx, i);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      tangent[own[i] + nx * j] = i == j;
  return 1;
}

int
gs_tangent_of (gs_work *w, const gs_constraint_rows *rows, int n, const int *own, gs_real least,
               gs_real *tangent, int *left)
{
  gs_block *begin = w->blocks;
  const int nx = w->s->nx;
  gs_real *basis = gs_numbers (w, nx * nx), *square = gs_numbers (w, n * n);
  int good = 0;
  if (basis && square)
    {
      *left = gs_null_space (w, rows->nk, nx, rows->k, GS_R (1e-9), basis);
      for (int i = 0; i < n && *left == n; i++)
        gs_put_row (n, basis, nx, own[i], square, n, i);
      good = *left == n && gs_condition (w, n, square) >= least
             && by_own (w, n, own, basis, tangent);
    }
  gs_work_back (w, begin);
  return good && w->told->verdict == 0;
}

/* the columns of h (m,n) that a rank-revealing factorization leaves over, ascending: how many */
static int
left_over (gs_work *w, int m, int n, const gs_real *h, int *list)
{
  int *order = gs_places (w, n);
  if (! order)
    return 0;
  const int rank = gs_column_order (w, m, n, h, GS_R (1e-9), order);
  for (int j = rank; j < n; j++)
    list[j - rank] = order[j];
  gs_sort_places (n - rank, list);
  return n - rank;
}

/* those that are wanted, as coordinates q and speeds u */
static void
chosen (gs_work *w, const gs_constraint_rows *rows, int n, const int *wanted,
        gs_free_velocities *f)
{
  const gs_scene *s = w->s;
  f->nq = f->nu = 0;
  for (int i = 0; i < s->nq; i++)
    if (gs_is_among (i, n, wanted))
      f->q[f->nq++] = i;
  for (int i = 0; i < s->nu; i++)
    if (gs_is_among (s->nq + i, n, wanted))
      f->u[f->nu++] = i;
  if (f->nu == 0 && s->nq == s->nu)
    for (f->nu = 0; f->nu < f->nq; f->nu++)
      f->u[f->nu] = f->q[f->nu];
  else if (f->nu == 0)
    f->nu = left_over (w, rows->nh, s->nu, rows->h, f->u);
}

static void
by_jacobian (gs_work *w, const gs_constraint_rows *rows, gs_free_velocities *f)
{
  const gs_scene *s = w->s;
  f->nq = left_over (w, rows->np, s->nq, rows->p, f->q);
  f->nu = left_over (w, rows->nh, s->nu, rows->h, f->u);
  if (s->nq == s->nu && f->nq == f->nu)
    for (int i = 0; i < f->nu; i++)
      f->u[i] = f->q[i];
}

/* coordinates, speeds, states of devices; how many */
static int
with_devices (const gs_scene *s, const gs_free_velocities *f, int *own)
{
  int n = 0;
  for (int i = 0; i < f->nq; i++)
    own[n++] = f->q[i];
  for (int i = 0; i < f->nu; i++)
    own[n++] = s->nq + f->u[i];
  for (int i = s->nq + s->nu; i < s->nx; i++)
    own[n++] = i;
  return n;
}

static int
undetermined (gs_work *w, int n, const int *own, int left)
{
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  for (int i = 0; i < n; i++)
    gs_put (&said, "%s%s", i ? ", " : "", w->d->states[own[i]]);
  gs_put (&said, " do not determine the motion here: the constraints leave %d free states, %d are "
          "chosen", left, n);
  return w->told->verdict;
}

int
gs_loop_tangent (gs_work *w, const gs_real *x, const int *wanted, int nwanted, int nheld,
                 const int *held, gs_real *tangent, int *own, int *n)
{
  gs_block *begin = w->blocks;
  gs_constraint_rows rows;
  gs_free_velocities f = { .q = gs_places (w, w->s->nq), .u = gs_places (w, w->s->nu) };
  int left = 0;
  if (! f.q || ! f.u || gs_constraints_there (w, x, nheld, held, &rows) != 0)
    return w->told->verdict;
  if (rows.nk > 0 && wanted)
    chosen (w, &rows, nwanted, wanted, &f);
  else
    by_jacobian (w, &rows, &f);
  *n = with_devices (w->s, &f, own);
  if (! gs_tangent_of (w, &rows, *n, own, GS_R (1e-10), tangent, &left) && w->told->verdict == 0)
    undetermined (w, *n, own, left);
  gs_work_back (w, begin);
  return w->told->verdict;
}

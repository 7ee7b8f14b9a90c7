/* free_velocities.c: which coordinates and speeds move independently. */
#include "host/linear/linear_parts.h"

enum { MOST_CHOICES = 300 };

/* rows of the n coordinates or speeds, as a matrix of one row after the other of basis (n,columns)
 * with the numbers list */
static void
rows_of (int n, int columns, const gs_real *basis, int many, const int *list, gs_real *part)
{
  for (int i = 0; i < many; i++)
    gs_put_row (columns, basis, n, list[i], part, many, i);
}

/* rows of basis (n,columns) that are independent: the first ones as far as they are, then those
 * that tell most; list (n): as many as there are columns */
static void
leading (gs_work *w, int n, int columns, const gs_real *basis, int nfirst, const int *first,
         int *list)
{
  gs_block *begin = w->blocks;
  gs_real *part = gs_numbers (w, n * columns), *rest = gs_numbers (w, columns * columns);
  gs_real *left = gs_numbers (w, n * columns), *turned = gs_numbers (w, n * columns);
  int *order = gs_places (w, n), many = 0;
  if (part && rest && left && turned && order)
    {
      for (int i = 0; i < nfirst && many < columns; i++)
        {
          list[many] = first[i];
          rows_of (n, columns, basis, many + 1, list, part);
          many += gs_rank (w, many + 1, columns, part, GS_R (1e-7)) > many;
        }
      rows_of (n, columns, basis, many, list, part);
      const int more = gs_null_space (w, many, columns, part, GS_R (1e-9), rest);
      gs_product (n, columns, more, basis, rest, left);
      for (int i = 0; i < n; i++)
        gs_put_row (more, left, n, i, turned + more * i, 1, 0);
      gs_column_order (w, more, n, turned, 0, order);
      for (int i = 0; i < more && many < columns; i++)
        list[many++] = order[i];
      gs_sort_places (many, list);
    }
  gs_work_back (w, begin);
}

/* a state beside x, where nothing vanishes by chance, and the Jacobian a of the rates there */
static int
beside (gs_work *w, const gs_real *x, gs_real *y, gs_real *a)
{
  const gs_scene *s = w->s;
  gs_real residual, *v = gs_numbers (w, s->nv);
  if (! v || ! s->prj)
    return v ? gs_work_failed (w, GS_LINEAR_ABSENT, "prj", 0) : w->told->verdict;
  gs_copy (s->nx, x, y);
  for (int i = 0; i < s->nq; i++)
    y[i] += GS_R (0.1) * gs_sin ((gs_real)(i + 1)) * (gs_real)w->d->nominal[i];
  for (int i = 0; i < s->nu; i++)
    y[s->nq + i] += GS_R (0.1) * gs_cos ((gs_real)(i + 1)) * (gs_real)w->d->nominal[s->nq + i];
  const int info = s->prj (w->t, y, w->cst, &residual);
  if (info != 0 && info != 2)
    return gs_work_failed (w, GS_LINEAR_FAILED, "prj", info);
  return gs_jacobian_there (w, y, v, a, NULL, NULL, NULL);
}

/* speeds are looked for among which the accelerations depend on few coordinates */
typedef struct
{
  gs_work *w;
  const gs_constraint_rows *rows; /* beside the state */
  const gs_real *a;               /* the Jacobian there */
  gs_real size;                   /* its largest entry of an acceleration: for what is rounding */
  int nq;
  const int *q;
  gs_real *tangent;
  int *own;
} search;

/* on how many coordinates the acceleration of speed u depends */
static int
depends_on (const search *f, int u)
{
  const gs_scene *s = f->w->s;
  gs_real most = gs_max (GS_R (1e-9), GS_R (1e-4) * f->size);
  int count = 0;
  for (int turn = 0; turn < 2; turn++)
    for (int j = 0; j < f->nq; j++)
      {
        gs_real sum = 0;
        for (int k = 0; k < s->nx; k++)
          sum += f->a[s->nq + u + s->nx * k] * f->tangent[k + s->nx * j];
        if (turn == 0)
          most = gs_max (most, gs_abs (sum));
        else
          count += gs_abs (sum) > GS_R (1e-9) * most;
      }
  return count;
}

/* the sum of that over the nu speeds, less where the others follow well from them; HUGE_VAL where
 * they do not follow */
static gs_real
dependences (const search *f, int nu, const int *u)
{
  const gs_scene *s = f->w->s;
  int n = 0, left, count = 0;
  for (int i = 0; i < f->nq; i++)
    f->own[n++] = f->q[i];
  for (int i = 0; i < nu; i++)
    f->own[n++] = s->nq + u[i];
  for (int i = s->nq + s->nu; i < s->nx; i++)
    f->own[n++] = i;
  if (! gs_tangent_of (f->w, f->rows, n, f->own, GS_R (1e-6), f->tangent, &left))
    return (gs_real)HUGE_VAL;
  for (int i = 0; i < nu; i++)
    count += depends_on (f, u[i]);
  return (gs_real)count - GS_R (0.9) / gs_norm (f->w, s->nx, n, f->tangent);
}

/* the next choice of many of n numbers, in the order of a dictionary; 0: there is none */
static int
next_choice (int n, int many, int *choice)
{
  for (int i = many - 1; i >= 0; i--)
    if (choice[i] < n - many + i)
      {
        choice[i]++;
        for (int j = i + 1; j < many; j++)
          choice[j] = choice[j - 1] + 1;
        return 1;
      }
  return 0;
}

/* as many as n choose many, no more than one above the most that are tried */
static int
choices (int n, int many)
{
  double count = 1;
  for (int i = 1; i <= many; i++)
    count *= (double)(n - many + i) / i;
  return count > MOST_CHOICES + 0.5 ? MOST_CHOICES + 1 : (int)(count + 0.5);
}

/* u (nu), which begins with the kept ones and then is any choice of others (n), becomes that of
 * which the accelerations depend on the fewest coordinates */
static void
fewest (const search *f, int kept, const int *others, int n, int nu, int *u, int *choice, int *try)
{
  gs_real least = (gs_real)HUGE_VAL;
  const int many = nu - kept;
  for (int i = 0; i < many; i++)
    choice[i] = i;
  int *first = try + nu;   /* the kept ones as they were */
  memcpy (first, u, (size_t)kept * sizeof *u);
  do
    {
      memcpy (try, first, (size_t)kept * sizeof *u);
      for (int i = 0; i < many; i++)
        try[kept + i] = others[choice[i]];
      gs_sort_places (nu, try);
      const gs_real count = dependences (f, nu, try);
      if (count < least)
        {
          least = count;
          memcpy (u, try, (size_t)nu * sizeof *u);
        }
    }
  while (next_choice (n, many, choice));
  gs_sort_places (nu, u);
}

/* f->u anew, where constraints on speeds leave a choice */
static int
choose_speeds (gs_work *w, const gs_real *x, int nfirst, const int *first, gs_free_velocities *f)
{
  const gs_scene *s = w->s;
  int *others = gs_places (w, s->nu), *list = gs_places (w, s->nu), kept = 0, n = 0;
  gs_real *y = gs_numbers (w, s->nx), *a = gs_numbers (w, s->nx * s->nx);
  gs_constraint_rows rows;
  search g = { w, &rows, a, 0, f->nq, f->q, gs_numbers (w, s->nx * s->nx), gs_places (w, s->nx) };
  int *choice = gs_places (w, s->nu), *try = gs_places (w, 2 * s->nu);
  if (! others || ! list || ! y || ! a || ! g.tangent || ! g.own || ! choice || ! try)
    return w->told->verdict;
  for (int i = 0; i < nfirst; i++)
    if (gs_is_among (first[i], f->nu, f->u))
      list[kept++] = first[i];
  for (int i = 0; i < s->nu; i++)
    if (! gs_is_among (i, kept, list))
      others[n++] = i;
  if (choices (n, f->nu - kept) > MOST_CHOICES)
    return 0;
  for (int i = 0, k = kept; i < f->nu; i++)
    if (! gs_is_among (f->u[i], kept, list))
      list[k++] = f->u[i];
  memcpy (f->u, list, (size_t)f->nu * sizeof *list);
  if (beside (w, x, y, a) != 0 || gs_constraints_there (w, y, 0, NULL, &rows) != 0)
    return w->told->verdict;
  for (int j = 0; j < s->nx; j++)
    for (int i = s->nq; i < s->nq + s->nu; i++)
      g.size = gs_max (g.size, gs_abs (a[i + s->nx * j]));
  fewest (&g, kept, others, n, f->nu, f->u, choice, try);
  return w->told->verdict;
}

int
gs_find_free_velocities (gs_work *w, const gs_real *x, int nfirst, const int *first,
                         gs_free_velocities *f)
{
  const gs_scene *s = w->s;
  gs_constraint_rows rows;
  gs_real *basis = gs_numbers (w, gs_most (s->nq * s->nq, s->nu * s->nu));
  int *wanted = gs_places (w, nfirst), nwanted = 0;
  if (! basis || ! wanted || gs_constraints_there (w, x, 0, NULL, &rows) != 0)
    return w->told->verdict;
  f->nu = gs_null_space (w, rows.nh, s->nu, rows.h, GS_R (1e-9), basis);
  leading (w, s->nu, f->nu, basis, nfirst, first, f->u);
  f->nq = f->nu;
  memcpy (f->q, f->u, (size_t)f->nu * sizeof *f->u);
  if (s->nq == s->nu && s->nlam == 0)
    return w->told->verdict;
  const int same = gs_rank (w, rows.np, s->nq, rows.p, GS_R (1e-9))
                   == gs_rank (w, rows.nh, s->nu, rows.h, GS_R (1e-9));
  for (int i = 0; i < nfirst; i++)
    if (first[i] < s->nq)
      wanted[nwanted++] = first[i];
  f->nq = gs_null_space (w, rows.np, s->nq, rows.p, GS_R (1e-9), basis);
  if (s->nq == s->nu && same)
    leading (w, s->nq, f->nq, basis, f->nu, f->u, f->q);
  else
    leading (w, s->nq, f->nq, basis, nwanted, wanted, f->q);
  if (s->nlam == 0 || same)
    return w->told->verdict;
  return choose_speeds (w, x, nfirst, first, f);
}

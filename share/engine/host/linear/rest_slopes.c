/* rest_slopes.c: how an equilibrium changes with parameters. */
#include "gsmbp/functions.h"
#include "host/linear/linear_parts.h"

/* rates of speeds and devices stay zero, constraints closed: all (m,nx+nv) dz = right (m,nsp) for
 * changes dz of states and inputs, of which those that are listed are unknown */
typedef struct
{
  gs_work *w;
  const gs_slopes_asked *asked;
  int m, n, *unknown; /* n: states, nx + inputs */
  gs_real *p, *ab;    /* (nx,nsp), (nx,nx+nv): the rates by parameters; by states and inputs */
  gs_real *all, *right;
} family;

static gs_real
size_of (const family *f, int k)
{
  return f->unknown[k] < f->w->s->nx ? (gs_real)f->w->d->nominal[f->unknown[k]] : 1;
}

static int
list_unknowns (family *f)
{
  const gs_scene *s = f->w->s;
  f->unknown = gs_places (f->w, s->nx + s->nv);
  if (! f->unknown)
    return f->w->told->verdict;
  for (int i = 0; i < s->nx; i++)
    if ((i < s->nq || i >= s->nq + s->nu) && ! gs_is_among (i, f->asked->nhold, f->asked->hold))
      f->unknown[f->n++] = i;
  for (int i = 0; i < f->asked->ninputs; i++)
    f->unknown[f->n++] = s->nx + f->asked->inputs[i];
  return 0;
}

/* is the state at rest? */
static int
check_rest (family *f, const gs_real *rates)
{
  gs_work *w = f->w;
  gs_real most = 0;
  int moves = 0;
  for (int i = 0; i < w->s->nx; i++)
    {
      const int speed = i >= w->s->nq && i < w->s->nq + w->s->nu;
      most = gs_max (most, gs_abs (rates[i] / (gs_real)w->d->nominal[i]));
      moves |= speed && gs_abs (w->at->x[i]) > 0;
    }
  if (! moves && most < GS_R (1e-6))
    return 0;
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  gs_put (&said, "expected an equilibrium, as trim finds it; found rates up to %.3g",
          (double)most);
  return w->told->verdict;
}

/* the derivatives of the rates */
static int
rates_there (family *f)
{
  gs_work *w = f->w;
  const gs_scene *s = w->s;
  gs_real *rates = gs_numbers (w, s->nx);
  int row, column;
  f->p = gs_numbers (w, s->nx * s->nsp);
  f->ab = gs_numbers (w, s->nx * (s->nx + s->nv));
  if (! rates || ! f->p || ! f->ab
      || gs_slopes_there (w, w->at->x, w->at->v, f->p, f->ab, f->ab + s->nx * s->nx, rates) != 0)
    return w->told->verdict;
  if (gs_first_not_finite (s->nx, s->nx + s->nv, f->ab, &row, &column))
    return gs_no_derivative (w, "rate of ", w->d->states[row], column);
  if (gs_first_not_finite (s->nx, s->nsp, f->p, &row, &column))
    return gs_no_derivative_by (w, "rate of ", w->d->states[row], f->asked->names[column]);
  return check_rest (f, rates);
}

/* the equations: rates, Euler parameters, loops */
static int
equations_there (family *f)
{
  gs_work *w = f->w;
  const gs_scene *s = w->s;
  const int nr = s->nx - s->nq, columns = s->nx + s->nv;
  gs_constraint_rows rows;
  gs_real *pp = gs_numbers (w, 2 * s->nlam * s->nsp);
  if (! pp || gs_constraints_there (w, w->at->x, 0, NULL, &rows) != 0)
    return w->told->verdict;
  f->m = nr + rows.np;
  f->all = gs_numbers (w, f->m * columns);
  f->right = gs_numbers (w, f->m * s->nsp);
  if (! f->all || ! f->right)
    return w->told->verdict;
  if (s->nlam > 0 && ! s->cop)
    return gs_work_failed (w, GS_LINEAR_ABSENT, "cop", 0);
  if (s->nlam > 0)
    s->cop (w->t, w->at->x, w->cst, pp, s->nlam, pp + s->nlam * s->nsp, s->nlam);
  for (int i = 0; i < nr; i++)
    {
      gs_put_row (columns, f->ab, s->nx, s->nq + i, f->all, f->m, i);
      gs_put_row (s->nsp, f->p, s->nx, s->nq + i, f->right, f->m, i);
    }
  for (int i = 0; i < rows.np; i++)
    gs_put_row (s->nq, rows.p, rows.np, i, f->all, f->m, nr + i);
  for (int i = 0; i < s->nlam; i++)
    gs_put_row (s->nsp, pp, s->nlam, i, f->right, f->m, nr + rows.np - s->nlam + i);
  return 0;
}

/* e (m,n): the columns of the unknowns, in their sizes; the largest entry of a row is 1 */
static void
scale (const family *f, gs_real *e)
{
  for (int i = 0; i < f->m; i++)
    {
      gs_real most = 0;
      for (int k = 0; k < f->n; k++)
        {
          e[i + f->m * k] = f->all[i + f->m * f->unknown[k]] * size_of (f, k);
          most = gs_max (most, gs_abs (e[i + f->m * k]));
        }
      if (! (most > 0))
        continue;
      for (int k = 0; k < f->n; k++)
        e[i + f->m * k] /= most;
      for (int j = 0; j < f->w->s->nsp; j++)
        f->right[i + f->m * j] /= most;
    }
}

/* does the equilibrium stand alone? */
static int
check_alone (family *f, const gs_real *e)
{
  gs_work *w = f->w;
  gs_real *basis = gs_numbers (w, f->n * f->n);
  const int many = basis ? gs_null_space (w, f->m, f->n, e, GS_R (1e-9), basis) : 0;
  const char *between = "";
  if (many == 0)
    return w->told->verdict;
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  gs_put (&said, "the equilibrium does not stand alone: ");
  for (int k = 0; k < f->n; k++)
    {
      gs_real most = 0;
      for (int j = 0; j < many; j++)
        most = gs_max (most, gs_abs (basis[k + f->n * j]));
      if (! (most > GS_R (1e-6)))
        continue;
      const int own = f->unknown[k], nx = w->s->nx;
      gs_put (&said, "%s%s", between, own < nx ? w->d->states[own] : w->at->inputs[own - nx]);
      between = ", ";
    }
  gs_put (&said, " can be moved; hold some of them (\"hold\")");
  return w->told->verdict;
}

/* the largest sum of a row of a (m,n) - b (m,n); b null: of a */
static gs_real
row_sum (int m, int n, const gs_real *a, const gs_real *b)
{
  gs_real most = 0;
  for (int i = 0; i < m; i++)
    {
      gs_real sum = 0;
      for (int j = 0; j < n; j++)
        sum += gs_abs (a[i + m * j] - (b ? b[i + m * j] : 0));
      most = gs_max (most, sum);
    }
  return most;
}

static int
solve (family *f, gs_rest_slopes *found)
{
  gs_work *w = f->w;
  const gs_scene *s = w->s;
  gs_real *e = gs_numbers (w, f->m * f->n), *inverse = gs_numbers (w, f->n * f->m);
  gs_real *z = gs_numbers (w, f->n * s->nsp), *back = gs_numbers (w, f->m * s->nsp);
  if (! e || ! inverse || ! z || ! back)
    return w->told->verdict;
  scale (f, e);
  if (check_alone (f, e) != 0)
    return w->told->verdict;
  gs_pseudo_inverse (w, f->m, f->n, e, 0, inverse);
  gs_product (f->n, f->m, s->nsp, inverse, f->right, z);
  gs_product (f->m, f->n, s->nsp, e, z, back);
  if (! (row_sum (f->m, s->nsp, back, f->right)
         <= GS_R (1e-8) * gs_max (1, row_sum (f->m, s->nsp, f->right, NULL))))
    {
      gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
      gs_put (&said, "with other parameters there is no equilibrium near this one; free an input "
              "(\"free\")");
      return w->told->verdict;
    }
  for (int j = 0; j < s->nsp; j++)
    for (int k = 0; k < f->n; k++)
      {
        const gs_real change = 0 - z[k + f->n * j] * size_of (f, k);
        if (f->unknown[k] < s->nx)
          found->dx[f->unknown[k] + s->nx * j] = change;
        else
          found->dv[f->unknown[k] - s->nx + s->nv * j] = change;
      }
  return 0;
}

/* the outputs follow */
static int
outputs (family *f, gs_rest_slopes *found)
{
  gs_work *w = f->w;
  const gs_scene *s = w->s;
  const int ny = s->ny;
  gs_real *a = gs_numbers (w, s->nx * s->nx), *c = gs_numbers (w, ny * (s->nx + s->nv));
  gs_real *part = gs_numbers (w, ny * s->nsp), *by = gs_numbers (w, ny * s->nsp);
  found->outputs = s->oup != NULL;
  if (ny == 0 || ! s->oup || ! a || ! c || ! part || ! by)
    return w->told->verdict;
  if (gs_jacobian_there (w, w->at->x, w->at->v, a, NULL, c, c + ny * s->nx) != 0)
    return w->told->verdict;
  const int info = s->oup (w->t, w->at->x, w->at->v, w->cst, by, ny);
  if (info != 0)
    return gs_work_failed (w, GS_LINEAR_FAILED, "oup", info);
  gs_product (ny, s->nx, s->nsp, c, found->dx, found->dy);
  gs_product (ny, s->nv, s->nsp, c + ny * s->nx, found->dv, part);
  for (int k = 0; k < ny * s->nsp; k++)
    found->dy[k] += part[k] + by[k];
  return 0;
}

int
gs_slopes_of_rest (const gs_description *d, const gs_linear_place *at,
                   const gs_slopes_asked *asked, gs_rest_slopes *found, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  const gs_scene *s = d->scene;
  family f = { .w = &w, .asked = asked };
  gs_zero (s->nx * s->nsp, found->dx);
  gs_zero (s->nv * s->nsp, found->dv);
  gs_zero (s->ny * s->nsp, found->dy);
  if (list_unknowns (&f) == 0 && rates_there (&f) == 0 && equations_there (&f) == 0
      && solve (&f, found) == 0)
    outputs (&f, found);
  return gs_work_end (&w);
}

void
gs_family_steps (int nx, const double *nominal, double p, const double *dx, double *steps,
                 double *factors)
{
  static const double weights[] = { 45, -9, 1 };
  double h = 1e-2 * (p < 0 ? -p : p > 0 ? p : 1), most = 1;
  for (int i = 0; i < nx; i++)
    {
      const double part = h * (dx[i] < 0 ? -dx[i] : dx[i]) / (1e-2 * nominal[i]);
      most = part > most ? part : most;
    }
  h /= most;
  for (int k = 0; k < 3; k++)
    {
      steps[2 * k] = (k + 1) * h;
      steps[2 * k + 1] = -steps[2 * k];
      factors[2 * k] = weights[k] / (60 * h);
      factors[2 * k + 1] = -factors[2 * k];
    }
}

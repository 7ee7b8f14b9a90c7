/* linear.c: an exact linear model, from the Jacobians of the scene to the model in independent
 * deviations. */
#include "host/linear/linear_parts.h"

/* A, B, C, D of the whole state, as long as the model is made of them */
typedef struct
{
  int ny;
  gs_real *a, *b, *c, *d;
} whole;

static int
outputs_of (const gs_scene *s)
{
  return s->ny > 0 ? s->ny : s->nx;
}

static int
jacobians (gs_work *w, const gs_linear_place *at, whole *all, gs_linear_model *model)
{
  const gs_scene *s = w->s;
  const int ny = all->ny = outputs_of (s);
  int row, column;
  all->a = gs_numbers (w, s->nx * (s->nx + s->nv));
  all->c = gs_numbers (w, ny * (s->nx + s->nv));
  if (! all->a || ! all->c)
    return w->told->verdict;
  all->b = all->a + s->nx * s->nx;
  all->d = all->c + ny * s->nx;
  if (gs_jacobian_there (w, at->x, at->v, all->a, all->b, s->ny ? all->c : NULL, all->d) != 0)
    return w->told->verdict;
  if (gs_first_not_finite (s->nx, s->nx + s->nv, all->a, &row, &column))
    return gs_no_derivative (w, "rate of ", w->d->states[row], column);
  model->row = model->column = -1;
  if (s->ny > 0)
    gs_first_not_finite (ny, s->nx + s->nv, all->c, &model->row, &model->column);
  else
    {
      gs_zero (ny * (s->nx + s->nv), all->c);
      for (int i = 0; i < ny; i++)
        all->c[i + ny * i] = 1;
    }
  return 0;
}

/* without constraints all coordinates are independent */
static int
check_all_named (gs_work *w, const gs_linear_asked *asked)
{
  const gs_scene *s = w->s;
  for (int i = 0; i < s->nq; i++)
    if (! gs_is_among (i, asked->nwanted, asked->wanted))
      {
        gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
        gs_put (&said, "option \"reduced\": without constraints all coordinates are independent; "
                "expected \"auto\" or all of ");
        for (int k = 0; k < s->nq; k++)
          gs_put (&said, "%s%s", k ? ", " : "", w->d->states[k]);
        return w->told->verdict;
      }
  return 0;
}

/* what may run steadily, where some is to be dropped and nothing else is said */
static int
want_steady (gs_work *w, const gs_linear_place *at, gs_linear_asked *asked)
{
  const gs_scene *s = w->s;
  gs_free_velocities f = { 0, 0, gs_places (w, s->nq), gs_places (w, s->nu) };
  int *wanted = gs_places (w, s->nq + s->nu);
  if (! f.q || ! f.u || ! wanted || gs_find_free_velocities (w, at->x, 0, NULL, &f) != 0)
    return w->told->verdict;
  asked->nwanted = 0;
  for (int i = 0; i < f.nq; i++)
    wanted[asked->nwanted++] = f.q[i];
  for (int i = 0; i < f.nu; i++)
    wanted[asked->nwanted++] = s->nq + f.u[i];
  asked->wanted = wanted;
  return 0;
}

/* the independent states and their tangent, into the model */
static int
independent_states (gs_work *w, const gs_linear_place *at, const gs_linear_asked *asked,
                    gs_linear_model *model)
{
  const gs_scene *s = w->s;
  const int named = asked->reduced == GS_REDUCED_NAMED;
  gs_linear_asked wanted = *asked;
  const int steady = (asked->running || asked->ndrop > 0) && ! named;
  if (steady && want_steady (w, at, &wanted) != 0)
    return w->told->verdict;
  if ((s->nlam > 0 || s->nq > s->nu) && (steady || asked->reduced != GS_REDUCED_NONE))
    return gs_loop_tangent (w, at->x, named || steady ? wanted.wanted : NULL, wanted.nwanted, 0,
                            NULL, model->tangent, model->independent, &model->n);
  model->n = s->nx;
  gs_zero (s->nx * s->nx, model->tangent);
  for (int i = 0; i < s->nx; i++)
    {
      model->independent[i] = i;
      model->tangent[i + s->nx * i] = 1;
    }
  return named ? check_all_named (w, asked) : 0;
}

/* A, B, C of the independent deviations; rows: (nx,nx) */
static void
reduce (const gs_scene *s, const whole *all, gs_real *rows, gs_linear_model *model)
{
  const int n = model->n, nx = s->nx;
  for (int i = 0; i < n; i++)
    {
      gs_put_row (nx, all->a, nx, model->independent[i], rows, n, i);
      gs_put_row (s->nv, all->b, nx, model->independent[i], model->b, n, i);
    }
  gs_product (n, nx, n, rows, model->tangent, model->a);
  gs_product (all->ny, nx, n, all->c, model->tangent, model->c);
  gs_copy (all->ny * s->nv, all->d, model->d);
  model->m = all->ny;
  for (int i = 0; i < model->m; i++)
    model->seen[i] = i;
}

/* the rows and columns of a (m,n) that are listed, in their order, in place */
static void
keep_parts (int m, int mkeep, const int *rows, int nkeep, const int *columns, gs_real *a)
{
  for (int j = 0; j < nkeep; j++)
    for (int i = 0; i < mkeep; i++)
      a[i + mkeep * j] = a[(rows ? rows[i] : i) + m * (columns ? columns[j] : j)];
}

/* the outputs that follow what is dropped are left out, the others are listed: how many */
static int
see_outputs (const gs_linear_model *model, const int *keep, int *list)
{
  int many = 0;
  for (int i = 0; i < model->m; i++)
    {
      gs_real most = 0;
      int gone = 0;
      for (int j = 0; j < model->n; j++)
        most = gs_max (most, gs_abs (model->c[i + model->m * j]));
      for (int j = 0; j < model->n; j++)
        gone |= ! keep[j] && gs_abs (model->c[i + model->m * j]) > GS_R (1e-12) * most;
      if (! gone)
        list[many++] = i;
    }
  return many;
}

static int
drop (gs_work *w, const gs_linear_place *at, const gs_linear_asked *asked, gs_linear_model *model)
{
  const gs_scene *s = w->s;
  const int n = model->n, m = model->m;
  int *keep = gs_places (w, n), *left = gs_places (w, n), many = 0;
  if (! keep || ! left
      || gs_without_states (w, at, asked, n, model->independent, model->a, keep) != 0)
    return w->told->verdict;
  model->m = see_outputs (model, keep, model->seen);
  model->ndropped = 0;
  for (int i = 0; i < n; i++)
    if (keep[i])
      left[many++] = i;
    else
      model->dropped[model->ndropped++] = model->independent[i];
  keep_parts (n, many, left, many, left, model->a);
  keep_parts (n, many, left, s->nv, NULL, model->b);
  keep_parts (m, model->m, model->seen, many, left, model->c);
  keep_parts (m, model->m, model->seen, s->nv, NULL, model->d);
  keep_parts (s->nx, s->nx, NULL, many, left, model->tangent);
  for (int i = 0; i < many; i++)
    model->independent[i] = model->independent[left[i]];
  model->n = many;
  return 0;
}

int
gs_linear (const gs_description *d, const gs_linear_place *at, const gs_linear_asked *asked,
           gs_linear_model *model, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  gs_real *rows = gs_numbers (&w, d->scene->nx * d->scene->nx);
  whole all = { 0 };
  model->ndropped = 0;
  if (rows && jacobians (&w, at, &all, model) == 0
      && independent_states (&w, at, asked, model) == 0)
    {
      reduce (d->scene, &all, rows, model);
      if (asked->running || asked->ndrop > 0)
        drop (&w, at, asked, model);
    }
  return gs_work_end (&w);
}

int
gs_linear_tangent (const gs_description *d, const gs_linear_place *at, const int *wanted,
                   int nwanted, gs_real *tangent, int *independent, int *n, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  gs_loop_tangent (&w, at->x, wanted, nwanted, 0, NULL, tangent, independent, n);
  return gs_work_end (&w);
}

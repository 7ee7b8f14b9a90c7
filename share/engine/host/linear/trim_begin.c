/* trim_begin.c: unknowns and equations of an equilibrium, their usual sizes. */
#include "gsmbp/functions.h"
#include "host/linear/trim_parts.h"

/* x on the constraints, if that can be: held coordinates where they are, or all moved */
static void
close_guess (gs_work *w, const gs_trim_asked *asked, gs_real *x)
{
  const gs_scene *s = w->s;
  gs_real *y = gs_numbers (w, s->nx), residual;
  gs_free_velocities held = { 0, 0, gs_places (w, s->nq), gs_places (w, s->nu) };
  if (! y || ! held.q || ! held.u)
    return;
  gs_copy (s->nx, x, y);
  for (int i = 0; i < asked->nhold; i++)
    if (asked->hold[i] < s->nq)
      held.q[held.nq++] = asked->hold[i];
  if (held.nq == 0 && s->prj)
    {
      const int info = s->prj (w->t, y, w->cst, &residual);
      if ((info == 0 || info == 2) && gs_not_finite (s->nx, y) == 0)
        gs_copy (s->nq, y, x);
    }
  else if (gs_close_rest (w, &held, y))
    gs_copy (s->nq, y, x);
}

/* unknowns of an equilibrium: all coordinates and states of devices that are not held */
static void
rest_begin (gs_trim_problem *p)
{
  const gs_scene *s = p->w->s;
  gs_rest *r = &p->rest;
  for (int i = 0; i < s->nx; i++)
    if ((i < s->nq || i >= s->nq + s->nu) && ! gs_is_among (i, p->asked->nhold, p->asked->hold))
      p->own[r->nown++] = i;
  for (int i = s->nq; i < s->nx; i++)
    p->rows[r->nrows++] = i;
}

static void
usual_sizes (gs_trim_problem *p)
{
  const double *nominal = p->w->d->nominal;
  const gs_rest *r = &p->rest;
  for (int i = 0; i < gs_rest_unknowns (r); i++)
    {
      p->size[i] = i < r->nown ? (gs_real)nominal[p->own[i]] : 1;
      p->z[i] = i < r->nown ? r->x[p->own[i]] : r->v[r->inputs[i - r->nown]];
    }
  for (int i = 0; i < gs_rest_equations (r); i++)
    p->usual[i] = i < r->nrows ? (gs_real)nominal[p->rows[i]] : 1;
}

/* a free input counts by what moves the rates as much as the usual sizes of the states do */
static void
input_sizes (gs_trim_problem *p)
{
  const gs_rest *r = &p->rest;
  const int ne = gs_rest_equations (r), n = gs_rest_unknowns (r);
  gs_real *jacobian = gs_numbers (p->w, ne * n), *f = gs_numbers (p->w, ne);
  if (! jacobian || ! f)
    return;
  gs_rest_at (r, p->z, p->w->t, f, jacobian);
  if (gs_not_finite (ne * n, jacobian) != 0)
    return;
  for (int k = r->nown; k < n; k++)
    {
      gs_real least = (gs_real)HUGE_VAL;
      for (int i = 0; i < ne; i++)
        {
          gs_real row = 0;
          for (int j = 0; j < r->nown; j++)
            row += gs_abs (jacobian[i + ne * j]) * p->size[j];
          const gs_real reach = gs_max (row, p->usual[i]) / gs_abs (jacobian[i + ne * k]);
          if (reach > 0 && reach < least)
            least = reach;
        }
      if (least < (gs_real)HUGE_VAL)
        p->size[k] = gs_max (least, gs_abs (p->z[k]));
    }
}

int
gs_trim_begin (gs_work *w, const gs_trim_asked *asked, gs_real *x, gs_real *v, gs_trim_problem *p)
{
  const gs_scene *s = w->s;
  const int most = s->nx + s->nv, rows = s->nx + 2 * s->nlam + w->d->nsets;
  *p = (gs_trim_problem){ .w = w, .asked = asked };
  p->own = gs_places (w, s->nx);
  p->rows = gs_places (w, s->nx);
  p->fixed = gs_places (w, most);
  p->running = gs_places (w, s->nq);
  p->z = gs_numbers (w, most);
  p->size = gs_numbers (w, most);
  p->usual = gs_numbers (w, rows);
  gs_real *given = gs_numbers (w, s->nx);
  if (! p->own || ! p->rows || ! p->fixed || ! p->running || ! p->z || ! p->size || ! p->usual
      || ! given)
    return w->told->verdict;
  p->rest = (gs_rest){ w, x, v, 0, asked->ninputs, 0, p->own, asked->inputs, p->rows, p->fixed,
                       p->size, asked->steady };
  gs_copy (s->nx, x, given);
  gs_zero (s->nu, x + s->nq);
  if (s->nlam > 0 || s->nq > s->nu)
    close_guess (w, asked, x);
  if (asked->steady)
    {
      gs_copy (s->nu, given + s->nq, x + s->nq);
      if (gs_steady_begin (p) != 0)
        return w->told->verdict;
    }
  else
    rest_begin (p);
  usual_sizes (p);
  input_sizes (p);
  return w->told->verdict;
}

/* trim_told.c: why no equilibrium was found, in words. */
#include <string.h>

#include "gsmbp/functions.h"
#include "host/linear/trim_parts.h"

/* ------------------------------------------------------------------------- names of equations */

void
gs_trim_equation (const gs_trim_problem *p, int i, gs_writer *name)
{
  const gs_description *d = p->w->d;
  const gs_scene *s = d->scene;
  const int k = i - p->rest.nrows, n = s->nlam, set = k - (p->rest.moves ? 2 : 1) * n;
  if (k < 0)
    gs_put (name, "%s of %s",
            p->rows[i] >= s->nq && p->rows[i] < s->nq + s->nu ? "acceleration" : "rate",
            d->states[p->rows[i]]);
  else if (set < 0)
    gs_put (name, "%sconstraint %s", k < n ? "" : "rate of ", d->constraints[k % n]);
  else
    gs_put (name, "norm of %s .. %s", d->states[d->sets[4 * set]],
            d->states[d->sets[4 * set + 3]]);
}

void
gs_put_rate_unit (const gs_work *w, int state, gs_writer *unit)
{
  const char *own = w->at->units[state];
  const int length = (int)strlen (own), rate = length > 2 && ! strcmp (own + length - 2, "/s");
  gs_put (unit, "%.*s/s%s", rate ? length - 2 : length, own, rate ? "^2" : "");
}

void
gs_trim_unit (const gs_trim_problem *p, int i, gs_writer *unit)
{
  const gs_work *w = p->w;
  const int k = i - p->rest.nrows, n = w->s->nlam;
  if (k < 0)
    gs_put_rate_unit (w, p->rows[i], unit);
  else if (k < (p->rest.moves ? 2 : 1) * n)
    gs_put (unit, "%s%s", w->at->constraints[k % n], k < n ? "" : "/s");
  else
    gs_put (unit, "1");
}

int
gs_trim_unknown (const gs_trim_problem *p, int k)
{
  return k < p->rest.nown ? p->own[k] : p->w->s->nx + p->rest.inputs[k - p->rest.nown];
}

/* --------------------------------------------------------------------------------------- checks */

static int
check_moving (const gs_trim_problem *p, const gs_real *rate, double sign, const char *how,
              const char *unit)
{
  gs_work *w = p->w;
  for (int k = 0; k < w->s->nlam; k++)
    if (! (gs_abs (rate[k]) <= (gs_real)p->asked->tolerance))
      {
        gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
        gs_put (&said, "no state at rest at t = %g s: with all speeds zero the constraint %s %s "
                "%g%s%s%s, it is driven with time; take a time at which it rests (option "
                "\"time\"), or let the driven coordinate run on (option \"steady\")",
                (double)w->t, w->d->constraints[k], how, sign * (double)rate[k],
                w->at->constraints[k][0] ? " " : "", w->at->constraints[k], unit);
        return w->told->verdict;
      }
  return 0;
}

int
gs_trim_check_rest (const gs_trim_problem *p)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nlam;
  gs_real *phi = gs_numbers (w, 3 * n), *h = gs_numbers (w, n * s->nu);
  gs_real *u = gs_numbers (w, s->nu);
  if (n == 0 || p->rest.moves)
    return 0;
  if (! phi || ! h || ! u)
    return w->told->verdict;
  s->con (w->t, p->rest.x, u, w->cst, phi, phi + n, h, n, phi + 2 * n);
  if (check_moving (p, phi + n, 1, "moves at", "/s") != 0)
    return w->told->verdict;
  return check_moving (p, phi + 2 * n, -1, "starts with an acceleration of", "/s^2");
}

int
gs_trim_check_derivatives (const gs_trim_problem *p, const gs_real *z)
{
  gs_work *w = p->w;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *jacobian = gs_numbers (w, ne * n), *f = gs_numbers (w, ne);
  int row, column;
  char name[300] = "";
  gs_writer of = { name, sizeof name, 0 };
  if (! jacobian || ! f)
    return w->told->verdict;
  gs_rest_at (&p->rest, z, w->t, f, jacobian);
  if (! gs_first_not_finite (ne, n, jacobian, &row, &column))
    return 0;
  gs_trim_equation (p, row, &of);
  return gs_no_derivative (w, "", name, gs_trim_unknown (p, column));
}

int
gs_trim_check_margins (const gs_trim_problem *p)
{
  gs_work *w = p->w;
  char text[2000];
  const int passed = gs_passed_text (w->d, w->t, p->rest.x, p->rest.v, w->cst, p->asked->par, text,
                                     sizeof text);
  if (passed > 0)
    {
      gs_writer said = gs_work_refused (w, GS_LINEAR_MARGIN);
      gs_put (&said, "an equilibrium was found, but a device cannot be there: %s; try another "
              "guess, or take it as it is: \"margins\", \"ignore\"", text);
    }
  else if (passed < 0)
    w->told->verdict = GS_LINEAR_NO_MEMORY;
  return w->told->verdict;
}

/* ----------------------------------------------------------------------------- what is missing */

/* inputs that act on what the states cannot take away: g (ne), what is left of the equations in the
 * sizes row; b (nx,nv); how many */
static int
list_helpers (const gs_trim_problem *p, const gs_real *g, const gs_real *row, const gs_real *b,
              int *list)
{
  const gs_rest *r = &p->rest;
  const gs_scene *s = p->w->s;
  const gs_real length = gs_sqrt (gs_dot (gs_rest_equations (r), 0, g, g));
  int many = 0;
  for (int k = 0; k < s->nv; k++)
    {
      gs_real product = 0, size = 0;
      if (gs_is_among (k, r->ninputs, r->inputs) || gs_is_among (k, p->asked->nmodes,
                                                                 p->asked->modes))
        continue;
      for (int i = 0; i < r->nrows; i++)
        {
          const gs_real one = b[p->rows[i] + s->nx * k] / row[i];
          product += g[i] * one;
          size += one * one;
        }
      if (length > 0 && gs_abs (product) > GS_R (1e-6) * length * gs_sqrt (size))
        list[many++] = k;
    }
  return many;
}

/* g := what of the equations f the unknowns cannot take away, by least squares, in the sizes row;
 * 0: they are not finite */
static int
left_of (const gs_trim_problem *p, const gs_real *z, gs_real *row, gs_real *f, gs_real *g)
{
  gs_work *w = p->w;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *k = gs_numbers (w, ne * n), *inverse = gs_numbers (w, n * ne);
  gs_real *step = gs_numbers (w, n), *moved = gs_numbers (w, ne);
  if (! k || ! inverse || ! step || ! moved)
    return 0;
  gs_rest_at (&p->rest, z, w->t, f, k);
  gs_trim_rows (p, k, row);
  for (int i = 0; i < ne; i++)
    {
      row[i] = gs_max (row[i], p->usual[i]);
      g[i] = f[i] / row[i];
      for (int j = 0; j < n; j++)
        k[i + ne * j] *= p->size[j] / row[i];
    }
  if (gs_not_finite (ne * n, k) != 0 || gs_not_finite (ne, g) != 0)
    return 0;
  gs_pseudo_inverse (w, ne, n, k, GS_R (1e-10), inverse);
  gs_product (n, ne, 1, inverse, g, step);
  gs_product (ne, n, 1, k, step, moved);
  for (int i = 0; i < ne; i++)
    g[i] -= moved[i];
  return 1;
}

static void
put_helpers (const gs_trim_problem *p, const gs_real *z, gs_writer *said)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int ne = gs_rest_equations (&p->rest), ny = gs_most (1, s->ny);
  gs_real *row = gs_numbers (w, ne), *f = gs_numbers (w, ne), *g = gs_numbers (w, ne);
  gs_real *a = gs_numbers (w, (s->nx + ny) * (s->nx + s->nv));
  int *list = gs_places (w, s->nv), many = 0;
  if (row && f && g && a && list && left_of (p, z, row, f, g))
    {
      gs_real *b = a + s->nx * s->nx, *c = b + s->nx * s->nv;
      s->jac (w->t, p->rest.x, p->rest.v, w->cst, a, s->nx, b, s->nx, c, ny, c + ny * s->nx, ny);
      if (gs_not_finite (s->nx * s->nv, b) == 0)
        many = list_helpers (p, g, row, b, list);
    }
  gs_put (said, "; %s", many ? "these inputs act on it: "
                             : "try another guess, or let inputs be free");
  for (int k = 0; k < many; k++)
    gs_put (said, "%s%s", k ? ", " : "", w->at->inputs[list[k]]);
  gs_put (said, "%s", many ? " (option \"free\")" : "");
}

/* the four equations that are left most, the worst first */
static void
put_left (const gs_trim_problem *p, const gs_real *f, gs_real *beside, gs_writer *said)
{
  const int ne = gs_rest_equations (&p->rest);
  for (int many = 0; many < 4; many++)
    {
      int worst = 0;
      for (int i = 1; i < ne; i++)
        if (beside[i] > beside[worst])
          worst = i;
      if (! (beside[worst] > 1))
        return;
      gs_put (said, "%s", many ? ", " : "");
      gs_trim_equation (p, worst, said);
      gs_put (said, " = %g ", (double)f[worst]);
      gs_trim_unit (p, worst, said);
      beside[worst] = 0;
    }
}

int
gs_trim_refuse (const gs_trim_problem *p, const gs_real *z)
{
  gs_work *w = p->w;
  const int ne = gs_rest_equations (&p->rest);
  gs_real *beside = gs_numbers (w, ne), *f = gs_numbers (w, ne);
  char outside[1200] = "";
  if (! beside || ! f)
    return w->told->verdict;
  gs_trim_worst (p, z, w->t, (gs_real)p->asked->tolerance, beside, f);
  gs_rest_put (&p->rest, z);
  gs_outside_text (w->d, w->t, p->rest.x, p->rest.v, w->cst, p->asked->par, outside,
                   sizeof outside);
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  gs_put (&said, "no %s found near the guess; what does not vanish: ",
          p->rest.moves ? "steady motion" : "equilibrium");
  put_left (p, f, beside, &said);
  gs_put (&said, "%s", outside);
  put_helpers (p, z, &said);
  return w->told->verdict;
}

/* ------------------------------------------------------------------------------ some time later */

/* an equilibrium the same state some other times, or a warning */
static void
warn_later (const gs_trim_problem *p, const gs_real *z, char *warning, int size)
{
  static const double later[] = { 0.618, 3.7, 19.1 };
  gs_work *w = p->w;
  const int ne = gs_rest_equations (&p->rest);
  gs_real *beside = gs_numbers (w, ne), *f = gs_numbers (w, ne), *now = gs_numbers (w, ne);
  if (! beside || ! f || ! now)
    return;
  const gs_real tolerance = (gs_real)p->asked->tolerance;
  gs_trim_worst (p, z, w->t, tolerance, now, f);
  for (int k = 0; k < 3; k++)
    {
      gs_trim_worst (p, z, w->t + (gs_real)later[k], tolerance, beside, f);
      for (int i = 0; i < ne; i++)
        if (! (beside[i] <= 10))
          {
            gs_writer said = { warning, size, 0 };
            gs_put (&said, "an equilibrium at t = %g s alone: ", (double)w->t);
            gs_trim_equation (p, i, &said);
            gs_put (&said, " changes with time");
            return;
          }
    }
}

static int
refuse_later (const gs_trim_problem *p, int row, double f, double later)
{
  gs_work *w = p->w;
  gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
  gs_put (&said, "no steady motion: while ");
  for (int k = 0; k < p->nrunning; k++)
    gs_put (&said, "%s%s", k ? ", " : "", w->d->states[p->running[k]]);
  gs_put (&said, " run%s on, the ", p->nrunning == 1 ? "s" : "");
  gs_trim_equation (p, row, &said);
  gs_put (&said, " does not stay zero: %.3g after %g s", f, later);
  return w->told->verdict;
}

/* some time later, with the coordinates that run moved on, the same rates have to vanish */
static int
check_steady (gs_trim_problem *p, const gs_real *z)
{
  static const double later[] = { 0.618, 3.7 };
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int ne = gs_rest_equations (&p->rest), n = gs_rest_unknowns (&p->rest);
  gs_real *xd = gs_numbers (w, s->nx), *x = gs_numbers (w, s->nx), *y = gs_numbers (w, n);
  gs_real *beside = gs_numbers (w, ne), *f = gs_numbers (w, ne);
  if (! xd || ! x || ! y || ! beside || ! f)
    return w->told->verdict;
  gs_rest_put (&p->rest, z);
  gs_copy (s->nx, p->rest.x, x);
  if (gs_rates_there (w, w->t, x, p->rest.v, xd) != 0)
    return w->told->verdict;
  for (int k = 0; k < 2 && w->told->verdict == 0; k++)
    {
      gs_copy (s->nx, x, p->rest.x);
      for (int i = 0; i < p->nrunning; i++)
        p->rest.x[p->running[i]] += (gs_real)later[k] * xd[p->running[i]];
      gs_follow_rest (w, w->t + (gs_real)later[k], &p->free, p->rest.x);
      for (int i = 0; i < n; i++)
        y[i] = i < p->rest.nown ? p->rest.x[p->own[i]] : z[i];
      gs_trim_worst (p, y, w->t + (gs_real)later[k], (gs_real)p->asked->tolerance, beside, f);
      for (int i = 0; i < ne && w->told->verdict == 0; i++)
        if (! (beside[i] <= 100))
          refuse_later (p, i, (double)f[i], later[k]);
    }
  gs_copy (s->nx, x, p->rest.x);
  return w->told->verdict;
}

int
gs_trim_check_later (gs_trim_problem *p, const gs_real *z, char *warning, int size)
{
  if (p->rest.moves)
    return check_steady (p, z);
  warn_later (p, z, warning, size);
  gs_rest_put (&p->rest, z);
  return p->w->told->verdict;
}

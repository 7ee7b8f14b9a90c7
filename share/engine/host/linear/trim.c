/* trim.c: an equilibrium or a steady motion, from the guess to what is found. */
#include <string.h>

#include "host/linear/trim_parts.h"

/* does the scene have what the equations need */
static int
check_routines (gs_work *w)
{
  const gs_scene *s = w->s;
  if (! s->rhs || ! s->jac)
    return gs_work_failed (w, GS_LINEAR_ABSENT, s->rhs ? "jac" : "rhs", 0);
  if (s->nlam > 0 && (! s->con || ! s->tan))
    return gs_work_failed (w, GS_LINEAR_ABSENT, s->con ? "tan" : "con", 0);
  return 0;
}

/* what can be moved; what runs; how much is left */
static int
tell (gs_trim_problem *p, const gs_real *z, int columns, const gs_real *basis,
      gs_trim_found *found)
{
  gs_work *w = p->w;
  const int n = gs_rest_unknowns (&p->rest), ne = gs_rest_equations (&p->rest);
  gs_real *f = gs_numbers (w, ne), *xd = gs_numbers (w, w->s->nx);
  if (! f || ! xd || gs_rates_there (w, w->t, found->x, found->v, xd) != 0)
    return w->told->verdict;
  gs_rest_at (&p->rest, z, w->t, f, NULL);
  found->residual = 0;
  for (int i = 0; i < ne; i++)
    found->residual = fmax (found->residual, (double)(gs_abs (f[i]) / p->usual[i]));
  for (int k = 0; k < n; k++)
    for (int j = 0; j < columns; j++)
      found->indifferent[gs_trim_unknown (p, k)] |= gs_abs (basis[k + n * j]) > GS_R (1e-6);
  for (int i = 0; i < p->nrunning; i++)
    {
      const int q = p->running[i];
      found->running[q] = gs_abs (xd[q]) > GS_R (1e-12) * (gs_real)w->d->nominal[q];
    }
  return w->told->verdict;
}

static int
solve (gs_trim_problem *p, gs_trim_found *found)
{
  gs_work *w = p->w;
  const int n = gs_rest_unknowns (&p->rest);
  gs_real *z = gs_numbers (w, n), *basis = gs_numbers (w, n * n);
  const gs_real tolerance = (gs_real)p->asked->tolerance;
  if (! z || ! basis || gs_trim_check_rest (p) != 0 || gs_trim_check_derivatives (p, p->z) != 0)
    return w->told->verdict;
  gs_trim_solve (p, z, &found->way);
  gs_rest_put (&p->rest, z);
  if (gs_trim_check_rest (p) != 0)
    return w->told->verdict;
  if (! (gs_trim_worst (p, z, w->t, tolerance, NULL, NULL) <= 1))
    return gs_trim_refuse (p, z);
  if (gs_trim_check_derivatives (p, z) != 0)
    return w->told->verdict;
  const int columns = gs_trim_free (p, z, basis);
  gs_trim_nearest (p, columns, basis, z);
  gs_rest_put (&p->rest, z);
  if (gs_trim_check_later (p, z, found->warning, sizeof found->warning) != 0
      || tell (p, z, columns, basis, found) != 0)
    return w->told->verdict;
  return p->asked->margins ? gs_trim_check_margins (p) : 0;
}

int
gs_trim (const gs_description *d, const gs_linear_place *at, const gs_trim_asked *asked,
         gs_trim_found *found, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  const gs_scene *s = d->scene;
  gs_trim_problem p;
  gs_copy (s->nx, at->x, found->x);
  gs_copy (s->nv, at->v, found->v);
  memset (found->running, 0, (size_t)s->nq * sizeof *found->running);
  memset (found->indifferent, 0, (size_t)(s->nx + s->nv) * sizeof *found->indifferent);
  found->warning[0] = '\0';
  if (check_routines (&w) == 0 && gs_trim_begin (&w, asked, found->x, found->v, &p) == 0)
    solve (&p, found);
  return gs_work_end (&w);
}

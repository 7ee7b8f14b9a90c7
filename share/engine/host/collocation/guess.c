/* guess.c: where an optimal motion begins: states on a line between the ends, or given ones.
 *
 * On a line accelerations are what these lines of the speeds have: those of the machine there
 * belong to another motion, from which Ipopt needs up to twice as many iterations. With a guess
 * accelerations and multipliers follow from it. */
#include <math.h>
#include <string.h>

#include "host/collocation/collocation_parts.h"
#include "host/linear/linear_parts.h"

/* accelerations and multipliers at the unknowns z of a point at t, which leave the least of the
 * residuals, into their places: they stand linearly there */
static void
follow_motion (gs_search *w, double t, double *z)
{
  const gs_description *d = w->d;
  const gs_scene *s = d->scene;
  const int n = s->nu + s->nlam, nr = d->nresiduals, nz = s->nx + n + s->nv;
  gs_linear_told told;
  const gs_linear_place place = { .t = t, .cst = w->p->cst };
  gs_work work = gs_work_begin (d, &place, &told);
  gs_real *f = gs_numbers (&work, nr + s->nx + s->ny), *g = gs_numbers (&work, d->njacobian);
  gs_real *a = gs_numbers (&work, nr * n), *inverse = gs_numbers (&work, n * nr);
  gs_real *at = gs_numbers (&work, nz), *y = gs_numbers (&work, n);
  if (f && g && a && inverse && at && y)
    {
      gs_real *ud = at + s->nx, *lam = ud + s->nu, *v = lam + s->nlam;
      for (int l = 0; l < nz; l++)
        at[l] = l >= s->nx && l < s->nx + n ? 0 : z[l];
      s->dae (t, at, ud, lam, v, w->p->cst, f);
      s->daj (t, at, ud, lam, v, w->p->cst, g);
      for (int e = 0; e < d->njacobian; e++)
        {
          const int i = d->jacobian[2 * e], l = d->jacobian[2 * e + 1] - 1 - s->nx;
          if (i < nr && l >= 0 && l < n)
            a[i + nr * l] = g[e];
        }
      gs_pseudo_inverse (&work, nr, n, a, 1e-14, inverse);
      gs_product (n, nr, 1, inverse, f, y);
      for (int l = 0; l < n; l++)
        z[s->nx + l] = isfinite ((double)y[l]) ? -(double)y[l] : 0;
    }
  w->bad = gs_work_end (&work) == GS_LINEAR_NO_MEMORY ? 1 : w->bad;
}

/* the position of z that the loops allow, near to the one before */
static void
close_loops (gs_search *w, const gs_motion_guess *given, double t, const double *before, double *z,
             gs_real *x)
{
  const gs_scene *s = w->d->scene;
  gs_real residual = 0;
  for (int j = 0; before && j < s->nq; j++)
    {
      int actuated = 0;
      for (int k = 0; k < given->nactuated; k++)
        actuated |= given->actuated[k] == j;
      if (! actuated)
        z[j] = before[j];
    }
  for (int j = 0; j < s->nx; j++)
    x[j] = z[j];
  int good = s->prj (t, x, w->p->cst, &residual) == 0;
  for (int j = 0; j < s->nx; j++)
    good = good && isfinite ((double)x[j]);
  for (int j = 0; good && j < s->nx; j++)
    z[j] = (double)x[j];
}

static double
either (double a, double b, double c)
{
  return ! isnan (a) ? a : ! isnan (b) ? b : c;
}

static void
straight (gs_search *w, const gs_motion_guess *given, int n, double duration, double *t, double *z)
{
  const gs_scene *s = w->d->scene;
  const gs_motion_problem *p = w->p;
  const int nz = s->nx + s->nu + s->nlam + s->nv;
  gs_real *x = gs_room_reals (&w->room, s->nx);
  if (gs_search_bad (w))
    return;
  for (int k = 0; k < n; k++)
    {
      double *one = z + nz * k;
      t[k] = (double)k / (n - 1);
      for (int j = 0; j < s->nx; j++)
        {
          const double a = either (p->x0[j], given->xf_hint[j], given->start[j]);
          const double b = either (given->xf_hint[j], p->x0[j], given->start[j]);
          one[j] = a + (b - a) * t[k];
        }
      if (s->nlam > 0 && s->prj)
        close_loops (w, given, t[k] * duration, k > 0 ? one - nz : NULL, one, x);
    }
}

/* inputs between their bounds, nearest to what is there; accelerations and multipliers */
static void
complete (gs_search *w, int n, double duration, int line, const double *t, double *z)
{
  const gs_scene *s = w->d->scene;
  const gs_motion_problem *p = w->p;
  const int nz = s->nx + s->nu + s->nlam + s->nv;
  for (int k = 0; k < n; k++)
    {
      double *one = z + nz * k;
      for (int l = nz - s->nv; l < nz; l++)
        one[l] = fmax (p->low[l], fmin (p->high[l], one[l]));
      follow_motion (w, t[k] * duration, one);
    }
  for (int k = 0; line && k < n; k++)
    for (int j = s->nq; j < s->nq + s->nu; j++)
      z[nz * k + s->nx + j - s->nq] = (z[nz * (n - 1) + j] - z[j]) / duration;
}

gs_guess
gs_first_guess (gs_search *w, const gs_motion_guess *given)
{
  const gs_scene *s = w->d->scene;
  const gs_motion_problem *p = w->p;
  const int line = given->n == 0, n = line ? 21 : given->n;
  const int nz = s->nx + s->nu + s->nlam + s->nv;
  double *t = gs_room_numbers (&w->room, n), *z = gs_room_numbers (&w->room, (ptrdiff_t)n * nz);
  double *duration = gs_room_numbers (&w->room, 1);
  double *unknown = gs_room_numbers (&w->room, w->d->nunknown);
  const gs_guess g = { n, t, z, duration, unknown };
  if (gs_search_bad (w))
    return g;
  *duration = fmin (fmax (line ? 1 : given->duration, p->duration[0]), p->duration[1]);
  for (int k = 0; k < w->d->nunknown; k++)
    unknown[k] = fmax (p->unknown_low[k],
                       fmin (p->unknown_high[k], p->par[w->d->unknown[k]]));
  if (line)
    straight (w, given, n, *duration, t, z);
  for (int k = 0; ! line && k < n; k++)
    {
      t[k] = given->t[k];
      memcpy (z + nz * k, given->x + s->nx * k, (size_t)s->nx * sizeof *z);
      memcpy (z + nz * (k + 1) - s->nv, given->v + s->nv * k, (size_t)s->nv * sizeof *z);
    }
  if (! gs_search_bad (w))
    complete (w, n, *duration, line, t, z);
  return g;
}

/* guess.c: where an optimal motion begins: states on a line between the ends, or given ones.
 *
 * In a closed chain what follows is closed along the line, the speeds are those of the path. On a
 * line of an open one accelerations are what the lines of the speeds have: those of the machine
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

/* the speeds of z at t by the positions of before and after, the time span apart */
static void
follow_path (gs_search *w, double t, double span, const double *before, const double *after,
             double *z)
{
  const gs_description *d = w->d;
  const gs_scene *s = d->scene;
  const int nq = s->nq, nu = s->nu, nr = d->nresiduals, nz = s->nx + nu + s->nlam + s->nv;
  gs_linear_told told;
  const gs_linear_place place = { .t = t, .cst = w->p->cst };
  gs_work work = gs_work_begin (d, &place, &told);
  gs_real *at = gs_numbers (&work, nz), *g = gs_numbers (&work, d->njacobian);
  gs_real *k = gs_numbers (&work, nq * nu), *inverse = gs_numbers (&work, nu * nq);
  gs_real *rates = gs_numbers (&work, nq), *u = gs_numbers (&work, nu);
  if (at && g && k && inverse && rates && u)
    {
      for (int l = 0; l < s->nx; l++)
        at[l] = z[l];
      s->daj (t, at, at + s->nx, at + s->nx + nu, at + nz - s->nv, w->p->cst, g);
      for (int e = 0; e < d->njacobian; e++)
        {
          const int i = d->jacobian[2 * e] - nr, l = d->jacobian[2 * e + 1] - 1 - nq;
          if (i >= 0 && i < nq && l >= 0 && l < nu)
            k[i + nq * l] = g[e];
        }
      for (int i = 0; i < nq; i++)
        rates[i] = (after[i] - before[i]) / span;
      gs_pseudo_inverse (&work, nq, nu, k, 1e-14, inverse);
      gs_product (nu, nq, 1, inverse, rates, u);
      for (int l = 0; l < nu; l++)
        z[nq + l] = isfinite ((double)u[l]) ? (double)u[l] : z[nq + l];
    }
  w->bad = gs_work_end (&work) == GS_LINEAR_NO_MEMORY ? 1 : w->bad;
}

static double
either (double a, double b, double c)
{
  return ! isnan (a) ? a : ! isnan (b) ? b : c;
}

/* The states of z, one after the other at t, n of them, onto the constraints: the driven
 * coordinates as they are, the others next to where they were before; speeds between the ends by
 * the path. */
static void
close_path (gs_search *w, const gs_motion_guess *given, int n, double duration, const double *t,
            double *z)
{
  const gs_scene *s = w->d->scene;
  const int nz = s->nx + s->nu + s->nlam + s->nv;
  int *held = gs_room_places (&w->room, s->nq);
  gs_assembly *found = gs_room_take (&w->room, 1, sizeof *found);
  for (int j = 0; ! gs_search_bad (w) && j < given->nactuated; j++)
    held[given->actuated[j]] = 1;
  for (int k = 0; k < n && ! gs_search_bad (w); k++)
    {
      double *one = z + nz * k;
      for (int j = 0; k > 0 && j < s->nq; j++)
        one[j] = held[j] ? one[j] : one[j - nz];
      gs_close_chain (w, given, t[k] * duration, held, one, found);
    }
  for (int k = 1; k < n - 1 && ! gs_search_bad (w); k++)
    follow_path (w, t[k] * duration, (t[k + 1] - t[k - 1]) * duration, z + nz * (k - 1),
                 z + nz * (k + 1), z + nz * k);
}

static void
straight (gs_search *w, const gs_motion_guess *given, int n, double duration, double *t, double *z)
{
  const gs_scene *s = w->d->scene;
  const gs_motion_problem *p = w->p;
  const int nz = s->nx + s->nu + s->nlam + s->nv;
  for (int k = 0; k < n; k++)
    {
      t[k] = (double)k / (n - 1);
      for (int j = 0; j < s->nx; j++)
        {
          const double a = either (p->x0[j], w->hint[j], given->start[j]);
          const double b = either (w->hint[j], p->x0[j], given->start[j]);
          z[nz * k + j] = a + (b - a) * t[k];
        }
    }
  if (gs_is_closed (s))
    close_path (w, given, n, duration, t, z);
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
  for (int k = 0; line && ! gs_is_closed (s) && k < n; k++)
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

/* gs_step_passage: the motion through a position where the constraints lose rank, in one step of an
 * implicit method whose stages keep away from it.
 *
 * x is the state at t, which may lie anywhere between tc - d and tc + d, at the singular position
 * as well, which ought to lie at tc. Collocation at the points of Gauss, an even number: none of 8
 * is nearer to tc than 0.18*d, none of 12 nearer than 0.12*d. The stages are completed by
 * gs_complete_state. First every stage is predicted from those before it, then all of them are
 * iterated. On the branch that the mechanism takes the motion is a smooth function of time, but
 * what follows from the constraints at a position close to the singular one is not known: an error
 * e of theirs is one of e/s in completed coordinates, e/s**2 in speeds, e/s**3 in accelerations, s
 * being the least pivot.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.7
 * (collocation). */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"

enum { TOO_FAR = 1, DIVERGES, STAGE_FAILED };

typedef struct
{
  gs_real c[12], wt[12], c0; /* points and weights of the stages, the place of x */
  int order[12];            /* of the stages, from 1 */
  gs_real tol;
} points;

/* all stages once more; a->eit: what that moved. info: of a stage that failed */
static int
iterate (const gs_system *g, const gs_real *x, gs_passage *a, const points *z, gs_real *f,
         gs_real *xn, gs_real *fn)
{
  const int nx = g->nx;
  a->eit = 0;
  for (int j = 0; j < a->ns; j++)
    {
      const int k = z->order[j] - 1;
      gs_real b[12], size, *stage = f + nx * (k + 1);
      gs_gauss_weights (a->ns, z->c, z->wt, z->c0, z->c[k], b);
      gs_passage_path (nx, a->ns, nx, x, a->d, b, f, xn);
      int info = gs_passage_rates (g, a->tc + z->c[k] * a->d, a->tv, xn, fn);
      if (info != 0)
        return info;
      for (int i = 0; i < nx; i++)
        {
          gs_real old = stage[i];
          stage[i] = fn[i];
          fn[i] = a->d * z->wt[k] * (fn[i] - old);
        }
      gs_passage_error (g, x, fn, z->tol, &size);
      a->eit += size;
    }
  return 0;
}

/* until it moves no more */
static int
converge (const gs_system *g, const gs_real *x, gs_passage *a, const points *z, gs_real *f,
          gs_real *xn, gs_real *fn)
{
  gs_real old = GS_HUGE;
  for (int l = 1; l <= 40; l++)
    {
      if (iterate (g, x, a, z, f, xn, fn) != 0)
        return STAGE_FAILED;
      if (! (a->eit <= GS_HUGE))
        return DIVERGES;
      if (a->eit <= GS_R (0.02) || (l > 2 && a->eit > GS_R (0.5) * old && a->eit <= 30))
        return 0;
      old = a->eit;
    }
  return DIVERGES;
}

/* the error, by how the last coefficients of the polynomial fall */
static void
estimate (const gs_system *g, const gs_real *x, gs_passage *a, const points *z, const gs_real *f,
          gs_real *fn)
{
  const int nx = g->nx, ns = a->ns;
  gs_real old = 0, size;
  for (int j = ns - 4; j < ns; j++)
    {
      for (int i = 0; i < nx; i++)
        fn[i] = 0;
      for (int k = 0; k < ns; k++)
        {
          gs_real b[12];
          gs_legendre (ns, z->c[k], b);
          const gs_real s = a->d * z->wt[k] * b[j] * GS_R (0.5);
          for (int i = 0; i < nx; i++)
            fn[i] += s * f[i + nx * (k + 1)];
        }
      gs_passage_error (g, x, fn, z->tol, &size);
      if (j < ns - 2)
        old = gs_max (old, size);
      else
        a->err = gs_max (a->err, size);
    }
  if (a->err < old)
    a->err *= a->err / old;
}

int
gs_step_passage (const gs_system *g, gs_real t, const gs_real *x, gs_passage *a, gs_real *f,
                 gs_real *xn, gs_real *fn)
{
  points z;
  gs_real cs;
  gs_gauss_points (a->ns, z.c, z.wt);
  z.c0 = (t - a->tc) / a->d;
  z.tol = gs_max (g->ropt[1], GS_R (5e3) * gs_epsilon ());
  a->err = 0;
  a->eit = 0;
  if (gs_passage_stages (g, x, a, z.c0, z.c, f, xn, z.order) != 0)
    return STAGE_FAILED;
  gs_passage_least_pivot (g, t, x, a->tc, a->d, -GS_R (0.7), GS_R (0.7), a->ns, f, xn, &cs,
                          &a->smin);
  a->tmin = a->tc + cs * a->d;
  if (gs_abs (cs) > GS_R (0.03))
    return TOO_FAR;
  int info = converge (g, x, a, &z, f, xn, fn);
  if (info != 0)
    return info;
  estimate (g, x, a, &z, f, fn);
  gs_passage_least_pivot (g, t, x, a->tc, a->d, -GS_R (0.1), GS_R (0.1), a->ns, f, xn, &cs,
                          &a->smin);
  a->tmin = a->tc + cs * a->d;
  return 0;
}

/* stages behind c0, then those before it, outwards; how many are behind it */
static int
outwards (int ns, gs_real c0, const gs_real *c, int *order)
{
  int n = 0;
  for (int k = 0; k < ns; k++)
    if (c[k] > c0)
      order[n++] = k + 1;
  const int behind = n;
  for (int k = ns - 1; k >= 0; k--)
    if (c[k] <= c0)
      order[n++] = k + 1;
  return behind;
}

/* Each by the polynomial through up to seven of those that are known already; close to the singular
 * position its own rates are of no use once there are others. */
int
gs_passage_stages (const gs_system *g, const gs_real *x, const gs_passage *a, gs_real c0,
                   const gs_real *c, gs_real *f, gs_real *xn, int *order)
{
  const int nx = g->nx, behind = outwards (a->ns, c0, c, order);
  gs_real place[13] = { c0 }, b[13], from = c0;
  int known[13] = { 0 }, n = 1; /* columns of f at these places */
  for (int j = 0; j < a->ns; j++)
    {
      const int k = order[j] - 1;
      if (j == 0 || j == behind)
        {
          from = c0;
          for (int i = 0; i < nx; i++)
            xn[i] = x[i];
        }
      if (j == 1 && gs_abs (c0) < GS_R (0.1))
        {
          place[0] = place[1];
          known[0] = known[1];
          n = 1;
        }
      gs_interpolation_weights (n, place, from, c[k], b);
      for (int i = 0; i < nx; i++)
        for (int l = 0; l < n; l++)
          xn[i] += a->d * b[l] * f[i + nx * known[l]];
      int info = gs_passage_rates (g, a->tc + c[k] * a->d, a->tv, xn, f + nx * (k + 1));
      if (info != 0)
        return info;
      from = c[k];
      place[n] = c[k];
      known[n++] = k + 1;
    }
  return 0;
}

/* Beyond a jump of the inputs, at tv[0] or tv[1], with those up to it, continued. */
int
gs_passage_rates (const gs_system *g, gs_real t, const gs_real *tv, gs_real *x, gs_real *xd)
{
  const int side = t >= tv[1] ? -1 : 1;
  const gs_real te = gs_min (gs_max (t, tv[0]), tv[1]);
  gs_real tf = t;
  if (tv[2] > 0)
    tf = te + tv[2] * gs_tanh ((t - te) / tv[2]);
  return gs_rates_from (g, t, te, tf, side, x, xd);
}

/* States that are completed from others are left out. */
void
gs_passage_error (const gs_system *g, const gs_real *x, const gs_real *d, gs_real tol, gs_real *err)
{
  const gs_real *counts = g->p + GS_PARTS + g->s->nu, rtol = g->ropt[1];
  const int moving = g->s->nq + g->s->nu;
  int n = 0;
  *err = 0;
  for (int i = 0; i < g->nx; i++)
    {
      if (i < moving && ! (counts[i] > 0))
        continue;
      n++;
      gs_real s = (g->atol[i] / rtol + gs_abs (x[i])) * tol;
      if (s > 0)
        *err += (d[i] / s) * (d[i] / s);
    }
  *err = gs_sqrt (*err / (gs_real)gs_most (1, n));
}

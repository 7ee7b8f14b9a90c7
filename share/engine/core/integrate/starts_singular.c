/* gs_starts_singular: whether a run starts in, or very close to, a position where the constraints
 * lose rank. Then p knows their rank and pivots where they do not.
 *
 * The pivots beyond the rank at x a little ahead, and half as far. On the straight way from a
 * singular position they grow with the way, those of constraints that are redundant everywhere
 * with its square, as far as it leads off the constraints. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* where gs_starts_singular looks from */
typedef struct
{
  const gs_scene *s;
  gs_real t;
  const gs_real *x, *cst, *f;
  gs_real *xt, *xw, *siz, *p;
} start;

/* the rank of the constraints h behind t */
static int
rank_behind (const start *b, gs_real h)
{
  int rank;
  gs_singular_pivots (b->s, b->t, b->x, h, b->cst, b->f, b->xt, b->xw, b->siz, b->p, &rank);
  return rank;
}

/* the pivot i (from 1) there beside the largest, 0 where the rank is less */
static gs_real
pivot_behind (const start *b, gs_real h, int i)
{
  const gs_real *siz = gs_partition_of (b->s->nq, b->s->nu, b->s->nlam, b->p).siz;
  return rank_behind (b, h) >= i ? siz[i - 1] / siz[0] : 0;
}

/* the rank elsewhere, nr being that at x: the last pivot that grows with the way h, half as far for
 * half of it; 0: none does */
static int
rank_elsewhere (const start *b, int nr, gs_real h, gs_real half)
{
  for (int i = gs_least (b->s->nu, b->s->nlam); i >= gs_most (1, nr); i--)
    {
      gs_real mid = pivot_behind (b, GS_R (0.1) * h, i);
      gs_real near = pivot_behind (b, GS_R (0.1) * half * h, i);
      if (i <= nr || (mid > 0 && mid <= GS_R (2.8) * near))
        return i;
    }
  return 0;
}

void
gs_starts_singular (const gs_scene *s, gs_real t, const gs_real *x, gs_real hmax,
                    const gs_real *cst, const gs_real *f, gs_real *xt, gs_real *xw, gs_real *hc,
                    gs_real *siz, gs_real *p, int *state)
{
  const start b = { s, t, x, cst, f, xt, xw, siz, p };
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  gs_real h;
  int rest;
  *state = -1;
  gs_singular_turn_time (s, t, x, hmax, cst, f, xt, xw, hc, siz, p, &h, &rest);
  if (h <= 0)
    return;
  *state = 0;
  const gs_real half = rest == 1 ? gs_sqrt (GS_R (0.5)) : GS_R (0.5);
  const int nr = rank_behind (&b, 0);
  gs_real here = nr > 0 ? part.siz[nr - 1] / part.siz[0] : 0;
  const int rank = rank_elsewhere (&b, nr, h, half);
  if (rank == 0 || rank_behind (&b, h) < rank)
    return;
  const gs_real far = part.siz[rank - 1] / part.siz[0];
  if (rank > nr)
    here = 0;
  if (here > GS_R (0.25) * far)
    return;
  if (here <= GS_R (1e-4) * far)
    *state = 1;
  if (rank > nr && rest == 1)
    *state = 2;
  p[GS_RANK] = (gs_real)rank;
  p[GS_TIMES + 5] = here;
  p[GS_PIVOT] = here;
  p[GS_LARGEST] = far;
  for (int i = 0; i < s->nlam; i++)
    part.size[i] = siz[i];
}

/* how far the rows of the Jacobian that p holds have turned from hc, rows that are nothing there
 * apart; first: that is the one that hc becomes */
static gs_real
turned (const gs_scene *s, const gs_real *now, gs_real *hc, gs_real *big, int first)
{
  gs_real turn = 0;
  for (int i = 0; i < s->nlam; i++)
    {
      gs_real d2 = 0, r = 0;
      for (int j = 0; j < s->nu; j++)
        {
          const int ij = i + s->nlam * j;
          if (first)
            hc[ij] = now[ij];
          const gs_real d = now[ij] - hc[ij];
          r += hc[ij] * hc[ij];
          d2 += d * d;
        }
      if (first)
        *big = gs_max (*big, r);
      if (r > GS_R (1e-6) * *big)
        turn = gs_max (turn, d2 / r);
    }
  return turn;
}

void
gs_singular_turn_time (const gs_scene *s, gs_real t, const gs_real *x, gs_real hmax,
                       const gs_real *cst, const gs_real *f, gs_real *xt, gs_real *xw, gs_real *hc,
                       gs_real *siz, gs_real *p, gs_real *h, int *rest)
{
  const start b = { s, t, x, cst, f, xt, xw, siz, p };
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  gs_real turn = 0, big = 0;
  int last = 0;
  *h = 0;
  for (int k = 0; k <= 24; k++)
    {
      for (int i = 0; i < s->nlam; i++)
        siz[i] = part.size[i];
      turn = GS_HUGE;
      if (rank_behind (&b, *h) >= 0)
        turn = turned (s, part.hc, hc, &big, k == 0);
      if (last == 2 || (turn <= GS_R (0.09) && (last == 1 || k == 21)))
        break;
      if (turn > GS_R (0.09))
        {
          last++;
          *h = k < 2 ? 0 : GS_R (0.5) * *h;
        }
      else
        *h = hmax * gs_ldexp (1, 2 * k - 40);
    }
  if (! (turn >= GS_R (1e-4) && turn <= GS_R (0.09)))
    *h = 0;

  /* the way there, what the speeds alone do of it */
  gs_real byu = 0, way = 0;
  s->kin (t, x, x + s->nq, cst, xw);
  for (int i = 0; i < s->nq; i++)
    {
      byu = gs_max (byu, gs_abs (*h * xw[i]));
      way = gs_max (way, gs_abs (xt[i] - x[i]));
    }
  *rest = byu <= GS_R (1e-3) * way;
}

/* On the path from x with the accelerations in f; the lengths of rows are in siz. */
void
gs_singular_pivots (const gs_scene *s, gs_real t, const gs_real *x, gs_real h, const gs_real *cst,
                    const gs_real *f, gs_real *xt, gs_real *xw, gs_real *siz, gs_real *p, int *rank)
{
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  s->kin (t, x, x + s->nq, cst, xt);
  s->kin (t, x, f + s->nq, cst, xw);
  for (int i = 0; i < s->nq; i++)
    xt[i] = x[i] + h * (xt[i] + GS_R (0.5) * h * xw[i]);
  *rank = -1;
  int info = s->con (t + h, xt, x + s->nq, cst, part.phi, part.phit, part.hc, s->nlam, part.gam);
  if (info != 0 && info != 2)
    return;
  gs_real least;
  gs_constraint_pivots (s->nu, s->nlam, part.hc, siz, part.y, part.piv, part.beta, part.siz, rank,
                        &least);
}

/* As rates of coordinates. */
void
gs_passage_speed_gap (const gs_system *g, gs_real t, const gs_real *x, const gs_passage *a,
                      const gs_real *f, gs_real *xw, gs_real *gap)
{
  const int nq = g->s->nq, ns = a->ns;
  gs_real c[12], wt[12], p[12], p0[12], b[12], big = 0;
  gs_gauss_points (ns, c, wt);
  gs_legendre (ns, (t - a->tc) / a->d, p0);
  for (int k = 0; k < ns; k++)
    {
      gs_real s = 0;
      gs_legendre (ns, c[k], p);
      for (int j = 0; j < ns; j++)
        s += ((gs_real)j + GS_R (0.5)) * p[j] * p0[j];
      b[k] = wt[k] * s;
    }
  g->s->kin (t, x, x + nq, g->cst, xw);
  *gap = 0;
  for (int i = 0; i < nq; i++)
    {
      gs_real s = 0;
      for (int k = 0; k < ns; k++)
        s += b[k] * f[i + g->nx * (k + 1)];
      *gap = gs_max (*gap, gs_abs (s - xw[i]));
      big = gs_max (big, gs_abs (xw[i]));
    }
  if (big > 0)
    *gap /= big;
}

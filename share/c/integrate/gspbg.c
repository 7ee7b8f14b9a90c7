/* GSPBG: whether a run starts in, or very close to, a position where the constraints lose rank.
 * Then p knows their rank and pivots where they do not.
 *
 * The pivots beyond the rank at x a little ahead, and half as far. On the straight way from a
 * singular position they grow with the way, those of constraints that are redundant everywhere
 * with its square, as far as it leads off the constraints. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* where gspbg looks from */
typedef struct
{
  const gs_scene *s;
  double t;
  const double *x, *cst, *f;
  double *xt, *xw, *siz, *p;
} start;

/* the rank of the constraints h behind t */
static int
rank_behind (const start *b, double h)
{
  int rank;
  gspbv (b->s, b->t, b->x, h, b->cst, b->f, b->xt, b->xw, b->siz, b->p, &rank);
  return rank;
}

/* the pivot i (from 1) there beside the largest, 0 where the rank is less */
static double
pivot_behind (const start *b, double h, int i)
{
  const double *siz = gs_partition_of (b->s->nq, b->s->nu, b->s->nlam, b->p).siz;
  return rank_behind (b, h) >= i ? siz[i - 1] / siz[0] : 0.0;
}

/* the rank elsewhere, nr being that at x: the last pivot that grows with the way h, half as far for
 * half of it; 0: none does */
static int
rank_elsewhere (const start *b, int nr, double h, double half)
{
  for (int i = gs_least (b->s->nu, b->s->nlam); i >= gs_most (1, nr); i--)
    {
      double mid = pivot_behind (b, 0.1 * h, i);
      double near = pivot_behind (b, 0.1 * half * h, i);
      if (i <= nr || (mid > 0.0 && mid <= 2.8 * near))
        return i;
    }
  return 0;
}

void
gspbg (const gs_scene *s, double t, const double *x, double hmax, const double *cst,
       const double *f, double *xt, double *xw, double *hc, double *siz, double *p, int *state)
{
  const start b = { s, t, x, cst, f, xt, xw, siz, p };
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  double h;
  int rest;
  *state = -1;
  gspbh (s, t, x, hmax, cst, f, xt, xw, hc, siz, p, &h, &rest);
  if (h <= 0.0)
    return;
  *state = 0;
  const double half = rest == 1 ? sqrt (0.5) : 0.5;
  const int nr = rank_behind (&b, 0.0);
  double here = nr > 0 ? part.siz[nr - 1] / part.siz[0] : 0.0;
  const int rank = rank_elsewhere (&b, nr, h, half);
  if (rank == 0 || rank_behind (&b, h) < rank)
    return;
  const double far = part.siz[rank - 1] / part.siz[0];
  if (rank > nr)
    here = 0.0;
  if (here > 0.25 * far)
    return;
  if (here <= 1e-4 * far)
    *state = 1;
  if (rank > nr && rest == 1)
    *state = 2;
  p[GS_RANK] = rank;
  p[GS_TIMES + 5] = here;
  p[GS_PIVOT] = here;
  p[GS_LARGEST] = far;
  for (int i = 0; i < s->nlam; i++)
    part.size[i] = siz[i];
}

/* how far the rows of the Jacobian that p holds have turned from hc, rows that are nothing there
 * apart; first: that is the one that hc becomes */
static double
turned (const gs_scene *s, const double *now, double *hc, double *big, int first)
{
  double turn = 0.0;
  for (int i = 0; i < s->nlam; i++)
    {
      double d2 = 0.0, r = 0.0;
      for (int j = 0; j < s->nu; j++)
        {
          const int ij = i + s->nlam * j;
          if (first)
            hc[ij] = now[ij];
          const double d = now[ij] - hc[ij];
          r += hc[ij] * hc[ij];
          d2 += d * d;
        }
      if (first)
        *big = gs_max (*big, r);
      if (r > 1e-6 * *big)
        turn = gs_max (turn, d2 / r);
    }
  return turn;
}

void
gspbh (const gs_scene *s, double t, const double *x, double hmax, const double *cst,
       const double *f, double *xt, double *xw, double *hc, double *siz, double *p, double *h,
       int *rest)
{
  const start b = { s, t, x, cst, f, xt, xw, siz, p };
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  double turn = 0.0, big = 0.0;
  int last = 0;
  *h = 0.0;
  for (int k = 0; k <= 24; k++)
    {
      for (int i = 0; i < s->nlam; i++)
        siz[i] = part.size[i];
      turn = 1e300;
      if (rank_behind (&b, *h) >= 0)
        turn = turned (s, part.hc, hc, &big, k == 0);
      if (last == 2 || (turn <= 0.09 && (last == 1 || k == 21)))
        break;
      if (turn > 0.09)
        {
          last++;
          *h = k < 2 ? 0.0 : 0.5 * *h;
        }
      else
        *h = hmax * ldexp (1.0, 2 * k - 40);
    }
  if (! (turn >= 1e-4 && turn <= 0.09))
    *h = 0.0;

  /* the way there, what the speeds alone do of it */
  double byu = 0.0, way = 0.0;
  s->kin (t, x, x + s->nq, cst, xw);
  for (int i = 0; i < s->nq; i++)
    {
      byu = gs_max (byu, fabs (*h * xw[i]));
      way = gs_max (way, fabs (xt[i] - x[i]));
    }
  *rest = byu <= 1e-3 * way;
}

/* On the path from x with the accelerations in f; the lengths of rows are in siz. */
void
gspbv (const gs_scene *s, double t, const double *x, double h, const double *cst, const double *f,
       double *xt, double *xw, double *siz, double *p, int *rank)
{
  const gs_partition part = gs_partition_of (s->nq, s->nu, s->nlam, p);
  s->kin (t, x, x + s->nq, cst, xt);
  s->kin (t, x, f + s->nq, cst, xw);
  for (int i = 0; i < s->nq; i++)
    xt[i] = x[i] + h * (xt[i] + 0.5 * h * xw[i]);
  *rank = -1;
  int info = s->con (t + h, xt, x + s->nq, cst, part.phi, part.phit, part.hc, s->nlam, part.gam);
  if (info != 0 && info != 2)
    return;
  double least;
  gslpv (s->nu, s->nlam, part.hc, siz, part.y, part.piv, part.beta, part.siz, rank, &least);
}

/* As rates of coordinates. */
void
gspbc (const gs_system *g, double t, const double *x, const gs_passage *a, const double *f,
       double *xw, double *gap)
{
  const int nq = g->s->nq, ns = a->ns;
  double c[12], wt[12], p[12], p0[12], b[12], big = 0.0;
  gsgln (ns, c, wt);
  gslgp (ns, (t - a->tc) / a->d, p0);
  for (int k = 0; k < ns; k++)
    {
      double s = 0.0;
      gslgp (ns, c[k], p);
      for (int j = 0; j < ns; j++)
        s += (j + 0.5) * p[j] * p0[j];
      b[k] = wt[k] * s;
    }
  g->s->kin (t, x, x + nq, g->cst, xw);
  *gap = 0.0;
  for (int i = 0; i < nq; i++)
    {
      double s = 0.0;
      for (int k = 0; k < ns; k++)
        s += b[k] * f[i + g->nx * (k + 1)];
      *gap = gs_max (*gap, fabs (s - xw[i]));
      big = gs_max (big, fabs (xw[i]));
    }
  if (big > 0.0)
    *gap /= big;
}

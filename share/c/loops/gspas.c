#include "gsmbp/arith.h"
#include "gsmbp/loops.h"

#include <math.h>
#include <string.h>

/* where the search is: pivots below smin are wanted */
typedef struct
{
  const gs_scene *s;
  const double *u, *cst; /* speeds, as they are at the last step's end */
  double *p;
  gs_partition a;
  double tmin, smin;
} search;

/* time and least pivot at the end of the last step but 2, 1, 0 */
static double *
end_of (double *p, int back)
{
  return p + GS_TIMES + 2 * (2 - back);
}

/* the memory goes on by one step to t, x */
static void
remember (const gs_scene *s, double t, const double *x, const double *cst, double *p)
{
  int nq = s->nq;
  double *path = gs_partition_of (nq, s->nu, s->nlam, p).path;
  memmove (end_of (p, 2), end_of (p, 1), 4 * sizeof *p);
  memmove (path, path + 2 * nq, 4 * nq * sizeof *p);
  p[GS_STEPS] += 1.0;
  end_of (p, 0)[0] = t;
  end_of (p, 0)[1] = p[GS_PIVOT];
  memcpy (path + 4 * nq, x, nq * sizeof *p);
  s->kin (t, x, x + nq, cst, path + 5 * nq);
}

/* whether the least pivot was smaller at the end of the last step but one than around it */
static int
passed (double *p)
{
  double before = end_of (p, 2)[1], mid = end_of (p, 1)[1], now = end_of (p, 0)[1];
  return ! (p[GS_STEPS] < 3.0 || mid > before || mid >= now || mid > 0.5 * p[GS_LARGEST]);
}

/* whether the constraints turned by more than 0.3 rad in the last step */
static int
turned (search *f)
{
  const gs_scene *s = f->s;
  gs_partition *a = &f->a;
  double turn;
  gspch (s->nq, s->nu, s->nlam, f->p, a->y, 0, &turn);
  int info = s->con (end_of (f->p, 1)[0], a->path + 2 * s->nq, f->u, f->cst, a->phi, a->phit,
                     a->hc, s->nlam, a->gam);
  if (info != 0 && info != 2)
    return 0;
  gspch (s->nq, s->nu, s->nlam, f->p, a->y, 1, &turn);
  return turn > 0.3;
}

/* the cubic through two positions at times h apart and their rates, four columns of n entries, at
 * the part z of the way */
static void
cubic (int n, const double *c, double h, double z, double *q)
{
  for (int i = 0; i < n; i++, c++)
    q[i] = c[0] + z * z * (3.0 - 2.0 * z) * (c[2 * n] - c[0])
           + h * z * (1.0 - z) * ((1.0 - z) * c[n] - z * c[3 * n]);
}

/* the least pivot at a time of the last two steps, kept if it is below the least so far */
static void
sample (search *f, double t)
{
  const gs_scene *s = f->s;
  gs_partition *a = &f->a;
  int back = t >= end_of (f->p, 1)[0] ? 1 : 2, rank;
  double begin = end_of (f->p, back)[0], h = end_of (f->p, back - 1)[0] - begin;
  double z = (t - begin) / h, least;
  if (z < 0.0 || z > 1.0)
    return;
  cubic (s->nq, a->path + 2 * s->nq * (2 - back), h, z, a->between);
  int info = s->con (t, a->between, f->u, f->cst, a->phi, a->phit, a->hc, s->nlam, a->gam);
  if (info != 0 && info != 2)
    return;
  gslpv (s->nu, s->nlam, a->hc, a->size, a->y, a->piv, a->beta, a->siz, &rank, &least);
  if (rank < f->p[GS_RANK])
    least = 0.0;
  if (least < f->smin)
    {
      f->smin = least;
      f->tmin = t;
    }
}

/* The minimum is looked for where the least pivot has passed one, on the cubics through positions
 * and their rates. Where the constraints turn by more than 0.3 rad in a step it may lie within,
 * unseen at its ends, and is looked for in every case. */
void
gspas (const gs_scene *s, double t, const double *x, const double *cst, double *p, double *tmin,
       double *smin)
{
  search f = { s, x + s->nq, cst, p, gs_partition_of (s->nq, s->nu, s->nlam, p), 0.0, 0.0 };
  const double *mid = end_of (p, 1), *now = end_of (p, 0);
  remember (s, t, x, cst, p);
  *smin = -1.0;
  if (p[GS_STEPS] < 2.0)
    return;
  int within = ! passed (p); /* the last step alone, else the last two */
  if (within && ! turned (&f))
    return;

  /* samples of these steps, then finer and finer */
  f.smin = within ? 0.9 * gs_min (mid[1], now[1]) : mid[1];
  f.tmin = within ? now[0] : mid[0];
  double first = end_of (p, within ? 1 : 2)[0], w = (now[0] - first) / 16.0;
  for (int l = 0; l < 4; l++)
    {
      double begin = l == 0 ? first : f.tmin - w;
      if (l > 0)
        w *= 0.125;
      for (int k = 1; k < 16; k++)
        sample (&f, begin + k * w);
      /* within one step: only what falls below both ends is followed */
      if (within && ! (f.tmin < now[0]))
        break;
    }
  *tmin = f.tmin;
  *smin = f.smin;
  if (within)
    {
      if (f.tmin < now[0])
        p[GS_STEPS] = 1.0; /* the steps that follow find others */
      else
        *smin = -1.0;
    }
}

void
gspch (int nq, int nu, int nlam, const double *p, double *hc, int job, double *turn)
{
  gs_partition a = gs_partition_of (nq, nu, nlam, (double *)p); /* only read */
  *turn = 0.0;
  for (int i = 0; i < nlam; i++)
    {
      double s = 0.0;
      for (int j = 0; j < nu; j++)
        {
          double now = a.hc[i + nlam * j];
          if (job == 0)
            hc[i + nlam * j] = now;
          s += (hc[i + nlam * j] - now) * (hc[i + nlam * j] - now);
        }
      if (s > 0.0)
        *turn = gs_max (*turn, sqrt (s) / a.size[i]);
    }
}

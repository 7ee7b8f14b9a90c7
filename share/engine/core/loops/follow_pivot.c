#include "gsmbp/arith.h"
#include "gsmbp/loops.h"

/* where the search is: pivots below smin are wanted */
typedef struct
{
  const gs_scene *s;
  const gs_real *u, *cst; /* speeds, as they are at the last step's end */
  gs_real *p;
  gs_partition a;
  gs_real tmin, smin;
} search;

/* time and least pivot at the end of the last step but 2, 1, 0 */
static gs_real *
end_of (gs_real *p, int back)
{
  return p + GS_TIMES + 2 * (2 - back);
}

/* the memory goes on by one step to t, x */
static void
remember (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p)
{
  int nq = s->nq;
  gs_real *path = gs_partition_of (nq, s->nu, s->nlam, p).path;
  gs_move (4, end_of (p, 1), end_of (p, 2));
  gs_move (4 * nq, path + 2 * nq, path);
  p[GS_STEPS] += 1;
  end_of (p, 0)[0] = t;
  end_of (p, 0)[1] = p[GS_PIVOT];
  gs_copy (nq, x, path + 4 * nq);
  s->kin (t, x, x + nq, cst, path + 5 * nq);
}

/* whether the least pivot was smaller at the end of the last step but one than around it */
static int
passed (gs_real *p)
{
  gs_real before = end_of (p, 2)[1], mid = end_of (p, 1)[1], now = end_of (p, 0)[1];
  return ! (p[GS_STEPS] < 3 || mid > before || mid >= now || mid > GS_R (0.5) * p[GS_LARGEST]);
}

/* whether the constraints turned by more than 0.3 rad in the last step */
static int
turned (search *f)
{
  const gs_scene *s = f->s;
  gs_partition *a = &f->a;
  gs_real turn;
  gs_jacobian_turn (s->nq, s->nu, s->nlam, f->p, a->y, 0, &turn);
  int info = s->con (end_of (f->p, 1)[0], a->path + 2 * s->nq, f->u, f->cst, a->phi, a->phit,
                     a->hc, s->nlam, a->gam);
  if (info != 0 && info != 2)
    return 0;
  gs_jacobian_turn (s->nq, s->nu, s->nlam, f->p, a->y, 1, &turn);
  return turn > GS_R (0.3);
}

/* the cubic through two positions at times h apart and their rates, four columns of n entries, at
 * the part z of the way */
static void
cubic (int n, const gs_real *c, gs_real h, gs_real z, gs_real *q)
{
  for (int i = 0; i < n; i++, c++)
    q[i] = c[0] + z * z * (3 - 2 * z) * (c[2 * n] - c[0])
           + h * z * (1 - z) * ((1 - z) * c[n] - z * c[3 * n]);
}

/* the least pivot at a time of the last two steps, kept if it is below the least so far */
static void
sample (search *f, gs_real t)
{
  const gs_scene *s = f->s;
  gs_partition *a = &f->a;
  int back = t >= end_of (f->p, 1)[0] ? 1 : 2, rank;
  gs_real begin = end_of (f->p, back)[0], h = end_of (f->p, back - 1)[0] - begin;
  gs_real z = (t - begin) / h, least;
  if (z < 0 || z > 1)
    return;
  cubic (s->nq, a->path + 2 * s->nq * (2 - back), h, z, a->between);
  int info = s->con (t, a->between, f->u, f->cst, a->phi, a->phit, a->hc, s->nlam, a->gam);
  if (info != 0 && info != 2)
    return;
  gs_constraint_pivots (s->nu, s->nlam, a->hc, a->size, a->y, a->piv, a->beta, a->siz, &rank,
                        &least);
  if ((gs_real)rank < f->p[GS_RANK])
    least = 0;
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
gs_follow_pivot (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
                 gs_real *tmin, gs_real *smin)
{
  search f = { s, x + s->nq, cst, p, gs_partition_of (s->nq, s->nu, s->nlam, p), 0, 0 };
  const gs_real *mid = end_of (p, 1), *now = end_of (p, 0);
  remember (s, t, x, cst, p);
  *smin = -1;
  if (p[GS_STEPS] < 2)
    return;
  int within = ! passed (p); /* the last step alone, else the last two */
  if (within && ! turned (&f))
    return;

  /* samples of these steps, then finer and finer */
  f.smin = within ? GS_R (0.9) * gs_min (mid[1], now[1]) : mid[1];
  f.tmin = within ? now[0] : mid[0];
  gs_real first = end_of (p, within ? 1 : 2)[0], w = (now[0] - first) / 16;
  for (int l = 0; l < 4; l++)
    {
      gs_real begin = l == 0 ? first : f.tmin - w;
      if (l > 0)
        w *= GS_R (0.125);
      for (int k = 1; k < 16; k++)
        sample (&f, begin + (gs_real)k * w);
      /* within one step: only what falls below both ends is followed */
      if (within && ! (f.tmin < now[0]))
        break;
    }
  *tmin = f.tmin;
  *smin = f.smin;
  if (within)
    {
      if (f.tmin < now[0])
        p[GS_STEPS] = 1; /* the steps that follow find others */
      else
        *smin = -1;
    }
}

void
gs_jacobian_turn (int nq, int nu, int nlam, const gs_real *p, gs_real *hc, int job, gs_real *turn)
{
  gs_partition a = gs_partition_of (nq, nu, nlam, (gs_real *)p); /* only read */
  *turn = 0;
  for (int i = 0; i < nlam; i++)
    {
      gs_real s = 0;
      for (int j = 0; j < nu; j++)
        {
          gs_real now = a.hc[i + nlam * j];
          if (job == 0)
            hc[i + nlam * j] = now;
          s += (hc[i + nlam * j] - now) * (hc[i + nlam * j] - now);
        }
      if (s > 0)
        *turn = gs_max (*turn, gs_sqrt (s) / a.size[i]);
    }
}

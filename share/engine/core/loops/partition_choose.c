#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/system.h"
#include "gsmbp/solve.h"

int
gs_partition_choose (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p)
{
  gs_partition a = gs_partition_of (s->nq, s->nu, s->nlam, p);
  int info = s->con (t, x, x + s->nq, cst, a.phi, a.phit, a.hc, s->nlam, a.gam), rank, change;
  gs_real least;
  if (info != 0 && info != 2)
    return info;
  p[GS_DEPENDENT] = -1;
  gs_partition_rank (s, t, x, cst, p, &rank, &least, &change);
  return 0;
}

int
gs_partition_choose_in_run (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                            gs_real *p, int *istat)
{
  int info = gs_partition_choose (s, t, x, cst, p);
  istat[GS_FAILED_INFO] = info;
  istat[GS_FAILED] = info == 0 ? GS_AT_NOTHING : GS_AT_CON;
  return info;
}

/* the volume that the present dependent columns span beside that of the best rank ones, whose sizes
 * gs_constraint_pivots left; 0 if there are not as many. y is destroyed. */
static gs_real
volume (const gs_scene *s, const gs_real *p, int rank, gs_partition *a)
{
  gs_real ratio;
  if ((int)p[GS_DEPENDENT] != rank)
    return 0;
  for (int j = 0; j < rank; j++)
    {
      const gs_real *col = a->hc + s->nlam * ((int)a->order[j] - 1);
      for (int i = 0; i < s->nlam; i++)
        a->y[i + s->nlam * j] = col[i] / a->size[i];
    }
  gs_volume (s->nlam, rank, a->y, a->siz, &ratio);
  return ratio;
}

/* the choice of displacements where constraints on speeds alone do not count; their number */
static int
displacements (const gs_scene *s, gs_partition *a)
{
  int rank;
  for (int i = 0; i < s->nlam; i++)
    {
      gs_real part = a->size[i] > 0 ? a->rows[i] / a->size[i] : 0;
      for (int j = 0; j < s->nu; j++)
        a->y[i + s->nlam * j] = part * a->hc[i + s->nlam * j];
    }
  gs_qr_columns (s->nlam, s->nu, a->y, s->nlam, GS_R2 (1e-7, 1e-4), a->displ, a->beta, a->siz,
                 &rank);
  return rank;
}

/* By column pivoting of HC, each row divided by the largest size it had so far (one that vanishes
 * now is seen to vanish). A set that has been chosen is kept as long as the volume that its columns
 * span is at least 0.8 of the best one's (the product of the diagonals of their triangular
 * factors): where it is much less, errors of the independent ones are multiplied. With
 * p[GS_WAY] = 3 it is kept down to 0.05: every change costs a method that keeps the energy some of
 * that. */
void
gs_partition_rank (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
                   int *rank, gs_real *least, int *change)
{
  gs_partition a = gs_partition_of (s->nq, s->nu, s->nlam, p);
  *change = 0;
  gs_constraint_pivots (s->nu, s->nlam, a.hc, a.size, a.y, a.piv, a.beta, a.siz, rank, least);
  if (p[GS_WAY] <= 0)
    return;

  if (volume (s, p, *rank, &a) < (p[GS_WAY] > GS_R (2.5) ? GS_R (0.05) : GS_R (0.8)))
    {
      *change = p[GS_DEPENDENT] >= 0;
      p[GS_DEPENDENT] = (gs_real)*rank;
      p[GS_DISPLACED] = (gs_real)*rank;
      for (int j = 0; j < s->nu; j++)
        {
          a.order[j] = a.piv[j];
          a.displ[j] = a.piv[j];
        }
    }
  else if (p[GS_NONHOLONOMIC] <= 0)
    return;

  if (p[GS_NONHOLONOMIC] > 0)
    p[GS_DISPLACED] = (gs_real)displacements (s, &a);
  gs_partition_weights (s, t, x, cst, p, a.displ, a.du);
}

/* Those count that are not completed from others. */
void
gs_partition_weights (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                      gs_real *p, const gs_real *order, gs_real *w)
{
  gs_partition a = gs_partition_of (s->nq, s->nu, s->nlam, p);
  gs_real *qdot = w + s->nu;
  for (int i = 0; i < s->nq; i++)
    a.counts[i] = p[GS_WAY] < 2;
  for (int j = 0; j < s->nu; j++)
    {
      a.counts[s->nq + (int)a.order[j] - 1] = j >= (int)p[GS_DEPENDENT];
      w[j] = 0;
    }
  for (int j = (int)p[GS_DISPLACED]; j < s->nu; j++)
    {
      int k = (int)order[j] - 1;
      w[k] = 1;
      s->kin (t, x, w, cst, qdot);
      w[k] = 0;
      for (int i = 0; i < s->nq; i++)
        if (gs_abs (qdot[i]) > GS_R2 (1e-12, 1e-6))
          a.counts[i] = 1;
    }
}

void
gs_volume (int m, int r, gs_real *y, const gs_real *siz, gs_real *ratio)
{
  *ratio = 1;
  for (int k = 0; k < r; k++)
    {
      gs_real *col = y + k + m * k, d = gs_dot (m - k, 0, col, col), beta;
      *ratio = *ratio * gs_sqrt (d) / siz[k];
      if (! (d > 0))
        return;
      gs_reflection (m, r, k, y, m, d, &beta);
    }
}

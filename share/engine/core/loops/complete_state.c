#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

#include <stdbool.h>

/* the constraints at x into the arrays of the partition; what con returned, but 0 for 2 */
static int
constraints (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_partition *a)
{
  int info = s->con (t, x, x + s->nq, cst, a->phi, a->phit, a->hc, s->nlam, a->gam);
  return info == 2 ? 0 : info;
}

/* the displacement that closes the loops, by the factorization in the partition of that rank: dq =
 * kin(du) */
static void
displacement (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, int r2, int rank,
              gs_partition *a)
{
  for (int i = 0; i < s->nlam; i++)
    a->rhs[i] = -a->rows[i] * a->phi[i];
  gs_partition_solve (s->nlam, r2, rank, a->y, a->piv, a->beta, a->rhs, s->nu, a->displ, a->du);
  s->kin (t, x, a->du, cst, a->dq);
}

/* Newton's method on the dependent displacements, until one is so small that what is left is
 * rounding; hc and its factorization, of that rank, are those of that place. info as
 * gs_complete_state */
static int
positions (const gs_scene *s, gs_real t, gs_real *x, const gs_real *cst, int r2, gs_partition *a,
           int *rank)
{
  gs_real old = 0, near = GS_R (1e-2) * gs_sqrt (gs_epsilon ());
  bool closed = false;
  for (int k = 0; k < 30; k++)
    {
      int info = constraints (s, t, x, cst, a);
      if (info != 0)
        return info;
      gs_partition_factors (s->nlam, r2, a->hc, a->displ, a->rows, a->y, a->piv, a->beta, a->siz,
                            rank);
      if (closed)
        return 0;
      displacement (s, t, x, cst, r2, *rank, a);
      gs_real d = 0, big = 1;
      for (int i = 0; i < s->nq; i++)
        {
          d = gs_max (d, gs_abs (a->dq[i]));
          big = gs_max (big, gs_abs (x[i]));
        }
      if (! (d <= GS_HUGE))
        return 3;
      gs_real part = gs_min (1, GS_R (0.5) / gs_max (d, GS_R (0.5)));
      for (int i = 0; i < s->nq; i++)
        x[i] += part * a->dq[i];
      closed = d <= near || (k > 0 && d >= GS_R (0.25) * old && d <= GS_R2 (1e-8, 1e-4) * big);
      old = d;
    }
  return 3;
}

/* the dependent speeds: HC*u + phit = 0, by the factorization in the partition of that rank */
static void
speeds (const gs_scene *s, gs_real *x, int r, int rank, gs_partition *a)
{
  gs_real *u = x + s->nq;
  for (int i = 0; i < s->nlam; i++)
    {
      gs_real gap = -a->phit[i];
      for (int j = 0; j < s->nu; j++)
        gap -= a->hc[i + s->nlam * j] * u[j];
      a->rhs[i] = gap;
    }
  gs_partition_solve (s->nlam, r, rank, a->y, a->piv, a->beta, a->rhs, s->nu, a->order, a->du);
  for (int j = 0; j < s->nu; j++)
    u[j] += a->du[j];
}

/* Newton's method on the dependent speeds' displacements du, with dq = kin(du), so that Euler
 * parameters stay on their sphere but for terms of second order. Columns of HC that are dependent
 * are left where they are; more rows than columns are solved by least squares.
 *
 * Wehage and Haug 1982, generalized coordinate partitioning for dimension reduction in analysis of
 * constrained dynamic systems. */
int
gs_complete_state (const gs_scene *s, gs_real t, gs_real *x, const gs_real *cst, gs_real *p)
{
  gs_partition a = gs_partition_of (s->nq, s->nu, s->nlam, p);
  int r = (int)p[GS_DEPENDENT], rank = 0;
  if (r <= 0)
    return 0;
  int info = p[GS_WAY] < 2 ? constraints (s, t, x, cst, &a)
                             : positions (s, t, x, cst, (int)p[GS_DISPLACED], &a, &rank);
  if (info != 0)
    return info;
  if (p[GS_WAY] < 2 || p[GS_NONHOLONOMIC] > 0)
    {
      for (int i = 0; i < s->nlam; i++)
        a.rhs[i] = 1;
      gs_partition_factors (s->nlam, r, a.hc, a.order, a.rhs, a.y, a.piv, a.beta, a.siz, &rank);
    }
  speeds (s, x, r, rank, &a);
  return 0;
}

void
gs_partition_factors (int m, int r, const gs_real *hc, const gs_real *order, const gs_real *rows,
                      gs_real *y, gs_real *piv, gs_real *beta, gs_real *siz, int *rank)
{
  for (int j = 0; j < r; j++)
    {
      const gs_real *col = hc + m * ((int)order[j] - 1);
      for (int i = 0; i < m; i++)
        y[i + m * j] = rows[i] * col[i];
    }
  gs_qr_pivoted (m, r, y, m, GS_R (1e5) * gs_epsilon (), piv, beta, siz, rank);
}

void
gs_partition_solve (int m, int r, int rank, const gs_real *y, const gs_real *piv,
                    const gs_real *beta, gs_real *b, int nu, const gs_real *order, gs_real *du)
{
  for (int i = 0; i < nu; i++)
    du[i] = 0;
  if (r == 0)
    return;
  gs_qr_times (m, rank, y, m, beta, b, 1);
  for (int k = rank - 1; k >= 0; k--)
    {
      b[k] /= y[k + m * k];
      du[(int)order[(int)piv[k] - 1] - 1] = b[k];
      gs_take (k, b[k], y + m * k, b);
    }
}

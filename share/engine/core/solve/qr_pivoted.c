#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

void
gs_qr_pivoted (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
               gs_real *siz, int *rank)
{
  int grp[1] = { 0 };
  gs_qr_groups (n, m, y, ldy, tol, grp, piv, beta, siz, rank);
}

/* for gs_qr_groups: the column from k on of which most is left, relative to its size, or -1; left:
 * the square of that */
static int
most_left (int n, int m, int k, const gs_real *y, int ldy, gs_real tol, gs_real small,
           const gs_real *siz, gs_real *left)
{
  int p = -1;
  gs_real best = tol * tol;
  for (int j = k; j < m; j++)
    if (siz[j] > small)
      {
        gs_real s = gs_dot (n - k, 0, y + k + ldy * j, y + k + ldy * j);
        if (s > best * siz[j])
          {
            best = s / siz[j] * (1 + GS_R2 (1e-8, 1e-5));
            p = j;
            *left = s;
          }
      }
  return p;
}

/* In siz are squares. A column is also dependent if its size is not above tol/500 or 4e-14 times
 * the largest. */
void
gs_qr_groups (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv,
              gs_real *beta, gs_real *siz, int *rank)
{
  gs_real big = 0;
  for (int j = 0; j < m; j++)
    {
      siz[j] = gs_dot (n, 0, y + ldy * j, y + ldy * j);
      piv[j] = (gs_real)(j + 1);
      big = gs_max (big, siz[j]);
    }
  gs_group_sizes (m, grp, GS_R2 (1e-6, 1e-4), siz);
  gs_real small = gs_min (tol / GS_R (5e2), GS_R (2e2) * gs_epsilon ());
  small = small * small * big;

  *rank = 0;
  for (int k = 0; k < gs_least (n, m); k++)
    {
      gs_real d = 0;
      int p = most_left (n, m, k, y, ldy, tol, small, siz, &d);
      if (p < 0)
        return;
      if (p != k)
        {
          gs_swap (n, y + ldy * k, y + ldy * p);
          gs_swap (1, piv + k, piv + p);
          gs_swap (1, siz + k, siz + p);
        }
      *rank = k + 1;
      gs_reflection (n, m, k, y, ldy, d, beta + k);
    }
}

void
gs_group_sizes (int m, const int *grp, gs_real part, gs_real *siz)
{
  if (grp[0] == 0)
    return;
  gs_real big = 0;
  for (int i = 0; i < m; i++)
    {
      gs_real *first = siz + grp[i] - 1;
      *first = gs_max (*first, siz[i]);
      big = gs_max (big, siz[i]);
    }
  for (int i = 0; i < m; i++)
    siz[i] = gs_max (siz[grp[i] - 1], part * big);
}

/* for gs_qr_columns: the column from k on of which most is left; left: the square of that */
static int
longest (int n, int m, int k, const gs_real *y, int ldy, gs_real *left)
{
  int p = k;
  *left = -1;
  for (int j = k; j < m; j++)
    {
      gs_real s = gs_dot (n - k, 0, y + k + ldy * j, y + k + ldy * j);
      if (s > *left * (1 + GS_R2 (1e-8, 1e-5)))
        {
          p = j;
          *left = s;
        }
    }
  return p;
}

/* The first rank columns are far from dependent, and inv(R11)*R12 has no large entries. */
void
gs_qr_columns (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
               gs_real *siz, int *rank)
{
  gs_real big = 0, d;
  for (int j = 0; j < m; j++)
    piv[j] = (gs_real)(j + 1);
  *rank = 0;
  for (int k = 0; k < gs_least (n, m); k++)
    {
      int p = longest (n, m, k, y, ldy, &d);
      if (k == 0)
        big = d;
      if (! (d > tol * tol * big))
        return;
      if (p != k)
        {
          gs_swap (n, y + ldy * k, y + ldy * p);
          gs_swap (1, piv + k, piv + p);
        }
      *rank = k + 1;
      siz[k] = gs_sqrt (d);
      gs_reflection (n, m, k, y, ldy, d, beta + k);
    }
}

/* the columns of one reflection, v with the entries v[1..n-1] behind v[0] = 1: y := y - beta*v'y*v,
 * all of y below its first entry */
static void
reflect (int n, gs_real beta, const gs_real *v, gs_real *y)
{
  gs_real s = gs_dot (n - 1, y[0], v + 1, y + 1) * beta;
  y[0] -= s;
  gs_take (n - 1, s, v + 1, y + 1);
}

void
gs_reflection (int n, int m, int k, gs_real *y, int ldy, gs_real d, gs_real *beta)
{
  gs_real *v = y + k + ldy * k, r = -gs_copysign (gs_sqrt (d), v[0]), s = 1 / (v[0] - r);
  *beta = (r - v[0]) / r;
  for (int i = 1; i < n - k; i++)
    v[i] *= s;
  v[0] = r;
  for (int j = k + 1; j < m; j++)
    reflect (n - k, *beta, v, y + k + ldy * j);
}

void
gs_qr_times (int n, int k, const gs_real *y, int ldy, const gs_real *beta, gs_real *b, int trans)
{
  for (int l = 0; l < k; l++)
    {
      int j = trans == 0 ? k - 1 - l : l;
      reflect (n - j, beta[j], y + j + ldy * j, b + j);
    }
}

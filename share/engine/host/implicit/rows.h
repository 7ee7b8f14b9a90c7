/* Linear equations of loops: M, and rows M^-1 rows' of constraints that may depend on each
   other. */
#ifndef GS_HOST_ROWS_H
#define GS_HOST_ROWS_H
#include <math.h>
#include <stddef.h>

typedef struct
{
  int n, m, rank;             /* speeds, rows, those that do not depend on others */
  int *order;                 /* M: the rows in the order of their pivots */
  double *S, *solved,         /* M x M: factors of rows M^-1 rows'; N x M: L^-1 rows', M = L L' */
      *scale, *side,          /* M each */
      *most;                  /* M: the largest diagonals of S so far, by row */
} gs_rows;

/* how many numbers it needs, and their places in ROOM */
static inline ptrdiff_t
rows_room (ptrdiff_t n, ptrdiff_t m)
{
  return m * m + n * m + 3 * m;
}

static inline void
place_rows (gs_rows *w, int n, int m, int *order, double *room)
{
  w->n = n;
  w->m = m;
  w->order = order;
  w->S = room;
  w->solved = w->S + (ptrdiff_t) m * m;
  w->scale = w->solved + (ptrdiff_t) n * m;
  w->side = w->scale + m;
  w->most = w->side + m;
}

/* A = L L'; 0: A is not positive definite */
static inline int
cholesky (int n, double *a)
{
  for (int j = 0; j < n; j++)
    {
      double scale = a[j + n * j];
      for (int k = 0; k < j; k++)
        for (int i = j; i < n; i++)
          a[i + n * j] -= a[i + n * k] * a[j + n * k];
      if (! (a[j + n * j] > 1e-14 * fabs (scale)))
        return 0;
      double root = sqrt (a[j + n * j]);
      for (int i = j; i < n; i++)
        a[i + n * j] /= root;
    }
  return 1;
}

static inline void
forward (int n, const double *l, double *x)
{
  for (int j = 0; j < n; j++)
    {
      x[j] /= l[j + n * j];
      for (int i = j + 1; i < n; i++)
        x[i] -= l[i + n * j] * x[j];
    }
}

static inline void
backward (int n, const double *l, double *x)
{
  for (int j = n - 1; j >= 0; j--)
    {
      for (int i = j + 1; i < n; i++)
        x[j] -= l[i + n * j] * x[i];
      x[j] /= l[j + n * j];
    }
}

/* S = ROWS M^-1 ROWS' in the order of the rows; MASS: factors of M */
static inline void
gram (gs_rows *w, const double *rows, const double *mass)
{
  int n = w->n, m = w->m;
  for (int k = 0; k < m; k++)
    {
      for (int j = 0; j < n; j++)
        w->solved[j + n * k] = rows[k + m * j];
      forward (n, mass, w->solved + n * k);
    }
  for (int i = 0; i < m; i++)
    for (int k = 0; k < m; k++)
      {
        const double *a = w->solved + n * w->order[i], *b = w->solved + n * w->order[k];
        double sum = 0;
        for (int j = 0; j < n; j++)
          sum += a[j] * b[j];
        w->S[i + m * k] = sum;
      }
}

/* rows and columns A and B change places */
static inline void
exchange (gs_rows *w, int a, int b)
{
  int m = w->m, number = w->order[a];
  double *S = w->S, swap = w->scale[a];
  w->scale[a] = w->scale[b], w->scale[b] = swap;
  w->order[a] = w->order[b], w->order[b] = number;
  for (int j = 0; j < m; j++)
    swap = S[a + m * j], S[a + m * j] = S[b + m * j], S[b + m * j] = swap;
  for (int j = 0; j < m; j++)
    swap = S[j + m * a], S[j + m * a] = S[j + m * b], S[j + m * b] = swap;
}

/* column K of the factors of S, whose pivot is above zero */
static inline void
take_column (gs_rows *w, int k)
{
  int m = w->m;
  double *S = w->S, root = sqrt (S[k + m * k]);
  for (int i = k; i < m; i++)
    S[i + m * k] /= root;
  for (int j = k + 1; j < m; j++)
    for (int i = k + 1; i < m; i++)
      S[i + m * j] -= S[i + m * k] * S[j + m * k];
}

/* SCALE: what the diagonals of S are measured by, the largest so far; a row that has always been
   nothing stays nothing */
static inline void
take_scale_of_rows (gs_rows *w)
{
  double big = 0;
  for (int k = 0; k < w->m; k++)
    {
      w->most[k] = fmax (w->most[k], w->S[k + w->m * k]);
      big = fmax (big, w->most[k]);
    }
  for (int k = 0; k < w->m; k++)
    w->scale[k] = fmax (w->most[k], 1e-12 * big);
}

/* S = L L', its rows in the order of their pivots, as far as they are independent */
static inline void
factorize_rows (gs_rows *w, const double *rows, const double *mass)
{
  int m = w->m;
  double *S = w->S, *scale = w->scale;
  for (int k = 0; k < m; k++)
    w->order[k] = k;
  gram (w, rows, mass);
  take_scale_of_rows (w);
  for (w->rank = 0; w->rank < m; w->rank++)
    {
      int k = w->rank, best = k;
      for (int i = k + 1; i < m; i++)
        if (S[i + m * i] * scale[best] > S[best + m * best] * scale[i])
          best = i;
      if (! (S[best + m * best] > 1e-10 * scale[best]))
        return;
      exchange (w, k, best);
      take_column (w, k);
    }
}

/* ... the rows that are so in LIKE, in its order; 0: they depend on each other */
static inline int
factorize_like (gs_rows *w, const gs_rows *like, const double *rows, const double *mass)
{
  for (int k = 0; k < w->m; k++)
    w->order[k] = like->order[k];
  gram (w, rows, mass);
  for (w->rank = 0; w->rank < like->rank; w->rank++)
    {
      if (! (w->S[w->rank + w->m * w->rank] > 0))
        return 0;
      take_column (w, w->rank);
    }
  return 1;
}

/* what solves S X = X; zero for rows that depend on others */
static inline void
solve_rows (gs_rows *w, double *x)
{
  int m = w->m, r = w->rank;
  double *y = w->side;
  for (int i = 0; i < r; i++)
    {
      y[i] = x[w->order[i]];
      for (int j = 0; j < i; j++)
        y[i] -= w->S[i + m * j] * y[j];
      y[i] /= w->S[i + m * i];
    }
  for (int i = r - 1; i >= 0; i--)
    {
      for (int j = i + 1; j < r; j++)
        y[i] -= w->S[j + m * i] * y[j];
      y[i] /= w->S[i + m * i];
    }
  for (int i = 0; i < m; i++)
    x[i] = 0;
  for (int i = 0; i < r; i++)
    x[w->order[i]] = y[i];
}
#endif

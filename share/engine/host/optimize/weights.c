/* weights.c: weights of integrals over times; the points of differences. */
#include <math.h>
#include <stdlib.h>

#include "host/optimize/optimize_parts.h"

enum { BAND = 2, WIDTH = 3 * BAND + 1 }; /* with room for what pivots fill in */

/* entry (i,j) of a matrix of n rows whose band is kept row by row */
static double *
entry (double *a, int i, int j)
{
  return a + WIDTH * i + (j - i + BAND);
}

/* solves a*x = b in place, a of BAND diagonals on both sides: Gauss with pivots */
static void
solve_band (int n, double *a, double *b)
{
  for (int k = 0; k < n; k++)
    {
      const int last = k + BAND < n ? k + BAND : n - 1;
      const int wide = k + 2 * BAND < n ? k + 2 * BAND : n - 1;
      int p = k;
      for (int i = k + 1; i <= last; i++)
        if (fabs (*entry (a, i, k)) > fabs (*entry (a, p, k)))
          p = i;
      for (int j = k; p != k && j <= wide; j++)
        gs_swap (entry (a, k, j), entry (a, p, j));
      gs_swap (b + k, b + p);
      for (int i = k + 1; i <= last; i++)
        {
          const double factor = *entry (a, i, k) / *entry (a, k, k);
          for (int j = k; factor != 0 && j <= wide; j++)
            *entry (a, i, j) -= factor * *entry (a, k, j);
          b[i] -= factor * b[k];
        }
    }
  for (int k = n - 1; k >= 0; k--)
    {
      for (int j = k + 1; j <= k + 2 * BAND && j < n; j++)
        b[k] -= *entry (a, k, j) * b[j];
      b[k] /= *entry (a, k, k);
    }
}

/* The transpose of the equations for the second derivatives of a spline, that of its first and of
 * its last piece alike: column i has the factors of row i. */
static void
spline_equations (int n, const double *h, double *a)
{
  for (int i = 1; i < n - 1; i++)
    {
      *entry (a, i - 1, i) = h[i - 1];
      *entry (a, i, i) = 2 * (h[i - 1] + h[i]);
      *entry (a, i + 1, i) = h[i];
    }
  *entry (a, 0, 0) = h[1];
  *entry (a, 1, 0) = -h[0] - h[1];
  *entry (a, 2, 0) = h[0];
  *entry (a, n - 3, n - 1) = h[n - 2];
  *entry (a, n - 2, n - 1) = -h[n - 3] - h[n - 2];
  *entry (a, n - 1, n - 1) = h[n - 3];
}

/* w: of straight lines; less what the second derivatives of the spline take */
static int
smooth_weights (int n, const double *h, double *w)
{
  double *room = calloc ((size_t)n * (WIDTH + 2), sizeof *room);
  if (! room)
    return 1;
  double *b = room + (size_t)n * WIDTH, *less = b + n;
  for (int i = 0; i < n; i++)
    b[i] = ((i < n - 1 ? pow (h[i], 3) : 0) + (i > 0 ? pow (h[i - 1], 3) : 0)) / 24;
  spline_equations (n, h, room);
  solve_band (n, room, b);
  for (int i = 1; i < n - 1; i++)
    {
      const double before = 6 / h[i - 1], after = 6 / h[i];
      less[i - 1] += before * b[i];
      less[i] -= (before + after) * b[i];
      less[i + 1] += after * b[i];
    }
  int positive = 1;
  for (int i = 0; i < n; i++)
    positive = positive && w[i] - less[i] > 0;
  for (int i = 0; positive && i < n; i++)
    w[i] -= less[i];
  free (room);
  return 0;
}

static int
weights (int n, const double *t, double late, double *h, double *w)
{
  for (int i = 0; i < n - 1; i++)
    h[i] = t[i + 1] - t[i] + (i == n - 2 ? late : 0);
  for (int i = 0; i < n; i++)
    w[i] = ((i < n - 1 ? h[i] : 0) + (i > 0 ? h[i - 1] : 0)) / 2;
  return n >= 4 && smooth_weights (n, h, w);
}

int
gs_integral_weights (int n, const double *t, double *w, double *slope)
{
  static const double factors[] = { 1, -8, 8, -1 };
  double *room = malloc (2 * ((size_t)n + 1) * sizeof *room);
  int bad = room ? weights (n, t, 0, room, w) : 1;
  for (int i = 0; ! bad && slope && i < n; i++)
    slope[i] = 0;
  for (int k = 0; ! bad && slope && n > 1 && k < 4; k++)
    {
      const double step = 1e-3 * (t[n - 1] - t[n - 2]);
      double *there = room + n;
      bad = weights (n, t, step * (k < 2 ? k - 2 : k - 1), room, there);
      for (int i = 0; ! bad && i < n; i++)
        slope[i] += factors[k] * there[i] / (12 * step);
    }
  free (room);
  return bad;
}

double
gs_scale_of (const gs_free *v)
{
  if (v->start != 0)
    return fabs (v->start);
  return v->high - v->low < INFINITY ? v->high - v->low : 1;
}

int
gs_difference_points (const gs_free *v, double at, double *points, double *factors)
{
  static const double middle[] = { -1, 8, -8, 1 }, one_sided[] = { -25, 48, -36, 16, -3 };
  double h = 1e-3 * gs_scale_of (v);
  const double up = (v->high - at) / 2, down = (at - v->low) / 2;
  const int inside = fmin (up, down) >= h / 100;
  h = inside ? fmin (h, fmin (up, down)) : fmin (h, fmax (up, down) / 2) * (up > down ? 1 : -1);
  for (int k = 0; k < (inside ? 4 : 5); k++)
    {
      points[k] = at + h * (! inside ? k : k < 2 ? 2 - k : 1 - k);
      points[k] = gs_within (points[k], v->low, v->high);
      factors[k] = (inside ? middle : one_sided)[k] / (12 * h);
    }
  return inside ? 4 : 5;
}

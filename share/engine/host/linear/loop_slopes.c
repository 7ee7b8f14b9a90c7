/* loop_slopes.c: the derivatives of ILP solved for what follows from the planned motion. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/linear/loop_slopes.h"

/* m equations a (m,m) for n right-hand sides b (m,n), by columns, the number of the unknown */
typedef struct
{
  int m, n;
  double *a, *b;
  int *unknown;
} equations;

/* rows, then columns beside their largest numbers; wide: of the columns. 0: one is zero */
static int
scale (const equations *s, double *wide)
{
  const int m = s->m;
  for (int i = 0; i < m; i++)
    {
      double size = 0;
      for (int j = 0; j < m; j++)
        size = fmax (size, fabs (s->a[i + m * j]));
      if (! (size > 0))
        return 0;
      for (int j = 0; j < m; j++)
        s->a[i + m * j] /= size;
      for (int k = 0; k < s->n; k++)
        s->b[i + m * k] /= size;
    }
  for (int j = 0; j < m; j++)
    {
      wide[j] = 0;
      for (int i = 0; i < m; i++)
        wide[j] = fmax (wide[j], fabs (s->a[i + m * j]));
      if (! (wide[j] > 0))
        return 0;
      for (int i = 0; i < m; i++)
        s->a[i + m * j] /= wide[j];
    }
  return 1;
}

static void
swap_rows (double *a, int m, int n, int i, int k)
{
  for (int j = 0; i != k && j < n; j++)
    {
      const double kept = a[i + m * j];
      a[i + m * j] = a[k + m * j];
      a[k + m * j] = kept;
    }
}

/* b becomes the solution, by Gauss with pivots; 0: the equations depend on each other */
static int
eliminate (const equations *s)
{
  const int m = s->m;
  double *a = s->a, *b = s->b, least = INFINITY, most = 0;
  for (int k = 0; k < m; k++)
    {
      int p = k;
      for (int i = k + 1; i < m; i++)
        p = fabs (a[i + m * k]) > fabs (a[p + m * k]) ? i : p;
      least = fmin (least, fabs (a[p + m * k]));
      most = fmax (most, fabs (a[p + m * k]));
      if (! (least > 1e-13 * most))
        return 0;
      swap_rows (a, m, m, p, k);
      swap_rows (b, m, s->n, p, k);
      for (int i = k + 1; i < m; i++)
        {
          const double factor = a[i + m * k] / a[k + m * k];
          for (int j = k; j < m; j++)
            a[i + m * j] -= factor * a[k + m * j];
          for (int j = 0; j < s->n; j++)
            b[i + m * j] -= factor * b[k + m * j];
        }
    }
  for (int k = m - 1; k >= 0; k--)
    for (int j = 0; j < s->n; j++)
      {
        for (int i = k + 1; i < m; i++)
          b[k + m * j] -= a[k + m * i] * b[i + m * j];
        b[k + m * j] /= a[k + m * k];
      }
  return 1;
}

/* the equations for what is not planned: 0, there are too few or too many */
static int
set_up (equations *s, int nu, int npar, const double *d, int np, const int *planned,
        const double *q, const double *p)
{
  const int m = s->m;
  int at = 0;
  for (int j = 0; j < 4 * nu; j++)
    {
      int known = -1;
      for (int i = 0; i < np && j < 3 * nu; i++)
        known = planned[i] == j % nu ? i : known;
      if (known < 0 && at < m)
        {
          memcpy (s->a + m * at, d + m * j, (size_t)m * sizeof *d);
          s->unknown[at] = j;
        }
      at += known < 0;
      for (int k = 0; known >= 0 && k < s->n; k++)
        for (int i = 0; i < m; i++)
          s->b[i + m * k] -= d[i + m * j] * q[known + np * (j / nu + 3 * k)];
    }
  for (int k = 0; k < s->n; k++)
    for (int j = 0; j < npar; j++)
      for (int i = 0; i < m; i++)
        s->b[i + m * k] -= d[i + m * (4 * nu + j)] * p[j + npar * k];
  return at == m;
}

int
gs_loop_slopes (int nu, int npar, int rows, const double *d, int nplanned, const int *planned,
                int n, const double *q, const double *p, double *x, double *e)
{
  const size_t m = (size_t)rows;
  double *room = calloc (m * m + m * (size_t)n + m + 1, sizeof *room);
  int *unknown = calloc (m + 1, sizeof *unknown);
  equations s = { rows, n, room, room ? room + m * m : NULL, unknown };
  int bad = room && unknown ? 0 : 1;
  if (! bad)
    {
      double *wide = s.b + m * (size_t)n;
      bad = set_up (&s, nu, npar, d, nplanned, planned, q, p) && scale (&s, wide) && eliminate (&s)
                ? 0 : 2;
      for (int k = 0; ! bad && k < n; k++)
        {
          for (int i = 0; i < nplanned; i++)
            for (int j = 0; j < 3; j++)
              x[planned[i] + nu * (j + 3 * k)] = q[i + nplanned * (j + 3 * k)];
          for (int i = 0; i < rows; i++)
            *(unknown[i] < 3 * nu ? x + unknown[i] + 3 * nu * k
                                  : e + (unknown[i] - 3 * nu) + nu * k)
                = s.b[i + rows * k] / wide[i];
        }
    }
  free (room);
  free (unknown);
  return bad;
}

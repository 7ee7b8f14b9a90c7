/* reach.c: axes of poses; which solution of inverse kinematics is taken; what is free at a singular
 * one. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"
#include "host/reach/reach.h"

static const double whole_turn = 6.283185307179586477;
static const double rounding = 1e-12;   /* of a limit that is reached */

/* of a matrix (3,3) its cofactors: the determinant times the transpose of the inverse */
static double
cofactors (const double *a, double *c)
{
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      {
        const int k = (i + 1) % 3, l = (i + 2) % 3, m = 3 * ((j + 1) % 3), n = 3 * ((j + 2) % 3);
        c[i + 3 * j] = a[k + m] * a[l + n] - a[k + n] * a[l + m];
      }
  return a[0] * c[0] + a[1] * c[1] + a[2] * c[2];
}

/* the largest entry of R'R - 1 */
static double
off (const double *a)
{
  double most = 0;
  for (int i = 0; i < 9; i++)
    {
      const double *x = a + 3 * (i % 3), *y = a + 3 * (i / 3);
      most = fmax (most, fabs (x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - (i % 4 == 0)));
    }
  return most;
}

static int
closest_rotation (const double *given, int k, double *axes, char *why, int size)
{
  double c[9];
  for (int i = 0; i < 9; i++)
    axes[i] = given[i];
  const double miss = off (axes), det = cofactors (axes, c);
  if (! (miss <= 1e-6) || det < 0)
    {
      snprintf (why, (size_t)size, "axes of pose %d: expected a rotation matrix, found R'R - 1 up "
                "to %g, det %g", k, miss, det);
      return 0;
    }
  for (int turn = 0; turn < 3; turn++)   /* Newton's method for the polar decomposition */
    {
      const double size_of = cofactors (axes, c);
      for (int i = 0; i < 9; i++)
        axes[i] = 0.5 * (axes[i] + c[i] / size_of);
    }
  return 1;
}

int
gs_reach_axes (int n, const double *given, int k, double *axes, char *why, int size)
{
  if (n == 9)
    return closest_rotation (given, k, axes, why, size);
  const double *e = given;
  const double length = sqrt (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
  if (! (length >= 1e-6))
    {
      snprintf (why, (size_t)size, "axes: Euler parameters of pose %d are zero", k);
      return 0;
    }
  const double s = e[0] / length, x = e[1] / length, y = e[2] / length, z = e[3] / length;
  const double all[] = { 1 - 2 * (y * y + z * z), 2 * (x * y + s * z), 2 * (x * z - s * y),
                         2 * (x * y - s * z), 1 - 2 * (x * x + z * z), 2 * (y * z + s * x),
                         2 * (x * z + s * y), 2 * (y * z - s * x), 1 - 2 * (x * x + y * y) };
  for (int i = 0; i < 9; i++)
    axes[i] = all[i];
  return 1;
}

/* an angle by whole turns as close to that before as the limits allow; on a limit that is passed by
 * rounding alone */
static double
turned (const gs_reach_choice *c, int k, double q)
{
  const double low = c->limits[k], high = c->limits[c->nq + k];
  if (c->turns[k])
    {
      q -= whole_turn * round ((q - c->before[k]) / whole_turn);
      q += whole_turn * ceil (fmax (low - q - rounding, 0) / whole_turn);
      q -= whole_turn * ceil (fmax (q - high - rounding, 0) / whole_turn);
    }
  return q < low && q >= low - rounding ? low : q > high && q <= high + rounding ? high : q;
}

int
gs_reach_choose (const gs_reach_choice *c, int n, double *q, const int *branches, int branch)
{
  int chosen = -1;
  double least = HUGE_VAL;
  for (int i = 0; i < n; i++)
    {
      int within = branch == 0 || branches[i] == branch;
      double sum = 0;
      for (int k = 0; k < c->nq; k++)
        {
          double *one = q + k + (size_t)c->nq * (size_t)i;
          *one = turned (c, k, *one);
          within &= *one >= c->limits[k] && *one <= c->limits[c->nq + k];
          sum += (*one - c->before[k]) * (*one - c->before[k]);
        }
      if (within && (chosen < 0 || sum < least))
        {
          chosen = i;
          least = sum;
        }
    }
  return chosen;
}

int
gs_reach_free (int m, int n, const double *jacobian, int singular, double *speed)
{
  const int many = gs_least (m, n);
  gs_real *b = calloc ((size_t)(m * n + n * n + n + 1), sizeof *b);
  int rank, found = 0;
  if (! b)
    return -1;
  gs_real *v = b + m * n, *s = v + n * n;
  for (int i = 0; i < m * n; i++)
    b[i] = (gs_real)jacobian[i];
  gs_singular_values (m, n, b, m, v, n, s, 0, &rank);
  if (many > 0)
    found = (m >= n && s[many - 1] < GS_R (3e-8) * s[0]) || singular;
  for (int i = 0; i < n; i++)
    speed[i] = found ? (double)v[i + n * (many - 1)] : 0;
  free (b);
  return found;
}

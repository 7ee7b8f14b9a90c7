/* reach.c: which solution of inverse kinematics is taken; what is free at a singular one. */
#include <stdlib.h>

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"
#include "host/reach/reach.h"

static const double whole_turn = 6.283185307179586477;
static const double rounding = 1e-12;   /* of a limit that is reached */

/* an angle by whole turns as close to that before as the limits allow */
static double
turned (const gs_reach_choice *c, int k, double q)
{
  const double low = c->limits[k], high = c->limits[c->nq + k];
  q -= whole_turn * round ((q - c->before[k]) / whole_turn);
  q += whole_turn * ceil (fmax (low - q - rounding, 0) / whole_turn);
  return q - whole_turn * ceil (fmax (q - high - rounding, 0) / whole_turn);
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
          if (c->turns[k])
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

/* pole_slopes.c: how eigenvalues change with their matrix. */
#include <complex.h>
#include <math.h>

#include "host/linear/linear.h"

static double complex
number (const double *z)
{
  return z[0] + z[1] * I;
}

/* w' a v; a null: w' v */
static double complex
product (int n, const double *w, const double *a, const double *v)
{
  double complex sum = 0;
  for (int j = 0; j < n; j++)
    {
      double complex left = a ? 0 : conj (number (w + 2 * j));
      for (int i = 0; i < n && a; i++)
        left += conj (number (w + 2 * i)) * a[i + n * j];
      sum += left * number (v + 2 * j);
    }
  return sum;
}

/* is another eigenvalue at the same place, or does it not move smoothly? */
static int
is_multiple (int n, const double *e, int k, const double *v, const double *w)
{
  double most = 0, nearest = INFINITY;
  for (int i = 0; i < n; i++)
    {
      most = fmax (most, cabs (number (e + 2 * i)));
      if (i != k)
        nearest = fmin (nearest, cabs (number (e + 2 * i) - number (e + 2 * k)));
    }
  const double sizes = sqrt (creal (product (n, v, NULL, v)) * creal (product (n, w, NULL, w)));
  return nearest <= 1e-9 * most || ! (cabs (product (n, w, NULL, v)) >= 1e-6 * sizes);
}

void
gs_slopes_of_poles (int n, const double *e, const double *v, const double *w, const double *da,
                    gs_pole_slopes *found)
{
  for (int k = 0; k < n; k++)
    {
      const double *vk = v + (ptrdiff_t)2 * n * k, *wk = w + (ptrdiff_t)2 * n * k;
      const double complex pole = number (e + 2 * k);
      const double complex slope = is_multiple (n, e, k, vk, wk)
                                       ? NAN + NAN * I
                                       : product (n, wk, da, vk) / product (n, wk, NULL, vk);
      const double size = cabs (pole);
      found->poles[2 * k] = creal (slope);
      found->poles[2 * k + 1] = cimag (slope);
      found->frequency[k] = creal (conj (pole) * slope) / size;
      found->damping[k] = -(creal (slope) - creal (pole) / size * found->frequency[k]) / size;
    }
}

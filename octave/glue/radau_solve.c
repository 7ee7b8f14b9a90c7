#include <math.h>
#include <stddef.h>
#include "radau_solve.h"

/* Both kinds of number by one text: columns are eliminated by those to their left as a whole. */
#define FACTORS(NAME, NUMBER, SIZE)                                                                \
  int NAME (int n, NUMBER shift, const double *J, NUMBER *lu, int *pivot)                          \
  {                                                                                                \
    for (ptrdiff_t k = 0; k < (ptrdiff_t) n * n; k++)                                              \
      lu[k] = -J[k];                                                                               \
    for (ptrdiff_t k = 0; k < n; k++)                                                              \
      lu[k + n * k] += shift;                                                                      \
    for (int k = 0; k < n; k++)                                                                    \
      {                                                                                            \
        NUMBER *a = lu + (ptrdiff_t) n * k;                                                        \
        int p = k;                                                                                 \
        for (int i = k + 1; i < n; i++)                                                            \
          if (SIZE (a[i]) > SIZE (a[p]))                                                           \
            p = i;                                                                                 \
        pivot[k] = p;                                                                              \
        if (! (SIZE (a[p]) > 0))                                                                   \
          return 1;                                                                                \
        for (int j = 0; p != k && j < n; j++)                                                      \
          {                                                                                        \
            NUMBER *row = lu + (ptrdiff_t) n * j, swap = row[k];                                   \
            row[k] = row[p], row[p] = swap;                                                        \
          }                                                                                        \
        NUMBER over = 1 / a[k];                                                                    \
        for (int i = k + 1; i < n; i++)                                                            \
          a[i] *= over;                                                                            \
        for (int j = k + 1; j < n; j++)                                                            \
          {                                                                                        \
            NUMBER *b = lu + (ptrdiff_t) n * j, factor = b[k];                                     \
            if (factor != 0)                                                                       \
              for (int i = k + 1; i < n; i++)                                                      \
                b[i] -= factor * a[i];                                                             \
          }                                                                                        \
      }                                                                                            \
    return 0;                                                                                      \
  }

#define SOLVE(NAME, NUMBER)                                                                        \
  void NAME (int n, const NUMBER *lu, const int *pivot, NUMBER *x)                                 \
  {                                                                                                \
    for (int k = 0; k < n; k++)                                                                    \
      {                                                                                            \
        NUMBER swap = x[pivot[k]];                                                                 \
        x[pivot[k]] = x[k], x[k] = swap;                                                           \
      }                                                                                            \
    for (int k = 0; k < n; k++)                                                                    \
      for (int i = k + 1; i < n; i++)                                                              \
        x[i] -= x[k] * lu[i + (ptrdiff_t) n * k];                                                  \
    for (int k = n - 1; k >= 0; k--)                                                               \
      {                                                                                            \
        x[k] /= lu[k + (ptrdiff_t) n * k];                                                         \
        for (int i = 0; i < k; i++)                                                                \
          x[i] -= x[k] * lu[i + (ptrdiff_t) n * k];                                                \
      }                                                                                            \
  }

/* as large, for the choice of pivots */
#define TAXI(z) (fabs (creal (z)) + fabs (cimag (z)))

FACTORS (gsmbp_real_factors, double, fabs)
SOLVE (gsmbp_real_solve, double)
FACTORS (gsmbp_complex_factors, double complex, TAXI)
SOLVE (gsmbp_complex_solve, double complex)

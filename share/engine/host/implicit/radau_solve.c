#include <math.h>
#include <stddef.h>
#include "radau_solve.h"

/* Both kinds of number by one text: columns are eliminated by those to their left as a whole. */
#define DENSE(NAME, NUMBER, SIZE)                                                                  \
  static int NAME (int n, int ld, NUMBER *lu, int *pivot)                                          \
  {                                                                                                \
    for (int k = 0; k < n; k++)                                                                    \
      {                                                                                            \
        NUMBER *a = lu + (ptrdiff_t) ld * k;                                                       \
        int p = k;                                                                                 \
        for (int i = k + 1; i < n; i++)                                                            \
          if (SIZE (a[i]) > SIZE (a[p]))                                                           \
            p = i;                                                                                 \
        pivot[k] = p;                                                                              \
        if (! (SIZE (a[p]) > 0))                                                                   \
          return SINGULAR;                                                                         \
        for (int j = 0; p != k && j < n; j++)                                                      \
          {                                                                                        \
            NUMBER *row = lu + (ptrdiff_t) ld * j, swap = row[k];                                  \
            row[k] = row[p], row[p] = swap;                                                        \
          }                                                                                        \
        NUMBER over = 1 / a[k];                                                                    \
        for (int i = k + 1; i < n; i++)                                                            \
          a[i] *= over;                                                                            \
        for (int j = k + 1; j < n; j++)                                                            \
          {                                                                                        \
            NUMBER *b = lu + (ptrdiff_t) ld * j, factor = b[k];                                    \
            if (factor != 0)                                                                       \
              for (int i = k + 1; i < n; i++)                                                      \
                b[i] -= factor * a[i];                                                             \
          }                                                                                        \
      }                                                                                            \
    return 0;                                                                                      \
  }

#define DENSE_SOLVE(NAME, NUMBER)                                                                  \
  static void NAME (int n, int ld, const NUMBER *lu, const int *pivot, NUMBER *y)                  \
  {                                                                                                \
    for (int k = 0; k < n; k++)                                                                    \
      {                                                                                            \
        NUMBER swap = y[pivot[k]];                                                                 \
        y[pivot[k]] = y[k], y[k] = swap;                                                           \
      }                                                                                            \
    for (int k = 0; k < n; k++)                                                                    \
      for (int i = k + 1; i < n; i++)                                                              \
        y[i] -= y[k] * lu[i + (ptrdiff_t) ld * k];                                                 \
    for (int k = n - 1; k >= 0; k--)                                                               \
      {                                                                                            \
        y[k] /= lu[k + (ptrdiff_t) ld * k];                                                        \
        for (int i = 0; i < k; i++)                                                                \
          y[i] -= y[k] * lu[i + (ptrdiff_t) ld * k];                                               \
      }                                                                                            \
  }

/* the pivots along the lists; their inverses stay on the diagonal */
#define LISTS(NAME, NUMBER, SIZE)                                                                  \
  static int NAME (const radau_order *o, const double *J, NUMBER shift, NUMBER *lu)                \
  {                                                                                                \
    ptrdiff_t n = o->n;                                                                            \
    for (ptrdiff_t k = 0; k < o->sparse; k++)                                                      \
      {                                                                                            \
        NUMBER *a = lu + n * k;                                                                    \
        if (! (SIZE (a[k]) > 1e-6 * (SIZE (shift) + fabs (J[k + n * k]))))                         \
          return SMALL_PIVOT;                                                                      \
        a[k] = 1 / a[k];                                                                           \
        for (int i = o->row_from[k]; i < o->row_from[k + 1]; i++)                                  \
          a[o->rows[i]] *= a[k];                                                                   \
        for (int j = o->column_from[k]; j < o->column_from[k + 1]; j++)                            \
          {                                                                                        \
            NUMBER *b = lu + n * o->columns[j], factor = b[k];                                     \
            for (int i = o->row_from[k]; i < o->row_from[k + 1]; i++)                              \
              b[o->rows[i]] -= factor * a[o->rows[i]];                                             \
          }                                                                                        \
      }                                                                                            \
    return 0;                                                                                      \
  }

#define FACTORS(NAME, NUMBER, ALONG_LISTS, OF_DENSE)                                               \
  int NAME (radau_order *o, NUMBER shift, const double *J, NUMBER *lu, int *pivot)                 \
  {                                                                                                \
    ptrdiff_t n = o->n, m = o->sparse;                                                             \
    for (ptrdiff_t k = 0; k < n * n; k++)                                                          \
      lu[k] = -J[k];                                                                               \
    for (ptrdiff_t k = 0; k < n; k++)                                                              \
      lu[k + n * k] += shift;                                                                      \
    int info = ALONG_LISTS (o, J, shift, lu);                                                      \
    if (info == SMALL_PIVOT)                                                                       \
      o->plain = 1;                                                                                \
    if (info != 0)                                                                                 \
      return info;                                                                                 \
    return OF_DENSE (o->n - o->sparse, o->n, lu + m + n * m, pivot);                               \
  }

#define SOLVE(NAME, NUMBER, OF_DENSE)                                                              \
  void NAME (const radau_order *o, const NUMBER *lu, const int *pivot, NUMBER *x, NUMBER *work)    \
  {                                                                                                \
    ptrdiff_t n = o->n, m = o->sparse;                                                             \
    for (ptrdiff_t k = 0; k < n; k++)                                                              \
      work[k] = x[o->order[k]];                                                                    \
    for (ptrdiff_t k = 0; k < m; k++)                                                              \
      for (int i = o->row_from[k]; i < o->row_from[k + 1]; i++)                                    \
        work[o->rows[i]] -= lu[o->rows[i] + n * k] * work[k];                                      \
    OF_DENSE (o->n - o->sparse, o->n, lu + m + n * m, pivot, work + m);                            \
    for (ptrdiff_t k = m - 1; k >= 0; k--)                                                         \
      {                                                                                            \
        for (int j = o->column_from[k]; j < o->column_from[k + 1]; j++)                            \
          work[k] -= lu[k + n * o->columns[j]] * work[o->columns[j]];                              \
        work[k] *= lu[k + n * k];                                                                  \
      }                                                                                            \
    for (ptrdiff_t k = 0; k < n; k++)                                                              \
      x[o->order[k]] = work[k];                                                                    \
  }

/* as large, for the choice of pivots */
#define TAXI(z) (fabs (creal (z)) + fabs (cimag (z)))

DENSE (real_dense, double, fabs)
DENSE (complex_dense, double complex, TAXI)
DENSE_SOLVE (real_dense_solve, double)
DENSE_SOLVE (complex_dense_solve, double complex)
LISTS (real_lists, double, fabs)
LISTS (complex_lists, double complex, TAXI)
FACTORS (gsmbp_real_factors, double, real_lists, real_dense)
FACTORS (gsmbp_complex_factors, double complex, complex_lists, complex_dense)
SOLVE (gsmbp_real_solve, double, real_dense_solve)
SOLVE (gsmbp_complex_solve, double complex, complex_dense_solve)

int
gsmbp_dense_factors (int n, double *a, int *pivot)
{
  return real_dense (n, n, a, pivot);
}

void
gsmbp_dense_solve (int n, const double *lu, const int *pivot, double *x)
{
  real_dense_solve (n, n, lu, pivot, x);
}

/* gsmbp/arith.h: what the sources of this folder share: MAX and MIN as Fortran has them, loops over
 * columns. No part of the interface. */
#ifndef GSMBP_ARITH_H
#define GSMBP_ARITH_H

static inline double
gs_max (double a, double b)
{
  return a > b ? a : b;
}

static inline double
gs_min (double a, double b)
{
  return a < b ? a : b;
}

static inline int
gs_most (int a, int b)
{
  return a > b ? a : b;
}

static inline int
gs_least (int a, int b)
{
  return a < b ? a : b;
}

/* s + x'*y, summed from the first entry on */
static inline double
gs_dot (int n, double s, const double *x, const double *y)
{
  for (int i = 0; i < n; i++)
    s += x[i] * y[i];
  return s;
}

/* y := y - s*x; the two do not overlap */
static inline void
gs_take (int n, double s, const double *restrict x, double *restrict y)
{
  for (int i = 0; i < n; i++)
    y[i] -= s * x[i];
}

/* x and y change places */
static inline void
gs_swap (int n, double *x, double *y)
{
  for (int i = 0; i < n; i++)
    {
      double s = x[i];
      x[i] = y[i];
      y[i] = s;
    }
}

#endif

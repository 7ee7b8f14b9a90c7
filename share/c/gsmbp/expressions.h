/* gsmbp/expressions.h: functions of emitted expressions: MAX and MIN as Fortran has them, whole
 * powers by the products that gfortran takes. No part of the interface. */
#ifndef GSMBP_EXPRESSIONS_H
#define GSMBP_EXPRESSIONS_H

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

static inline double
gs_power2 (double x)
{
  return x * x;
}

#endif

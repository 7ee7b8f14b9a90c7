/* gsmbp/expressions.h: functions of emitted expressions: MAX and MIN as Fortran has them, whole
 * powers by the products that gfortran takes; what stands ahead of a loop over states. No part of
 * the interface. */
#ifndef GSMBP_EXPRESSIONS_H
#define GSMBP_EXPRESSIONS_H

#include "gsmbp/real.h"

/* no turn of the loop behind it needs another */
#if defined(__GNUC__) && ! defined(__clang__)
#define GS_EACH_STATE _Pragma ("GCC ivdep")
#else
#define GS_EACH_STATE
#endif

static inline gs_real
gs_max (gs_real a, gs_real b)
{
  return a > b ? a : b;
}

static inline gs_real
gs_min (gs_real a, gs_real b)
{
  return a < b ? a : b;
}

static inline gs_real
gs_square (gs_real x)
{
  return x * x;
}

/* x to the power n >= 1: the product of the powers n - k and k, k from the table of addition chains
 * that gcc has (tree-ssa-math-opts.c) */
static inline gs_real
gs_power (gs_real x, int n)
{
  static const signed char part[33]
      = { 0,  1,  1,  2,  2,  3,  3,  4,  4,  6,  5,  6,  6,  10, 7,  9, 8,
          16, 16, 16, 10, 12, 11, 13, 12, 17, 13, 18, 14, 24, 15, 26, 16 };
  gs_real power[33] = { 1, x }, rest = 1;
  for (; n > 32; n /= 2)
    {
      if (n % 2 == 1)
        rest *= x;
      x *= x;
    }
  power[1] = x;
  for (int k = 2; k <= n; k++)
    power[k] = power[k - part[k]] * power[part[k]];
  return power[n] * rest;
}

#endif

/* gsmbp/real.h: gs_real, the type of all numbers that are not integers: double, or
 *
 *   float       where GSMBP_FLOAT is defined, for processors without arithmetic in double precision
 *   __float128  where GSMBP_QUAD is defined: gcc with libquadmath (link with -lquadmath); long
 *               double where that is IEEE quadruple (ARM64)
 *
 * All files of a program are compiled with the same choice. Literals that are not small integers
 * are written GS_R (0.1), functions of the mathematical library gs_sin (x): both are of this type.
 */
#ifndef GSMBP_REAL_H
#define GSMBP_REAL_H

#include <float.h>
#include <math.h>

/* GS_R (a): a literal; GS_LIBRARY (name): a function of the mathematical library; GS_EPSILON: the
 * distance from 1 to the next number; GS_DIGITS: binary digits of a number */
#if defined(GSMBP_FLOAT) && defined(GSMBP_QUAD)
#error "expected one of GSMBP_FLOAT and GSMBP_QUAD; found both: define one or none"
#elif defined(GSMBP_FLOAT)
typedef float gs_real;
#define GS_R(a) a##F
#define GS_LIBRARY(name) name##f
#define GS_EPSILON FLT_EPSILON
#define GS_DIGITS FLT_MANT_DIG
#elif defined(GSMBP_QUAD) && LDBL_MANT_DIG == 113
typedef long double gs_real;
#define GS_R(a) a##L
#define GS_LIBRARY(name) name##l
#define GS_EPSILON LDBL_EPSILON
#define GS_DIGITS LDBL_MANT_DIG
#elif defined(GSMBP_QUAD) && ! defined(__SIZEOF_FLOAT128__)
#error "this compiler has no quadruple precision: build in double precision"
#elif defined(GSMBP_QUAD)
#include <quadmath.h>
typedef __float128 gs_real;
#define GS_R(a) a##Q
#define GS_LIBRARY(name) name##q
#define GS_EPSILON FLT128_EPSILON
#define GS_DIGITS FLT128_MANT_DIG
#else
typedef double gs_real;
#define GS_R(a) a
#define GS_LIBRARY(name) name
#define GS_EPSILON DBL_EPSILON
#define GS_DIGITS DBL_MANT_DIG
#endif

/* C that was emitted for double stops here, also where compilers only warn of it */
#if (defined(GSMBP_FLOAT) || defined(GSMBP_QUAD)) && defined(__GNUC__) && ! defined(__cplusplus)
#pragma GCC diagnostic error "-Wincompatible-pointer-types"
#endif

/* GS_R2 (a, b): a, or b in single precision; on some processors that is what double is (AVR) */
#if GS_DIGITS < 53
#define GS_R2(a, b) GS_R (b)
#else
#define GS_R2(a, b) GS_R (a)
#endif

/* beyond all numbers of a scene, and below all but 0; the reciprocals of both are finite */
#define GS_HUGE GS_R2 (1e300, 1e37)
#define GS_TINY GS_R2 (1e-300, 1e-37)
#define GS_INFINITY ((gs_real)INFINITY)

#define gs_abs(x) GS_LIBRARY (fabs) (x)
#define gs_acos(x) GS_LIBRARY (acos) (x)
#define gs_asin(x) GS_LIBRARY (asin) (x)
#define gs_atan(x) GS_LIBRARY (atan) (x)
#define gs_atan2(y, x) GS_LIBRARY (atan2) (y, x)
#define gs_ceil(x) GS_LIBRARY (ceil) (x)
#define gs_copysign(x, y) GS_LIBRARY (copysign) (x, y)
#define gs_cos(x) GS_LIBRARY (cos) (x)
#define gs_cosh(x) GS_LIBRARY (cosh) (x)
#define gs_exp(x) GS_LIBRARY (exp) (x)
#define gs_floor(x) GS_LIBRARY (floor) (x)
#define gs_fmax(x, y) GS_LIBRARY (fmax) (x, y)
#define gs_fmin(x, y) GS_LIBRARY (fmin) (x, y)
#define gs_fmod(x, y) GS_LIBRARY (fmod) (x, y)
#define gs_ldexp(x, n) GS_LIBRARY (ldexp) (x, n)
#define gs_log(x) GS_LIBRARY (log) (x)
#define gs_lround(x) GS_LIBRARY (lround) (x)
#define gs_pow(x, y) GS_LIBRARY (pow) (x, y)
#define gs_round(x) GS_LIBRARY (round) (x)
#define gs_sin(x) GS_LIBRARY (sin) (x)
#define gs_sinh(x) GS_LIBRARY (sinh) (x)
#define gs_sqrt(x) GS_LIBRARY (sqrt) (x)
#define gs_tan(x) GS_LIBRARY (tan) (x)
#define gs_tanh(x) GS_LIBRARY (tanh) (x)
#define gs_trunc(x) GS_LIBRARY (trunc) (x)

#endif

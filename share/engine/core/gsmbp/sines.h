/* gsmbp/sines.h: gs_sine_cosine for compilers to put in line. */
#ifndef GSMBP_SINES_H
#define GSMBP_SINES_H

#include "gsmbp/functions.h"
#include "gsmbp/real.h"

/* Sine s and cosine c of the angle x [rad].
 *
 * x = f*pi/2 + y + e, polynomials in y, and the quadrant says which of sine, cosine and their
 * opposites are asked for; without branches, that a processor would have to foresee. The error is
 * below one unit in the last place. Beyond |x| = 1e5, where x is NaN, and in a precision other than
 * double, gs_sine_cosine_far computes both by the library.
 *
 * FDLIBM 5.3 (Sun Microsystems, 1993): e_rem_pio2.c, k_sin.c, k_cos.c: the parts of pi/2 and the
 * polynomials. */
static inline void
gs_sines (gs_real x, gs_real *s, gs_real *c)
{
#if GS_DIGITS != 53
  gs_sine_cosine_far (x, s, c);
#else
  const double round = 6755399441055744.0, twopi = 0.636619772367581382433;
  const double p1 = 1.5707963267341256, p2 = 6.077100506303966e-11, p3 = 2.0222662487959506e-21;
  const double s1 = -1.66666666666666324348e-01, s2 = 8.33333333332248946124e-03,
               s3 = -1.98412698298579493134e-04, s4 = 2.75573137070700676789e-06,
               s5 = -2.50507602534068634195e-08, s6 = 1.58969099521155010221e-10;
  const double c1 = 4.16666666666666019037e-02, c2 = -1.38888888888741095749e-03,
               c3 = 2.48015872894767294178e-05, c4 = -2.75573143513906633035e-07,
               c5 = 2.08757232129817482790e-09, c6 = -1.13596475577881948265e-11;
  if (! (fabs (x) <= 1e5))
    {
      gs_sine_cosine_far (x, s, c);
      return;
    }
  double f = (x * twopi + round) - round;
  int k = (int)f & 3;
  double r = x - f * p1, w = f * p2, y = r - w;
  double e = ((r - y) - w) - f * p3, z = y * y;
  w = 0.5 * z;
  r = 1.0 - w;
  double out[5];
  out[0] = y + (e + z * (y * (s1 + z * (s2 + z * (s3 + z * (s4 + z * (s5 + z * s6))))) - 0.5 * e));
  out[1] = r + (((1.0 - r) - w)
                + (z * z * (c1 + z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * c6))))) - y * e));
  out[2] = -out[0];
  out[3] = -out[1];
  out[4] = out[0];
  *s = out[k];
  *c = out[k + 1];
#endif
}

#endif

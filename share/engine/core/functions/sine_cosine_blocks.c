#include "gsmbp/functions.h"
#include "gsmbp/real.h"

#if GS_DIGITS == 53

/* 6755399441055744 is 1.5*2^52: a number added and taken off again is rounded to a whole one */
#define ROUND 6755399441055744.0

/* One block in a form that vectorizes; out gathers the squares of the quadrants' numbers.
 *
 * x = f*pi/2 + y + e, |y| <= pi/4: pi/2 is taken off in three parts, the first two of 33 bits, so
 * that f*p1 and f*p2 are exact; e is what rounding left of y. Then polynomials in y, and the
 * quadrant f - 4*nint(f/4) says which is which, with which sign.
 *
 * FDLIBM 5.3 (Sun Microsystems, 1993): e_rem_pio2.c, k_sin.c, k_cos.c: the parts of pi/2 and the
 * polynomials. */
static void
block (const double *restrict x, double *restrict s, double *restrict c, double *restrict out)
{
  const double twopi = 0.636619772367581382433;
  const double p1 = 1.5707963267341256, p2 = 6.077100506303966e-11, p3 = 2.0222662487959506e-21;
  const double s1 = -1.66666666666666324348e-01, s2 = 8.33333333332248946124e-03,
               s3 = -1.98412698298579493134e-04, s4 = 2.75573137070700676789e-06,
               s5 = -2.50507602534068634195e-08, s6 = 1.58969099521155010221e-10;
  const double c1 = 4.16666666666666019037e-02, c2 = -1.38888888888741095749e-03,
               c3 = 2.48015872894767294178e-05, c4 = -2.75573143513906633035e-07,
               c5 = 2.08757232129817482790e-09, c6 = -1.13596475577881948265e-11;
  for (int i = 0; i < 8; i++)
    {
      double f = (x[i] * twopi + ROUND) - ROUND;
      out[i] += f * f;
      double r = x[i] - f * p1, w = f * p2, y = r - w;
      double e = ((r - y) - w) - f * p3, z = y * y;
      w = 0.5 * z;
      r = 1.0 - w;
      double sy = s2 + z * (s3 + z * (s4 + z * (s5 + z * s6)));
      sy = y + (e + z * (y * (s1 + z * sy) - 0.5 * e));
      double cy = c1 + z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * c6))));
      cy = r + (((1.0 - r) - w) + (z * z * cy - y * e));
      double d = f - 4.0 * ((0.25 * f + ROUND) - ROUND);
      w = d * d;
      int odd = w > 0.5 && w < 2.0;
      double sine = odd ? cy : sy, cosine = odd ? sy : cy;
      s[i] = w - d > 1.0 ? -sine : sine;
      c[i] = w + d > 1.0 ? -cosine : cosine;
    }
}

#endif

/* In double precision the error is below one unit in the last place up to |x| = 1e5. Larger ones
 * and NaN, which a sum of f^2 over a row of x shows (it is above 4e9), are left to the library, as
 * all are in another precision. */
void
gs_sine_cosine_blocks (int n, const gs_real *x, gs_real *s, gs_real *c)
{
#if GS_DIGITS != 53
  for (int k = 0; k < 8 * n; k++)
    gs_sine_cosine_far (x[k], s + k, c + k);
#else
  double out[8] = { 0 };
  for (int j = 0; j < n; j++)
    block (x + 8 * j, s + 8 * j, c + 8 * j, out);
  for (int i = 0; i < 8; i++)
    if (! (out[i] <= 4e9))
      {
        for (int k = 0; k < 8 * n; k++)
          if (! (fabs (x[k]) <= 1e5))
            gs_sine_cosine_far (x[k], s + k, c + k);
        return;
      }
#endif
}

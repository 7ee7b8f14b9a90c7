#include "gsmbp/functions.h"
#include "gsmbp/real.h"

#if GS_DIGITS == 53

/* what atan (q) is less than q, |q| <= 0.55: coefficients of the least largest error (Remez) */
static inline double
bend (double q)
{
  const double a0 = 0.33333333333333154, a1 = -0.19999999999951903, a2 = 0.14285714281234652,
               a3 = -0.11111110900584631, a4 = 0.09090903239258846, a5 = -0.0769220276351427,
               a6 = 0.0666538831273945, a7 = -0.058714380553215734, a8 = 0.05196741802164547,
               a9 = -0.04472258418869529, a10 = 0.034457396596170524, a11 = -0.02013541368452217,
               a12 = 0.006305736176752147;
  double z = q * q, w = z * z;
  double e = a0 + w * (a2 + w * (a4 + w * (a6 + w * (a8 + w * (a10 + w * a12)))));
  double o = a1 + w * (a3 + w * (a5 + w * (a7 + w * (a9 + w * a11))));
  return q * (z * (e + z * o));
}

/* One block in a form that vectorizes; out counts where it is good.
 *
 * The tangent q of an angle of at most pi/8 or so, and the octant what is added to it: m times
 * pi/4, as two numbers, of which the first has 48 bits, so that m times it is exact. Sums in
 * conditions would keep gcc from vectorizing the loop without masks (AVX-512). */
static void
block (const double *restrict y, const double *restrict x, double *restrict a,
       double *restrict out)
{
  const double ph = 0.7853981633974456, pl = 2.6951514290790595e-15;
  for (int i = 0; i < 8; i++)
    {
      double ax = fabs (x[i]), ay = fabs (y[i]);
      int steep = ay > ax;
      double low = steep ? ax : ay, big = steep ? ay : ax;
      double m = steep ? 2.0 : 0.0, s = steep ? -1.0 : 1.0;
      out[i] += low >= 0.0 && big >= 1e-290 && big <= 1e300 ? 1.0 : 0.0;
      double middle = 0.5 - copysign (0.5, 0.55 * big - low);   /* 1 or 0 */
      double num = low - middle * big, den = big + middle * low;
      double side = copysign (1.0, x[i]);
      m = 2.0 + side * (m + middle * s - 2.0);
      s = side * s;
      double q = num / den;
      a[i] = copysign (m * ph + (s * q + (m * pl - s * bend (q))), y[i]);
    }
}

#endif

/* In double precision the error is below 1.7 units in the last place. Where the larger of |x| and
 * |y| is not within 1e-290 and 1e300, or something is NaN, all are left to gs_atan2_point, as in
 * another precision. */
void
gs_atan2_blocks (int n, const gs_real *y, const gs_real *x, gs_real *a)
{
#if GS_DIGITS != 53
  for (int k = 0; k < 8 * n; k++)
    gs_atan2_point (y[k], x[k], a + k);
#else
  double out[8] = { 0 };
  for (int j = 0; j < n; j++)
    block (y + 8 * j, x + 8 * j, a + 8 * j, out);
  for (int i = 0; i < 8; i++)
    if (out[i] < n)
      {
        for (int k = 0; k < 8 * n; k++)
          gs_atan2_point (y[k], x[k], a + k);
        return;
      }
#endif
}

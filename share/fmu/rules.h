/* rules.h: what values of a scene must be; v (n) are finite in each of them. */
#ifndef GSF_RULES_H
#define GSF_RULES_H

#include <math.h>

static inline int
gsf_is_finite (int n, const double *v)
{
  for (int i = 0; i < n; i++)
    if (! (fabs (v[i]) <= 1e300))
      return 0;
  return 1;
}

static inline int
gsf_is_nonnegative (int n, const double *v)
{
  return gsf_is_finite (n, v) && v[0] >= 0;
}

static inline int
gsf_is_positive (int n, const double *v)
{
  return gsf_is_finite (n, v) && v[0] > 0;
}

static inline int
gsf_is_nonzero (int n, const double *v)
{
  return gsf_is_finite (n, v) && ! (v[0] == 0);
}

static inline int
gsf_is_fraction (int n, const double *v)
{
  return gsf_is_finite (n, v) && v[0] > 0 && v[0] <= 1;
}

static inline int
gsf_is_axis (int n, const double *v)
{
  int some = 0;
  for (int i = 0; i < n; i++)
    some |= fabs (v[i]) >= 1e-12;
  return some && gsf_is_finite (n, v);
}

/* two axes at right angles */
static inline int
gsf_is_across (int n, const double *v)
{
  return gsf_is_finite (n, v) && fabs (v[0] * v[3] + v[1] * v[4] + v[2] * v[5]) < 1e-12;
}

/* nine entries, symmetric, without a negative eigenvalue: no principal minor is negative */
static inline int
gsf_is_inertia (int n, const double *v)
{
  double big = 0, xy = 0.5 * (v[1] + v[3]), xz = 0.5 * (v[2] + v[6]), yz = 0.5 * (v[5] + v[7]);
  for (int i = 0; i < n; i++)
    big = fmax (big, fabs (v[i]));
  const double a = v[0], b = v[4], c = v[8], e = 1e-13 * big;
  const double all = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz);
  return gsf_is_finite (n, v) && fmin (a, fmin (b, c)) >= -e && a * b - xy * xy >= -2 * e * big
         && a * c - xz * xz >= -2 * e * big && b * c - yz * yz >= -2 * e * big
         && all >= -6 * e * big * big;
}

/* nine entries by rows: R'R = 1, determinant 1 */
static inline int
gsf_is_rotation (int n, const double *v)
{
  double worst = 0;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      worst = fmax (worst, fabs (v[i] * v[j] + v[3 + i] * v[3 + j] + v[6 + i] * v[6 + j]
                                 - (i == j)));
  const double det = v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6])
                     + v[2] * (v[3] * v[7] - v[4] * v[6]);
  return gsf_is_finite (n, v) && worst < 1e-12 && det > 0;
}

static inline double
gsf_sign (double x)
{
  return (x > 0) - (x < 0);
}

#endif

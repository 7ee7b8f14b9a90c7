/* The rules of share/fmu/rules.h at the edges of what they allow, which the manual states
 * (share/manual/errors.texi, "above 0 and at most 1"). */
#include "rules.h"
#include <float.h>
#include <stdio.h>

static void
rule (const char *name, int (*is) (int, const double *), int n, int expected, const double *v)
{
  if (is (n, v) == expected)
    return;
  printf ("not ok %s: expected %s:", name, expected ? "taken" : "refused");
  for (int i = 0; i < n; i++)
    printf (" %.17g", v[i]);
  printf ("\n");
}

#define RULE(is, expected, ...)                                                                    \
  rule (#is, is, sizeof ((double[]){ __VA_ARGS__ }) / sizeof (double), expected,                   \
        (double[]){ __VA_ARGS__ })

int
main (void)
{
  RULE (gsf_is_finite, 1, 1e300, -1e300);
  RULE (gsf_is_finite, 0, 1, NAN);
  RULE (gsf_is_finite, 0, -INFINITY);
  RULE (gsf_is_nonnegative, 1, 0);
  RULE (gsf_is_nonnegative, 0, -4.9e-324);
  RULE (gsf_is_nonnegative, 0, NAN);
  RULE (gsf_is_positive, 1, 4.9e-324);
  RULE (gsf_is_positive, 0, 0);
  RULE (gsf_is_positive, 0, INFINITY);
  RULE (gsf_is_nonzero, 1, -4.9e-324);
  RULE (gsf_is_nonzero, 0, -0.0);
  RULE (gsf_is_nonzero, 0, NAN);
  RULE (gsf_is_fraction, 1, 4.9e-324);
  RULE (gsf_is_fraction, 1, 1);
  RULE (gsf_is_fraction, 0, 0);
  RULE (gsf_is_fraction, 0, 1 + DBL_EPSILON);
  RULE (gsf_is_fraction, 0, NAN);
  RULE (gsf_is_axis, 1, 0, 0, -2e-12);
  RULE (gsf_is_axis, 0, 0, 0, 0);
  RULE (gsf_is_axis, 0, 1, NAN, 0);
  RULE (gsf_is_across, 1, 1, 2, 3, -2, 1, 0);
  RULE (gsf_is_across, 0, 1, 0, 0, 1e-9, 1, 0);
  RULE (gsf_is_inertia, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  RULE (gsf_is_inertia, 1, 2, -1, 0, -1, 2, -1, 0, -1, 2);
  RULE (gsf_is_inertia, 0, 1, 2, 0, 2, 1, 0, 0, 0, 9);          /* eigenvalue -1 in one plane */
  RULE (gsf_is_inertia, 0, 1, 0, 2, 0, 9, 0, 2, 0, 1);
  RULE (gsf_is_inertia, 0, 9, 0, 0, 0, 1, 2, 0, 2, 1);
  RULE (gsf_is_inertia, 0, 1, -0.9, -0.9, -0.9, 1, -0.9, -0.9, -0.9, 1);   /* of all three: -0.8 */
  RULE (gsf_is_inertia, 0, 1, 0, 0, 0, -1, 0, 0, 0, 1);
  RULE (gsf_is_rotation, 1, 0, -1, 0, 1, 0, 0, 0, 0, 1);
  RULE (gsf_is_rotation, 1, -1, 0, 0, 0, -1, 0, 0, 0, 1);
  RULE (gsf_is_rotation, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1);        /* a reflection */
  RULE (gsf_is_rotation, 0, 1, 0, 0, 0, 1, 1e-9, 0, 0, 1);
  return 0;
}

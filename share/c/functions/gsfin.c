#include "gsmbp/functions.h"

#include <math.h>

/* By magnitude: the comparison fails for infinities and for what is no number. Valid only where
 * -ffast-math is not used. */
int
gsfin (int n, const double *x)
{
  for (int i = 0; i < n; i++)
    if (! (fabs (x[i]) <= 1e300))
      return i + 1;
  return 0;
}

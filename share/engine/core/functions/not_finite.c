#include "gsmbp/functions.h"

/* By magnitude: the comparison fails for infinities and for what is no number. Valid only where
 * -ffast-math is not used. */
int
gs_not_finite (int n, const gs_real *x)
{
  for (int i = 0; i < n; i++)
    if (! (gs_abs (x[i]) <= GS_HUGE))
      return i + 1;
  return 0;
}

#include "gsmbp/functions.h"

#include <math.h>

void
gsatl (double y, double x, double *a)
{
  *a = atan2 (y, x);
}

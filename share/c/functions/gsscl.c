#include "gsmbp/functions.h"

#include <math.h>

void
gsscl (double x, double *s, double *c)
{
  *s = sin (x);
  *c = cos (x);
}

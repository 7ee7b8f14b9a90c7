#include "gsmbp/functions.h"

#include <float.h>

double
gseps (void)
{
  return DBL_EPSILON;
}

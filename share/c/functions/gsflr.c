#include "gsmbp/functions.h"

#include <math.h>

double
gsflr (double x)
{
  double whole = trunc (x);
  return whole > x ? whole - 1.0 : whole;
}

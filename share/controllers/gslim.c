#include "controllers.h"

#include <math.h>

/* Fortran's ANINT is round. */
int
gslim (double low, double high, double step, double *v)
{
  double raw = *v;
  if (*v < low)
    *v = low;
  if (*v > high)
    *v = high;
  int within = *v == raw;
  if (step > 0.0)
    *v = step * round (*v / step);
  return within;
}

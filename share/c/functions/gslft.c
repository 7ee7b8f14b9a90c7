/* GSLFT: the time that stands for t: with side < 0, the limit from the left, one just before it, so
 * that what switches at t has not yet switched; else t itself. */
#include <math.h>

#include "gsmbp/functions.h"

double
gslft (double t, int side)
{
  return side < 0 ? t - fmax (2.0 * gseps () * fabs (t), 1e-300) : t;
}

#include "gsmbp/functions.h"

void
gs_atan2_point (gs_real y, gs_real x, gs_real *a)
{
  *a = gs_atan2 (y, x);
}

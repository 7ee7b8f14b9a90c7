#include "gsmbp/functions.h"

gs_real
gs_whole_below (gs_real x)
{
  gs_real whole = gs_trunc (x);
  return whole > x ? whole - 1 : whole;
}

#include "gsmbp/functions.h"

gs_real
gs_epsilon (void)
{
  return GS_EPSILON;
}

#include "gsmbp/functions.h"



gs_real
gseps (void)
{
  return GS_EPSILON;
}

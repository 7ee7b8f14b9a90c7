#include "gsmbp/functions.h"
#include "gsmbp/sines.h"

void
gssc (double x, double *s, double *c)
{
  gs_sines (x, s, c);
}

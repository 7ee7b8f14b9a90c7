#include "gsmbp/functions.h"
#include "gsmbp/sines.h"

void
gs_sine_cosine (gs_real x, gs_real *s, gs_real *c)
{
  gs_sines (x, s, c);
}

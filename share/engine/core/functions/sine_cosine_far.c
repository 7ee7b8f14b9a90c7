#include "gsmbp/functions.h"

void
gs_sine_cosine_far (gs_real x, gs_real *s, gs_real *c)
{
  *s = gs_sin (x);
  *c = gs_cos (x);
}

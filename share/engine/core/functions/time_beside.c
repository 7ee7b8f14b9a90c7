/* gs_time_beside: the time that stands for t: with side < 0, the limit from the left, one just
 * before it, so that what switches at t has not yet switched; else t itself. */

#include "gsmbp/functions.h"

gs_real
gs_time_beside (gs_real t, int side)
{
  return side < 0 ? t - gs_fmax (2 * gs_epsilon () * gs_abs (t), GS_TINY) : t;
}

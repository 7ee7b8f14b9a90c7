/* wall_clock.c: the time, which C99 has in seconds only. */
#define _POSIX_C_SOURCE 199309L
#include <time.h>

#include "host/collocation/nlp.h"

double
gs_wall_clock (void)
{
#if defined(CLOCK_MONOTONIC)
  struct timespec now;
  clock_gettime (CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
#else
  return (double)time (NULL);
#endif
}

/* host/engine.h: which run time integrates by dp853, rk4 and auto: the one in C, or with the
 * environment variable GSMBP_ENGINE=fortran the Fortran one. */
#ifndef GSMBP_HOST_ENGINE_H
#define GSMBP_HOST_ENGINE_H

#include <stdlib.h>
#include <string.h>

/* 1: the one in C, 0: the Fortran one, -1: the variable has another word */
static inline int
gs_engine_is_c (void)
{
  const char *word = getenv ("GSMBP_ENGINE");
  if (! word || ! *word || strcmp (word, "c") == 0)
    return 1;
  return strcmp (word, "fortran") == 0 ? 0 : -1;
}
#endif

/* The methods of the engine by their words. */
#include <string.h>

#include "implicit.h"

gs_implicit_method *
gs_method_named (const char *name)
{
#define GS_NAMED_core(word)
#define GS_NAMED_both(word)
#define GS_NAMED_library(word)
#define GS_NAMED_engine(word)                                                                      \
  if (strcmp (name, #word) == 0)                                                                   \
    return gs_##word;
#define GS_NAMED(word, number, steps, by, orders, order) GS_NAMED_##by (word)
  GS_METHODS (GS_NAMED)
  return NULL;
}

/* optimize.c: designs for the module. */
#include <stddef.h>

#include "host/optimize/optimize.h"

#define NAME(name) #name "\n"

/* words of goals and demands, solvers, ways of the choices, a line each */
const char *
gs_loop_design_words (int which)
{
  static const char *const tables[]
      = { GS_DESIGN_WORDS (NAME), GS_DESIGN_SOLVERS (NAME), GS_DESIGN_CHOICES (NAME) };
  return tables[which];
}

/* bytes of the structures that Python fills and reads as well */
int
gs_loop_design_size (int which)
{
  static const size_t sizes[] = { sizeof (gs_free), sizeof (gs_design_row), sizeof (gs_case_times),
                                  sizeof (gs_series), sizeof (gs_design_values),
                                  sizeof (gs_design), sizeof (gs_design_options),
                                  sizeof (gs_design_active), sizeof (gs_design_end),
                                  sizeof (gs_design_result) };
  return (int)sizes[which];
}

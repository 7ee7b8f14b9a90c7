/* assemble.c: states from guesses for the module. */
#include "host/assemble/assemble.h"

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

int
gs_loop_assemble (const gs_assembly_asked *asked, const double *start, double *x,
                  gs_assembly *found)
{
  return gs_assemble (gs_loop_about (), asked, start, x, found);
}

int
gs_loop_lost_rank (double t, const double *cst, int rank, const double *start, const double *x,
                   int *loose, char *text, int size)
{
  return gs_lost_rank (gs_loop_about (), t, cst, rank, start, x, loose, text, size);
}

/* bytes of the structures that Python fills and reads as well */
int
gs_loop_assembly_size (int which)
{
  return (int)(which == 0 ? sizeof (gs_assembly_asked) : sizeof (gs_assembly));
}

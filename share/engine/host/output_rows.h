/* output_rows.h: rows of the outputs of a run. */
#ifndef GS_OUTPUT_ROWS_H
#define GS_OUTPUT_ROWS_H

#include "gsmbp/functions.h"
#include "gsmbp/scene.h"

/* The time that stands for row k of the output times t, of which a run has reached so many: where
 * the scene switches the row has what was before, as the inputs in it, but for the first one and
 * those after the end of the run. */
static inline gs_real
gs_row_time (const gs_real *t, int k, int reached, int nsw, const gs_real *switches)
{
  for (int i = 0; i < nsw && k > 0 && k < reached; i++)
    if (switches[i] >= t[k] && switches[i] <= t[k])
      return gs_time_beside (t[k], -1);
  return t[k];
}

/* The outputs y (ny) at time t. 1; 0: there are none, since a state or an input is no finite number
 * or they cannot be calculated. */
static inline int
gs_outputs (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst,
            gs_real *y)
{
  if (! s->out || gs_not_finite (s->nx, x) != 0 || gs_not_finite (s->nv, v) != 0)
    return 0;
  const int info = s->out (t, x, v, cst, y);
  return info == 0 || info == 2;
}
#endif

/* ensemble.c: many runs for the module. */
#include <stdlib.h>

#include "host/ensemble/run_rows.h"

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

/* ask of gs_run_options: what Python has written ends all runs */
static int
ask (void *over, double t)
{
  (void)t;
  return *(const volatile int *)over;
}

/* over: not 0 ends all runs with that info */
int
gs_loop_ensemble (gs_run_options *o, const gs_run_start *s, const gs_run_inputs *in,
                  const gs_rows *rows, int threads, int *over, gs_results *results,
                  gs_run_result *r)
{
  o->ask = ask;
  o->asked = over;
  return gs_run_rows (gs_loop_about (), o, s, in, rows, threads, results, NULL, r);
}

/* bytes of the structures that Python fills as well */
int
gs_loop_rows_size (int which)
{
  static const size_t sizes[] = { sizeof (gs_rows), sizeof (gs_results) };
  return (int)sizes[which];
}

/* n texts of gs_results */
void
gs_loop_forget (char **texts, int n)
{
  for (int i = 0; i < n; i++)
    free (texts[i]);
}

/* simulate.c: two seconds of @name@ from its start, inputs zero; prints the states at 21 times.
 * simulate METHOD [ORDER]: dp853 (if nothing is said), rk4, radau, gauss, auto. */
#include "@name@.h"
#include "host/run/run.h"

#include "start.h"

#include <stdio.h>
#include <stdlib.h>

enum { NX = @NAME@_NX, TIMES = 21 };
extern const gs_description @prefix@_about;

static void
show (const gs_run_result *r)
{
  for (int k = 0; k < r->rows; k++)
    {
      printf ("%4.1f", r->times[k]);
      for (int j = 0; j < NX; j++)
        printf (" %13.6g", r->x[NX * k + j]);
      printf ("\n");
    }
  if (r->ended)
    printf ("an event has ended the run; ");
  printf ("info %d, %d steps, t = %g s\n", r->info, r->istat[GS_N_STEPS],
          r->rstat[GS_T_REACHED]);
}

int
main (int count, char **words)
{
  @prefix@_parameters par;
  double cst[@NAME@_NCST + 1], times[TIMES];
  gs_run_options options = gs_default_options ();
  const gs_run_inputs inputs = { 0 };
  const gs_run_start from = { .nt = TIMES, .times = times, .x0 = start,
                              .par = (const double *)&par, .cst = cst };
  gs_run_result result;
  for (int k = 0; k < TIMES; k++)
    times[k] = 0.1 * k;
  options.rtol = 1e-9;
  options.project = 1;
  if (count > 1)
    options.method = words[1];
  if (count > 2)
    options.maxorder = atof (words[2]);
  @prefix@_par (&par);
  if (@prefix@_pre (&par, cst) != 0)
    return 1;
  const int failed = gs_run (&@prefix@_about, &options, &from, &inputs, &result);
  if (result.refused)
    printf ("%s: %s\n", result.option, result.text);
  else
    show (&result);
  if (result.info != 0)
    printf ("%s\n", result.text);
  gs_free_result (&result);
  return failed;
}

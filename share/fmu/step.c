/* step.c: a communication step of co-simulation: the run goes on (host/run/stepped.h). */
#include "fmu.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* other coordinates where these are near the end of their range */
static void
arrive (gsf_instance *a)
{
  double range, normal;
  gsf_next_switch (a);
  a->known = 0;
  if (a->m->scene->nlam > 0 && gsf_margins (a, &range, &normal))
    gsf_choose (a);
  gsf_take (a);
}

int
gsf_can_step (gsf_instance *a, double t, double h)
{
  const double now = *a->t;
  gsf_hide_samples (a);
  if (! (fabs (t - now) <= 1e-9 * (1 + fabs (now))))
    return gsf_fail (a, GSF_ERROR, "a step begins where the last one ended, at t = %.15g s; found "
                     "t = %.15g s", now, t);
  if (*a->run.ended > 0)
    return gsf_ended (a, GSF_ERROR);
  if (! (h > 0 && h <= 1e300))
    return gsf_fail (a, GSF_ERROR, "expected a step above 0; found %g s", h);
  return GSF_OK;
}

int
gsf_step (gsf_instance *a, double t)
{
  gsf_hide_samples (a);
  const int failed = gs_step_on (&a->run, t);
  arrive (a);
  if (! failed)
    return gsf_watch (a);
  gsf_run_says (a);
  const size_t n = strlen (a->text);
  if (a->run.r.info == GS_TOO_MANY)
    snprintf (a->text + n, sizeof a->text - n, ": %d in a communication step of an FMU; take "
              "shorter ones", GSF_MOST_STEPS);
  return GSF_ERROR;
}

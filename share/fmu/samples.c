/* samples.c: samples of digital devices at a communication point of co-simulation.
 *
 * They are taken in the step that begins there, since the importer may set inputs that they read.
 * What is read at the point are the values after them, as in model exchange: gsf_show_samples takes
 * them with the inputs as they are and keeps the instance as it was, gsf_hide_samples returns to
 * that before anything is set, saved or continued. So reading leaves no trace, and an input that is
 * set there is one that the samples read. */
#include "fmu.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"

#include <math.h>
#include <string.h>

/* a sample or a delayed output at the communication point, which no step has taken? */
static int
is_due (const gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  const gs_run_result *r = &a->run.r;
  const double t = *a->t;
  return s->nctl > 0 && a->i[GSF_KIND] == GSF_COSIMULATION && *a->run.ended == 0
         && (a->i[GSF_PHASE] & (GSF_STEP | GSF_DONE))
         && gs_next_sample (s->nv, r->ip + r->ip[GS_SAMPLES] - 1, r->rp + r->ip[GS_SAMPLES + 1] - 1)
                <= t + 8 * gs_epsilon () * fabs (t);
}

/* ports and events of the user as where a run begins (k = 0) and after its samples (k = -1) */
static int
events (gsf_instance *a, int k)
{
  int istat[GS_COUNTED] = { 0 };
  const int info = gs_resolve_under_inputs (a->m->scene, *a->t, a->x, a->m->scene->nx,
                                            a->run.r.ip, a->run.r.rp, a->cst, a->v, a->w, istat,
                                            k);
  if (info != 0)
    return gsf_failed (a, GSF_ERROR, istat[GS_FAILED], info);
  gs_step_tally (&a->run);
  return GSF_OK;
}

int
gsf_show_samples (gsf_instance *a)
{
  int acted, status = GSF_OK;
  if (a->shown || ! is_due (a))
    return GSF_OK;
  gsf_save (a, a->kept);
  a->shown = 1;
  a->known = 0;
  if (a->m->nown > 0 && gs_step_jump (&a->run))
    status = gsf_run_says (a);
  if (status == GSF_OK)
    status = events (a, 0);
  if (status == GSF_OK)
    status = gsf_take_samples (a, &acted);
  if (status == GSF_OK)
    status = events (a, -1);
  a->known = 0;
  if (status)
    gsf_restore (a, a->kept);
  return status;
}

void
gsf_hide_samples (gsf_instance *a)
{
  if (a->shown)
    gsf_restore (a, a->kept);
}

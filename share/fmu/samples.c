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
#include "plan.h"

#include <math.h>
#include <string.h>

int
gsf_sample_near (const gsf_instance *a, double *t, double h)
{
  const gs_scene *s = a->m->scene;
  if (s->nctl == 0)
    return 0;
  const gs_samples plan = gsf_samples (a);
  for (int k = 0; k < 2 * s->nctl; k++)
    {
      const double period = plan.period[k / 2], delay = k % 2 ? plan.delay[k / 2] : 0;
      const double due = round ((*t - delay) / period) * period + delay;
      if (fabs (due - *t) > fmax (16 * gs_epsilon () * fabs (*t), 1e-9 * fmin (h, period)))
        continue;
      *t = due;
      return 1;
    }
  return 0;
}

/* a sample or a delayed output at the communication point, which no step has taken? */
static int
is_due (const gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  const double t = a->d[GSF_T];
  return s->nctl > 0 && a->i[GSF_KIND] == GSF_COSIMULATION && a->i[GSF_ENDED] == 0
         && (a->i[GSF_PHASE] & (GSF_STEP | GSF_DONE))
         && gs_next_sample (s->nv, a->ip + a->ip[GS_SAMPLES] - 1, a->rp + a->ip[GS_SAMPLES + 1] - 1)
                <= t + 8 * gs_epsilon () * fabs (t);
}

/* the arrays of the instance are copied; back: as they were kept */
static void
copy (gsf_instance *a, int back)
{
  memcpy (back ? a->d : a->kept_d, back ? a->kept_d : a->d, a->nd * sizeof (double));
  memcpy (back ? a->i : a->kept_i, back ? a->kept_i : a->i, a->ni * sizeof (int));
  a->shown = ! back;
  a->known = 0;
}

/* ports and events of the user as where a run begins (k = 0) and after its samples (k = -1) */
static int
events (gsf_instance *a, int k)
{
  int istat[GS_COUNTED] = { 0 };
  const int info = gs_resolve_under_inputs (a->m->scene, a->d[GSF_T], a->x, a->m->scene->nx, a->ip,
                                            a->rp, a->cst, a->v, a->w, istat, k);
  if (info != 0)
    return gsf_failed (a, GSF_ERROR, istat[GS_FAILED], info);
  gsf_tally (a);
  return GSF_OK;
}

int
gsf_show_samples (gsf_instance *a)
{
  int acted, status = GSF_OK;
  if (a->shown || ! is_due (a))
    return GSF_OK;
  copy (a, 0);
  if (a->m->nown > 0)
    status = gsf_begin_step (a);
  if (status == GSF_OK)
    status = events (a, 0);
  if (status == GSF_OK)
    status = gsf_take_samples (a, &acted);
  if (status == GSF_OK)
    status = events (a, -1);
  a->known = 0;
  if (status)
    copy (a, 1);
  return status;
}

void
gsf_hide_samples (gsf_instance *a)
{
  if (a->shown)
    copy (a, 1);
}

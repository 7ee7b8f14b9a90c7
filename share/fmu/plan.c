/* plan.c: the plan of the inputs of an instance, see plan.h. */
#include "plan.h"

#include <string.h>

/* inputs are constant within a step; events of the user are recorded */
static gs_plan
plan_of (const gsf_model *m)
{
  gs_plan p;
  memset (&p, 0, sizeof p);
  p.s = m->scene;
  p.nx = m->scene->nx;
  p.on_the_way = m->scene->nctl * GSF_ON_THE_WAY;
  p.events = m->nown > 0 ? GSF_RECORDS : 0;
  return p;
}

int
gsf_plan_numbers (const gsf_model *m)
{
  const gs_plan p = plan_of (m);
  return gs_reals (&p);
}

int
gsf_plan_wholes (const gsf_model *m)
{
  const gs_plan p = plan_of (m);
  return gs_wholes (&p);
}

void
gsf_plan (gsf_instance *a)
{
  const gs_plan p = plan_of (a->m);
  gs_lay (&p, a->ip, a->rp);
  if (a->m->nown == 0)
    return;
  const gs_events e = gsf_events (a);
  *e.tells = 2;
  for (int k = a->m->nports; k < a->m->scene->nev; k++)
    e.kind[k] = 4;   /* gs_integrate comes back at each */
}

gs_samples
gsf_samples (const gsf_instance *a)
{
  return gs_planned_samples (a->m->scene, a->ip, a->rp);
}

gs_events
gsf_events (const gsf_instance *a)
{
  return gs_planned_events (a->m->scene->nx, a->ip, a->rp);
}

int
gsf_plan_samples (gsf_instance *a, double t0)
{
  const gs_scene *s = a->m->scene;
  gs_start start;
  if (gs_check_samples (&a->about, t0, a->cst, a->ip, a->rp, &start) != GS_START_TAKEN)
    return gsf_fail (a, GSF_ERROR, "%s", start.text);
  if (s->nctl == 0)
    return GSF_OK;
  const gs_samples plan = gsf_samples (a);
  for (int i = 0; i < s->nctl; i++)
    if (! (plan.delay[i] <= (GSF_ON_THE_WAY - 2) * plan.period[i]))
      return gsf_fail (a, GSF_ERROR, "sampled device %d: an FMU holds delays of at most %d "
                       "periods; found %g s and a period of %g s", i + 1, GSF_ON_THE_WAY - 2,
                       plan.delay[i], plan.period[i]);
  return GSF_OK;
}

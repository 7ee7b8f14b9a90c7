/* plan.c: the plan of the inputs of an instance, see plan.h. */
#include "plan.h"

#include <float.h>
#include <math.h>
#include <string.h>

static int
places (const gsf_model *m)
{
  return m->nctl * GSF_ON_THE_WAY;
}

static size_t
sample_numbers (const gsf_model *m)
{
  if (m->nctl == 0)
    return 0;
  return 2 * m->nctl + m->nheld + m->nxk + m->scene->ny + m->scene->nv
         + (size_t)places (m) * (1 + m->nheld);
}

static size_t
sample_wholes (const gsf_model *m)
{
  return m->nctl == 0 ? 0 : 10 + 3 * m->nctl + m->nheld + places (m);
}

size_t
gsf_plan_numbers (const gsf_model *m)
{
  return m->scene->nv + 1 + sample_numbers (m) + (m->nev ? 5 * m->nev + 3 * m->scene->nx : 0);
}

size_t
gsf_plan_wholes (const gsf_model *m)
{
  return GS_NUMBERS + 1 + sample_wholes (m) + (m->nev ? 10 + 5 * m->nev : 0);
}

gs_samples
gsf_samples (const gsf_instance *a)
{
  return gs_samples_of (a->m->scene->nv, a->ip + a->ip[GS_SAMPLES] - 1,
                        a->rp + a->ip[GS_SAMPLES + 1] - 1);
}

gs_events
gsf_events (const gsf_instance *a)
{
  return gs_events_of (a->m->scene->nx, a->ip + a->ip[GS_EVENTS] - 1,
                       a->rp + a->ip[GS_EVENTS + 1] - 1);
}

/* is and rs begin at these places, from 1 */
static void
lay_samples (gsf_instance *a, int is, int rs)
{
  const gsf_model *m = a->m;
  const int head[6] = { m->nctl, m->nxk, m->scene->ny, m->nheld, places (m), 0 };
  a->ip[GS_HELD] = m->nheld;
  a->ip[GS_HELD + 1] = is + 10 + 3 * m->nctl;
  a->ip[GS_HELD_AT] = rs + 2 * m->nctl;
  a->ip[GS_SAMPLES] = is;
  a->ip[GS_SAMPLES + 1] = rs;
  memcpy (a->ip + is - 1, head, sizeof head);
  gs_samples s = gsf_samples (a);
  for (int k = 0; k < m->nctl; k++)
    {
      s.held[k] = m->held_counts[k];
      s.anew[k] = m->again[k];
      s.period[k] = 1;
    }
  for (int k = 0; k < m->nheld; k++)
    s.input[k] = m->held_inputs[k];
  for (int k = 0; k < m->nxk; k++)
    s.memory[k] = m->memory[k];
}

static void
lay_events (gsf_instance *a, int ie, int re)
{
  const gsf_model *m = a->m;
  a->ip[GS_EVENTS] = ie;
  a->ip[GS_EVENTS + 1] = re;
  a->ip[ie - 1] = m->nev;
  gs_events e = gsf_events (a);
  for (int k = 0; k < m->nev; k++)
    {
      e.input[k] = m->event_inputs[k];
      e.kind[k] = m->event_kinds[k];
    }
}

void
gsf_plan (gsf_instance *a)
{
  const gsf_model *m = a->m;
  int is = GS_NUMBERS + 2, rs = m->scene->nv + 2;
  a->ip[GS_TABLE + 3] = 1;
  if (m->nctl > 0)
    lay_samples (a, is, rs);
  if (m->nev > 0)
    lay_events (a, is + (int)sample_wholes (m), rs + (int)sample_numbers (m));
}

/* the number of the first sample at t0 or later: sample k is at k*period; a start that differs from
 * one by rounding only is one */
static double
first_sample (double t0, double period)
{
  double k = floor (t0 / period + 0.5);
  return fabs (k * period - t0) <= 8 * DBL_EPSILON * fabs (t0) ? k : ceil (t0 / period);
}

int
gsf_plan_samples (gsf_instance *a, double t0)
{
  const gsf_model *m = a->m;
  if (m->nctl == 0)
    return GSF_OK;
  gs_samples s = gsf_samples (a);
  m->ctp (a->cst, s.period, s.delay);
  for (int k = 0; k < m->nctl; k++)
    {
      if (! (s.period[k] > 0) || ! (s.delay[k] >= 0))
        return gsf_fail (a, GSF_ERROR, "sampled device %d: expected a period > 0 and a delay >= 0;"
                         " found %g s and %g s", k + 1, s.period[k], s.delay[k]);
      if (! (s.delay[k] <= (GSF_ON_THE_WAY - 2) * s.period[k]))
        return gsf_fail (a, GSF_ERROR, "sampled device %d: an FMU holds delays of at most %d "
                         "periods; found %g s and a period of %g s", k + 1, GSF_ON_THE_WAY - 2,
                         s.delay[k], s.period[k]);
      double next = first_sample (t0, s.period[k]);
      if (! (fabs (next) < 2e9))
        return gsf_fail (a, GSF_ERROR, "sampled device %d: more than 2e9 samples", k + 1);
      s.next[k] = (int)next;
    }
  return GSF_OK;
}

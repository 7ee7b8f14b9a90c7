/* own.c: events of the user: how often and when they have happened, and in model exchange when the
 * next one of each does.
 *
 * The expression of an event, with the sign of its direction, falls to 0 where it happens. There it
 * is 0 but for rounding, and the importer's method tells no better. So three cases follow:
 *   armed: above 0 since its last event, it happens where it is not above 0;
 *   left: it rises behind its event, as that of a ball which is thrown back: it is armed as soon as
 *     it is above a little, and happens again where it falls a little below where it was;
 *   below: it goes on falling: the importer finds where it is above a little, then it is armed.
 * "A little" is 1e-10 of its largest value so far. What happens again and again without rising
 * has infinitely many events: an error. */
#include "fmu.h"
#include "host/failure.h"

#include <math.h>

enum { GSF_ARMED, GSF_LEFT, GSF_BELOW };
enum { GSF_MOST_LOW = 10 };   /* so many without rising accumulate */

static double
little (const gsf_instance *a, int k)
{
  return 1e-10 * (a->size[k] > 0 ? a->size[k] : 1);
}

static void
enters (gsf_instance *a, int k, int phase)
{
  a->phase[k] = phase;
  a->level[k] = phase == GSF_ARMED ? 0 : phase == GSF_LEFT ? a->g[k] - little (a, k)
                                                           : little (a, k);
}

/* ---------------------------------------------------------------------------------- both kinds */

int
gsf_tally (const gsf_instance *a, int k)
{
  int n = 0;
  for (int i = a->m->nports; i < a->m->scene->nev; i++)
    n += a->m->own[i - a->m->nports] == k ? a->run.tally[i] : 0;
  return n;
}

double
gsf_when (const gsf_instance *a, int k)
{
  double t = -HUGE_VAL;
  for (int i = a->m->nports; i < a->m->scene->nev; i++)
    t = a->m->own[i - a->m->nports] == k ? fmax (t, a->run.when[i]) : t;
  return t;
}

int
gsf_ended (gsf_instance *a, int status)
{
  const int k = *a->run.ended - 1;
  return gsf_fail (a, status, "event %s has ended the run at t = %.15g s",
                   a->m->events[a->m->own[k - a->m->nports]], a->run.when[k]);
}

int
gsf_is_overridden (const gsf_instance *a, int k)
{
  if (a->m->nswitched == 0)
    return 0;
  const gs_events e = gsf_events (a);
  for (int i = 0; i < e.ns; i++)
    if (e.switched[i] == k + 1 && e.on[i] == 1)
      return 1;
  return 0;
}

/* ------------------------------------------------------------------------------- model exchange */

void
gsf_begin_own (gsf_instance *a)
{
  const gsf_model *m = a->m;
  for (int k = m->nports; k < m->scene->nev; k++)
    {
      a->size[k] = fabs (a->g[k]);
      a->low[k] = 0;
      enters (a, k, a->g[k] > 0 ? GSF_ARMED : GSF_BELOW);
    }
}

int
gsf_is_ready (const gsf_instance *a, int k)
{
  return a->phase[k] != GSF_BELOW;
}

void
gsf_before_own (gsf_instance *a)
{
  const gs_events e = gsf_events (a);
  for (int k = a->m->nports; k < a->m->scene->nev; k++)
    e.mark[k] = a->phase[k] == GSF_ARMED;
}

/* does function k rise from the state on? */
static int
rises (gsf_instance *a, int k)
{
  const gsf_model *m = a->m;
  const gs_scene *s = m->scene;
  double *x = a->xout, *g = x + s->nx, t = gsf_time (a), h = 1e-4;
  if (gsf_inputs (a) || ! gsf_is_usable (s->rhs (t, a->x, a->v, a->cst, a->xd)))
    return 0;
  for (int i = 0; i < s->nx; i++)
    h = fmin (h, 1e-7 * m->nominal[i] / fmax (fabs (a->xd[i]), 1e-300));
  h = fmax (h, 1e-12 * (1 + fabs (t)));
  for (int i = 0; i < s->nx; i++)
    x[i] = a->x[i] + h * a->xd[i];
  s->evt (t + h, x, a->v, gsf_events (a).mode, a->cst, g);
  return g[k] > a->g[k];
}

/* function k has just happened */
static int
happened (gsf_instance *a, int k)
{
  if (a->phase[k] == GSF_LEFT)
    a->low[k]++;
  else
    a->low[k] = 0;
  if (a->low[k] >= GSF_MOST_LOW)
    {
      int istat[GS_COUNTED] = { 0 };
      istat[GS_FAILED] = GS_AT_EVENT;
      istat[GS_FAILED_INFO] = 10;
      istat[GS_CAUSE] = k + 1;
      gs_failure (&(gs_failed_run){ .d = &a->about, .info = GS_ROUTINE_FAILED, .istat = istat,
                                    .t = *a->t },
                  a->text, sizeof a->text);
      return GSF_ERROR;
    }
  enters (a, k, a->g[k] > little (a, k) ? GSF_ARMED : rises (a, k) ? GSF_LEFT : GSF_BELOW);
  return GSF_OK;
}

int
gsf_after_own (gsf_instance *a)
{
  const gs_events e = gsf_events (a);
  int status = GSF_OK;
  if (gsf_functions (a))
    return GSF_ERROR;
  for (int k = a->m->nports; k < a->m->scene->nev && status == GSF_OK; k++)
    if (e.fresh[k] == 1)
      status = happened (a, k);
  gsf_risen_own (a, 1);
  return status;
}

void
gsf_risen_own (gsf_instance *a, int completed)
{
  for (int k = a->m->nports; k < a->m->scene->nev; k++)
    {
      if (completed)
        a->size[k] = fmax (a->size[k], fabs (a->g[k]));
      if (a->phase[k] == GSF_ARMED || ! (a->g[k] > little (a, k)))
        continue;
      a->low[k] = 0;
      if (completed)
        enters (a, k, GSF_ARMED);
    }
}

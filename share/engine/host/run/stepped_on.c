/* stepped_on.c: a stepped run continued, step by step, to a time. */
#include <math.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/expressions.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "host/run/run_parts.h"

void
gs_step_set (gs_stepped_run *a, int k, gs_real value)
{
  if (! (a->inputs[k] >= value && a->inputs[k] <= value))
    gs_step_forget (a);
  a->inputs[k] = value;
}

/* ---------------------------------------------------------------------------------------- times */

/* is there a sample at t but for rounding, at the end of a step of the length h? t becomes its
 * time */
static int
sample_near (const gs_stepped_run *a, gs_real *t, gs_real h)
{
  const gs_scene *s = a->parts->whole.d->scene;
  if (s->nctl == 0)
    return 0;
  const gs_samples plan = gs_planned_samples (s, a->r.ip, a->r.rp);
  for (int k = 0; k < 2 * s->nctl; k++)
    {
      const gs_real period = plan.period[k / 2], delay = k % 2 ? plan.delay[k / 2] : 0;
      const gs_real due = gs_round ((*t - delay) / period) * period + delay;
      if (gs_abs (due - *t)
          > gs_max (16 * gs_epsilon () * gs_abs (*t), GS_R (1e-9) * gs_min (h, period)))
        continue;
      *t = due;
      return 1;
    }
  return 0;
}

/* times are sums of steps: an event of the user that lies this near to one has happened there */
static gs_real
rounding (const gs_stepped_run *a, gs_real t)
{
  return a->parts->nown > 0 ? 16 * gs_epsilon () * gs_abs (t) : 0;
}

/* the end of a run to t: a little later, but not after a sample, which belongs to the next step */
static gs_real
end_of_run (const gs_stepped_run *a, gs_real t)
{
  return sample_near (a, &t, 0) ? t : t + rounding (a, t);
}

/* --------------------------------------------------------------------------------------- events */

int
gs_step_failed (gs_stepped_run *a, int routine, int info)
{
  gs_run_result *r = &a->r;
  memset (r->istat, 0, sizeof r->istat);
  r->info = GS_ROUTINE_FAILED;
  r->istat[GS_FAILED] = routine;
  r->istat[GS_FAILED_INFO] = info;
  r->istat[GS_N_OUTPUTS] = r->nt;   /* no state is to be looked at */
  r->rstat[GS_T_REACHED] = a->clock[GS_STEP_NOW];
  gs_tell_failure (&a->parts->whole);
  return 1;
}

int
gs_step_event (gs_stepped_run *a, int k)
{
  const gs_scene *s = a->parts->whole.d->scene;
  const gs_real t = a->clock[GS_STEP_NOW];
  gs_run_result *r = &a->r;
  int *ie = r->ip + r->ip[GS_EVENTS] - 1;
  int info = gs_inputs_of_run (s, t, 1, a->x, s->nx, r->ip, r->rp, r->cst, a->v, a->w);
  if (info != 0)
    return gs_step_failed (a, GS_AT_INPUTS, info);
  const gs_events e = gs_planned_events (s->nx, r->ip, r->rp);
  for (int i = 0; i < s->nev && k < 0; i++)
    e.fresh[i] = 0;
  info = gs_resolve_event (s, t, a->x, s->nx, a->v, r->cst, k, ie,
                           r->rp + r->ip[GS_EVENTS + 1] - 1);
  if (info != 0)
    return gs_step_failed (a, GS_AT_EVENT, info);
  ie[4] = 1;
  gs_step_tally (a);
  return 0;
}

int
gs_step_jump (gs_stepped_run *a)
{
  const gs_scene *s = a->parts->whole.d->scene;
  gs_run_result *r = &a->r;
  gs_event_before_sample (s, a->clock[GS_STEP_NOW], a->x, s->nx, r->ip, r->rp, r->cst, a->v, a->w,
                          r->istat);
  return gs_step_event (a, -1);
}

/* ---------------------------------------------------------------------------------------- steps */

static void
arrive (gs_stepped_run *a, gs_real t)
{
  gs_copy (a->r.nx, a->r.x, a->x);
  a->clock[GS_STEP_NOW] = t;
}

/* from the time now to t, the end of a step of the host of the length h, or to the next event of
 * the user */
static int
run_to (gs_stepped_run *a, gs_real t, gs_real h)
{
  gs_whole_run *w = &a->parts->whole;
  const gs_real end = end_of_run (a, t);
  w->ropt[0] = a->clock[GS_STEP_NEXT];
  w->ropt[1] = a->clock[GS_STEP_RTOL];
  gs_integration run = gs_prepared_run (w);
  run.tout = &end;
  run.beyond = gs_step_beyond (a, t, h);
  gs_integrate_by (w, w->d->scene, &run);
  if (a->r.info != GS_DONE && a->r.info != GS_ENDED)
    {
      gs_tell_failure (w);
      return 1;
    }
  if (! w->fixed)
    a->clock[GS_STEP_NEXT] = a->r.rstat[GS_H_NEXT];
  gs_step_keep (a, &run.last);
  arrive (a, a->r.info == GS_DONE ? t : a->r.rstat[GS_T_REACHED]);
  a->r.info = GS_DONE;
  gs_step_tally (a);
  return 0;
}

/* Through the part of the last step that is later than now, to t or to its end; is t reached? Where
 * the step ends at t itself and there are events of the user it is as if it had never been: one may
 * lie there. */
static int
go_ahead (gs_stepped_run *a, gs_real t)
{
  const gs_real last = a->clock[GS_STEP_AHEAD] + a->clock[GS_STEP_AHEAD_LENGTH];
  if (! (a->clock[GS_STEP_AHEAD_LENGTH] > 0))
    return 0;
  const int reached = t <= last + 8 * gs_epsilon () * gs_abs (last);   /* as samples are met */
  const gs_real end = reached ? t : last;
  if (a->parts->nown > 0 && reached && t + rounding (a, t) > last)
    {
      a->clock[GS_STEP_AHEAD_LENGTH] = 0;
      return 0;
    }
  if (gs_step_within (a, end) != 0)
    {
      gs_step_forget (a);
      return 0;
    }
  arrive (a, end);
  if (! reached)
    a->clock[GS_STEP_AHEAD_LENGTH] = 0;
  return reached;
}

/* can it go on to that time? */
static int
check_time (gs_stepped_run *a, gs_real until)
{
  const gs_real now = a->clock[GS_STEP_NOW], stop = a->clock[GS_STEP_STOP];
  if (*a->ended > 0)
    return gs_refuse (&a->r, GS_REFUSED_TIME, "", "an event has ended the run at t = %.15g s",
                      (double)now);
  if (! (until > now && until <= GS_HUGE))
    return gs_refuse (&a->r, GS_REFUSED_TIME, "",
                      "expected a time after t = %.15g s; found %.15g s", (double)now,
                      (double)until);
  if (until > stop + GS_R (1e-9) * (1 + gs_abs (stop)))
    return gs_refuse (&a->r, GS_REFUSED_TIME, "",
                      "a step to t = %.15g s, but the experiment stops at %.15g s", (double)until,
                      (double)stop);
  return 0;
}

int
gs_step_on (gs_stepped_run *a, gs_real until)
{
  gs_real t = until;
  const gs_real h = t - a->clock[GS_STEP_NOW], stop = a->clock[GS_STEP_STOP];
  a->r.refused = a->r.info = 0;
  a->r.text[0] = 0;
  if (check_time (a, t) || (! *a->parts->checked && gs_step_check (a)))
    return 1;
  sample_near (a, &t, h);
  if (gs_abs (stop - t) <= GS_R (1e-9) * h)
    t = stop;
  if (*a->parts->quiet < 2)
    (*a->parts->quiet)++;
  if (go_ahead (a, t))
    return 0;
  int failed = a->parts->nown > 0 && gs_step_jump (a);
  while (! failed && a->clock[GS_STEP_NOW] < t - rounding (a, t) && *a->ended == 0)
    failed = run_to (a, t, h);
  return failed;
}

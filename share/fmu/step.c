/* step.c: a communication step of co-simulation, by the integrator of Dormand and Prince of the run
 * time (gs_integrate) or by the method of the FMU (radau.c), with projection onto the constraints,
 * events and samples. */
#include "fmu.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { GSF_MOST_STEPS = 10000000 };

static int
failed (gsf_instance *a, const gs_integration *run, int info, const char *said)
{
  gsf_run_failed (a, info, run->istat, run->rstat[GS_T_REACHED], said);
  const size_t n = strlen (a->text);
  if (info == GS_TOO_MANY)
    snprintf (a->text + n, sizeof a->text - n, ": %d in a communication step of an FMU; take "
              "shorter ones", GSF_MOST_STEPS);
  if (info > 0 && gs_not_finite (a->m->scene->nx, run->xout) == 0)
    gsf_outside (a, run->rstat[GS_T_REACHED], run->xout, run->vout);
  return GSF_ERROR;
}

/* the options of a run */
static void
options (gsf_instance *a)
{
  const gsf_model *m = a->m;
  const gs_scene *s = m->scene;
  int *iopt = a->iopt;
  iopt[GS_METHOD] = m->integrate ? 0 : 8;
  iopt[GS_LOOPS] = s->prj ? 2 : 1;
  iopt[GS_DRIFT] = s->con != 0;
  iopt[GS_MOST_STEPS] = GSF_MOST_STEPS;
  iopt[GS_WATCH] = s->nlam > 0 && s->con && s->kin;
  iopt[GS_ON_SPEEDS] = m->nspeedrows;
  for (int k = 0; k < m->nspeedrows; k++)
    iopt[6 + k] = m->speedrows[k];
  for (int k = 0; k < s->nx; k++)
    a->atol[k] = a->d[GSF_TOLERANCE] * m->nominal[k];
}

/* the state after a step; other coordinates where these are near the end of their range */
static void
arrive (gsf_instance *a, double t)
{
  double range, normal;
  gs_copy (a->m->scene->nx, a->xout, a->x);
  a->d[GSF_T] = t;
  gsf_next_switch (a);
  a->known = 0;
  if (a->m->scene->nlam > 0 && gsf_margins (a, &range, &normal))
    gsf_choose (a);
  gsf_take (a);
}

int
gsf_can_step (gsf_instance *a, double t, double h)
{
  const double now = a->d[GSF_T];
  gsf_hide_samples (a);
  if (! (fabs (t - now) <= 1e-9 * (1 + fabs (now))))
    return gsf_fail (a, GSF_ERROR, "a step begins where the last one ended, at t = %.15g s; found "
                     "t = %.15g s", now, t);
  if (a->i[GSF_ENDED] > 0)
    return gsf_ended (a, GSF_ERROR);
  if (! (h > 0 && h <= 1e300))
    return gsf_fail (a, GSF_ERROR, "expected a step above 0; found %g s", h);
  if (t + h > a->d[GSF_T1] + 1e-9 * (1 + fabs (a->d[GSF_T1])))
    return gsf_fail (a, GSF_ERROR, "a step to t = %.15g s, but the experiment stops at %.15g s",
                     t + h, a->d[GSF_T1]);
  return GSF_OK;
}

/* communication points are sums of steps: an event of the user that lies this near to one has
 * happened there */
static double
rounding (const gsf_instance *a, double t)
{
  return a->m->nown > 0 ? 16 * gs_epsilon () * fabs (t) : 0;
}

/* the end of a run to the communication point t: a little behind it, but not behind a sample, which
 * belongs to the next step */
static double
end_of_run (const gsf_instance *a, double t)
{
  return gsf_sample_near (a, &t, 0) ? t : t + rounding (a, t);
}

/* from the time that is reached to t, the end of a communication step of the length h, or to the
 * next event of the user */
static int
run_on (gsf_instance *a, double t, double h)
{
  const gs_scene *s = a->m->scene;
  const double ropt[3] = { a->d[GSF_H], a->d[GSF_TOLERANCE], 0 }, end = end_of_run (a, t);
  gs_integration run;
  memset (&run, 0, sizeof run);
  run.nx = run.ldx = s->nx;
  run.t0 = a->d[GSF_T];
  run.x0 = a->x;
  run.nt = 1;
  run.tout = &end;
  run.iopt = a->iopt;
  run.ropt = ropt;
  run.atol = a->atol;
  run.ip = a->ip;
  run.rp = a->rp;
  run.cst = a->cst;
  run.xout = a->xout;
  run.vout = a->vout;
  run.ldv = s->nv > 1 ? s->nv : 1;
  run.w = a->w;
  run.lw = gs_room (s, s->nx, 0);
  run.beyond = gsf_beyond (a, t, h);
  char said[400] = "";
  int info = a->m->integrate ? a->m->integrate (s, &run, said, sizeof said)
                             : gs_integrate (s, &run);
  if (info != GS_DONE && info != GS_ENDED)
    return failed (a, &run, info, said);
  a->d[GSF_H] = run.rstat[GS_H_NEXT];
  gsf_keep (a, &run.last);
  arrive (a, info == GS_DONE ? t : run.rstat[GS_T_REACHED]);
  return GSF_OK;
}

/* through the step that goes beyond the time, to t or to its end; is t reached? Where the step ends
 * at t itself and there are events of the user it is as if it had never been: one may lie there */
static int
go_ahead (gsf_instance *a, double t)
{
  if (! (a->d[GSF_AHEAD_H] > 0))
    return 0;
  const int reached = gsf_reaches (a, t);
  const double last = a->d[GSF_AHEAD_T] + a->d[GSF_AHEAD_H], end = reached ? t : last;
  if (a->m->nown > 0 && reached && t + rounding (a, t) > last)
    {
      a->d[GSF_AHEAD_H] = 0;
      return 0;
    }
  if (! gsf_look (a, end))
    {
      gsf_forget (a);
      return 0;
    }
  arrive (a, end);
  if (! reached)
    a->d[GSF_AHEAD_H] = 0;
  return reached;
}

int
gsf_begin_step (gsf_instance *a)
{
  int istat[GS_COUNTED] = { 0 };
  gs_event_before_sample (a->m->scene, a->d[GSF_T], a->x, a->m->scene->nx, a->ip, a->rp, a->cst,
                          a->v, a->w, istat);
  a->known = 0;
  return gsf_happens (a, -1);
}

int
gsf_step (gsf_instance *a, double t)
{
  const double h = t - a->d[GSF_T];
  gsf_hide_samples (a);
  gsf_sample_near (a, &t, h);                /* sums of steps that are a sample, */
  if (fabs (a->d[GSF_T1] - t) <= 1e-9 * h)   /* the stop time */
    t = a->d[GSF_T1];
  options (a);
  if (a->i[GSF_QUIET] < 2)
    a->i[GSF_QUIET]++;
  if (go_ahead (a, t))
    return gsf_watch (a);
  int status = a->m->nown > 0 ? gsf_begin_step (a) : GSF_OK;
  while (status == GSF_OK && a->d[GSF_T] < t - rounding (a, t) && a->i[GSF_ENDED] == 0)
    {
      status = run_on (a, t, h);
      gsf_tally (a);
    }
  return status ? status : gsf_watch (a);
}

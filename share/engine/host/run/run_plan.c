/* run_plan.c: the inputs of a run, its sampled devices and events as a plan; times at which inputs
 * may jump. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/limits.h"
#include "gsmbp/refusals.h"
#include "host/run/run_parts.h"

static int
by_time (const void *a, const void *b)
{
  const gs_real x = *(const gs_real *)a, y = *(const gs_real *)b;
  return (x > y) - (x < y);
}

/* the breaks of a piecewise polynomial but its ends, behind those that are there */
static void
add_breaks (gs_whole_run *w, const gs_pieces *p)
{
  for (int k = 1; k < p->np; k++)
    w->jumps[w->njumps++] = p->numbers[k];
}

/* ... and the times at which the scene switches */
static void
add_switches (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  if (s->nsw > 0)
    s->swi (w->r->cst, w->jumps + w->njumps);
  w->njumps += s->nsw;
}

/* K times sorted, each once: how many these are */
static int
each_once (gs_real *times, int k)
{
  int n = 0;
  qsort (times, (size_t)k, sizeof *times, by_time);
  for (int i = 0; i < k; i++)
    if (n == 0 || times[i] > times[n - 1])
      times[n++] = times[i];
  return n;
}

/* the times at which inputs jump, those within the run; then with those at which the scene
 * switches, where gs_integrate stops by itself */
static int
find_breaks (gs_whole_run *w)
{
  const gs_run_inputs *in = w->in;
  const gs_pieces *all[] = { &in->table, &in->motion, &in->reference, &in->gain };
  const gs_real t0 = w->s->times[0], end = w->s->times[w->s->nt - 1];
  int many = in->nbreaks + w->d->scene->nsw;
  for (int k = 0; k < 4; k++)
    many += all[k]->np;
  w->jumps = malloc (2 * (size_t)(many + 1) * sizeof *w->jumps);
  if (! w->jumps)
    return 1;
  w->breaks = w->jumps + many + 1;
  for (int k = 0; k < 4; k++)
    add_breaks (w, all[k]);
  for (int k = 0; k < in->nbreaks; k++)
    w->jumps[w->njumps++] = (gs_real)in->breaks[k];
  w->njumps = each_once (w->jumps, w->njumps);
  for (int k = 0; k < w->njumps; k++)
    if (w->jumps[k] > t0 && w->jumps[k] < end)
      w->breaks[w->nb++] = w->jumps[k];
  add_switches (w);
  w->njumps = each_once (w->jumps, w->njumps);
  return 0;
}

/* in the place of a mode, among all inputs, is 0 or the mode that is given */
static int
no_mode_given (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  for (int k = 0; k < s->nev && w->in->constants; k++)
    {
      const int at = s->event_inputs[k] - 1;
      const int wanted = w->s->modes ? w->s->modes[k] : 0;
      const double found = at < 0 ? 0 : (double)w->in->constants[at];
      if (at >= 0 && found != 0 && ! (found >= wanted && found <= wanted))
        return gs_refuse (w->r, GS_REFUSED_OPTION, "", gs_refusals.given_mode, w->d->events[k],
                          found);
    }
  return 0;
}

/* places for outputs on their way, and instants that are recorded, of n devices with these periods
 * and delays */
static int
count_samples (gs_whole_run *w, int n, const double *period)
{
  const double t0 = (double)w->s->times[0], end = (double)w->s->times[w->s->nt - 1];
  for (int k = 0; k < n; k++)
    if (period[k] > 0 && fmax (fabs (t0), fabs (end)) / period[k] > gs_limits.fixed_steps)
      return gs_refuse (w->r, GS_REFUSED_SAMPLES, "", "more than 2e9 samples");
  const int own = gs_pending (n, period, period + n);
  w->plan.on_the_way = own > w->pending ? own : w->pending;
  w->plan.instants = w->o->samples ? (int)gs_instants (n, period, period + n, end - t0) : 0;
  return 0;
}

static int
plan_samples (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  const int n = s->nctl;
  int fails = 0;
  if (n == 0)
    return 0;
  gs_real *both = malloc (2 * (size_t)n * sizeof *both);
  double *period = malloc (2 * (size_t)n * sizeof *period);
  if (both && period)
    {
      s->ctp (w->r->cst, both, both + n);
      for (int k = 0; k < 2 * n; k++)
        period[k] = (double)both[k];
      fails = count_samples (w, n, period);
    }
  else
    fails = gs_refuse (w->r, GS_REFUSED_START, "", "there was no memory for the plan");
  free (both);
  free (period);
  return fails;
}

static int
plan_events (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  if (s->nev == 0)
    return 0;
  w->plan.events = (int)gs_limits.recorded_events;
  w->plan.modes = w->s->modes;
  return no_mode_given (w);
}

int
gs_lay_inputs (gs_whole_run *w)
{
  const gs_run_inputs *in = w->in;
  const gs_scene *s = w->d->scene;
  if (in->kind == 2 && gs_lacks (w, s->cmd != NULL, "the run", "cmd"))
    return 1;
  if (in->kind == 3 && gs_lacks (w, in->function || s->vin, "the run", "vin"))
    return 1;
  if (w->o->audit > 0 && in->gain.np > 0)
    return gs_refuse (w->r, GS_REFUSED_OPTION, "audit", "%s",
                      "no audit with state feedback from outside");
  w->plan = (gs_plan){
    .s = s, .nx = w->r->nx, .inputs = in->kind, .derivatives = w->d->order,
    .constants = in->constants, .table = in->table, .motion = in->motion, .planned = in->planned,
    .reference = in->reference, .gain = in->gain, .limits = in->limits, .memory = w->s->memory
  };
  if (find_breaks (w))
    return gs_refuse (w->r, GS_REFUSED_START, "", "there was no memory for the plan");
  return plan_samples (w) || plan_events (w);
}

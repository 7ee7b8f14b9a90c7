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

/* all times at which inputs jump, rising, and those within the run */
static int
find_breaks (gs_whole_run *w)
{
  const gs_run_inputs *in = w->in;
  const gs_pieces *all[] = { &in->table, &in->motion, &in->reference, &in->gain };
  const gs_real t0 = w->s->times[0], end = w->s->times[w->s->nt - 1];
  int many = in->nbreaks;
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
  qsort (w->jumps, (size_t)w->njumps, sizeof *w->jumps, by_time);
  int n = 0;
  for (int k = 0; k < w->njumps; k++)
    if (n == 0 || w->jumps[k] > w->jumps[n - 1])
      w->jumps[n++] = w->jumps[k];
  w->njumps = n;
  for (int k = 0; k < n; k++)
    if (w->jumps[k] > t0 && w->jumps[k] < end)
      w->breaks[w->nb++] = w->jumps[k];
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

/* outputs that may be on their way and instants that are recorded */
static int
plan_samples (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  const int n = s->nctl;
  if (n == 0)
    return 0;
  gs_real *both = malloc (2 * (size_t)n * sizeof *both);
  double *period = malloc (2 * (size_t)n * sizeof *period);
  if (both && period)
    {
      s->ctp (w->r->cst, both, both + n);
      for (int k = 0; k < 2 * n; k++)
        period[k] = (double)both[k];
      const double span = (double)(w->s->times[w->s->nt - 1] - w->s->times[0]);
      w->plan.on_the_way = gs_pending (n, period, period + n);
      w->plan.instants
          = w->o->samples ? (int)gs_instants (n, period, period + n, span) : 0;
    }
  const int fails = ! both || ! period;
  free (both);
  free (period);
  return fails ? gs_refuse (w->r, GS_REFUSED_START, "", "there was no memory for the plan") : 0;
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
  if (in->kind == 2 && ! s->cmd)
    return gs_refuse (w->r, GS_REFUSED_ROUTINE, "cmd", "the run needs it");
  w->plan = (gs_plan){
    .s = s, .nx = w->r->nx, .inputs = in->kind, .derivatives = w->d->order,
    .constants = in->constants, .table = in->table, .motion = in->motion, .planned = in->planned,
    .reference = in->reference, .gain = in->gain, .limits = in->limits, .memory = w->s->memory
  };
  if (find_breaks (w))
    return gs_refuse (w->r, GS_REFUSED_START, "", "there was no memory for the plan");
  return plan_samples (w) || plan_events (w);
}

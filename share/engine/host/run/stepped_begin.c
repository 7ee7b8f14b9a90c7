/* stepped_begin.c: a stepped run: its memory, its start. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/expressions.h"
#include "host/run/run_parts.h"

/* places for pending outputs of each sampled device; records of events of the user: those that are
 * kept, and as many as an instant may have */
enum { PENDING = 32, KEPT = 32, RECORDS = KEPT + 104 };

/* ----------------------------------------------------------------------------------------- plan */

/* inputs are constant within a step */
static gs_plan
plan_of (const gs_stepped_run *a, const gs_real *inputs, const gs_real *memory)
{
  const gs_description *d = a->parts->whole.d;
  return (gs_plan){ .s = d->scene, .nx = d->scene->nx, .derivatives = d->order,
                    .constants = inputs, .memory = memory, .modes = a->s.modes,
                    .on_the_way = d->scene->nctl * PENDING,
                    .events = a->parts->nown > 0 ? RECORDS : 0 };
}

/* the plan with the inputs that are set; gs_integrate comes back at each event of the user */
static void
lay (gs_stepped_run *a)
{
  const gs_scene *s = a->parts->whole.d->scene;
  gs_copy (s->nv, a->inputs, a->v);
  const gs_plan p = plan_of (a, a->v, a->s.memory);
  memset (a->r.ip, 0, (size_t)gs_wholes (&p) * sizeof (int));
  gs_zero (gs_reals (&p), a->r.rp);
  gs_lay (&p, a->r.ip, a->r.rp);
  if (a->parts->nown == 0)
    return;
  const gs_events e = gs_planned_events (s->nx, a->r.ip, a->r.rp);
  *e.tells = 2;
  for (int k = 0; k < s->nev; k++)
    if (gs_is_own (&e, k))
      e.kind[k] = 4;
}

void
gs_step_tally (gs_stepped_run *a)
{
  const gs_scene *s = a->parts->whole.d->scene;
  if (a->parts->nown == 0)
    return;
  const gs_events e = gs_planned_events (s->nx, a->r.ip, a->r.rp);
  const int row = 3 + 2 * s->nx;
  for (int j = 0; j < *e.count; j++)
    {
      gs_real *r = e.record + j * row;
      const int k = (int)r[1] - 1;
      if (r[2] < 0)   /* counted already */
        continue;
      r[2] = -1;
      a->tally[k]++;
      a->when[k] = r[0];
      if (s->event_kinds[k] == 4 && *a->ended == 0)
        *a->ended = k + 1;
    }
  const int gone = *e.count > KEPT ? *e.count - KEPT : 0;
  gs_move ((*e.count - gone) * row, e.record + gone * row, e.record);
  *e.count -= gone;
}

/* --------------------------------------------------------------------------------------- memory */

/* the parts of the two arrays, which may be null: then their lengths are found */
static void
divide (gs_stepped_run *a, int numbers, int wholes)
{
  const gs_description *d = a->parts->whole.d;
  const gs_scene *s = d->scene;
  const gs_plan p = plan_of (a, NULL, NULL);
  const int n[] = { GS_STEP_CLOCK, s->nx, d->ncst, s->nx, s->nev, 11 * s->nx, gs_reals (&p),
                    numbers };
  const int m[] = { 1, 1, 1, s->nev, gs_wholes (&p), wholes };
  gs_real **const number[] = { &a->clock, &a->x, &a->r.cst, &a->r.atol, &a->when, &a->parts->ahead,
                               &a->r.rp, &a->own };
  int **const whole[] = { &a->ended, &a->parts->quiet, &a->parts->checked, &a->tally, &a->r.ip,
                          &a->own_wholes };
  a->nnumbers = a->nwholes = 0;
  for (int k = 0; k < 8; k++)
    {
      *number[k] = a->numbers ? a->numbers + a->nnumbers : NULL;
      a->nnumbers += (size_t)n[k];
    }
  for (int k = 0; k < 6; k++)
    {
      *whole[k] = a->wholes ? a->wholes + a->nwholes : NULL;
      a->nwholes += (size_t)m[k];
    }
  a->inputs = a->r.rp;
}

static int
make_room (gs_stepped_run *a, int numbers, int wholes)
{
  const gs_scene *s = a->parts->whole.d->scene;
  gs_whole_run *w = &a->parts->whole;
  w->lw = gs_room (s, s->nx, w->d->order);
  divide (a, numbers, wholes);
  a->numbers = calloc (a->nnumbers, sizeof (gs_real));
  a->wholes = calloc (a->nwholes, sizeof (int));
  w->iopt = calloc ((size_t)(GS_ON_SPEEDS + 1 + w->d->nspeedrows), sizeof (int));
  a->w = calloc ((size_t)(w->lw + s->nx + 3 * s->nv + 2), sizeof (gs_real));
  if (! a->numbers || ! a->wholes || ! w->iopt || ! a->w)
    return gs_refuse (&a->r, GS_REFUSED_START, "", "there was no memory for the run");
  divide (a, numbers, wholes);
  w->w = a->w;
  w->atol = a->r.atol;
  w->x0 = a->x;
  a->r.x = a->w + w->lw;
  a->r.v = a->r.x + s->nx;
  a->v = a->r.v + s->nv + 1;
  return 0;
}

int
gs_step_open (gs_stepped_run *a, const gs_description *d, int numbers, int wholes)
{
  const gs_run_options o = a->o;
  *a = (gs_stepped_run){ .o = o };
  a->r = (gs_run_result){ .nx = d->scene->nx, .nt = 1, .ldv = gs_most (1, d->scene->nv) };
  a->parts = calloc (1, sizeof *a->parts);
  if (! a->parts)
    return gs_refuse (&a->r, GS_REFUSED_START, "", "there was no memory for the run");
  gs_whole_run *w = &a->parts->whole;
  *w = (gs_whole_run){ .d = d, .o = &a->o, .s = &a->s, .r = &a->r };
  for (int k = 0; k < d->scene->nev; k++)
    a->parts->nown += d->scene->event_kinds[k] > 2;
  if (o.ncolumns > 0 || o.audit > 0)
    return gs_refuse (&a->r, GS_REFUSED_COLUMNS, o.audit > 0 ? "audit" : "sensitivity",
                      "a run that its host continues has none");
  if (make_room (a, numbers, wholes))
    return 1;
  a->s = (gs_run_start){ .nt = 1, .times = a->clock };
  return gs_choose_method (w) || gs_choose_loops (w);
}

void
gs_step_close (gs_stepped_run *a)
{
  free (a->numbers);
  free (a->wholes);
  free (a->w);
  if (a->parts)
    free (a->parts->whole.iopt);
  free (a->parts);
  a->numbers = a->w = NULL;
  a->wholes = NULL;
  a->parts = NULL;
}

/* ---------------------------------------------------------------------------------------- start */

/* periods, delays and first samples */
static int
begin_samples (gs_stepped_run *a)
{
  const gs_scene *s = a->parts->whole.d->scene;
  gs_start found;
  if (gs_check_samples (a->parts->whole.d, a->clock[GS_STEP_NOW], a->r.cst, a->r.ip, a->r.rp,
                        &found)
      != GS_START_TAKEN)
    return gs_refuse (&a->r, GS_REFUSED_SAMPLES, "", "%s", found.text);
  if (s->nctl == 0)
    return 0;
  const gs_samples plan = gs_planned_samples (s, a->r.ip, a->r.rp);
  for (int i = 0; i < s->nctl; i++)
    if (! (plan.delay[i] <= (PENDING - 2) * plan.period[i]))
      return gs_refuse (&a->r, GS_REFUSED_SAMPLES, "",
                        "sampled device %d: expected a delay of at most %d periods; found %g s and "
                        "a period of %g s", i + 1, PENDING - 2, (double)plan.delay[i],
                        (double)plan.period[i]);
  return 0;
}

/* modes of the ports, and functions of the user as where a run begins; none of these has had an
 * event yet */
static int
begin_events (gs_stepped_run *a)
{
  const int nev = a->parts->whole.d->scene->nev;
  if (nev == 0)
    return 0;
  const gs_events e = gs_planned_events (a->r.nx, a->r.ip, a->r.rp);
  a->r.ip[a->r.ip[GS_EVENTS] + 3] = a->s.modes != NULL;
  *e.since = 0;
  for (int k = 0; k < nev; k++)
    e.mode[k] = a->s.modes ? a->s.modes[k] : 0;
  const int failed = gs_step_event (a, 0);
  for (int k = 0; k < nev; k++)
    {
      a->tally[k] = 0;
      a->when[k] = a->clock[GS_STEP_NOW];
    }
  *a->ended = 0;
  return failed;
}

int
gs_step_begin (gs_stepped_run *a, const gs_run_start *s)
{
  gs_whole_run *w = &a->parts->whole;
  const gs_start_given g = { .t = s->times[0], .cst = a->r.cst, .par = s->par,
                             .check = ! a->o.project, .modes = s->modes };
  a->r.refused = a->r.info = 0;
  a->r.text[0] = a->r.warning[0] = 0;
  a->clock[GS_STEP_STOP] = s->nt > 1 ? s->times[s->nt - 1] : GS_HUGE;
  a->clock[GS_STEP_NOW] = s->times[0];
  a->s = *s;
  a->s.times = a->clock;   /* which stay: the time now and the stop */
  a->s.nt = s->nt > 1 ? 2 : 1;
  gs_move (a->r.nx, s->x0, a->x);
  if (gs_choose_method (w) || gs_choose_tolerances (w) || gs_set_loop_method (w))
    return 1;
  a->clock[GS_STEP_RTOL] = w->ropt[1];
  a->clock[GS_STEP_NEXT] = w->ropt[0];
  *a->parts->checked = 0;
  gs_step_forget (a);
  lay (a);
  if (gs_close_start (w->d, &g, a->x, &a->r.start) != GS_START_TAKEN)
    return gs_refuse (&a->r, GS_REFUSED_START, "", "%s", a->r.start.text);
  return begin_samples (a) || begin_events (a);
}

int
gs_step_settle (gs_stepped_run *a, const int *given)
{
  gs_settle_states (a->parts->whole.d, a->clock[GS_STEP_NOW], a->r.cst, given, a->x);
  return begin_events (a);
}

int
gs_step_check (gs_stepped_run *a)
{
  gs_whole_run *w = &a->parts->whole;
  const gs_scene *s = w->d->scene;
  const gs_real t = a->clock[GS_STEP_NOW];
  const gs_start_given g = { .t = t, .cst = a->r.cst, .par = a->s.par, .v = a->v,
                             .modes = a->s.modes };
  const int info = gs_inputs_of_run (s, t, 1, a->x, s->nx, a->r.ip, a->r.rp, a->r.cst, a->v, a->w);
  *a->parts->checked = 1;
  if (info != 0)
    return gs_step_failed (a, GS_AT_INPUTS, info);
  if (gs_check_margins (w->d, &g, a->x, &a->r.start) == GS_START_TAKEN
      && gs_check_stops (w->d, &g, a->x, &a->r.start) == GS_START_TAKEN)
    return 0;
  return gs_refuse (&a->r, GS_REFUSED_START, "", "%s", a->r.start.text);
}

/* Collocation of Gauss of the orders 4, 6 and 8 with a fixed step, as a method of implicit.c: for
   long runs that keep their energy.

   The stages are found by fixed-point iteration, until their changes are rounding and no longer
   fall; the first guess is the polynomial of the step before.  The state is kept with what rounding
   took from it (compensated summation), weights are of longer numbers, so that errors of rounding
   are not systematic (Hairer, McLachlan, Razakarivony, Achieving Brouwer's law with implicit
   Runge-Kutta methods, BIT 48, 2008).  Whole steps lead to every output time, break and sample.

   Where they can be had the steps are those of coordinates and momenta (gauss_momenta.c), which
   are symplectic; those of the states are symmetric in time. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "gauss_momenta.h"
#include "gauss_rule.h"
#include "implicit_run.h"

enum { TURNS = 100 };

typedef struct
{
  int n;
  gauss_rule rule;
  gs_momenta *momenta;          /* if the steps are those of coordinates and momenta */
  double *k, *old, *x, *size;   /* rates of the stages, of the turn before; a state; usual sizes */
  double *lost, *before;        /* what rounding took from the state, and did before the step */
  double *start;                /* the state where the last step began */
  double from, to;              /* the way that whole steps of H lead along, */
  double steps, done;           /* ... how many there are, how many are done, */
  double at;                    /* ... and where the last one ended */
  int known;                    /* is there a step before, of the same length? */
  int turns;
} gauss;

/* ------------------------------------------------------------
 * one step */

/* the first guess of the rates: the polynomial of the step before, or the rate at the state */
static int
predict (gs_stepper *s)
{
  gauss *w = s->memory;
  int n = w->n, info = 0;
  double *before = w->old;
  gs_copy (n * w->rule.stages, w->k, before);
  if (! w->known && (info = gs_rate (s, s->t, s->x, before)) != 0)
    return info;
  for (int i = 0; i < w->rule.stages; i++)
    for (int l = 0; l < n; l++)
      {
        longer sum = w->known ? 0 : before[l];
        for (int j = 0; w->known && j < w->rule.stages; j++)
          sum += w->rule.ahead[i][j] * before[l + n * j];
        w->k[l + n * i] = (double) sum;
      }
  return 0;
}

/* state I of the stages, from the rates of the turn before */
static void
stage (const gs_stepper *s, int i, double h)
{
  gauss *w = s->memory;
  for (int l = 0; l < w->n; l++)
    {
      longer sum = 0;
      for (int j = 0; j < w->rule.stages; j++)
        sum += w->rule.a[i][j] * w->old[l + w->n * j];
      w->x[l] = (double) (s->x[l] + (w->lost[l] + h * sum));
    }
}

/* one turn of the iteration; CHANGE: the largest change of a state, beside its usual size */
static int
turn (gs_stepper *s, double h, double *change)
{
  gauss *w = s->memory;
  int n = w->n, info;
  *change = 0;
  gs_copy (n * w->rule.stages, w->k, w->old);
  for (int i = 0; i < w->rule.stages; i++)
    {
      stage (s, i, h);
      if ((info = gs_rate (s, s->t + (double) w->rule.c[i] * h, w->x, w->k + n * i)) != 0)
        return info;
      for (int l = 0; l < n; l++)
        *change = fmax (*change, h * fabs (w->k[l + n * i] - w->old[l + n * i]) / w->size[l]);
    }
  return 0;
}

static int
no_end (gs_stepper *s)
{
  snprintf (s->o->text, s->o->length, "%s",
            "the iteration does not end: take a shorter step, or radau for a stiff scene");
  return -2;
}

/* the rates of the stages; below zero where the iteration does not end */
static int
solve (gs_stepper *s, double h)
{
  gauss *w = s->memory;
  gs_settling so_far = { HUGE_VAL, 0 };
  double change;
  int info = predict (s);
  for (int i = 0; info == 0 && i < TURNS; i++)
    {
      info = turn (s, h, &change);
      w->turns++;
      if (info == 0 && gs_settled (&so_far, change))
        return 0;
    }
  return info < 0 ? -1 : no_end (s);
}

/* X at the end, and what rounding took from it */
static void
sum_up (gs_stepper *s, double h)
{
  gauss *w = s->memory;
  for (int l = 0; l < w->n; l++)
    {
      longer sum = 0;
      for (int j = 0; j < w->rule.stages; j++)
        sum += w->rule.b[j] * w->k[l + w->n * j];
      gs_round_off (s->x[l] + (w->lost[l] + h * sum), &w->x[l], &w->lost[l]);
    }
}

/* the state at T on the constraints: completed from the independent coordinates, or moved; what
 * has changed has lost nothing */
static int
on_constraints (gs_stepper *s, double t)
{
  gauss *w = s->memory;
  double *on = w->old;
  int info = gs_completes (s) ? gs_completed (s, t, w->x, on)
             : gs_projects (s) ? gs_moved (s, t, w->x, on)
             : 0;
  if (info != 0 || ! (gs_completes (s) || gs_projects (s)))
    return info;
  for (int l = 0; l < w->n; l++)
    if (on[l] != w->x[l])
      {
        w->x[l] = on[l];
        w->lost[l] = 0;
      }
  return 0;
}

/* ------------------------------------------------------------
 * the method */

/* the next way: to the stop or the next output time, in whole steps; not to one that is only just
 * behind an event (that of the event in another run): it lies within the first step */
static void
next_way (gs_stepper *s)
{
  gauss *w = s->memory;
  gs_integration *r = s->r;
  double to = s->stop, h = r->ropt[2] > 0 ? fmin (r->ropt[0], r->ropt[2]) : r->ropt[0];
  int k = r->istat[GS_N_OUTPUTS];
  while (k < r->nt && r->tout[k] - s->t < 1e-6 * h)
    k++;
  if (k < r->nt && r->tout[k] < to)
    to = r->tout[k];
  w->from = s->t;
  w->to = to;
  w->done = 0;
  w->at = s->t;
  w->steps = fmax (1, ceil ((to - s->t) / h * (1 - 1e-9)));
}

static int
step_of_states (gs_stepper *s, double h, double t)
{
  gauss *w = s->memory;
  if (fabs (h - s->h) > 1e-9 * h)
    w->known = 0;
  gs_copy (w->n, w->lost, w->before);
  int flag = solve (s, h);
  if (flag != 0)
    return flag;
  sum_up (s, h);
  w->known = 1;
  return on_constraints (s, t) != 0 ? -1 : 0;
}

/* the step H to T */
static int
step_to (gs_stepper *s, double h, double t)
{
  gauss *w = s->memory;
  int flag = w->momenta ? gs_momenta_step (s, w->momenta, h, t, w->x) : step_of_states (s, h, t);
  if (flag == -1 && s->r->istat[GS_FAILED] == GS_AT_NOTHING)
    snprintf (s->o->text, s->o->length, "there are no rates at a stage: take a shorter step");
  if (flag != 0)
    return flag == GS_NO_END ? no_end (s) : flag;
  gs_copy (w->n, s->x, w->start);
  s->t = t;
  s->h = s->next = h;
  s->y = w->x;
  return 0;
}

static int
step (gs_stepper *s)
{
  gauss *w = s->memory;
  if (w->done >= w->steps || s->t != w->at)   /* one was made again, shorter */
    next_way (s);
  double h = (w->to - w->from) / w->steps;
  w->done++;
  w->at = w->done == w->steps ? w->to : w->from + h * w->done;
  return step_to (s, h, w->at);
}

static int
again (gs_stepper *s)
{
  gauss *w = s->memory;
  double h = s->stop == w->at ? (w->to - w->from) / w->steps : s->stop - s->t;
  w->known = 0;
  if (w->momenta && gs_take_back (s, w->momenta) != 0)
    return -1;
  gs_copy (w->n, w->before, w->lost);
  return step_to (s, h, s->stop);
}

static int
restart (gs_stepper *s)
{
  gauss *w = s->memory;
  gs_zero (w->n, w->lost);
  w->known = 0;
  w->done = w->steps = 0;
  return w->momenta ? gs_restart_momenta (s, w->momenta) : 0;
}

/* are the steps those of coordinates and momenta? Where the emitted routines agree. */
static int
by_momenta (gs_stepper *s)
{
  gauss *w = s->memory;
  if (! gs_has_momenta (s))
    return 0;
  w->momenta = gs_new_momenta (s, &w->rule, w->size);
  if (! w->momenta)
    return GS_NO_MEMORY;
  if (gs_agree (s, w->momenta))
    s->p[0] = 0;   /* no coordinates are completed from others */
  else
    {
      gs_free_momenta (w->momenta);
      w->momenta = NULL;
    }
  return 0;
}

static int
begin (gs_stepper *s)
{
  gauss *w = s->memory;
  const int order = s->o->order;
  if (order != 4 && order != 6 && order != 8)
    {
      snprintf (s->o->text, s->o->length, "expected order 4, 6 or 8; found %d", order);
      return -1;
    }
  gsmbp_gauss_rule (&w->rule, s->o->order);
  if (s->p[0] == 2)
    s->p[0] = 3;   /* gs_complete_state: the partition is kept as long as it may be */
  for (int l = 0; l < w->n; l++)
    w->size[l] = s->r->ropt[1] > 0 && s->r->atol[l] > 0 ? s->r->atol[l] / s->r->ropt[1] : 1;
  int flag = by_momenta (s);
  return flag != 0 ? flag : restart (s);
}

static int
open_ (gs_stepper *s)
{
  ptrdiff_t n = s->r->nx;
  gauss *w = s->memory = gs_allocate (1, sizeof (gauss));
  if (! w)
    return 0;
  w->n = s->r->nx;
  w->k = gs_allocate ((2 * GAUSS + 5) * n, sizeof (double));
  if (! w->k)
    return 0;
  w->old = w->k + GAUSS * n;
  w->x = w->old + GAUSS * n;
  w->size = w->x + n;
  w->lost = w->size + n;
  w->before = w->lost + n;
  w->start = w->before + n;
  return 1;
}

static void
close_ (gs_stepper *s)
{
  gauss *w = s->memory;
  if (! w)
    return;
  gs_free_momenta (w->momenta);
  free (w->k);
  free (w);
}

/* events lie within steps, output times only just behind an event or a sample: there the polynomial
   of the stages */
static int
between (gs_stepper *s, double t, double *x)
{
  gauss *w = s->memory;
  longer b[GAUSS], at = 1 - (s->t - t) / s->h;
  if (w->momenta)
    return gs_momenta_between (s, w->momenta, w->start, at, x);
  gsmbp_gauss_weights (&w->rule, at, b);
  for (int l = 0; l < w->n; l++)
    {
      longer sum = 0;
      for (int j = 0; j < w->rule.stages; j++)
        sum += b[j] * w->k[l + w->n * j];
      x[l] = (double) (w->start[l] + s->h * sum);
    }
  return 0;
}

static int
rejected (gs_stepper *s)
{
  (void) s;
  return 0;
}

static void
count (gs_stepper *s)
{
  gauss *w = s->memory;
  s->r->istat[GS_N_NEWTON] += w->turns + (w->momenta ? gs_momenta_turns (w->momenta) : 0);
  w->turns = 0;
}

int
gs_gauss (const gs_scene *scene, gs_integration *run, const gs_implicit *options)
{
  static const gs_method collocation
    = { open_, close_, begin, restart, step, again, between, 0, rejected, count, 0, 0, 1 };
  return gs_implicit_run (scene, run, options, &collocation);
}

/* Collocation of Gauss of the orders 4, 6 and 8 with a fixed step, as a method of implicit.c: for
   long runs that keep their energy.

   The stages are found by fixed-point iteration, until their changes are rounding and no longer
   fall; the first guess is the polynomial of the step before.  The state is kept with what rounding
   took from it (compensated summation), weights are of longer numbers, so that errors of rounding
   are not systematic (Hairer, McLachlan, Razakarivony, Achieving Brouwer's law with implicit
   Runge-Kutta methods, BIT 48, 2008).  Whole steps lead to every output time, break and sample. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "implicit.h"

enum { MOST = 4, TURNS = 100 };
typedef long double longer;

typedef struct
{
  int n, stages;
  longer c[MOST], a[MOST][MOST], b[MOST], ahead[MOST][MOST];   /* AHEAD: from step to step */
  double *k, *old, *x, *size;   /* rates of the stages, of the turn before; a state; usual sizes */
  double *lost;                 /* what rounding took from the state */
  double from, to;              /* the way that whole steps of H lead along, */
  long steps, done;             /* ... how many there are, how many are done */
  int known;                    /* is there a step before, of the same length? */
  long turns;
} gauss;

/* ------------------------------------------------------------
 * the rule */

/* the roots of the Legendre polynomials, on [0, 1] */
static void
nodes (gauss *w)
{
  if (w->stages == 2)
    w->c[1] = sqrtl (1 / 3.0L);
  else if (w->stages == 3)
    w->c[2] = sqrtl (3 / 5.0L);
  else
    {
      w->c[2] = sqrtl ((3 - 2 * sqrtl (6 / 5.0L)) / 7);
      w->c[3] = sqrtl ((3 + 2 * sqrtl (6 / 5.0L)) / 7);
    }
  for (int i = 0; i < w->stages / 2; i++)
    w->c[i] = -w->c[w->stages - 1 - i];
  if (w->stages == 3)
    w->c[1] = 0;
  for (int i = 0; i < w->stages; i++)
    w->c[i] = (1 + w->c[i]) / 2;
}

/* coefficients of Lagrange's polynomial J, the constant first */
static void
lagrange (const gauss *w, int j, longer *p)
{
  memset (p, 0, (MOST + 1) * sizeof (longer));
  p[0] = 1;
  for (int k = 0; k < w->stages; k++)
    if (k != j)
      for (int l = w->stages - 1; l >= 0; l--)
        p[l] = ((l > 0 ? p[l - 1] : 0) - w->c[k] * p[l]) / (w->c[j] - w->c[k]);
}

static longer
value (const gauss *w, const longer *p, longer at)
{
  longer sum = 0;
  for (int l = w->stages - 1; l >= 0; l--)
    sum = sum * at + p[l];
  return sum;
}

static longer
integral (const gauss *w, const longer *p, longer to)
{
  longer sum = 0;
  for (int l = w->stages - 1; l >= 0; l--)
    sum = sum * to + p[l] / (l + 1);
  return sum * to;
}

static void
take_rule (gauss *w, int order)
{
  longer p[MOST + 1];
  w->stages = order / 2;
  nodes (w);
  for (int j = 0; j < w->stages; j++)
    {
      lagrange (w, j, p);
      w->b[j] = integral (w, p, 1);
      for (int i = 0; i < w->stages; i++)
        {
          w->a[i][j] = integral (w, p, w->c[i]);
          w->ahead[i][j] = value (w, p, 1 + w->c[i]);
        }
    }
}

/* ------------------------------------------------------------
 * one step */

/* the first guess of the rates: the polynomial of the step before, or the rate at the state */
static int
predict (gs_run *s)
{
  gauss *w = s->memory;
  int n = w->n, info = 0;
  double *before = w->old;
  memcpy (before, w->k, sizeof (double) * n * w->stages);
  if (! w->known && (info = gs_rate (s, s->t, s->x, before)) != 0)
    return info;
  for (int i = 0; i < w->stages; i++)
    for (int l = 0; l < n; l++)
      {
        longer sum = w->known ? 0 : before[l];
        for (int j = 0; w->known && j < w->stages; j++)
          sum += w->ahead[i][j] * before[l + n * j];
        w->k[l + n * i] = sum;
      }
  return 0;
}

/* state I of the stages, from the rates of the turn before */
static void
stage (const gs_run *s, int i, double h)
{
  gauss *w = s->memory;
  for (int l = 0; l < w->n; l++)
    {
      longer sum = 0;
      for (int j = 0; j < w->stages; j++)
        sum += w->a[i][j] * w->old[l + w->n * j];
      w->x[l] = s->x[l] + (w->lost[l] + h * sum);
    }
}

/* one turn of the iteration; CHANGE: the largest change of a state, beside its usual size */
static int
turn (gs_run *s, double h, double *change)
{
  gauss *w = s->memory;
  int n = w->n, info;
  *change = 0;
  memcpy (w->old, w->k, sizeof (double) * n * w->stages);
  for (int i = 0; i < w->stages; i++)
    {
      stage (s, i, h);
      if ((info = gs_rate (s, s->t + (double) w->c[i] * h, w->x, w->k + n * i)) != 0)
        return info;
      for (int l = 0; l < n; l++)
        *change = fmax (*change, h * fabs (w->k[l + n * i] - w->old[l + n * i]) / w->size[l]);
    }
  return 0;
}

/* The rates of the stages; below zero where the iteration does not end.  It ends where the changes
 * are rounding and do not fall: at once where they are tiny, else (states whose rates are
 * sensitive) after some turns without a smaller one. */
static int
solve (gs_run *s, double h)
{
  gauss *w = s->memory;
  double change, least = HUGE_VAL;
  int info = predict (s), idle = 0;
  for (int i = 0; info == 0 && i < TURNS; i++)
    {
      info = turn (s, h, &change);
      w->turns++;
      idle = change < least ? 0 : idle + 1;
      least = fmin (least, change);
      if (info == 0 && (change == 0 || (idle > 0 && least < 1e-13) || (idle > 4 && least < 1e-10)))
        return 0;
    }
  if (info < 0)
    return -1;
  snprintf (s->r->text, s->r->length, "%s",
            "the iteration does not end: take a shorter step, or radau for a stiff scene");
  return -2;
}

/* X at the end, and what rounding took from it */
static void
sum_up (gs_run *s, double h)
{
  gauss *w = s->memory;
  for (int l = 0; l < w->n; l++)
    {
      longer sum = 0;
      for (int j = 0; j < w->stages; j++)
        sum += w->b[j] * w->k[l + w->n * j];
      longer end = s->x[l] + (w->lost[l] + h * sum);
      w->x[l] = end;
      w->lost[l] = end - w->x[l];
    }
}

/* the state at T on the constraints: completed from the independent coordinates, or moved; what
 * has changed has lost nothing */
static int
on_constraints (gs_run *s, double t)
{
  gauss *w = s->memory;
  double *on = w->old;
  int info = gs_completes (s) ? gs_completed (s, t, w->x, on)
             : gs_projects (s->r) ? gs_moved (s, t, w->x, on)
             : 0;
  if (info != 0 || ! (gs_completes (s) || gs_projects (s->r)))
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

/* the next way: to the stop or the next output time, in whole steps */
static void
next_way (gs_run *s)
{
  gauss *w = s->memory;
  const gsmbp_run *r = s->r;
  double to = s->stop, h = r->ropt[2] > 0 ? fmin (r->ropt[0], r->ropt[2]) : r->ropt[0];
  if (r->istat[4] < r->nt && r->tout[r->istat[4]] < to)
    to = r->tout[r->istat[4]];
  w->from = s->t;
  w->to = to;
  w->done = 0;
  w->steps = lround (fmax (1, ceil ((to - s->t) / h * (1 - 1e-9))));
}

static int
step (gs_run *s)
{
  gauss *w = s->memory;
  if (w->done >= w->steps)
    next_way (s);
  double h = (w->to - w->from) / w->steps;
  if (fabs (h - s->h) > 1e-9 * h)
    w->known = 0;
  int flag = solve (s, h);
  if (flag != 0)
    return flag;
  sum_up (s, h);
  w->done++;
  double t = w->done == w->steps ? w->to : w->from + h * w->done;
  if (on_constraints (s, t) != 0)
    return -1;
  w->known = 1;
  s->t = t;
  s->h = s->next = h;
  s->y = w->x;
  return 0;
}

static int
restart (gs_run *s)
{
  gauss *w = s->memory;
  memset (w->lost, 0, sizeof (double) * w->n);
  w->known = 0;
  w->done = w->steps = 0;
  return 0;
}

static int
begin (gs_run *s)
{
  gauss *w = s->memory;
  take_rule (w, s->r->order);
  if (s->p[0] == 2)
    s->p[0] = 3;   /* GSPRT: the partition is kept as long as it may be */
  for (int l = 0; l < w->n; l++)
    w->size[l] = s->r->ropt[1] > 0 && s->r->atol[l] > 0 ? s->r->atol[l] / s->r->ropt[1] : 1;
  return restart (s);
}

static int
open_ (gs_run *s)
{
  size_t n = s->r->nx;
  gauss *w = s->memory = calloc (1, sizeof (gauss));
  if (! w)
    return 0;
  w->n = n;
  w->k = calloc ((2 * MOST + 3) * n, sizeof (double));
  if (! w->k)
    return 0;
  w->old = w->k + MOST * n;
  w->x = w->old + MOST * n;
  w->size = w->x + n;
  w->lost = w->size + n;
  return 1;
}

static void
close_ (gs_run *s)
{
  gauss *w = s->memory;
  if (! w)
    return;
  free (w->k);
  free (w);
}

/* no output time lies between steps */
static int
between (gs_run *s, double t, double *x)
{
  (void) t;
  memcpy (x, s->x, sizeof (double) * s->r->nx);
  return -1;
}

static long
rejected (gs_run *s)
{
  (void) s;
  return 0;
}

static void
count (gs_run *s)
{
  gauss *w = s->memory;
  s->r->istat[16] += w->turns;
  w->turns = 0;
}

int
gsmbp_gauss (const gsmbp_run *r)
{
  static const gs_method collocation
    = { open_, close_, begin, restart, step, between, rejected, count };
  return gs_implicit_run (r, &collocation);
}

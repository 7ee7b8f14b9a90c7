/* run_turns.c: events that a run with derivatives just misses, or grazes without being seen: from
 * there on it has no derivatives.
 *
 * Each place where an event function comes close to 0 and turns is looked at in a run of the states
 * alone, by a parabola through three states. These are 1e-4 s apart, less where an event is nearer:
 * beyond one the parabola says nothing. Derivatives end where the lowest value of the function is
 * within ten times what the tolerances make of it, or where one of the two runs has an event that
 * the other has not. */
#include <math.h>
#include <stdlib.h>

#include "host/run/run_parts.h"

static const double apart = 1e-4;

/* a place where event function number (from 1) turns, the distance of the states beside it [s] */
typedef struct
{
  int number;
  double t, step;
} turn;

static int
earlier (const void *a, const void *b)
{
  const double x = ((const turn *)a)->t, y = ((const turn *)b)->t;
  return (x > y) - (x < y);
}

static int
smaller (const void *a, const void *b)
{
  const gs_real x = *(const gs_real *)a, y = *(const gs_real *)b;
  return (x > y) - (x < y);
}

/* ---- events of a run */

typedef struct
{
  int n, width;
  const gs_real *record;
} events;

static events
events_of (const gs_run_result *r)
{
  const gs_events a = gs_planned_events (r->nx, r->ip, r->rp);
  return (events){ a.nr < *a.count ? a.nr : *a.count, 3 + 2 * r->nx, a.record };
}

static double
time_of (const events *e, int k)
{
  return (double)e->record[(ptrdiff_t)e->width * k];
}

static int
number_of (const events *e, int k)
{
  return (int)e->record[(ptrdiff_t)e->width * k + 1];
}

/* event k or the first one after it that changes what follows */
static int
changing_from (const gs_derivatives *d, const events *e, int k)
{
  while (k < e->n && ! gs_derivatives_changes (d, number_of (e, k)))
    k++;
  return k;
}

/* the first event that one of two runs has and the other has not; none: at HUGE_VAL */
static turn
unseen (const gs_derivatives *d, const events *a, const events *b)
{
  turn found = { 0, HUGE_VAL, 0 };
  int i = changing_from (d, a, 0), j = changing_from (d, b, 0);
  while (i < a->n && j < b->n && number_of (a, i) == number_of (b, j)
         && fabs (time_of (a, i) - time_of (b, j)) <= 10 * apart)
    {
      i = changing_from (d, a, i + 1);
      j = changing_from (d, b, j + 1);
    }
  if (i < a->n)
    found = (turn){ number_of (a, i), time_of (a, i), 0 };
  if (j < b->n && time_of (b, j) < found.t)
    found = (turn){ number_of (b, j), time_of (b, j), 0 };
  return found;
}

/* ---- the places */

/* those within the run, in the order of time, into list: how many */
static int
places_of (const gs_whole_run *w, const events *e, turn *list)
{
  const gs_run_result *r = w->r;
  const double *pairs = NULL;
  const int all = gs_derivatives_turns (r->derivatives, &pairs);
  int n = 0;
  for (int k = 0; k < all; k++)
    {
      const double t = pairs[2 * k + 1];
      double near = HUGE_VAL;
      if (! (t > (double)r->times[0] + apart && t < (double)r->times[r->rows - 1] - apart))
        continue;
      for (int i = 0; i < e->n; i++)
        near = fmin (near, fabs (t - time_of (e, i)));
      list[n++] = (turn){ (int)pairs[2 * k], t, fmin (apart, fmax (1e-9, 0.4 * near)) };
    }
  qsort (list, (size_t)n, sizeof *list, earlier);
  return n;
}

/* beginning and end of the run, and three times for each place, rising, into times (2 + 3*n): how
 * many */
static int
times_of (const gs_run_result *r, const turn *list, int n, gs_real *times)
{
  int m = 0, kept = 1;
  times[m++] = r->times[0];
  times[m++] = r->times[r->rows - 1];
  for (int k = 0; k < n; k++)
    for (int i = -1; i <= 1; i++)
      times[m++] = (gs_real)(list[k].t + i * list[k].step);
  qsort (times, (size_t)m, sizeof *times, smaller);
  for (int k = 1; k < m; k++)
    if (times[k] > times[kept - 1])
      times[kept++] = times[k];
  return kept;
}

/* the same run without derivatives */
static int
run_alone (const gs_whole_run *w, int nt, const gs_real *times, gs_run_result *q)
{
  gs_run_options o = *w->o;
  gs_run_start s = *w->s;
  o.ncolumns = 0;
  o.samples = 0;
  s.nt = nt;
  s.times = times;
  gs_run (w->d, &o, &s, w->in, q);
  return q->refused ? 0 : q->rows;
}

/* ---- one place */

/* the modes of the ports in row k */
static void
modes_at (const gs_scene *s, const gs_run_result *q, int k, int *mode)
{
  for (int i = 0; i < s->nev; i++)
    mode[i] = s->event_inputs[i] > 0
                ? (int)q->v[(ptrdiff_t)q->ldv * k + s->event_inputs[i] - 1] : 0;
}

static double
value_at (const gs_whole_run *w, const gs_run_result *q, int k, int number)
{
  const gs_scene *s = w->d->scene;
  int mode[s->nev + 1];
  gs_real all[s->nev + 1];
  modes_at (s, q, k, mode);
  s->evt (q->times[k], q->x + (ptrdiff_t)q->nx * k, q->v + (ptrdiff_t)q->ldv * k, mode, q->cst,
          all);
  return (double)all[number - 1];
}

/* what the tolerances make of an event function in row k */
static double
size_at (const gs_whole_run *w, const gs_run_result *q, int k, int number)
{
  const gs_scene *s = w->d->scene;
  int mode[s->nev + 1];
  gs_real g[s->nx + s->nv + s->nsp + 1];
  double size = 0;
  modes_at (s, q, k, mode);
  s->evp (q->times[k], q->x + (ptrdiff_t)q->nx * k, q->v + (ptrdiff_t)q->ldv * k, mode, number,
          q->cst, g);
  for (int i = 0; i < s->nx; i++)
    size += fabs ((double)g[i]) * (double)w->atol[i];
  return size;
}

static int
row_at (const gs_run_result *q, double t)
{
  int k = 0;
  while (k < q->rows && q->times[k] < (gs_real)t)
    k++;
  return k;
}

/* does its function come to 0 there, but for errors? */
static int
grazes (const gs_whole_run *w, const gs_run_result *q, const events *e, const turn *a)
{
  const int k[] = { row_at (q, a->t - a->step), row_at (q, a->t), row_at (q, a->t + a->step) };
  double g[3];
  if (k[2] >= q->rows)   /* an event has ended that run */
    return 0;
  for (int i = 0; i < 3; i++)
    g[i] = value_at (w, q, k[i], a->number);
  const double side = g[0] < 0 && g[2] < 0 ? -1 : 1;   /* one of the user may stay below 0 */
  for (int i = 0; i < 3; i++)
    g[i] *= side;
  const double bend = g[0] - 2 * g[1] + g[2];
  if (! (bend > 0))
    return 0;
  const double low = g[1] - (g[2] - g[0]) * (g[2] - g[0]) / (8 * bend),
               lowest = a->t + a->step * (g[0] - g[2]) / (2 * bend);
  for (int i = 0; i < e->n; i++)
    if ((time_of (e, i) - a->t) * (time_of (e, i) - lowest) < 0)
      return 0;
  return low <= 10 * size_at (w, q, k[1], a->number);
}

static void
look_at (gs_whole_run *w, const events *e, const turn *list, int n, const gs_run_result *q)
{
  const events of_states = events_of (q);
  turn found = unseen (w->r->derivatives, e, &of_states);
  for (int k = 0; k < n; k++)
    if (list[k].t < found.t && grazes (w, q, e, &list[k]))
      found = list[k];
  if (isfinite (found.t))
    gs_derivatives_end (w->r->derivatives, found.number, found.t);
}

int
gs_look_at_turns (gs_whole_run *w)
{
  const double *pairs = NULL;
  gs_run_result *r = w->r;
  const int all = gs_derivatives_turns (r->derivatives, &pairs);
  if (all == 0 || r->rows < 2)
    return 0;
  const events e = events_of (r);
  turn *list = malloc ((size_t)all * sizeof *list);
  gs_real *times = malloc ((size_t)(2 + 3 * all) * sizeof *times);
  gs_run_result q = { 0 };
  const int n = list && times ? places_of (w, &e, list) : 0;
  if (n > 0 && run_alone (w, times_of (r, list, n, times), times, &q) > 0)
    look_at (w, &e, list, n, &q);
  const int info = ! list || ! times                                    ? GS_OUT_OF_MEMORY
                   : q.info == GS_INTERRUPTED || q.info == GS_TIMED_OUT ? q.info
                                                                        : 0;
  gs_free_result (&q);
  free (list);
  free (times);
  return info;
}

/* Where an event is in a step of an implicit method: on the polynomial of the step, by
   gs_first_event; then by the step made again. */
#include <float.h>
#include <math.h>
#include "implicit_look.h"

enum { TURNS = 12 };

/* the state at T within the step, or at its end */
static int
state_at (gs_stepper *s, double t, double *x)
{
  if (t < s->t)
    return s->by->between (s, t, x);
  gs_copy (s->r->nx, s->y, x);
  return 0;
}

/* C: the points of gs_event_septic; D: what their values give the slope at the first one */
static void
points (double *c, double *d)
{
  for (int j = 0; j < GS_NODES; j++)
    c[j] = 0.5 * (1 - cos (j * acos (-1) / (GS_NODES - 1)));
  d[0] = 0;
  for (int j = 1; j < GS_NODES; j++)
    {
      d[j] = 1 / c[j];
      for (int k = 1; k < GS_NODES; k++)
        d[j] *= k == j ? 1 : -c[k] / (c[j] - c[k]);
      d[0] -= d[j];
    }
}

/* S->nodes: the states between FROM and TO at the points of gs_event_septic, bent so that value and
 * slope at the first are those of S->known: where an event has just been, its sign is decided
 * there.  The value alone where S->known is one of them (TOLD): of such a state, again and again,
 * slopes of what is stiff would go astray.  A flag */
static int
take_nodes (gs_stepper *s, int told, double from, double to)
{
  int n = s->r->nx, flag = 0;
  double c[GS_NODES], d[GS_NODES], h = to - from, *rate = s->work;
  points (c, d);
  for (int j = 0; j < GS_NODES && flag >= 0; j++)
    flag = state_at (s, j == GS_NODES - 1 ? to : from + c[j] * h, s->nodes + n * j);
  if (flag < 0 || gs_rate (s, from, s->known, rate) != 0)
    return flag < 0 ? flag : GS_NO_RATES;
  for (int i = 0; i < n; i++)
    {
      double value = s->known[i] - s->nodes[i], slope = told ? 0 : h * rate[i];
      for (int j = 0; j < GS_NODES && ! told; j++)
        slope -= d[j] * (s->nodes[i + n * j] - s->nodes[i]);
      for (int j = 1; j < GS_NODES; j++)
        s->nodes[i + n * j]
          += (1 - c[j]) * (1 - c[j]) * ((1 + 2 * c[j]) * value + c[j] * slope);
      s->nodes[i] = s->known[i];
    }
  return 0;
}

/* event function I at T in the state X; INFO */
int
gs_function (gs_stepper *s, int i, double t, const double *x, double *g)
{
  gs_integration *r = s->r;
  gs_events e = gs_events_planned (s);
  int info = gs_event_values (&s->g, t, gs_side_at (s, t), x, e.mode, e.now);
  gs_user_values_now (&e);
  *g = e.now[i - 1];
  if (info != 0)
    {
      r->istat[GS_FAILED_INFO] = info;
      r->istat[GS_FAILED] = GS_AT_INPUTS;
    }
  return info != 0 ? GS_ROUTINE_FAILED : GS_DONE;
}

/* What is known of the event functions before a step is looked at, to be looked at again. */
static void
remember (gs_stepper *s)
{
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne; i++)
    {
      s->marks[i] = e.mark[i];
      s->marks[e.ne + i] = e.fresh[i];
    }
  gs_copy (e.ne, e.g, s->levels);
  gs_copy (e.ne, e.level, s->levels + e.ne);
}

void
gs_recall (gs_stepper *s)
{
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne; i++)
    {
      e.mark[i] = s->marks[i];
      e.fresh[i] = s->marks[e.ne + i];
    }
  gs_copy (e.ne, s->levels, e.g);
  gs_copy (e.ne, s->levels + e.ne, e.level);
}

int
gs_climbs (gs_stepper *s, int i, double t, const double *x, const double *rate, double d, double *g,
           double *by)
{
  double at[2] = { 0, 0 }, *beside = s->between, clear = fmax (d, gs_shortest (t, t));
  int info = gs_function (s, i, t, x, g);
  for (int k = 0; k < 2 && info == 0; k++)
    {
      double way = 0.5 * (k + 1) * clear;   /* beside rounding errors of the time */
      for (int l = 0; l < s->r->nx; l++)
        beside[l] = x[l] + way * rate[l];
      info = gs_function (s, i, t + way, beside, &at[k]);
    }
  *by = info == 0 ? d / clear * (4 * (at[0] - *g) - (at[1] - *g)) : 0;
  return info;
}

/* S->rising: which functions of the user have just had their event at T (or the run begins), in
 * S->known, and rise from there above 0 before T + H, by the rates of take_nodes; INFO */
static int
take_rising (gs_stepper *s, double t, double h)
{
  gs_events e = gs_events_planned (s);
  double g, by;
  int info = GS_DONE;
  for (int i = 0; i < e.ne && info == 0; i++)
    {
      s->rising[i] = 0;
      if (gs_is_own (&e, i) && e.fresh[i] == 1 && e.mark[i] == 0)
        {
          info = gs_climbs (s, i + 1, t, s->known, s->work, 1e-3 * h, &g, &by);
          s->rising[i] = by > 0 && gs_risen (&e, i, g + 1e3 * by);
        }
    }
  return info;
}

/* the first of these that has fallen all the same in the part that was looked at, 0: none. The
 * step is too long to see what happens just behind the event. */
static int
sunk (const gs_stepper *s)
{
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne; i++)
    if (s->rising[i] && e.marks[i] == 0 && e.last[i] < 0)
      return i + 1;
  return 0;
}

/* the shortest step that may be made still shorter */
double
gs_shortest (double from, double to)
{
  return 1e3 * DBL_EPSILON * fmax (fabs (from), fabs (to));
}

/* gs_first_event between FROM and TO */
static int
search (gs_stepper *s, double from, double *to, int *found)
{
  gs_integration *r = s->r;
  gs_step e = { .t = from, .h = *to - from, .tn = *to, .side = gs_side_at (s, *to),
                .x = s->known, .xn = s->event, .f = s->nodes };
  gs_copy (r->nx, s->nodes + (size_t) r->nx * (GS_NODES - 1), s->event);
  int info = gs_first_event (&s->g, &e, found);
  if (info == 0 && *found > 0)
    *to = e.tn;
  return info != 0 ? GS_ROUTINE_FAILED : GS_DONE;
}

/* The first event between FROM, where the state is S->known, and TO: its function FOUND, TO and the
 * state there, S->event, on the polynomial; FOUND as gs_first_event.  A flag of the method in
 * *FLAG, INFO */
int
gs_look (gs_stepper *s, int told, double from, double *to, int *found, int *flag)
{
  const double end = *to;
  *found = 0;
  if ((*flag = take_nodes (s, told, from, *to)) < 0)
    return GS_DONE;
  int info = take_rising (s, from, end - from), which;
  remember (s);
  if (info != 0 || (info = search (s, from, to, found)) != 0 || (which = sunk (s)) == 0)
    return info;
  if (end - from <= gs_shortest (from, end))
    {
      const gs_events e = gs_events_planned (s);
      if (gs_reports (&e, which - 1))
        return info;
      s->r->istat[GS_FAILED_INFO] = 10;   /* as gs_first_event: they accumulate */
      s->r->istat[GS_FAILED] = GS_AT_EVENT;
      s->r->istat[GS_CAUSE] = which;
      return GS_ROUTINE_FAILED;
    }
  gs_recall (s);
  *found = -1;
  return GS_DONE;
}

/* the step from FROM once more, to TO at most; a flag */
int
gs_once_more (gs_stepper *s, double from, double to)
{
  double stop = s->stop;
  int side = s->side;
  if (to < stop)
    s->side = 1;
  s->stop = to;
  s->t = from;
  int flag = s->by->again (s);
  s->stop = stop;
  s->side = side;
  return flag;
}

/* The slope of function I behind the step to T, where it is G */
static int
slope_of (gs_stepper *s, int i, double from, double t, double g, double *slope)
{
  double d = 1e-3 * (t - from), before = 0;
  int info = s->by->between (s, t - d, s->event) < 0
               ? GS_METHOD_FAILED
               : gs_function (s, i, t - d, s->event, &before);
  *slope = (g - before) / d;
  return info;
}

/* the step to P->t once more; a flag of the method in *FLAG, INFO */
static int
tried (gs_stepper *s, place *p, int *flag)
{
  *flag = gs_once_more (s, p->from, p->t);
  return *flag < 0 || s->t < p->t ? GS_DONE : gs_function (s, p->i, p->t, s->y, &p->g);
}

/* an event of the user has happened: a little later than P its function is not above 0 */
static int
past (gs_stepper *s, place *p, int *flag)
{
  const gs_events e = gs_events_planned (s);
  int info = GS_DONE, own = gs_is_own (&e, p->i - 1);
  double least = DBL_EPSILON * fmax (fabs (p->from), fabs (p->end));
  for (int k = 0; k < 8 && own && info == 0 && *flag >= 0 && p->g > 0 && p->t < p->end; k++)
    {
      p->t = fmin (p->end, p->t + ldexp (least, k));
      info = tried (s, p, flag);
    }
  return info;
}

/* The step again, as long as it must be for the function to be 0 at its end, by the secant method
 * from its zero on the polynomial on.  S->t < P->t: the method made a shorter one of it. */
int
gs_locate (gs_stepper *s, place *p, int *flag)
{
  double slope = 0, t = 0, g = 0, least = 2 * DBL_EPSILON * fmax (fabs (p->from), fabs (p->end));
  /* one that is no time away from the beginning of the step: a step must have a length */
  p->t = fmin (p->end,
               fmax (p->t, p->from + DBL_EPSILON * fmax (fabs (p->from), p->end - p->from)));
  for (int turn = 0; turn < TURNS; turn++)
    {
      int info = tried (s, p, flag);
      if (info != 0 || *flag < 0 || s->t < p->t)
        return info;
      if (turn == 0 && (info = slope_of (s, p->i, p->from, p->t, p->g, &slope)) != 0)
        return info;
      if (turn > 0 && p->g != g)
        slope = (p->g - g) / (p->t - t);
      double d = p->g / slope;
      p->there = fabs (d) <= least;
      if (! (fabs (d) <= 0.1 * (p->end - p->from)) || fabs (d) <= least)
        break;
      t = p->t;
      g = p->g;
      p->t = fmin (p->end, fmax (p->t - d, p->begin + least));
      if (p->t == t)
        break;
    }
  return past (s, p, flag);
}

/* Events of a run by an implicit method: looked for on the polynomial of a step by gs_first_event;
   then the step is made again, as long as it must be (a method of one step; the polynomial of BDF
   is as accurate as its steps).  Behind one that changes nothing, which is only told, the step
   stands as it was. */
#include <math.h>
#include "implicit_look.h"

int
gs_has_events (const gs_stepper *s)
{
  return s->r->ip[GS_EVENTS] > 0;
}

int
gs_event_functions (const gs_stepper *s)
{
  return gs_has_events (s) ? gs_events_planned (s).ne : 0;
}

int
gs_has_ports (const gs_stepper *s)
{
  if (! gs_has_events (s))
    return 0;
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne; i++)
    if (! gs_is_own (&e, i))
      return 1;
  return 0;
}

/* event K at T, 0 the start, -1 inputs may have jumped: X behind it; INFO */
static int
happen (gs_stepper *s, double t, double *x, int k)
{
  gs_integration *r = s->r;
  int info = gs_resolve_under_inputs (s->scene, t, x, r->nx, r->ip, r->rp, r->cst, s->v, r->w,
                                      r->istat, k);
  return info != 0 ? GS_ROUTINE_FAILED : GS_DONE;
}

void
gs_onto_held (gs_stepper *s, double t, double *x)
{
  gs_integration *r = s->r;
  const int by_tolerances = 8;
  if (gs_has_ports (s) && gs_take_inputs (s, t, gs_side_at (s, t), x, s->v) == 0)
    gs_hold_after_step (s->scene, by_tolerances, t, x, r->nx, r->ip, r->rp, r->cst, s->v,
                        r->ropt[1], r->atol);
}

int
gs_first_events (gs_stepper *s)
{
  return gs_has_events (s) && ! s->o->resume ? happen (s, s->t, s->x, 0) : GS_DONE;
}

int
gs_ended_by_event (const gs_stepper *s)
{
  return gs_ended (s->r->ip);
}

int
gs_events_at_stop (gs_stepper *s, int *acted)
{
  *acted = 0;
  if (! gs_has_events (s))
    return GS_DONE;
  int so_far = *gs_events_planned (s).count, info = happen (s, s->t, s->x, -1);
  *acted = *gs_events_planned (s).count > so_far;
  return info != 0 ? info : gs_ended_by_event (s) ? GS_ENDED : GS_DONE;
}

int
gs_events_at_end (gs_stepper *s)
{
  gs_integration *r = s->r;
  if (! gs_has_events (s))
    return GS_DONE;
  const int so_far = *gs_events_planned (s).count;
  int info
      = gs_event_at_end (s->scene, s->t, s->x, r->nx, r->ip, r->rp, r->cst, s->v, r->w, r->istat);
  if (*gs_events_planned (s).count > so_far)
    s->side = 1;   /* the row is behind it */
  return info != 0 ? GS_ROUTINE_FAILED : gs_ended_by_event (s) ? GS_ENDED : GS_DONE;
}

/* ------------------------------------------------------------
 * a step with events */

/* do the events behind the first COUNT of the record change anything but what is told of them? */
static int
changed (const gs_stepper *s, int count)
{
  gs_events e = gs_events_planned (s);
  if (*e.count > e.nr || gs_ended_by_event (s))
    return 1;
  for (; count < *e.count; count++)
    if (! gs_reports (&e, (int) e.record[(3 + 2 * s->r->nx) * count + 1] - 1))
      return 1;
  return 0;
}

/* the end of the step at the event: S->event, onto the constraints where it is the polynomial's;
 * then the rows before it, and what happens at event I, where other functions may have risen above
 * 0 before it; INFO */
static int
act (gs_stepper *s, const place *p)
{
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne && p->t - p->begin > gs_shortest (p->begin, p->t); i++)
    if (gs_is_own (&e, i))
      e.mark[i] |= e.marks[i];
  if (! s->by->dense)
    gs_copy (s->r->nx, s->y, s->event);
  else if (gs_projects (s) && gs_check (s, s->project, p->t, s->event, gs_no_jump) != 0)
    return GS_ROUTINE_FAILED;
  int info = gs_put_out (s, nextafter (p->t, -HUGE_VAL));
  return info != 0 ? info : happen (s, p->t, s->event, p->i);
}

/* the step as it was; FLAG */
static int
as_it_was (gs_stepper *s, place *p)
{
  int flag = s->by->dense ? 0 : gs_once_more (s, p->from, p->end);
  if (! s->by->dense)
    p->end = s->t;
  return flag;
}

/* from the event at P, which changed nothing, on; FLAG */
static int
go_on (gs_stepper *s, place *p)
{
  gs_copy (s->r->nx, s->event, s->known);
  p->begin = p->t;
  return as_it_was (s, p);
}

/* Does function I rise along the motion where the polynomial of the method, by its error, lets it
 * fall? INFO */
static int
rises (gs_stepper *s, const place *p, int *is)
{
  const gs_events e = gs_events_planned (s);
  double g, by;
  *is = 0;
  if (! gs_is_own (&e, p->i - 1) || gs_rate (s, p->t, s->event, s->work) != 0)
    return GS_DONE;
  int info = gs_climbs (s, p->i, p->t, s->event, s->work, 1e-3 * (p->end - p->begin), &g, &by);
  *is = by > 0;
  return info;
}

/* The polynomial alone says that there is an event at P: the sign of its function at the end of the
 * step, as it was, is all that counts (as gs_first_event: its flag is 2 or 3) */
static void
by_its_end (gs_stepper *s, const place *p)
{
  gs_events e = gs_events_planned (s);
  e.fresh[p->i - 1] = 3 - (e.fresh[p->i - 1] == 1);
}

/* Where the function of the event at P is highest on the polynomial of the step, of seven points on
 * the way there, and how high; a flag of the method in *FLAG, INFO */
static int
highest (gs_stepper *s, const place *p, double *at, double *most, int *flag)
{
  double g;
  *most = -HUGE_VAL;
  for (int k = 1; k <= 7; k++)
    {
      const double t = p->begin + 0.125 * k * (p->t - p->begin);
      *flag = s->by->between (s, t, s->between);
      if (*flag < 0)
        return GS_DONE;
      int info = gs_function (s, p->i, t, s->between, &g);
      if (info != 0)
        return info;
      if (g > *most)
        *at = t;
      *most = fmax (*most, g);
    }
  return GS_DONE;
}

/* Has the function of the event at P been above 0 on the way there, where it is highest on the
 * polynomial, if it was not at P->begin, or does it rise from there?  On the step made again; on a
 * dense polynomial it must be so by more than that may be off.  Else by_its_end.  A flag of the
 * method in *FLAG, INFO */
static int
rose (gs_stepper *s, place *p, int *so, int *flag)
{
  gs_events e = gs_events_planned (s);
  int i = p->i - 1, info = GS_DONE;
  double g = -1, at = p->t;
  *so = ! gs_is_own (&e, i) || s->marks[i] == 1 || s->rising[i] || e.fresh[i] >= 2;
  if (*so)
    return info;
  if (p->t - p->begin > 1e-9 * (p->end - p->begin))
    {
      const double most = fmax (e.last[i], e.g[i]);
      if ((info = highest (s, p, &at, &g, flag)) != 0 || *flag < 0)
        return info;
      if (s->by->dense)
        g -= 1e-3 * fmax (most, -fmin (e.last[i], e.g[i]));
      else if ((*flag = gs_once_more (s, p->from, at)) < 0
               || (info = gs_function (s, p->i, s->t, s->y, &g)) != 0)
        return info;
    }
  *so = g > 0;
  if (*so)
    return info;
  gs_recall (s);
  by_its_end (s, p);
  *flag = as_it_was (s, p);
  return info;
}

/* is there an event at P, as far as the polynomial and the rates there tell? TAKEN: 0 if not, -1 if
 * the step is too long to say so; INFO */
static int
believed (gs_stepper *s, place *p, int *taken, int *flag)
{
  int so, risen = 0, info = rose (s, p, &so, flag);
  *taken = so;
  if (info != 0 || *flag < 0 || ! so || p->end - p->begin <= gs_shortest (p->begin, p->end))
    return info;
  if (s->by->dense && (info = rises (s, p, &risen)) == 0 && risen)
    gs_recall (s);
  /* it falls, but not where the polynomial says */
  if (risen || gs_events_planned (s).fresh[p->i - 1] >= 2)
    *taken = -1;
  return info;
}

/* Is function I that of the user, or of a port that has just begun to slide or rebounded, where the
 * step to the event is hardly one?  These must be 0 on the step itself (gs_event_secant) */
static int
needs_step (const gs_events *e, const place *p)
{
  const int i = p->i - 1;
  return gs_is_own (e, i) || ! p->there
         || ((e->kind[i] == 1) != (e->mode[i] == 0)
             && p->t - p->from <= gs_shortest (p->from, p->t));
}

/* the step up to the event at P; TAKEN: 0 if its function does not fall, -1 if it does later in the
 * step, which is too long to see where; INFO */
static int
up_to (gs_stepper *s, place *p, int *taken, int *flag)
{
  int info = s->by->dense ? GS_DONE : gs_locate (s, p, flag);
  gs_events e = gs_events_planned (s);
  double g;
  *taken = ! (info == 0 && *flag >= 0 && ! s->by->dense && s->t >= p->t && p->g > 0
              && needs_step (&e, p) && e.fresh[p->i - 1] < 2);
  if (*taken)
    return info;
  *flag = as_it_was (s, p);
  if (*flag < 0 || (info = gs_function (s, p->i, p->end, s->y, &g)) != 0)
    return info;
  gs_recall (s);
  if (g <= 0 && p->end - p->begin > gs_shortest (p->begin, p->end))
    *taken = -1;
  else
    by_its_end (s, p);
  return info;
}

/* the first event behind P->begin; *FOUND 0: there is none, -1: look again */
static int
next_event (gs_stepper *s, place *p, int *found, int *flag)
{
  p->t = p->end;
  int taken = -1, told = s->by->dense && p->begin > p->from;
  int info = gs_look (s, told, p->begin, &p->t, found, flag);
  if (info != 0 || *found == 0)
    return info;
  p->i = *found;
  if (*found > 0)
    info = believed (s, p, &taken, flag);
  if (info == 0 && *flag >= 0 && taken > 0)
    info = up_to (s, p, &taken, flag);
  if (info == 0 && *flag >= 0 && taken < 0)   /* too long to see what is just behind the last one */
    *flag = gs_once_more (s, p->from, p->begin + 0.25 * (p->end - p->begin));
  if (info == 0 && *flag >= 0 && (taken < 0 || (taken > 0 && ! s->by->dense && s->t < p->t)))
    {
      p->end = s->t;
      taken = -1;
    }
  *found = taken > 0 ? p->i : -1;
  return info;
}

/* The step made again ends before the last event that was told, or could not be made: on from that
 * event, as from one that changes something.  The functions are as they were behind it. */
static void
on_from_told (gs_stepper *s, const place *p, int *event, int *flag)
{
  gs_recall (s);
  gs_copy (s->r->nx, s->known, s->event);
  s->t = p->begin;
  s->y = s->event;
  *event = 1;
  *flag = 0;
}

int
gs_events_in_step (gs_stepper *s, double from, int *event, int *flag)
{
  place p = { .from = from, .begin = from, .end = s->t };
  int info, found;
  const double *end = s->y;
  gs_events e = gs_events_planned (s);
  for (int i = 0; i < e.ne; i++)
    e.fresh[i] = e.fresh[i] >= 2 ? 3 - e.fresh[i] : e.fresh[i];
  *event = *flag = 0;
  gs_copy (s->r->nx, s->x, s->known);
  while ((info = next_event (s, &p, &found, flag)) == 0)
    {
      if (p.begin > from && (*flag < 0 || p.end < p.begin))
        {
          on_from_told (s, &p, event, flag);
          return GS_DONE;
        }
      if (*flag < 0 || found == 0)
        break;
      if (found < 0)
        continue;
      int so_far = *gs_events_planned (s).count;
      if ((info = act (s, &p)) != 0)
        return info;
      *event = changed (s, so_far);
      if (! *event && (*flag = go_on (s, &p)) < 0)   /* on from the event, too */
        {
          gs_copy (s->r->nx, s->known, s->event);
          *event = 1;
        }
      if (*event || p.end <= p.t)
        {
          *event = 1;
          *flag = 0;
          s->t = p.t;
          s->y = s->event;
          return GS_DONE;
        }
      s->y = s->by->dense ? end : s->y;
    }
  return info;
}

/* Where the events of a step are: implicit_look.c, for implicit_events.c. */
#ifndef GS_HOST_IMPLICIT_LOOK_H
#define GS_HOST_IMPLICIT_LOOK_H
#include "gsmbp/plan.h"
#include "implicit_parts.h"

/* the plan of the events, and its arrays */
static inline gs_events
gs_events_planned (const gs_stepper *s)
{
  return gs_planned_events (s->r->nx, s->r->ip, s->r->rp);
}

/* What locates an event: the step from FROM ends at T, where function I is G; THERE: 0 but for
   rounding of the time. */
typedef struct { double from, begin, end, t, g; int i, there; } place;

/* event function I at T in the state X; INFO */
extern int gs_function (gs_stepper *s, int i, double t, const double *x, double *g);
/* G: function I at T in X; BY: how far it rises within D along the motion, whose rates are RATE;
   INFO */
extern int gs_climbs (gs_stepper *s, int i, double t, const double *x, const double *rate, double d,
                      double *g, double *by);
/* The first event between FROM, where the state is S->known, and TO: its function FOUND, TO and the
   state there, S->event, on the polynomial; FOUND as gs_first_event.  TOLD: S->known is a state of
   that polynomial, where an event was only told.  A flag of the method in *FLAG, INFO */
extern int gs_look (gs_stepper *s, int told, double from, double *to, int *found, int *flag);
/* the event functions as they were before it looked */
extern void gs_recall (gs_stepper *s);
/* the shortest step that may be made still shorter */
extern double gs_shortest (double from, double to);
/* the step from FROM once more, to TO at most; a flag */
extern int gs_once_more (gs_stepper *s, double from, double to);
/* The step again, as long as it must be for the function to be 0 at its end.  S->t < P->t: the
   method made a shorter one of it.  A flag in *FLAG, INFO */
extern int gs_locate (gs_stepper *s, place *p, int *flag);
#endif

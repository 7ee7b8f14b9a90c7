/* What the files of a run by an implicit method share (implicit.c, implicit_rates.c,
   implicit_events.c, implicit_look.c), and no method calls. */
#ifndef GS_HOST_IMPLICIT_PARTS_H
#define GS_HOST_IMPLICIT_PARTS_H
#include "implicit_run.h"

static const double gs_no_jump[3] = { 0, 0, 0 };

extern int gs_all_finite (int n, const double *x);
/* what ends the run at T, or 0: before a step and at every rate (a step may need none: gauss) */
extern int gs_asked (gs_stepper *s, double t);
/* below 0 where the limits from the left are wanted at T */
extern int gs_side_at (const gs_stepper *s, double t);
/* the inputs at T into V; INFO of gs_inputs_of_run */
extern int gs_take_inputs (gs_stepper *s, double t, int side, const double *x, double *v);
/* X at T moved onto the constraints, at most by JUMP; or looked after, by OPTIONS */
extern int gs_check (gs_stepper *s, const int *options, double t, double *x, const double *jump);
/* a state, with the turns that were kept apart */
extern void gs_turn_on (const gs_stepper *s, double *x);
/* the output times that the run has passed before LIMIT; INFO */
extern int gs_put_out (gs_stepper *s, double limit);

/* Events (implicit_events.c).  At the start; at a stop, where inputs may have jumped, ACTED: did
   anything happen? At the end of the run, in S->x.  INFO */
extern int gs_has_events (const gs_stepper *s);
extern int gs_event_functions (const gs_stepper *s);   /* how many there are */
extern int gs_first_events (gs_stepper *s);
extern int gs_events_at_stop (gs_stepper *s, int *acted);
extern int gs_events_at_end (gs_stepper *s);
extern int gs_ended_by_event (const gs_stepper *s);
/* The step from FROM is good: up to the first event in it that changes something (EVENT = 1: the
   state behind it is in Y), else all of it (EVENT = 0).  A flag of the method in *FLAG; INFO */
extern int gs_events_in_step (gs_stepper *s, double from, int *event, int *flag);
#endif

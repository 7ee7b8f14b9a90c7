/* The steps of method gauss in coordinates and momenta (gauss_momenta.c). */
#ifndef GS_HOST_GAUSS_MOMENTA_H
#define GS_HOST_GAUSS_MOMENTA_H
#include "gauss_rule.h"
#include "implicit_run.h"

typedef struct gs_momenta gs_momenta;

/* May the run's scene be integrated so, by what it is and by its routines? */
extern int gs_has_momenta (const gs_stepper *s);
/* a null pointer: no memory */
extern gs_momenta *gs_new_momenta (const gs_stepper *s, const gauss_rule *rule, const double *size);
extern void gs_free_momenta (gs_momenta *w);
/* Do the emitted routines agree at the state of the run, and elsewhere? 0: other terms are in its
   rates */
extern int gs_agree (gs_stepper *s, gs_momenta *w);
/* from the state of the run, where nothing is known of the steps before; a flag */
extern int gs_restart_momenta (gs_stepper *s, gs_momenta *w);
/* the step H to T, X: the state there; a flag, or GS_NO_END where the iteration does not end */
enum { GS_NO_END = 1 };
extern int gs_momenta_step (gs_stepper *s, gs_momenta *w, double h, double t, double *x);
/* the momenta and constraints as they were before the last step, to be made again from the time and
   state of the run; a flag */
extern int gs_take_back (gs_stepper *s, gs_momenta *w);
/* X: the state at the fraction AT of the last step, from START to Y */
extern int gs_momenta_between (gs_stepper *s, gs_momenta *w, const double *start, longer at,
                               double *x);
extern int gs_momenta_turns (gs_momenta *w);   /* then from zero */

/* Has an iteration ended, after a turn that changed the states by CHANGE beside their sizes?  It
   ends where the changes are rounding and do not fall: at once where they are tiny, else (states
   whose rates are sensitive) after some turns without a smaller one. */
typedef struct { double least; int idle; } gs_settling;
extern int gs_settled (gs_settling *k, double change);
#endif

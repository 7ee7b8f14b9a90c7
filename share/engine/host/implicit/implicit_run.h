/* Inside the implicit methods: the run (implicit.c), which every method shares, and what a method
   is to it (radau.c, gauss.c, cvode.c). */
#ifndef GS_HOST_IMPLICIT_RUN_H
#define GS_HOST_IMPLICIT_RUN_H
#include <stddef.h>
#include "gsmbp/arith.h"
#include "host/implicit/implicit.h"
#include "allocate.h"

typedef struct gs_stepper gs_stepper;

/* flags: no step, however short, is good; the rates at the state of the run are no numbers; there
 * is no memory */
enum { GS_NO_STEP = -1000, GS_NO_RATES, GS_NO_MEMORY };

/* A method.  What begins and what steps gives a flag, below zero where it failed. */
typedef struct
{
  int (*open) (gs_stepper *);              /* its memory; 0: there is none */
  void (*close) (gs_stepper *);
  int (*begin) (gs_stepper *);             /* at the time and state of the run */
  int (*restart) (gs_stepper *);           /* the same, where the inputs have jumped */
  int (*step) (gs_stepper *);              /* to STOP at most: T, Y, H, NEXT */
  int (*again) (gs_stepper *);             /* instead of the last step one from T to STOP at most */
  int (*between) (gs_stepper *, double t, double *x);   /* the state within the last step */
  /* X at T within the last step, onto the constraints as its end; 0, or the projection has to do
     the rest. May be a null pointer */
  int (*onto) (gs_stepper *, double t, double *x);
  int (*rejected) (gs_stepper *);         /* steps that failed the test of their error */
  void (*count) (gs_stepper *);            /* its statistics into ISTAT, then from zero */
  int dense;                           /* is the state within a step as accurate as its end? */
  int moves;                           /* is X moved behind steps to where ports are held? */
  int fixed;                           /* are all steps of the length ropt[0]? */
} gs_method;

struct gs_stepper
{
  const gs_scene *scene;
  gs_integration *r;
  const gs_implicit *o;
  gs_system g;           /* all of it, as the run time takes it */
  const gs_method *by;
  void *memory;          /* the method's */
  int side;              /* the limits of the inputs at STOP, a break, a sample or the end */
  double stop, sample;   /* ... and the next sample */
  double *stops;         /* rising: the breaks, and where the scene switches by itself */
  int nstops;
  int still;             /* steps in succession that hardly move the time */
  int asked;             /* what is not 0 is to end the run (ASK of gs_integration) */
  double t, h, next;     /* the last step's end, its length and that of the next */
  const double *y;       /* the state there, as the method leaves it */
  double *known, *event, *nodes;   /* a state within a step, at an event; GS_NODES of a step */
  double *levels;        /* of event functions, before a step is looked at */
  int *marks, *rising;   /* ... and what is known of them */
  double *turns;         /* whole turns by which coordinates are farther than in the states */
  double *x, *trial, *between, *v, *p, *b, *c, *d, *dv, *work;
  int *project,
      *watch; /* IOPT for gs_check_constraints: to move a state onto the constraints; to look after
                 what is left */
};

enum { GS_NODES = 8 };   /* of gs_event_septic */

/* What a method calls; 0, above 0: a smaller step may do, below 0: it is over */
extern int gs_rate (gs_stepper *s, double t, const double *x, double *xd);
/* The same in two parts, where the inputs follow the time alone: V (NV) at T, and the rate by it */
extern int gs_inputs_of_time (const gs_stepper *s);
extern int gs_inputs (gs_stepper *s, double t, double *v);
extern int gs_inputs_at (gs_stepper *s, double t, const double *x, double *v);
extern int gs_rate_by (gs_stepper *s, double t, const double *x, double *v, double *xd);
/* A: that of the own states, N x N. Columns of derivatives have the same one, each for itself: how
 * they depend on the states is left out, which needs second derivatives; Newton's iteration, in
 * which they follow the states, finds the same end without it. */
extern int gs_jacobian (gs_stepper *s, double t, const double *x, double *A);
/* the number of the states without columns */
extern int gs_own_states (const gs_stepper *s);
/* MOVED: X at T, which a step from the state of the run led to, moved onto the constraints */
extern int gs_moved (gs_stepper *s, double t, const double *x, double *moved);
/* X at T to where the ports that are held are held, by no more than the errors of steps */
extern void gs_onto_held (gs_stepper *s, double t, double *x);
/* does gs_rates_at complete the state from independent coordinates? X at T so */
extern int gs_completes (const gs_stepper *s);
extern int gs_completed (gs_stepper *s, double t, const double *x, double *completed);
/* do sampled devices or events act on the states as they are? */
extern int gs_acts (const gs_stepper *s);
/* are there ports that stick or hit stops? */
extern int gs_has_ports (const gs_stepper *s);
/* is the state moved onto constraints (or Euler parameters onto their sphere)? */
extern int gs_projects (const gs_stepper *s);

extern int gs_implicit_run (const gs_scene *scene, gs_integration *r, const gs_implicit *o,
                            const gs_method *by);
#endif

/* host/run/stepped.h: a run that its host continues from time to time: the program of a controller,
 * the loop of a game, an FMU. Inputs are numbers that the host sets; each holds until it is set
 * again. Sampled devices, ports and events of the user act as in gs_run (run.h).
 *
 *   gs_stepped_run run = { .o = gs_default_options () };
 *   gs_step_open (&run, &about, 0, 0)      memory, the method of run.o
 *   gs_step_begin (&run, &start)           the state at the first time of start
 *   gs_step_set (&run, 0, 2.5)             input 0 from now on
 *   gs_step_on (&run, 0.01)                run.x is the state at 0.01 s
 *   gs_step_close (&run)
 *
 * Errors: a function that returns an int returns 0 where all is well, but where an event ends the
 * run *run.ended is its number; else run.r.refused or run.r.info says what happened, as in gs_run,
 * and run.r.text in words. After a failure the time is that of the last event or call.
 *
 * Ownership: the run owns its memory until gs_step_close. The description, the arrays of the
 * options, parameters and modes of the start belong to the host and stay until then, and the
 * structure itself stays where it is. No two threads use a run at a time. Shapes, units:
 * gsmbp/scene.h.
 *
 * While no input changes a step of dp853 may end later than the time that is asked for, by 20 times
 * the way there at most: the states at the next times come from its polynomial. Where an
 * input changes the run goes on from the time now instead. */
#ifndef GSMBP_HOST_STEPPED_H
#define GSMBP_HOST_STEPPED_H

#include "host/run/run.h"

#ifdef __cplusplus
extern "C" {
#endif

/* clock: */
enum
{
  GS_STEP_NOW = 0,    /* the time [s] */
  GS_STEP_STOP,       /* no step ends later, 1e300: there is no such time [s] */
  GS_STEP_RTOL,       /* relative tolerance */
  GS_STEP_NEXT,       /* the length of the next step [s] */
  GS_STEP_AHEAD,      /* where the last step has begun if it ends after the time now, */
  GS_STEP_AHEAD_LENGTH, /* its length; 0: it does not [s] */
  GS_STEP_CLOCK
};

typedef struct
{
  gs_run_options o;   /* filled before gs_step_open; gs_step_begin reads step, rtol and atol again;
                         no columns, no audit */
  gs_run_start s;     /* as gs_step_begin got it; its times are clock */
  gs_run_result r;    /* of the last call: refused, info, option, text, warning, start, istat,
                         rstat; of the run: nx, atol, ip, rp, cst */
  /* All that changes is in two arrays of these lengths: a copy of them is the run at its time.
   * Copied back, also into another run of the same scene and method, it continues with the same
   * bits. */
  size_t nnumbers, nwholes;
  gs_real *numbers;
  int *wholes;
  gs_real *clock;     /* GS_STEP_CLOCK, above */
  gs_real *x;         /* nx: the state now */
  gs_real *inputs;    /* nv: as they are set; to be read */
  gs_real *when;      /* nev: when an event function of the user had its last event [s], */
  int *tally;         /* nev: how many it has had */
  int *ended;         /* the event function that has ended the run, from 1, or 0 */
  gs_real *own;       /* numbers of the host, */
  int *own_wholes;    /* whole ones */
  /* workspace between calls: */
  gs_real *v;         /* nv */
  gs_real *w;         /* gs_room */
  struct gs_stepped_parts *parts;
} gs_stepped_run;

/* Allocate a run of the scene d with so many numbers of the host; choose its method and how its
 * loops are kept. Inputs are 0. */
int gs_step_open (gs_stepped_run *a, const gs_description *d, int numbers, int wholes);
void gs_step_close (gs_stepped_run *a);

/* Take the start s: s->times[0] is its time, the last one of several where the run stops. s->x0 is
 * moved onto the constraints, or checked. Sampled devices hold the inputs in the places of their
 * outputs; their delays are 30 periods at most. */
int gs_step_begin (gs_stepped_run *a, const gs_run_start *s);

/* Let the settled states of a start that the scene states begin where their rates vanish, but for
 * those with given (nx) of 1. */
int gs_step_settle (gs_stepped_run *a, const int *given);

/* Check whether the laws of devices and stops allow the state under the inputs as they are.
 * gs_step_on does it before the first step where the host has not. */
int gs_step_check (gs_stepped_run *a);

/* Set input k (from 0). */
void gs_step_set (gs_stepped_run *a, int k, gs_real value);

/* Continue to the time `until`, later than now, or to an event of the user that ends the run. A
 * time that differs from a sample or the stop by rounding alone is that one. */
int gs_step_on (gs_stepped_run *a, gs_real until);

/* For hosts that show what happens at the time now, or integrate themselves: */

/* Let event k happen (0 the start, -1 inputs may have jumped, of scenes with events) and those that
 * follow; those that inputs have brought about since the last step. */
int gs_step_event (gs_stepped_run *a, int k);
int gs_step_jump (gs_stepped_run *a);

/* Count the recorded events of the user in tally, when and ended; forget the part of the last step
 * that is later than now. gs_step_event and gs_step_set do it. */
void gs_step_tally (gs_stepped_run *a);
void gs_step_forget (gs_stepped_run *a);

#ifdef __cplusplus
}
#endif
#endif

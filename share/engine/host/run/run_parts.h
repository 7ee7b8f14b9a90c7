/* run_parts.h: what the files of a run share. */
#ifndef GS_RUN_PARTS_H
#define GS_RUN_PARTS_H

#include "host/run/run.h"
#include "host/run/stepped.h"

#ifdef __cplusplus
extern "C" {
#endif

/* a run on its way */
typedef struct gs_whole_run
{
  const gs_description *d;
  const gs_run_options *o;
  const gs_run_start *s;
  const gs_run_inputs *in;
  gs_run_result *r;
  int fixed;            /* the method has steps of one length */
  int index2;           /* loops in index 2 */
  int order;            /* the largest one of an implicit method */
  gs_implicit_method *by; /* ... or a null pointer */
  int *iopt;            /* as gs_integration has them; in the room of the result, as the next */
  gs_real ropt[3];
  gs_real *atol, *x0;   /* nx */
  int nb;               /* breaks within the run, */
  gs_real *breaks;      /* rising */
  int njumps;           /* all of them, */
  gs_real *jumps;       /* with those at its ends */
  gs_plan plan;
  int pending;          /* places for outputs on their way that other runs by this plan need */
  gs_scene scene;       /* as this run calls it, on its plan */
  gs_fortran_inputs fortran;
  gs_real *w;           /* workspace, */
  int lw;
  char said[400];       /* by an implicit method that stopped */
} gs_whole_run;

/* a refusal: 1 */
int gs_refuse (gs_run_result *r, int refused, const char *option, const char *format, ...);

/* 0, or 1 where the run is refused; in this order: */
int gs_choose_method (gs_whole_run *w);     /* method, order, lengths and number of steps */
int gs_choose_tolerances (gs_whole_run *w);
int gs_choose_loops (gs_whole_run *w);      /* iopt */
int gs_set_loop_method (gs_whole_run *w);   /* r->cst */
int gs_lay_inputs (gs_whole_run *w);        /* plan, breaks */

/* 1 where the routine that what needs is not there, and the run is refused for that */
int gs_lacks (gs_whole_run *w, int there, const char *what, const char *routine);

/* the parameter loop_method as the way of the loops needs it */
gs_real gs_wanted_loop_method (const gs_whole_run *w);

/* the scene with columns of derivatives, r->derivatives; those of w->x0 onto the constraints */
int gs_open_columns (gs_whole_run *w);

/* after the run: events that it just misses end the derivatives; those of inputs and outputs. Info
 * of the run, where that is another now */
int gs_look_at_turns (gs_whole_run *w);
int gs_take_slopes (gs_whole_run *w);

/* all of these, room, r->ip, r->rp */
int gs_prepare_run (gs_whole_run *w);
void gs_forget_run (gs_whole_run *w);

/* the run as gs_integrate takes it, and what an implicit method has beside it; by its method:
 * r->info, istat, rstat; why it failed, with the devices that are outside their margins in its last
 * state */
gs_integration gs_prepared_run (gs_whole_run *w);
gs_implicit gs_prepared_implicit (gs_whole_run *w);
void gs_integrate_by (gs_whole_run *w, const gs_scene *scene, gs_integration *run);
void gs_tell_failure (gs_whole_run *w);

/* what a stepped run has beside gs_stepped_run */
typedef struct gs_stepped_parts
{
  gs_whole_run whole;
  int nown;             /* event functions of the user */
  gs_real *memory;      /* the arrays that do not change from step to step */
  gs_real *ahead;       /* (nx,11): the states at both ends of the last step, its polynomial */
  int *quiet;           /* steps since an input has changed */
  int *checked;         /* 1: gs_step_check */
} gs_stepped_parts;

/* why a routine (GS_AT_RHS, ...) failed that returned info, into r.text: 1 */
int gs_step_failed (gs_stepped_run *a, int routine, int info);

/* how far a step to the time t may go beyond it where the way there is h; the last one is kept; the
 * state at t within it into r.x: 0, or 1 where it cannot be moved onto the constraints */
gs_real gs_step_beyond (const gs_stepped_run *a, gs_real t, gs_real h);
void gs_step_keep (gs_stepped_run *a, const gs_dense *e);
int gs_step_within (gs_stepped_run *a, gs_real t);

#ifdef __cplusplus
}
#endif
#endif

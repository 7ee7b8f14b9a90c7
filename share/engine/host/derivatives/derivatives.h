/* host/derivatives/derivatives.h: runs that carry derivatives of their states by parameters and by
 * start values: gs_rates_with_columns in the place of the right-hand side, gs_project_columns after
 * the projection, the jumps at events and samples.
 *
 * gs_derivatives_open makes of a scene, its constants and the plan of a run another scene and other
 * constants. A run of nx*(1 + nc) states with both (gs_integrate, gs_radau, gs_cvode) has after its
 * nx states a column of nx derivatives for each of the nc parameters or start values; x0 holds
 * those at the start, atol what counts for each. The routines of that scene find what they need by
 * the address of these constants: there is no static data, and runs on several threads do not meet.
 * Shapes, units: gsmbp/scene.h; columns are in the units of the states per unit of the
 * parameter. */
#ifndef GSMBP_HOST_DERIVATIVES_H
#define GSMBP_HOST_DERIVATIVES_H

#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* what a run of nx*(1 + nc) states has; arrays are copied, but for ip and rp, those
 * of the gs_integration, laid out by gs_lay */
typedef struct
{
  const gs_scene *scene; /* with the routines of request sensitivity; its data goes to its vin */
  const gs_real *cst;    /* ncst: from <name>_pre, */
  int ncst;
  int nc;
  const int *col;        /* nc: the parameter of rhp of each column, from 1; 0: a start value */
  int nsets;
  const int *sets;       /* (4,nsets): coordinates that are Euler parameters, from 1 */
  int *ip;               /* the plan of the run: gs_derivatives_open changes whom it asks for its */
  gs_real *rp;           /* inputs */
  const gs_real *guess;  /* nu: of a planned motion of a closed chain; null: 0 */
  gs_real rtol;          /* tolerances of the run: relative, */
  const gs_real *atol;   /* nx: absolute; they say what only grazes */
  const int *changes;    /* nev: 0 where an event changes neither states nor inputs; null: where
                            its kind is 5 */
} gs_derivatives_given;

typedef struct gs_derivatives gs_derivatives;

/* The run with its columns, for gs_derivatives_close; a null pointer where there is no memory, or
 * the scene lacks a routine that the columns need: missing is its name ("rhp"), else null. */
gs_derivatives *gs_derivatives_open (const gs_derivatives_given *given, const char **missing);
void gs_derivatives_close (gs_derivatives *d);

/* the scene and the constants of the run, until gs_derivatives_close */
const gs_scene *gs_derivatives_scene (const gs_derivatives *d);
const gs_real *gs_derivatives_constants (const gs_derivatives *d);

/* The columns of the start x (nx,1+nc) of a closed chain made consistent with its constraints:
 * coordinates with fixed (nq) of 1, and their speeds, keep their derivatives, the others follow. 0,
 * or why they do not: */
enum
{
  GS_START_CHOICE = 1,    /* too few are fixed, */
  GS_START_CONTRADICTION, /* too many */
  GS_START_UNDEFINED      /* con fails, or speeds are not the rates of the coordinates */
};
int gs_derivatives_start (gs_derivatives *d, gs_real t, gs_real *x, const int *fixed);

/* how many coordinates of a closed chain in the state x the motion of the others follows from */
int gs_derivatives_freedoms (gs_derivatives *d, gs_real t, const gs_real *x);

/* ---------------------------------------------------------------------------- behind the run */

/* why column k (from 0) has no derivatives from some event on: 0: it has; */
enum
{
  GS_GRAZES = 1, /* the motion only grazes there */
  GS_SEVERAL,    /* another event of the instant would come at another time */
  GS_UNDEFINED,  /* the equations there have no derivatives */
  GS_CHOICE      /* what it sets is moved onto constraints that leave a choice */
};
/* ... with the number of the event (from 1) and its time [s]. The column is 0 from there on. */
int gs_derivatives_lost (const gs_derivatives *d, int k, int *event, double *time);

/* that in words */
const char *gs_derivatives_why (int why);

/* all columns only graze event function event (from 1) at the time t, but for those that have no
 * derivatives by then; derivatives by column k of the times of events from t on are NaN */
void gs_derivatives_end (gs_derivatives *d, int event, double t);
void gs_derivatives_drop_times (gs_derivatives *d, int k, double t);

/* 1: event function event (from 1) changes states or inputs */
int gs_derivatives_changes (const gs_derivatives *d, int event);

/* how many pairs (number of an event function from 1, time [s]) there are where it came close to 0
 * and turned */
int gs_derivatives_turns (const gs_derivatives *d, const double **pairs);

/* how many columns (1 + nv*nc) there are: a time, and the derivatives of the inputs (nv,nc) that
 * sampled devices and events of the user hold from that time on; -1: there was no memory */
int gs_derivatives_held (const gs_derivatives *d, const double **columns);

/* how many columns (nc) there are: derivatives of the time of each recorded event, NaN where there
 * is none */
int gs_derivatives_of_events (const gs_derivatives *d, const double **columns);

/* Whether inputs follow a planned motion, feedback or vin: then their derivatives from the left at
 * the n output times tout, into to (nv,nc,n); xout (ldx,n) and vout (ldv,n) are those of the run.
 * NaN where they cannot be had. */
int gs_derivatives_followed (const gs_derivatives *d);
void gs_derivatives_of_inputs (gs_derivatives *d, int n, const gs_real *tout, const gs_real *xout,
                               int ldx, const gs_real *vout, int ldv, double *to);

#ifdef __cplusplus
}
#endif
#endif

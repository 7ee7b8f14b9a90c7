/* host/start.h: how a run starts, for all hosts: the state moved onto the constraints, or the
 * message of a refusal; margins of devices.
 *
 * In the order of a start: gs_settle_states, of a state that the scene itself states;
 * gs_take_start, which is gs_close_start, gs_check_margins and gs_check_stops; after gs_lay of
 * plan.h gs_check_samples. Shapes, units: gsmbp/scene.h. */
#ifndef GSMBP_HOST_START_H
#define GSMBP_HOST_START_H

#include "gsmbp/failures.h"
#include "gsmbp/plan.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void gs_mar (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *g,
                     gs_real *size);

/* what the subroutine GSVIN of a user is called with next to time and states */
typedef struct
{
  const int *ip;
  const gs_real *rp, *cst;
} gs_fortran_inputs;

/* what a start needs of a scene besides its table; numbers of states count from 0, those of
 * constraints from 1. A null pointer: the host does not have it. */
typedef struct gs_description
{
  const gs_scene *scene;
  gs_mar *mar;                      /* margins of devices, */
  int nmargins;                     /* nmargins of them, and their sizes */
  const double *nominal;            /* nx: nominal magnitudes of the states */
  int nsets;
  const int *sets;                  /* (4,nsets): states that are Euler parameters */
  int nspeedrows;
  const int *speedrows;             /* constraints on speeds alone */
  int nsettled;
  const int *settled;               /* states that start where their rates vanish */
  const int *angles;                /* nq: 1 where a coordinate is an angle [rad] */
  const char *const *states;        /* nx: names */
  const char *const *constraints;   /* nlam: of the multipliers */
  const char *const *events;        /* nev */
  const char *const *devices;       /* nctl: of the sampled devices */
  const char *const *margins;       /* nmargins: what must be above 0 */
  const char *const *parameters;    /* npar */
  const int *margin_values;         /* for each margin how many states its message shows, these, how
                                       many parameters, these (from 0) */
  /* what INFO of a routine ("rhs") means; null: not known */
  const char *(*meaning) (const char *routine, int info);
  /* for whole runs (host/run) */
  int ncst, npar;                   /* constants, parameters */
  int (*pre) (const gs_real *par, gs_real *cst); /* the constants of parameters */
  int loop_method;                  /* the parameter of the ways nullspace, svd, kane, from 0; -1 */
  gs_rhs *audited;                  /* rates with the two states of an audit; null: not there */
  int order;                        /* highest derivative of a planned motion that cmd reads */
  int nfollowed;
  const int *followed;              /* states of devices that inputs of a motion follow, from 1 */
  int fortran_inputs;               /* 1: the data of scene->vin are a gs_fortran_inputs of a run */
  const struct gs_lane_routines *lanes; /* of ensembles (host/ensemble) */
  /* for optimal motions (host/collocation), numbers from 0: functions of dae are residuals, rates
     of coordinates and devices, outputs; unknowns time, states, accelerations, multipliers, inputs,
     the parameters here */
  int nresiduals;
  int njacobian, nhessian;
  const int *jacobian;              /* (2,njacobian): function and unknown of each entry of daj */
  const int *hessian;               /* (2,nhessian): the two unknowns of each entry of dah */
  int nunknown;
  const int *unknown;               /* parameters that are unknowns */
} gs_description;

/* a start that is asked for */
typedef struct
{
  gs_real t;
  const gs_real *cst;
  const double *par;      /* npar: shown in messages; may be null */
  const gs_real *v;       /* nv: the inputs there; null: zero */
  int check;              /* 1: the state must be on the constraints; 0: it is moved there */
  const int *modes;       /* nev: of the ports; null: they are found */
} gs_start_given;

/* what is found */
typedef struct
{
  int verdict;            /* GS_START_TAKEN, ... of failures.h */
  double residual;        /* the largest one at the given state, relative to nominal magnitudes */
  double moved;           /* the largest change of a state, relative to its nominal magnitude */
  int state;              /* the state that it is of, from 0; -1: none was moved */
  char row[300];          /* what the residual is of; "": nothing */
  char text[2400];        /* the message of a refusal */
} gs_start;

/* ------------------------------------------------------------------------------------ residuals */

/* How far the state x is from its constraints, a row for each set of Euler parameters (its length
 * less 1), each constraint on positions and the rate of each constraint: found in the unit of the
 * row; scaled relative to what the nominal magnitudes of the states make of it; both of the length
 * gs_residual_rows. 0; 1: no memory, and all are NaN. */
int gs_residual_rows (const gs_description *d);
int gs_residuals (const gs_description *d, gs_real t, const gs_real *x, const gs_real *cst,
                  double *scaled, double *found);

/* what row k (from 0) is of, into text of the given size */
void gs_residual_name (const gs_description *d, int k, char *text, int size);

/* the rows above the limit (or the largest, if none is), the worst first, six at most:
 * "C.x = 0.012, rate of C.x = 0.3" */
void gs_worst_residuals (const gs_description *d, const double *scaled, const double *found,
                         double limit, char *text, int size);

/* is the state x beside its constraints by more than a start may be? 1: text has the worst rows;
 * 0; -1: no memory */
int gs_beside_constraints (const gs_description *d, gs_real t, const gs_real *x,
                           const gs_real *cst, char *text, int size);

/* ---------------------------------------------------------------------------------------- start */

/* the settled states of x where their rates vanish at t with all inputs zero, but for those with
 * fixed (nx, may be null) of 1; as they are where there is no such place. What they read is taken
 * on the constraints: beside them it would hold what stabilizes the constraints. */
void gs_settle_states (const gs_description *d, gs_real t, const gs_real *cst, const int *fixed,
                       gs_real *x);

/* x onto the constraints, unless it is there but for rounding; the verdict. Where it is not
 * GS_START_TAKEN x is left as it was. */
int gs_close_start (const gs_description *d, const gs_start_given *g, gs_real *x, gs_start *s);

/* whether an angle of x has lost its sine to rounding; the verdict, s->state says which */
int gs_check_angles (const gs_description *d, const gs_real *x, gs_start *s);

/* the refusal of the Euler parameters of set k (from 0): its verdict */
int gs_refuse_orientation (const gs_description *d, int k, const gs_real *x, gs_start *s);

/* whether the laws of all devices hold in the state x, and no stop is passed that is not in contact
 * by g->modes; the verdict */
int gs_check_margins (const gs_description *d, const gs_start_given *g, const gs_real *x,
                      gs_start *s);
int gs_check_stops (const gs_description *d, const gs_start_given *g, const gs_real *x,
                    gs_start *s);

/* the ports, n of them: where they are (n), how fast (n), their ends and two other numbers of each
 * (4,n), for free; a null pointer: there are none (n = 0), or no memory */
gs_real *gs_ports_at (const gs_description *d, const gs_start_given *g, const gs_real *x, int *n);

/* all that, margins only where g->check is 1 */
int gs_take_start (const gs_description *d, const gs_start_given *g, gs_real *x, gs_start *s);

/* periods, delays and first samples of the sampled devices into the plan ip, rp; the verdict */
int gs_check_samples (const gs_description *d, gs_real t0, const gs_real *cst, int *ip, gs_real *rp,
                      gs_start *s);

/* of n sampled devices: places for outputs that are pending (gs_plan); samples and delayed outputs
 * in a run of the length span [s] */
int gs_pending (int n, const double *period, const double *delay);
double gs_instants (int n, const double *period, const double *delay, double span);

/* why the mode of event k (from 0) of the given modes contradicts the state x */
void gs_wrong_mode (const gs_description *d, const gs_start_given *g, const gs_real *x, int k,
                    char *text, int size);

/* -------------------------------------------------------------------------------------- margins */

/* The margins of the devices in the state x under the inputs v, after those of other states: least
 * (nmargins), which begins with HUGE_VAL, becomes the smallest values so far, NaN where one was
 * NaN; passed (nmargins), which begins with 0, becomes 1 where a margin is passed, not just
 * reached: no state close by keeps it. How many are passed here for the first time; -1: no
 * memory. */
int gs_margins_at (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
                   const gs_real *cst, int *passed, double *least);

/* margin k, its value and the states and parameters (null: not known) that it is made of */
void gs_margin_text (const gs_description *d, int k, double value, const gs_real *x,
                     const double *par, char *text, int size);

/* the margins that are passed in the state x under the inputs v, as text: how many; -1: no
 * memory */
int gs_passed_text (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
                    const gs_real *cst, const double *par, char *text, int size);

/* the same as what the message of a failed run adds; "" where none is passed */
void gs_outside_text (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
                      const gs_real *cst, const double *par, char *text, int size);

/* one that is passed in a run: margin k first in column first, its smallest value in column at */
typedef struct
{
  int k, first, at;
  double least;
} gs_passed_margin;

/* the margins that are passed in the n columns t, x (ldx,n), v (ldv,n), into list (nmargins): how
 * many; -1: no memory */
int gs_margins_of_run (const gs_description *d, int n, const gs_real *t, const gs_real *x, int ldx,
                       const gs_real *v, int ldv, const gs_real *cst, gs_passed_margin *list);

#ifdef __cplusplus
}
#endif
#endif

/* host/collocation/collocation.h: optimal motions by direct collocation, for all hosts: a problem
 * solved on finer and finer meshes, inputs that jump, singular arcs.
 *
 * Numbers count from 0; matrices lie by columns. Shapes, units: gsmbp/scene.h. */
#ifndef GSMBP_HOST_COLLOCATION_COLLOCATION_H
#define GSMBP_HOST_COLLOCATION_COLLOCATION_H

#include "host/collocation/nlp.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  int method, intervals;         /* GS_RADAU_IIA or GS_LOBATTO; of the first mesh */
  double accuracy;               /* of states, by their largest value or 1: intervals above it */
  int refinements;               /* are cut, so often at most */
  int polish;                    /* 1: the instants at which inputs jump become unknowns */
  double regularize;             /* weight of the roughness of inputs on singular arcs; 0: none */
  double tolerance, seconds;     /* of the solver, for each mesh; */
  int iterations;
  double timeout;                /* of all meshes together [s]; 0: none */
  gs_nlp_solver *solver;
  int (*ask) (void *asked);      /* not 0: it is to end; null: never */
  void *asked;
} gs_motion_options;

/* where the search begins: n times from 0 to 1, states and inputs there, the duration [s]; n 0: on
 * a line between the ends, on the constraints; states that are free there are those of start */
typedef struct
{
  int n;
  const double *t, *x, *v;       /* n, (nx,n), (nv,n) */
  double duration;
  const double *start;           /* nx */
  int nactuated;
  const int *actuated;           /* coordinates that others follow in a closed chain */
} gs_motion_guess;

/* a bound with a multiplier: of what, its number, 1: the largest; from and until [s]: when it holds
 * the goal back, NaN for a duration or a parameter */
enum { GS_BOUND_STATE, GS_BOUND_INPUT, GS_BOUND_OUTPUT, GS_BOUND_TIME, GS_BOUND_PARAMETER };
typedef struct
{
  int of, number, largest;
  double value, from, until, multiplier;
} gs_active_bound;

/* an arc on which the goal does not determine an input; ringing: its largest distance from a smooth
 * curve; weight: of its roughness; held: a state or an output is at a limit there */
typedef struct
{
  int input, held;
  double from, until, ringing, weight;
} gs_singular_arc;

typedef struct
{
  int intervals, iterations;
  double error;
  char ended[200];
} gs_mesh_report;

/* what is found: arrays of its own, freed by gs_motion_free */
typedef struct
{
  int solved;                    /* within the accuracy */
  int stopped;                   /* GS_INTERRUPTED, GS_TIMED_OUT of failures.h, or 0 */
  char ended[2400];              /* why it ended, how far it came, what is singular, in words */
  double goal, duration, error;
  int n;                         /* points: */
  double *t, *x, *v, *ud, *lambda, *y, *costates; /* n, (nx,n), (nv,n), ... */
  double *unknown;               /* nunknown: parameters */
  int pieces;                    /* of the inputs, between their pieces+1 breaks [s], */
  double *breaks, *input;        /* (nv,pieces,3): coefficients, that of t^2 first */
  int nplanned, *planned;        /* coordinates of the planned motion, 0: there is none; */
  double *motion;                /* between the points: (nplanned,n-1,6) */
  int nmeshes, nactive, nswitches, narcs;
  gs_mesh_report *meshes;
  gs_active_bound *active;
  double *switches;              /* [s] */
  gs_singular_arc *arcs;
  void *room;
} gs_motion;

/* In a closed chain numbers of xf for what follows the actuated coordinates are a guess, unless one
 * of these is free there. 0; 1: no memory; 2: the solver refuses, 3: the start is no state of the
 * chain, which ended says */
enum { GS_MOTION_START = 3 };
int gs_collocate (const gs_description *d, const gs_motion_problem *p, const gs_motion_guess *guess,
                  const gs_motion_options *o, gs_motion *r);
void gs_motion_free (gs_motion *r);

#ifdef __cplusplus
}
#endif
#endif

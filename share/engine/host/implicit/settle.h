/* How the steps of radau.c and cvode.c come onto the constraints of loops. */
#ifndef GS_HOST_SETTLE_H
#define GS_HOST_SETTLE_H
#include "implicit_run.h"
#include "radau_solve.h"
#include "rows.h"

typedef struct
{
  int n, m, nq, own;            /* speeds, constraints, coordinates, states */
  gs_rows gram;
  double of;                    /* the shift of D, 0: it is to be taken anew */
  int *pivots;                  /* of B */
  int held;                     /* do springs or dampers hold against D? */
  double *numbers;              /* all that follow */
  double *mass, *rows;          /* factors of M, the gradients, where J is of */
  double *D;                    /* a column for each row that does not depend on others */
  double *B, *here, *gap, *phit, *gamma, *side;   /* gradients HERE by D, what a state misses */
  double *slope;                /* null, or with index 2: J is of speeds u + SLOPE q, N x NQ */
} gs_loops;

/* SOLVE (OF, X): what solves (SHIFT*I - J) X = X */
typedef struct
{
  double shift;
  void (*solve) (const void *of, double *x);
  const void *of;
} gs_factors;

/* null: the scene has none, or there is no memory, which sets *FAILED */
extern gs_loops *gs_new_loops (const gs_stepper *s, int *failed);
extern void gs_free_loops (gs_loops *w);
/* The constraints at the state of the run, where J is of; 0 or a flag. */
extern int gs_take_loops (gs_stepper *s, gs_loops *w);
/* GAP: the constraints at X, gradients in ROWS; 0 or a flag.  GAP: what the speeds of X miss, by
   these. */
extern int gs_constraints (gs_stepper *s, gs_loops *w, double t, const double *x, double *rows);
extern void gs_rates_missed (gs_loops *w, const double *rows, const double *x);
/* the speeds u of X, a solution with J that is of speeds u + SLOPE q */
extern void gs_speeds (const gs_loops *w, double *x);
/* X, of a step to T, onto the constraints along what the scene does under their forces.  SCALE:
   what errors are measured by.  0; 1: gs_moved has to do the rest (Euler parameters, columns of
   derivatives, what rounding left); -1: X is of no use. */
extern int gs_settle (gs_stepper *s, gs_loops *w, const gs_factors *by, const double *scale,
                      double t, double *x);
#endif

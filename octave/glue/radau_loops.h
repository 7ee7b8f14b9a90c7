/* The loops of a scene in the steps of gsmbp_radau.c. */
#ifndef GSMBP_GLUE_RADAU_LOOPS_H
#define GSMBP_GLUE_RADAU_LOOPS_H
#include "implicit.h"
#include "radau_solve.h"

typedef struct gs_loops gs_loops;

/* the factors of SHIFT*I - J; WORK: a number for each state */
typedef struct
{
  const radau_order *order;
  double shift;
  const double *lu;
  const int *pivots;
  double *work;
} gs_factors;

/* null: the scene has none, or there is no memory, which sets *FAILED */
extern gs_loops *gs_new_loops (const gs_run *s, int *failed);
extern void gs_free_loops (gs_loops *w);
/* The constraints at the state of the run, where J is of; 0 or a flag. */
extern int gs_take_loops (gs_run *s, gs_loops *w);
/* X, of a step to T, onto the constraints along what the scene does under their forces.  SCALE:
   what errors are measured by.  0; 1: gs_moved has to do the rest (Euler parameters, columns of
   derivatives, what rounding left); -1: X is of no use. */
extern int gs_settle (gs_run *s, gs_loops *w, const gs_factors *by, const double *scale, double t,
                      double *x);
#endif

/* Loops in index 2 in the steps of radau.c. */
#ifndef GS_HOST_RADAU_INDEX2_H
#define GS_HOST_RADAU_INDEX2_H
#include "settle.h"
#include "radau_rule.h"

typedef struct gs_index2 gs_index2;

/* null: there is no memory */
extern gs_index2 *gs_new_index2 (gs_loops *loops);
extern void gs_free_index2 (gs_index2 *w);

/* J of the states, of where gs_take_loops was called: what stands in its place, for speeds
   u + SLOPE q */
extern void gs_index2_jacobian (gs_stepper *s, gs_index2 *w, double *J);
/* the solution X with it: speeds u again; gs_speeds does it for real ones */
extern void gs_index2_speeds (const gs_index2 *w, double complex *x);

/* The constraints at the stage I, at T and X; 0, 1 or a flag.  When all are known, G, what the
   stages miss of their rates, N numbers each, becomes that of index 2. */
extern int gs_index2_stage (gs_stepper *s, gs_index2 *w, int i, double t, const double *x);
extern void gs_index2_defects (gs_index2 *w, const radau_rule *rule, double h, double *g, int n);
/* the rates F, their speeds along the constraints */
extern void gs_index2_along (gs_index2 *w, double *f);
#endif

/* host/collocation/eliminate.h: unknowns of a program that some of its equations determine, taken
 * out before it is solved. */
#ifndef GSMBP_HOST_COLLOCATION_ELIMINATE_H
#define GSMBP_HOST_COLLOCATION_ELIMINATE_H

#include "host/collocation/nlp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* count blocks, each of size unknowns and size equations that determine them: the first unknown and
 * the first equation of a block stand step_unknown and step_equation behind those of the one before
 * it; no equation of a block has unknowns of another one */
typedef struct
{
  int count, size, unknown, step_unknown, equation, step_equation;
} gs_determined;

/* as gs_nlp_solver, the result is that of the whole program p. The solver gets it without the
 * blocks: they are functions of the other unknowns, their derivatives exact by those of p; or as it
 * is, where an unknown of a block has bounds or its equations are singular at p->x0. */
int gs_solve_eliminated (gs_nlp_solver *solver, const gs_nlp *p, const gs_determined *d,
                         const gs_nlp_options *o, gs_nlp_result *r);

#ifdef __cplusplus
}
#endif
#endif

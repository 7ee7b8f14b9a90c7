/* host/planned.h: the whole motion of a scene of which some coordinates are planned, for all hosts:
 * loops closed on one branch along the plan, internal states of devices carried along. Shapes,
 * units: gsmbp/scene.h; matrices lie by columns. */
#ifndef GSMBP_HOST_PLANNED_H
#define GSMBP_HOST_PLANNED_H

#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  const gs_real *cst;
  int side;                          /* which limit to take where the plan breaks: 1 from the right,
                                        -1 from the left */
  int order;                         /* the highest derivative that is wanted, at least 2 */
  int nplanned;
  const int *planned;                /* their numbers, from 1 */
  int pieces, powers;                /* of polynomials: */
  const gs_real *breaks, *coefficients; /* pieces + 1 [s]; (nplanned,pieces,powers), the highest
                                        power first */
  const gs_real *guess;              /* nu: where the loops begin to close */
  const gs_real *devices;            /* nx-nq-nu: their states at the first time */
  int carry;                         /* 1: internal ones go on by their own rates, of CMD */
  int n;
  const gs_real *t;                  /* n: one after the other [s] */
} gs_planned_asked;

typedef struct
{
  gs_real *qj;                       /* (nu,1+order,n): coordinates and their derivatives */
  gs_real *devices;                  /* (nx-nq-nu,n) */
  int done;                          /* so many times were found */
  char text[1000];                   /* why no more */
} gs_planned_found;

/* Loops that the plan leaves open are closed by CLO, which the scene must have then; a motion of
 * all coordinates of a closed chain must fulfil its constraints. 0; 1: no memory; 2: text says what
 * the chain or a device cannot do; 3: what of the internal states */
int gs_whole_motion (const gs_description *d, const gs_planned_asked *asked,
                     gs_planned_found *found);

#ifdef __cplusplus
}
#endif
#endif

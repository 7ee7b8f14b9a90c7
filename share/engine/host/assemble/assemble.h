/* host/assemble/assemble.h: states that fulfil the constraints, from a guess, for all hosts.
 *
 * Numbers of coordinates and states count from 0; matrices lie by columns. Shapes, units:
 * gsmbp/scene.h. */
#ifndef GSMBP_HOST_ASSEMBLE_H
#define GSMBP_HOST_ASSEMBLE_H

#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  gs_real t;
  const gs_real *cst;
  const int *held;      /* nq: 1: a coordinate that stays as it is, and the speeds that move it;
                           none: coordinates and speeds move as little as PRJ makes them */
  int branches;         /* so many more guesses around the given one, on any branch; 0: none */
  double longest;       /* by how much these change lengths [m], at least */
  double tolerance;     /* the largest |phi| that may be left, in units of the constraints */
  int settle;           /* 1: filters and observers end settled; 0: if they are so in the guess */
  int rank;             /* how many constraints are independent in general; 0: not known */
  const double *limits; /* (nq,2), of the joints; null: none */
} gs_assembly_asked;

typedef struct
{
  int n;                /* how many states were found */
  char text[2400];      /* why there is none */
  char beyond[800];     /* held coordinates beyond the limits of their joints; "": none */
  char lost[1200];      /* where a state is at which constraints have lost rank; "": nowhere */
} gs_assembly;

/* x (nx,1+branches): in its first column the guess, then the states that were found, the one next
 * to the guess first. With coordinates held and no branches the state is on the branch of the
 * guess. start (nx): where the scene starts. 0; 1: no memory */
int gs_assemble (const gs_description *d, const gs_assembly_asked *asked, const gs_real *start,
                 gs_real *x, gs_assembly *found);

/* how the constraints that are independent elsewhere, rank of them, depend on each other in the
 * state x, to 1e-4 of the largest, each row measured by its length there or in start, where the
 * scene starts: 1: text says in which rows, loose (nlam; null: not wanted) is 1 for those whose
 * multipliers no motion determines there; 0: they do not, or the scene has no CON; -1: no memory */
int gs_lost_rank (const gs_description *d, gs_real t, const gs_real *cst, int rank,
                  const gs_real *start, const gs_real *x, int *loose, char *text, int size);

#ifdef __cplusplus
}
#endif
#endif

/* host/reach/reach.h: the axes of poses that are asked for, the choice among the solutions of
 * inverse kinematics (gsmbp/reach.h), and speeds that do not move a tool, for all hosts. Matrices
 * lie by columns without gaps. */
#ifndef GSMBP_HOST_REACH_H
#define GSMBP_HOST_REACH_H

#ifdef __cplusplus
extern "C" {
#endif

/* The axes (3,3) of pose k, a number for messages: of Euler parameters, n = 4 numbers, scalar
 * first, of any length; or the rotation closest to the matrix given, n = 9, whose decimals may be
 * rounded. 1; 0: it is none, and why says so */
int gs_reach_axes (int n, const double *given, int k, double *axes, char *why, int size);

typedef struct
{
  int nq;
  const int *turns;      /* nq: 1 where a coordinate is an angle [rad], which may turn */
  const double *limits;  /* (nq,2): the least and the largest values */
  const double *before;  /* nq: the coordinates of the pose before */
} gs_reach_choice;

/* Of the n solutions q (nq,n), whose angles become those closest to the ones before that the limits
 * allow, on a limit that is passed by 1e-12 at most: which one is within the limits and closest to
 * that before, counted from 0; -1: none.
 * branches (n): of each; branch: the one that is wanted, 0: any. */
int gs_reach_choose (const gs_reach_choice *c, int n, double *q, const int *branches, int branch);

/* speed (n) that does not move the tool, where the rows of its Jacobian (m,n) depend on each other:
 * to 3e-8, the square root of rounding errors, to which a double solution is known; or where the
 * solution is singular already. 1: there it is; 0: it is none, zeros; -1: no memory */
int gs_reach_free (int m, int n, const double *jacobian, int singular, double *speed);

#ifdef __cplusplus
}
#endif
#endif

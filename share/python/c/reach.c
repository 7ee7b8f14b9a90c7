/* reach.c: axes of poses, the choice among solutions of inverse kinematics for the module. */
#include "host/reach/reach.h"

int
gs_loop_axes (int n, const double *given, int k, double *axes, char *why, int size)
{
  return gs_reach_axes (n, given, k, axes, why, size);
}

int
gs_loop_choose (int nq, const int *turns, const double *limits, const double *before, int n,
                double *q, const int *branches, int branch)
{
  return gs_reach_choose (&(gs_reach_choice){ nq, turns, limits, before }, n, q, branches, branch);
}

int
gs_loop_free (int m, int n, const double *jacobian, int singular, double *speed)
{
  return gs_reach_free (m, n, jacobian, singular, speed);
}

/* A non-linear program that is evaluated without Octave: what a scene's module hands to Ipopt's. */
#ifndef GSMBP_GLUE_PROGRAM_H
#define GSMBP_GLUE_PROGRAM_H

enum gsmbp_part { GSMBP_GOAL, GSMBP_GRADIENT, GSMBP_EQUATIONS, GSMBP_JACOBIAN, GSMBP_HESSIAN };

typedef struct
{
  void *data;
  /* PART at the point Z into OUT (FACTOR of the goal and LAMBDA of the equations: for the Hessian);
     0: it has none there */
  int (*evaluate) (void *data, int part, const double *z, double factor, const double *lambda,
                   double *out);
} gsmbp_program;
#endif

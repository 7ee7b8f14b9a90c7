/* The collocation rules of Radau, IIA: their numbers.

   X' = f: the stages X(I) = X0 + Z(I) at the times C(I)*H of a step solve Z = H*A*F(X0 + Z);
   the last one is the end of the step.  Hairer, Wanner: Solving Ordinary Differential Equations
   II, IV.5 and IV.8. */
#ifndef GSMBP_RADAU_RULE_H
#define GSMBP_RADAU_RULE_H
#include <complex.h>

enum { STAGES = 7, PAIRS = 3 };   /* at most: order 13 */

typedef struct
{
  int stages, pairs;
  double c[STAGES + 1],            /* (0) is the start of the step */
      a[STAGES][STAGES], inverse[STAGES][STAGES];
  double root, right[STAGES], left[STAGES];             /* of INVERSE: eigenvalue, eigenvectors */
  double complex roots[PAIRS], rights[PAIRS][STAGES], lefts[PAIRS][STAGES];
  double estimate[STAGES];         /* of Z in the estimate of the error */
} radau_rule;

/* the rule of 3, 5 or 7 stages */
extern const radau_rule *gsmbp_radau_rule (int stages);
#endif

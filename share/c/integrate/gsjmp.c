/* GSJMP: how far a coordinate and a speed may be moved after a step, so that it is no jump: a tenth
 * of the step's own move, or 100 times the tolerance of the largest, or what rounding does to it
 * close to a singular position (its root). */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

void
gsjmp (int nq, int nu, const double *x, const double *xn, double rtol, const double *atol,
       double *jump)
{
  const double root = 10.0 * sqrt (gseps ());
  jump[0] = root;
  jump[1] = 0.0;
  for (int i = 0; i < nq + nu; i++)
    {
      double *most = jump + (i >= nq);
      *most = gs_max (*most, 0.1 * fabs (xn[i] - x[i]));
      *most = gs_max (*most, 1e2 * (atol[i] + rtol * fabs (x[i])));
      *most = gs_max (*most, root * fabs (x[i]));
    }
}

/* gs_largest_move: how far a coordinate and a speed may be moved after a step, so that it is no
 * jump: a tenth of the step's own move, or 100 times the tolerance of the largest, or what rounding
 * does to it close to a singular position (its root). */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

void
gs_largest_move (int nq, int nu, const gs_real *x, const gs_real *xn, gs_real rtol,
                 const gs_real *atol, gs_real *jump)
{
  const gs_real root = 10 * gs_sqrt (gs_epsilon ());
  jump[0] = root;
  jump[1] = 0;
  for (int i = 0; i < nq + nu; i++)
    {
      gs_real *most = jump + (i >= nq);
      *most = gs_max (*most, GS_R (0.1) * gs_abs (xn[i] - x[i]));
      *most = gs_max (*most, GS_R (1e2) * (atol[i] + rtol * gs_abs (x[i])));
      *most = gs_max (*most, root * gs_abs (x[i]));
    }
}

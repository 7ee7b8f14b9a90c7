/* Double and singular solutions of inverse kinematics. As gsigd.f. */
#include <string.h>
#include "gsmbp/arith.h"
#include "gsmbp/reach.h"

static const int turning[] = { 1, 1, 1, 1, 1, 1 };

/* the position x half way between the solutions a and b: does it miss the pose by rounding only? */
static int
are_one (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p, const gs_real *a,
         const gs_real *b, gs_real *x)
{
  gs_real rj[36], e[6], miss;
  if (gs_reach_difference (6, turning, a, b) > GS_R (1e-4))
    return 0;
  for (int i = 0; i < 6; i++)
    {
      gs_real d = a[i] - b[i];
      d = b[i] + GS_R (0.5) * gs_atan2 (gs_sin (d), gs_cos (d));
      x[i] = gs_atan2 (gs_sin (d), gs_cos (d));
    }
  gs_arm_missed (turning, ka, pa, r, p, x, rj, e, &miss);
  return miss <= GS_R (4e-14) * gs_reach_size (6, pa, p);
}

int
gs_arm_doubles (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                gs_real *q, int *ns)
{
  gs_real x[6];
  int info = 0;
  for (int k = *ns - 1; k > 0; k--)
    for (int j = 0; j < k; j++)
      if (are_one (ka, pa, r, p, q + 6 * k, q + 6 * j, x))
        {
          info = 2;
          --*ns;
          memcpy (q + 6 * j, x, sizeof x);
          gs_move (6 * (*ns - k), q + 6 * (k + 1), q + 6 * k);
          break;
        }
  return gs_arm_singular (6, turning, ka, pa, r, p, q, *ns, info);
}

int
gs_arm_singular (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                 const gs_real *p, const gs_real *qs, int ns, int info)
{
  gs_real z[6], s;
  for (int k = 0; k < ns; k++)
    {
      gs_reach_least_move (n, kind, ka, pa, r, p, qs + n * k, z, &s);
      info = s <= GS_R (3e-8) ? 2 : info;
    }
  return info;
}

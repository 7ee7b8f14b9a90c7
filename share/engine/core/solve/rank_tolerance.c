#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

/* The next position on the constraints is about d = max |phi[i]|/size[i] [rad or m] away, size[i]
 * that of row i of h (gs_qr_groups). On the way there, rows change by parts of the size of d: of a
 * row that is dependent there, some d times its size is left here. And where s times its size is
 * left of an independent row, the way may be as long as d/s, which changes s by little only if s^2
 * > d (Kantorovich's condition for Newton's method). So the tolerance is the root of d: above it
 * the rank here is the rank on the constraints, below it nobody can tell. It stays between rounding
 * errors, 1e-11, and 1e-2.
 *
 * Ortega and Rheinboldt 1970, Iterative solution of nonlinear equations in several variables,
 * 12.6. */
void
gs_rank_tolerance (int n, int m, const gs_real *h, int ldh, const gs_real *phi, const int *grp,
                   gs_real *tol, gs_real *w)
{
  gs_real d = 0;
  for (int i = 0; i < m; i++)
    {
      gs_real s = 0;
      for (int j = 0; j < n; j++)
        s += h[i + ldh * j] * h[i + ldh * j];
      w[i] = gs_sqrt (s);
    }
  gs_group_sizes (m, grp, GS_R (1e-3), w);
  for (int i = 0; i < m; i++)
    if (w[i] > 0)
      d = gs_max (d, gs_abs (phi[i]) / w[i]);
  *tol = gs_min (GS_R (1e-2), gs_max (GS_R (5e4) * gs_epsilon (), gs_sqrt (d)));
}

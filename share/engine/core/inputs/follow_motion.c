/* gs_follow_motion: the motion of a closed chain of which some coordinates are planned: the others
 * come from clo, on the branch on which they were at the time before.
 *
 * Newton's method of clo goes to some closure, near or far. From the time of qj to t the motion is
 * followed along the plan. A step counts if each dependent coordinate moves by the mean of its
 * rates at both ends times the step, but for a tenth of the larger rate (and 1e-6): else another
 * branch may have been met, and half the step is tried. qj stays on its branch when info is not
 * 0. */

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

int
gs_motion_follows (int nu, gs_real dt, const gs_real *old, const gs_real *qj)
{
  for (int i = 0; i < nu; i++)
    {
      gs_real move = qj[i] - old[i] - GS_R (0.5) * dt * (qj[i + nu] + old[nu + i]);
      gs_real rate = gs_max (gs_abs (qj[i + nu]), gs_abs (old[nu + i]));
      if (! (gs_abs (move) <= GS_R (0.1) * gs_abs (dt) * rate + GS_R (1e-6)))
        return 0;
    }
  return 1;
}

int
gs_follow_motion (const gs_scene *s, gs_real t, int side, int r, int na, const int *ipl, int np,
                  int k, const gs_real *brk, const gs_real *coef, const gs_real *cst, gs_real *qj,
                  gs_real *w)
{
  const int nu = s->nu;
  gs_real *const f = w + 2, *const old = f + na * (r + 1);
  int halvings = 0, info;
  if (w[1] <= 0)
    w[0] = t;
  gs_real h = t - w[0];
  for (;;)
    {
      gs_real tn = w[0] + h, res;
      if (gs_abs (tn - t) <= GS_R (0.5) * gs_abs (h))
        tn = t;
      const int atend = gs_abs (tn - t) <= 0;
      const gs_real dt = tn - w[0];
      gs_copy (2 * nu, qj, old);
      if (w[1] > 0)
        for (int i = 0; i < nu; i++)
          qj[i] += dt * qj[i + nu];
      info = gs_planned_rows (tn, atend ? side : 1, nu, r, na, ipl, np, k, brk, coef, f, qj);
      if (info < 0)
        break;
      info = s->clo (tn, qj, cst, &res);
      const int moves = atend || gs_abs (dt) > 0; /* not a step that rounding made 0 */
      if (info == 0 && moves && (! (w[1] > 0) || gs_motion_follows (nu, dt, old, qj)))
        {
          w[0] = tn;
          w[1] = 1;
          h = 2 * dt;
          if (gs_abs (h) > gs_abs (t - tn))
            h = t - tn;
          if (atend)
            return 0;
          continue;
        }
      if (w[1] <= 0 || halvings >= 100 || gs_abs (dt) <= 0)
        {
          if (info == 0)
            info = 2;
          break;
        }
      halvings++;
      h = GS_R (0.5) * dt;
      gs_motion_back (nu, old, qj);
    }
  gs_motion_back (nu, old, qj);
  return info;
}

int
gs_planned_rows (gs_real t, int side, int nu, int r, int na, const int *ipl, int np, int k,
                 const gs_real *brk, const gs_real *coef, gs_real *f, gs_real *qj)
{
  int info = gs_polynomials_at (na, np, k, brk, coef, t, side, r, f, gs_most (1, na));
  for (int j = 0; j <= r; j++)
    for (int i = 0; i < na; i++)
      qj[ipl[i] - 1 + nu * j] = f[i + na * j];
  return gs_least (0, info);
}

void
gs_motion_back (int nu, const gs_real *w, gs_real *qj)
{
  gs_copy (2 * nu, w, qj);
}

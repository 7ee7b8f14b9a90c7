/* GSFOL: the motion of a closed chain of which some coordinates are planned: the others come from
 * clo, on the branch on which they were at the time before.
 *
 * Newton's method of clo goes to some closure, near or far. From the time of qj to t the motion is
 * followed along the plan. A step counts if each dependent coordinate moves by the mean of its
 * rates at both ends times the step, but for a tenth of the larger rate (and 1e-6): else another
 * branch may have been met, and half the step is tried. qj stays on its branch when info is not
 * 0. */
#include <math.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

/* do the coordinates in qj follow from those in old by their rates? */
static int
follows (int nu, double dt, const double *old, const double *qj)
{
  for (int i = 0; i < nu; i++)
    {
      double move = qj[i] - old[i] - 0.5 * dt * (qj[i + nu] + old[nu + i]);
      double rate = gs_max (fabs (qj[i + nu]), fabs (old[nu + i]));
      if (! (fabs (move) <= 0.1 * fabs (dt) * rate + 1e-6))
        return 0;
    }
  return 1;
}

int
gsfol (const gs_scene *s, double t, int side, int r, int na, const int *ipl, int np, int k,
       const double *brk, const double *coef, const double *cst, double *qj, double *w)
{
  const int nu = s->nu;
  double *const f = w + 2, *const old = f + na * (r + 1);
  int halvings = 0, info;
  if (w[1] <= 0.0)
    w[0] = t;
  double h = t - w[0];
  for (;;)
    {
      double tn = w[0] + h, res;
      if (fabs (tn - t) <= 0.5 * fabs (h))
        tn = t;
      const int atend = fabs (tn - t) <= 0.0;
      const double dt = tn - w[0];
      memcpy (old, qj, 2 * nu * sizeof (double));
      if (w[1] > 0.0)
        for (int i = 0; i < nu; i++)
          qj[i] += dt * qj[i + nu];
      info = gsppl (tn, atend ? side : 1, nu, r, na, ipl, np, k, brk, coef, f, qj);
      if (info < 0)
        break;
      info = s->clo (tn, qj, cst, &res);
      const int moves = atend || fabs (dt) > 0.0; /* not a step that rounding made 0 */
      if (info == 0 && moves && (! (w[1] > 0.0) || follows (nu, dt, old, qj)))
        {
          w[0] = tn;
          w[1] = 1.0;
          h = 2.0 * dt;
          if (fabs (h) > fabs (t - tn))
            h = t - tn;
          if (atend)
            return 0;
          continue;
        }
      if (w[1] <= 0.0 || halvings >= 100 || fabs (dt) <= 0.0)
        {
          if (info == 0)
            info = 2;
          break;
        }
      halvings++;
      h = 0.5 * dt;
      gsbak (nu, old, qj);
    }
  gsbak (nu, old, qj);
  return info;
}

int
gsppl (double t, int side, int nu, int r, int na, const int *ipl, int np, int k, const double *brk,
       const double *coef, double *f, double *qj)
{
  int info = gspln (na, np, k, brk, coef, t, side, r, f, gs_most (1, na));
  for (int j = 0; j <= r; j++)
    for (int i = 0; i < na; i++)
      qj[ipl[i] - 1 + nu * j] = f[i + na * j];
  return gs_least (0, info);
}

void
gsbak (int nu, const double *w, double *qj)
{
  memcpy (qj, w, 2 * nu * sizeof (double));
}

/* GSRSF: friction at rest that slides against its push: the mode of the first such port is set to
 * 0; or, where there is none, that of the first stop that a port at rest is pushed against.
 *
 * Several ports may be let go at one instant, and what lets one go may hold another. One that is at
 * rest slides the right way if it could not be held: if the effort that would hold it, the modes of
 * the others being as they are, is beyond its limit and against the way it slides. This and what
 * lets ports go (gsres) are the pivots of a linear complementarity problem in the ports at rest. A
 * stop pushes if it would in contact. Where another port that moves alike is held, it is enough. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* GSHLJ: is another port held that moves as port i does (friction and a stop in one joint)? */
int
gshlj (int nu, int nh, int i, const int *kind, const int *mode, const double *row)
{
  int found = 0;
  for (int j = 0; j < nh; j++)
    if (j != i && (kind[j] == 1) == (mode[j] == 0))
      {
        double a = 0.0, b = 0.0, c = 0.0;
        for (int n = 0; n < nu; n++)
          {
            const double x = row[i + nh * n], y = row[j + nh * n];
            a += x * x;
            b += y * y;
            c += x * y;
          }
        found |= c * c >= (1.0 - 1e-12) * a * b;
      }
  return found;
}

/* the largest of the efforts that hold and of those that may */
static double
largest (int nh, const int *kind, const double *hold, const double *prm)
{
  double c = 0.0;
  for (int j = 0; j < nh; j++)
    {
      c = gs_max (c, fabs (hold[j]));
      if (kind[j] == 1)
        c = gs_max (c, prm[4 * j]);
    }
  return c;
}

void
gsrsf (const gs_scene *s, double t, const double *x, const double *v, int *mode,
       const double *cst, int nh, const int *kind, const int *ipl, double *vm, double *ud,
       double *lam, double *hold, double *row, double *pos, double *sd, double *prm)
{
  s->hld (t, x, v, cst, row, nh, pos, sd, prm);
  for (int i = 0; i < nh; i++)
    {
      const int way = mode[i];
      if (kind[i] != 1 || way == 0 || fabs (sd[i]) > 1.000001e-9 * prm[4 * i + 1]
          || gshlj (s->nu, nh, i, kind, mode, row))
        continue;
      mode[i] = 0;
      gshld (s, t, x, v, mode, cst, nh, kind, ipl, vm, ud, lam, hold, row, pos, sd, prm);
      if (way * hold[i] > -(1.0 - 1e-9) * prm[4 * i])
        return;
      mode[i] = way;
    }
  for (int i = 0; i < nh; i++)
    {
      const double up = prm[4 * i + 1] - pos[i], down = pos[i] - prm[4 * i];
      if (kind[i] != 2 || mode[i] != 0 || gs_min (up, down) > gsate (pos[i], prm + 4 * i)
          || fabs (sd[i]) > 1e-9 * prm[4 * i + 3] || gshlj (s->nu, nh, i, kind, mode, row))
        continue;
      mode[i] = down < up ? -1 : 1;
      gshld (s, t, x, v, mode, cst, nh, kind, ipl, vm, ud, lam, hold, row, pos, sd, prm);
      if (mode[i] * hold[i] < -1e-9 * largest (nh, kind, hold, prm))
        return;
      mode[i] = 0;
    }
}

/* gs_release_port: friction at rest that slides against its push: the mode of the first such port
 * is set to 0; or, where there is none, that of the first stop that a port at rest is pushed
 * against.
 *
 * Several ports may be let go at one instant, and what lets one go may hold another. One that is at
 * rest slides the right way if it could not be held: if the effort that would hold it, the modes of
 * the others being as they are, is beyond its limit and against the way it slides. This and what
 * lets ports go (gs_resolve_event) are the pivots of a linear complementarity problem in the ports
 * at rest. A stop pushes if it would in contact. Where another port that moves alike is held, it is
 * enough. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* gs_port_held_twice: is another port held that moves as port i does (friction and a stop in one
   joint)? */
int
gs_port_held_twice (int nu, int nh, int i, const int *kind, const int *mode, const gs_real *row)
{
  int found = 0;
  for (int j = 0; j < nh; j++)
    if (j != i && (kind[j] == 1) == (mode[j] == 0))
      {
        gs_real a = 0, b = 0, c = 0;
        for (int n = 0; n < nu; n++)
          {
            const gs_real x = row[i + nh * n], y = row[j + nh * n];
            a += x * x;
            b += y * y;
            c += x * y;
          }
        found |= c * c >= (1 - GS_R2 (1e-12, 1e-6)) * a * b;
      }
  return found;
}

/* the largest of the efforts that hold and of those that may */
static gs_real
largest (int nh, const int *kind, const gs_real *hold, const gs_real *prm)
{
  gs_real c = 0;
  for (int j = 0; j < nh; j++)
    {
      c = gs_max (c, gs_abs (hold[j]));
      if (kind[j] == 1)
        c = gs_max (c, prm[4 * j]);
    }
  return c;
}

void
gs_release_port (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *v, int *mode,
                 const gs_real *cst, int nh, const int *kind, const int *ipl, gs_real *vm,
                 gs_real *ud, gs_real *lam, gs_real *hold, gs_real *row, gs_real *pos, gs_real *sd,
                 gs_real *prm)
{
  s->hld (t, x, v, cst, row, nh, pos, sd, prm);
  for (int i = 0; i < nh; i++)
    {
      const int way = mode[i];
      if (kind[i] != 1 || way == 0
          || gs_abs (sd[i]) > GS_R2 (1.000001e-9, 1.00001e-5) * prm[4 * i + 1]
          || gs_port_held_twice (s->nu, nh, i, kind, mode, row))
        continue;
      mode[i] = 0;
      gs_ports_held (s, t, x, v, mode, cst, nh, kind, ipl, vm, ud, lam, hold, row, pos, sd, prm);
      if ((gs_real)way * hold[i] > -(1 - GS_R2 (1e-9, 1e-5)) * prm[4 * i])
        return;
      mode[i] = way;
    }
  for (int i = 0; i < nh; i++)
    {
      const gs_real up = prm[4 * i + 1] - pos[i], down = pos[i] - prm[4 * i];
      if (kind[i] != 2 || mode[i] != 0 || gs_min (up, down) > gs_stop_nearness (pos[i], prm + 4 * i)
          || gs_abs (sd[i]) > GS_R2 (1e-9, 1e-5) * prm[4 * i + 3]
          || gs_port_held_twice (s->nu, nh, i, kind, mode, row))
        continue;
      mode[i] = down < up ? -1 : 1;
      gs_ports_held (s, t, x, v, mode, cst, nh, kind, ipl, vm, ud, lam, hold, row, pos, sd, prm);
      if ((gs_real)mode[i] * hold[i] < -GS_R2 (1e-9, 1e-5) * largest (nh, kind, hold, prm))
        return;
      mode[i] = 0;
    }
}

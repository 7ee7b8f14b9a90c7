/* gs_port_functions: event functions of the ports that stick or hit a stop: above 0 where nothing
 * happens; an event is where one falls to 0.
 *
 * mode: friction 1 or -1 where it slides forward or backward, 0 where it sticks; stops 1 or -1
 * where the upper or lower stop is in contact, else 0. prm (4,k): friction: the largest force that
 * holds, its Stribeck speed (a speed 1e-9 of this the other way is rest, not sliding back:
 * rounding errors where a stop holds the port, too); stops: lower and upper end, restitution,
 * speed of rebound below which the contact stays. A port that rests where a stop is, held by
 * something else, or leaves it does not hit it: what is left of its distance, up to 1e-12 of its
 * travel (gs_stop_travel) before its end and 1e-6 behind it, are errors of rounding and of the step
 * that came there. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* gs_stop_travel: the travel of a stop that errors at its nearer end are beside: its range, but no
 * more than 1 [m or rad] or the modulus of that end, the larger one of them, as the other end may
 * be out of reach */
gs_real
gs_stop_travel (gs_real s, const gs_real *prm)
{
  const gs_real end = prm[1] - s < s - prm[0] ? prm[1] : prm[0];
  return gs_min (prm[1] - prm[0], gs_max (1, gs_abs (end)));
}

void
gs_port_functions (int k, const int *kind, const int *mode, const gs_real *s, const gs_real *sd,
                   const gs_real *prm, const gs_real *hold, gs_real *gv)
{
  for (int i = 0; i < k; i++, prm += 4)
    if (kind[i] == 1 && mode[i] == 0)
      gv[i] = prm[0] - gs_abs (hold[i]);
    else if (kind[i] == 1)
      gv[i] = (gs_real)mode[i] * sd[i] + GS_R2 (1e-9, 1e-5) * prm[1];
    else if (mode[i] == 0)
      {
        const gs_real tiny = GS_R2 (1e-12, 1e-7) * gs_stop_travel (s[i], prm);
        gv[i] = (prm[1] - s[i]) * (s[i] - prm[0]) / (prm[1] - prm[0]);
        const gs_real way = s[i] - prm[0] < prm[1] - s[i] ? -sd[i] : sd[i];
        if (gv[i] <= tiny && gv[i] >= -GS_R (1e6) * tiny && way <= GS_R2 (1e-9, 1e-5) * prm[3])
          gv[i] = tiny;
      }
    else
      gv[i] = -(gs_real)mode[i] * hold[i];
}

/* gs_correct_modes: modes of ports that contradict the state: they are changed to what it says.
 *
 * Friction that moves does not stick, nor slide the other way; a stop is not in contact away from
 * its end, nor with a port that moves. The end of a run may be the start of another one, so that
 * there is room for its errors: what a port that is one of the speeds keeps to rounding where it is
 * held; much more where it is held along a row that turns with the state, or beside loops. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* the speeds that the row of a port adds up; how many */
static gs_real
added (int nu, int nh, const gs_real *row, const gs_real *u, int *n)
{
  gs_real size = 0;
  *n = 0;
  for (int j = 0; j < nu; j++)
    {
      *n += gs_abs (row[nh * j]) > 0;
      size += gs_abs (row[nh * j] * u[j]);
    }
  return size;
}

void
gs_correct_modes (int nu, int nlam, int nh, const int *kind, int *mode, const gs_real *row,
                  const gs_real *s, const gs_real *sd, const gs_real *prm, const gs_real *u)
{
  for (int i = 0; i < nh; i++)
    {
      const gs_real *p = prm + 4 * i;
      int n;
      const gs_real size = added (nu, nh, row + i, u, &n);
      const int loose = n > 1 || nlam > 0;
      gs_real e = loose ? GS_R (1e-2) * size : 0;
      if (kind[i] == 1)
        {
          if (loose)
            e = e + p[1];
          e = gs_max (e, GS_R2 (1e-6, 1e-4) * p[1]);
          if (gs_abs (sd[i]) > e && (gs_real)mode[i] * sd[i] <= 0)
            mode[i] = sd[i] < 0 ? -1 : 1;
        }
      else if (mode[i] != 0)
        {
          const gs_real gap
              = gs_abs (mode[i] > 0 ? p[1] - s[i] : s[i] - p[0]) / gs_stop_travel (s[i], p);
          if (loose)
            e = e + GS_R (1e2) * p[3];
          e = gs_max (e, p[3]);
          if (gs_abs (sd[i]) > e || gap > GS_R (1e-2) || (gap > GS_R2 (1e-6, 1e-4) && ! loose))
            mode[i] = 0;
        }
    }
}

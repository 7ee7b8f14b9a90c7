/* GSRSM: modes of ports that contradict the state: they are changed to what it says.
 *
 * Friction that moves does not stick, nor slide the other way; a stop is not in contact away from
 * its end, nor with a port that moves. The end of a run may be the start of another one, so that
 * there is room for its errors: what a port that is one of the speeds keeps to rounding where it is
 * held; much more where it is held along a row that turns with the state, or beside loops. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* the speeds that the row of a port adds up; how many */
static double
added (int nu, int nh, const double *row, const double *u, int *n)
{
  double size = 0.0;
  *n = 0;
  for (int j = 0; j < nu; j++)
    {
      *n += fabs (row[nh * j]) > 0.0;
      size += fabs (row[nh * j] * u[j]);
    }
  return size;
}

void
gsrsm (int nu, int nlam, int nh, const int *kind, int *mode, const double *row, const double *s,
       const double *sd, const double *prm, const double *u)
{
  for (int i = 0; i < nh; i++)
    {
      const double *p = prm + 4 * i;
      int n;
      const double size = added (nu, nh, row + i, u, &n);
      const int loose = n > 1 || nlam > 0;
      double e = loose ? 1e-2 * size : 0.0;
      if (kind[i] == 1)
        {
          if (loose)
            e = e + p[1];
          e = gs_max (e, 1e-6 * p[1]);
          if (fabs (sd[i]) > e && mode[i] * sd[i] <= 0.0)
            mode[i] = sd[i] < 0.0 ? -1 : 1;
        }
      else if (mode[i] != 0)
        {
          const double gap = fabs (mode[i] > 0 ? p[1] - s[i] : s[i] - p[0]) / gstvl (s[i], p);
          if (loose)
            e = e + 1e2 * p[3];
          e = gs_max (e, p[3]);
          if (fabs (sd[i]) > e || gap > 1e-2 || (gap > 1e-6 && ! loose))
            mode[i] = 0;
        }
    }
}

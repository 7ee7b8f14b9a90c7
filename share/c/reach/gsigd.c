/* Double and singular solutions of inverse kinematics. As gsigd.f. */
#include <math.h>
#include <string.h>
#include "gsmbp/reach.h"

static const int turning[] = { 1, 1, 1, 1, 1, 1 };

/* the position x half way between the solutions a and b: does it miss the pose by rounding only? */
static int
are_one (const double *ka, const double *pa, const double *r, const double *p, const double *a,
         const double *b, double *x)
{
  double rj[36], e[6], miss;
  if (gsikk (6, turning, a, b) > 1e-4)
    return 0;
  for (int i = 0; i < 6; i++)
    {
      double d = a[i] - b[i];
      d = b[i] + 0.5 * atan2 (sin (d), cos (d));
      x[i] = atan2 (sin (d), cos (d));
    }
  gsikj (turning, ka, pa, r, p, x, rj, e, &miss);
  return miss <= 4e-14 * gsik0 (6, pa, p);
}

int
gsigd (const double *ka, const double *pa, const double *r, const double *p, double *q, int *ns)
{
  double x[6];
  int info = 0;
  for (int k = *ns - 1; k > 0; k--)
    for (int j = 0; j < k; j++)
      if (are_one (ka, pa, r, p, q + 6 * k, q + 6 * j, x))
        {
          info = 2;
          --*ns;
          memcpy (q + 6 * j, x, sizeof x);
          memmove (q + 6 * k, q + 6 * (k + 1), 6 * (*ns - k) * sizeof (double));
          break;
        }
  return gsigs (6, turning, ka, pa, r, p, q, *ns, info);
}

int
gsigs (int n, const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *qs, int ns, int info)
{
  double z[6], s;
  for (int k = 0; k < ns; k++)
    {
      gsiko (n, kind, ka, pa, r, p, qs + n * k, z, &s);
      info = s <= 3e-8 ? 2 : info;
    }
  return info;
}

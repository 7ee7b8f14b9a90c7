/* GSDUE: the sampled devices at a stop of a run: what is due at t happens, with the inputs from the
 * right. */
#include <math.h>

#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/system.h"

int
gsdue (const gs_scene *s, double t, const double *x, int nx, int *ip, double *rp,
       const double *cst, double *v, double *w, int *istat, double *ts, int *acted)
{
  *acted = 0;
  *ts = 2e300;
  if (ip[GS_SAMPLES] <= 0)
    return 0;
  int *is = ip + ip[GS_SAMPLES] - 1;
  double *rs = rp + ip[GS_SAMPLES + 1] - 1;
  *ts = gsnxt (s->nv, is, rs);
  if (*ts > t + 8.0 * gseps () * fabs (t))
    return 0;
  *acted = 1;
  istat[GS_FAILED_INFO] = gsinp (s, t, 1, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = 1;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  istat[GS_FAILED_INFO] = gssmp (s, t, x, cst, v, is, rs);
  istat[GS_FAILED] = 6;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  istat[GS_FAILED] = 0;
  *ts = gsnxt (s->nv, is, rs);
  return 0;
}

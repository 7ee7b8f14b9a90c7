/* gs_samples_due: the sampled devices at a stop of a run: what is due at t happens, with the inputs
 * from the right. */

#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/system.h"

int
gs_samples_due (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip, gs_real *rp,
                const gs_real *cst, gs_real *v, gs_real *w, int *istat, gs_real *ts, int *acted)
{
  *acted = 0;
  *ts = 2 * GS_HUGE;
  if (ip[GS_SAMPLES] <= 0)
    return 0;
  int *is = ip + ip[GS_SAMPLES] - 1;
  gs_real *rs = rp + ip[GS_SAMPLES + 1] - 1;
  *ts = gs_next_sample (s->nv, is, rs);
  if (*ts > t + 8 * gs_epsilon () * gs_abs (t))
    return 0;
  *acted = 1;
  istat[GS_FAILED_INFO] = gs_inputs_of_run (s, t, 1, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = GS_AT_INPUTS;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  istat[GS_FAILED_INFO] = gs_sample (s, t, x, cst, v, is, rs);
  istat[GS_FAILED] = GS_AT_OUTPUT;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  istat[GS_FAILED] = GS_AT_NOTHING;
  *ts = gs_next_sample (s->nv, is, rs);
  return 0;
}

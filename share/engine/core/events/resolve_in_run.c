/* gs_resolve_under_inputs: gs_resolve_event under the inputs of a run, from the right. At the start
 * (k = 0) of a run where a sampled device acts functions of the user are marked only if they are
 * above 0 just before, too (gs_event_at_begin). gs_resolve_in_run: what is told of it. */
#include "gsmbp/events.h"
#include "gsmbp/inputs.h"

int
gs_resolve_under_inputs (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                         const gs_real *cst, gs_real *v, gs_real *w, int *istat, int k)
{
  if (ip[GS_EVENTS] <= 0)
    return 0;
  istat[GS_FAILED_INFO] = gs_inputs_of_run (s, t, 1, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = GS_AT_INPUTS;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  const int info = gs_resolve_in_run (s, t, x, nx, ip, rp, cst, v, istat, k);
  if (info == 0 && k == 0)
    gs_event_at_begin (s, t, x, nx, ip, rp, cst, v, w);
  return info;
}

int
gs_resolve_in_run (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                   const gs_real *cst, gs_real *v, int *istat, int k)
{
  int *ie = ip + ip[GS_EVENTS] - 1;
  gs_real *re = rp + ip[GS_EVENTS + 1] - 1;
  istat[GS_FAILED_INFO] = gs_resolve_event (s, t, x, nx, v, cst, k, ie, re);
  istat[GS_FAILED] = istat[GS_FAILED_INFO] != 0 ? GS_AT_EVENT : GS_AT_NOTHING;
  if (istat[GS_FAILED] != GS_AT_NOTHING)
    istat[GS_CAUSE]
        = istat[GS_FAILED_INFO] == 13 ? ie[8] : *gs_events_of (nx, ie, re).newest;
  return istat[GS_FAILED_INFO];
}

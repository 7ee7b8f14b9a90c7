/* GSEND: the end of a run: an event of the user that lies there.
 *
 * Steps end at a stop as it is just before (GSLFT); what the event functions are at t itself counts
 * here: an event belongs to the run if its function is not above 0 there, else to one that goes on
 * from there. No other event happens: ports find their modes where a run begins. */
#include "gsmbp/events.h"
#include "gsmbp/inputs.h"

int
gsenf (const gs_scene *s, const gs_events *a, double t, const double *x, const double *v,
       const double *cst)
{
  int k = 0;
  s->evt (t, x, v, a->mode, cst, a->now);
  gsusg (a);
  for (int i = a->ne - 1; i >= 0; i--)
    if (gs_is_own (a, i) && a->mark[i] == 1 && a->now[i] <= 0.0)
      k = i + 1;
  return k;
}

int
gsend (const gs_scene *s, double t, double *x, int nx, int *ip, double *rp, const double *cst,
       double *v, double *w, int *istat)
{
  if (ip[GS_EVENTS] <= 0)
    return 0;
  int *ie = ip + ip[GS_EVENTS] - 1;
  double *re = rp + ip[GS_EVENTS + 1] - 1;
  const gs_events a = gs_events_of (nx, ie, re);
  const int k = gsenf (s, &a, t, x, v, cst);
  if (k == 0)
    return 0;
  istat[GS_FAILED_INFO] = gsres (s, t, x, nx, v, cst, k, ie, re);
  istat[GS_FAILED] = 7;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  istat[GS_FAILED_INFO] = gsinp (s, t, -1, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = istat[GS_FAILED_INFO] != 0 ? 1 : 0;
  return istat[GS_FAILED_INFO];
}

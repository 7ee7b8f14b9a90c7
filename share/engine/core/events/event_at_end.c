/* gs_event_at_end: the end of a run: an event of the user that lies there.
 *
 * Steps end at a stop as it is just before (gs_time_beside); what the event functions are at t
 * itself counts here: an event belongs to the run if its function is not above 0 there, else to one
 * that goes on from there. So does one that a jump of the inputs at t brings about, as within a run
 * (gs_integration_stop, k = -1). No other event happens: ports find their modes where a run begins.
 * Behind an event v is from the right. What a sample at t takes back is no event, either: it is
 * computed with states alone where a run carries derivatives. */
#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/plan.h"

int
gs_event_first_above (const gs_scene *s, const gs_events *a, gs_real t, const gs_real *x,
                      const gs_real *v, const gs_real *cst)
{
  int k = -1;
  s->evt (t, x, v, a->mode, cst, a->now);
  gs_user_values_now (a);
  for (int i = a->ne - 1; i >= 0; i--)
    if (gs_is_own (a, i) && a->mark[i] == 1)
      k = a->now[i] <= 0 ? i + 1 : gs_most (k, 0);
  return k;
}

void
gs_event_before_sample (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip,
                        gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w, int *istat)
{
  gs_real ts;
  int acted;
  if (ip[GS_SAMPLES] <= 0 || ip[GS_EVENTS] <= 0)
    return;
  int *is = ip + ip[GS_SAMPLES] - 1;
  gs_real *rs = rp + ip[GS_SAMPLES + 1] - 1;
  const gs_events a = gs_planned_events (nx, ip, rp);
  if (gs_next_sample (s->nv, is, rs) > t + 8 * gs_epsilon () * gs_abs (t)
      || gs_inputs_of_run (s, t, 1, x, nx, ip, rp, cst, v, w) != 0
      || gs_event_first_above (s, &a, t, x, v, cst) <= 0)
    return;
  for (int i = 0; i < a.ne; i++)
    a.marks[i] = a.mark[i] == 1 && a.now[i] <= 0;
  gs_sample_keep (0, s->nv, is, rs);
  *a.search = *a.tells == 1;
  const int info = gs_samples_due (s, t, x, nx, ip, rp, cst, v, w, istat, &ts, &acted);
  *a.search = 0;
  gs_sample_keep (1, s->nv, is, rs);
  istat[GS_FAILED_INFO] = 0;
  istat[GS_FAILED] = GS_AT_NOTHING;
  if (info != 0)
    return;
  gs_event_first_above (s, &a, t, x, v, cst);
  for (int i = 0; i < a.ne; i++)
    if (gs_is_own (&a, i) && a.marks[i] == 1 && a.now[i] > 0)
      a.mark[i] = 0;
}

void
gs_event_at_begin (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip, gs_real *rp,
                   const gs_real *cst, gs_real *v, gs_real *w)
{
  if (ip[GS_SAMPLES] <= 0 || ip[GS_EVENTS] <= 0
      || gs_next_sample (s->nv, ip + ip[GS_SAMPLES] - 1, rp + ip[GS_SAMPLES + 1] - 1)
             > t + 8 * gs_epsilon () * gs_abs (t))
    return;
  const gs_events a = gs_planned_events (nx, ip, rp);
  if (gs_inputs_of_run (s, t, -1, x, nx, ip, rp, cst, v, w) == 0)
    {
      gs_event_first_above (s, &a, gs_time_beside (t, -1), x, v, cst);
      for (int i = 0; i < a.ne; i++)
        if (gs_is_own (&a, i) && a.now[i] <= 0)
          a.mark[i] = 0;
    }
  gs_inputs_of_run (s, t, 1, x, nx, ip, rp, cst, v, w);
}

int
gs_event_at_end (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                 const gs_real *cst, gs_real *v, gs_real *w, int *istat)
{
  if (ip[GS_EVENTS] <= 0)
    return 0;
  const gs_events a = gs_planned_events (nx, ip, rp);
  gs_event_before_sample (s, t, x, nx, ip, rp, cst, v, w, istat);
  istat[GS_FAILED_INFO] = gs_inputs_of_run (s, t, -1, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = istat[GS_FAILED_INFO] != 0 ? GS_AT_INPUTS : GS_AT_NOTHING;
  if (istat[GS_FAILED_INFO] != 0)
    return istat[GS_FAILED_INFO];
  int k = gs_event_first_above (s, &a, t, x, v, cst), side = k > 0 ? 1 : -1;
  int info = k > 0 ? gs_resolve_in_run (s, t, x, nx, ip, rp, cst, v, istat, k) : 0;
  if (k < 0 || info != 0)
    return info;

  /* from the right; nothing where the run has ended already */
  if (gs_inputs_of_run (s, t, 1, x, nx, ip, rp, cst, v, w) == 0 && gs_ended (ip) == 0
      && gs_event_first_above (s, &a, t, x, v, cst) > 0)
    {
      side = 1;
      info = gs_resolve_in_run (s, t, x, nx, ip, rp, cst, v, istat, -1);
      if (info != 0)
        return info;
    }
  istat[GS_FAILED_INFO] = gs_inputs_of_run (s, t, side, x, nx, ip, rp, cst, v, w);
  istat[GS_FAILED] = istat[GS_FAILED_INFO] != 0 ? GS_AT_INPUTS : GS_AT_NOTHING;
  return istat[GS_FAILED_INFO];
}

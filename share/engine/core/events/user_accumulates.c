/* gs_user_before_event, gs_user_after_event, gs_user_points, gs_user_accumulates, gs_user_rises:
 * what is remembered of events of the user, and whether they accumulate. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

void
gs_user_before_event (const gs_events *a, int i, gs_real t, const gs_real *x)
{
  gs_real *r = gs_told (a, i - 1);
  for (int k = 3; k > 0; k--)
    r[GS_TOLD_TIMES + k] = r[GS_TOLD_TIMES + k - 1];
  r[GS_TOLD_TIMES] = t;
  gs_copy (a->nx, x, r + GS_TOLD_STATE);
}

void
gs_user_after_event (const gs_events *a, int i, const gs_real *x)
{
  gs_real *r = gs_told (a, i - 1);
  r[GS_TOLD_CHANGED] = 0;
  for (int k = 0; k < a->nx; k++)
    if (gs_abs (r[GS_TOLD_STATE + k] - x[k]) > 0)
      r[GS_TOLD_CHANGED] = 1;
  gs_copy (a->nx, x, r + GS_TOLD_STATE);
}

/* The rate of the function is the difference quotient of second order along the rates of the
 * states. */
int
gs_user_rises (const gs_system *s, const gs_events *a, int i, gs_real fell, gs_real d)
{
  gs_real *told = gs_told (a, i), *x = told + GS_TOLD_STATE;
  const gs_real t = told[GS_TOLD_TIMES];
  gs_real rate = 0;
  if (gs_rates_at (s, t, 1, x, a->end) != 0)
    return 1;
  for (int side = -1; side <= 1; side += 2)
    {
      for (int j = 0; j < a->nx; j++)
        a->z[j] = x[j] + (gs_real)side * d * a->end[j];
      if (gs_event_values (s, t + (gs_real)side * d, 1, a->z, a->mode, a->before) != 0)
        return 1;
      rate += (gs_real)side * a->before[i] / (2 * d);
    }
  return ! (rate < -GS_R (0.01) * fell);
}

/* A function has its fourth event within 1000 units of rounding of the time. One that only reports
 * does not accumulate: it has to rise higher, tenfold, to have risen again. */
static int
at_once (const gs_events *a, int i, gs_real end)
{
  gs_real *told = gs_told (a, i), *risen = told + GS_TOLD_RISEN;
  if (! (a->times[i] >= 3
         && told[GS_TOLD_TIMES + 2] >= end - GS_R (1e3) * gs_epsilon () * gs_abs (end)))
    return 0;
  if (! gs_reports (a, i))
    return 1;
  *risen = 10 * gs_max (*risen, gs_max (gs_abs (a->last[i]), gs_abs (a->older[i])));
  return 0;
}

/* ... or it has not risen since its last event, though it should have */
static int
drowned (const gs_system *s, const gs_events *a, int i, gs_real h, gs_real end, gs_real g)
{
  const gs_real *told = gs_told (a, i);
  if (a->mark[i] + a->marks[i] != 0 || ! (end >= gs_accumulates_from (a, i)))
    return 0;
  return gs_user_rises (s, a, i, -g / gs_max (GS_TINY, end - told[GS_TOLD_TIMES]),
                        GS_R2 (5e-6, 1e-4) * gs_max (h, s->rstat[GS_H_LARGEST]));
}

int
gs_user_points (const gs_events *a, gs_real t, gs_real h)
{
  const gs_real shortest = GS_R2 (1e-9, 1e-5) * gs_max (gs_abs (t), gs_abs (t + h));
  gs_real most = 8;
  for (int i = 0; i < a->ne; i++)
    {
      const gs_real d = gs_interval (a, i);
      if (d > shortest && t < gs_repeats_until (a, i) && t + h > gs_repeats_until (a, i))
        most = gs_max (most, gs_min (8 * h, GS_R (1e6) * d) / d);
    }
  return (int) most;
}

int
gs_user_accumulates (const gs_system *s, const gs_events *a, gs_real t, gs_real h, int but,
                     const gs_real *g)
{
  int info = 0;
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i)
        && (i + 1 == but ? at_once (a, i, t + h) : drowned (s, a, i, h, t + h, g[i])))
      {
        if (info == 0 || gs_told (a, i)[GS_TOLD_CHANGED] > 0)
          s->istat[GS_CAUSE] = i + 1;
        info = 10;
        s->istat[GS_FAILED_INFO] = info;
        s->istat[GS_FAILED] = GS_AT_EVENT;
      }
  return info;
}

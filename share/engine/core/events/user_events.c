/* gs_user_events_begin, gs_user_event, gs_user_from_levels, gs_user_values_now,
 * gs_user_levels_left: events of the user within gs_resolve_event and gs_first_event.
 *
 * Where an event was looked for within a step and what it sets has not changed its own function,
 * this is 0 but for rounding errors: its level. It is taken for 0, or a body that has just left the
 * ground would be below it yet. So are functions that were the same number within the step, and the
 * same with the other sign, which was below 0 before. To have risen a function must be above ten
 * times its level, and 0.7 of what that was at the event before; one that only reports above
 * the largest so far, and 1000 units of rounding of what it was in the step up to an event: a speed
 * that is held at 0 may not be 0 but for rounding errors. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"

void
gs_user_events_begin (const gs_events *a, int k)
{
  for (int i = 0; i < a->ne; i++)
    {
      gs_real *told = gs_told (a, i),
             size = gs_max (gs_abs (a->g[i]), gs_max (gs_abs (a->last[i]), gs_abs (a->older[i])));
      if (k >= 0)
        a->fresh[i] = k == 0 && gs_is_own (a, i);
      if (k > 0 && gs_is_own (a, i))
        told[GS_TOLD_NOISE] = gs_max (told[GS_TOLD_NOISE], GS_R (1e3) * gs_epsilon () * size);
      if (k > 0 && gs_reports (a, i))
        told[GS_TOLD_RISEN] = gs_max (told[GS_TOLD_RISEN], told[GS_TOLD_NOISE]);
    }
}

/* the inputs that event l switches are held at their values in v */
static void
hold (const gs_events *a, int l, const gs_real *v)
{
  for (int i = 0; i < a->ns; i++)
    if (a->by[i] == l)
      {
        for (int j = 0; j < a->ns; j++)
          if (a->switched[j] == a->switched[i])
            a->on[j] = 0;
        a->on[i] = 1;
        a->held[i] = v[a->switched[i] - 1];
      }
}

/* the levels of the functions of the user that are function i, or the way back */
static void
levels_like (const gs_events *a, int i, gs_real size)
{
  for (int j = 0; j < a->ne; j++)
    {
      const gs_real like = gs_copysign (1, a->last[j]) * gs_copysign (1, a->last[i]);
      if (gs_is_own (a, j) && j != i
          && gs_abs (a->last[j] - like * a->last[i]) <= GS_R2 (1e-8, 1e-5) * gs_abs (a->last[i])
          && gs_abs (a->g[j] - like * a->g[i]) <= GS_R2 (1e-8, 1e-5) * size)
        {
          a->level[j] = a->g[j];
          if (like < 0)
            {
              a->mark[j] = 0;
              a->fresh[j] = 1;
            }
        }
    }
}

void
gs_user_event (const gs_events *a, int l, int k, gs_real g, const gs_real *v)
{
  const int i = l - 1;
  const gs_real old = a->level[i];
  const gs_real size = gs_max (gs_abs (a->last[i]), gs_abs (a->older[i]));
  a->fresh[i] = 1;
  if (l == k || gs_abs (a->g[i] - old) > 0)
    a->level[i] = 0;
  if (l == k && gs_abs (g - old) <= GS_R (1e-2) * size
      && gs_abs (a->g[i] - g) <= gs_max (GS_R (0.5) * gs_abs (g), GS_R2 (1e-8, 1e-5) * size))
    {
      a->level[i] = a->g[i];
      levels_like (a, i, size);
    }
  if (a->kind[i] == 4 && *a->ended == 0)
    *a->ended = l;
  hold (a, l, v);
}

void
gs_user_from_levels (const gs_events *a, gs_real *g)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      {
        gs_real *risen = gs_told (a, i) + GS_TOLD_RISEN;
        if (! gs_reports (a, i) && a->fresh[i] == 1)
          *risen *= GS_R (0.7);
        *risen = gs_max (*risen, 10 * gs_abs (a->level[i]));
        if (gs_abs (g[i] - a->level[i]) > gs_abs (a->level[i]))
          a->level[i] = 0;
        g[i] -= a->level[i];
      }
}

void
gs_user_values_now (const gs_events *a)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      a->now[i] -= a->level[i];
}

void
gs_user_levels_left (const gs_events *a)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      {
        a->fresh[i] = 0;
        const gs_real g = a->g[i] + a->level[i];
        if (g * a->g[i] > 0)
          {
            a->g[i] = g;
            a->level[i] = 0;
          }
      }
}

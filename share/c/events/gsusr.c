/* GSUSE, GSUSL, GSUSD, GSUSG, GSUSC, GSUSZ: events of the user within gsres and gsevn.
 *
 * Where an event was looked for within a step and what it sets has not changed its own function,
 * this is 0 but for rounding errors: its level. It is taken for 0, or a body that has just left the
 * ground would be below it yet. So are functions that were the same number within the step, and the
 * same with the other sign. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"

void
gsuse (const gs_events *a, int k)
{
  if (k >= 0)
    for (int i = 0; i < a->ne; i++)
      a->fresh[i] = k == 0 && gs_is_own (a, i);
}

/* the inputs that event l switches are held at their values in v */
static void
hold (const gs_events *a, int l, const double *v)
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
levels_like (const gs_events *a, int i, double size)
{
  for (int j = 0; j < a->ne; j++)
    {
      const double like = copysign (1.0, a->last[j]) * copysign (1.0, a->last[i]);
      if (gs_is_own (a, j) && j != i
          && fabs (a->last[j] - like * a->last[i]) <= 1e-8 * fabs (a->last[i])
          && fabs (a->g[j] - like * a->g[i]) <= 1e-8 * size)
        {
          a->level[j] = a->g[j];
          if (like < 0.0)
            a->fresh[j] = 1;
        }
    }
}

void
gsusl (const gs_events *a, int l, int k, double g, const double *v)
{
  const int i = l - 1;
  const double old = a->level[i];
  const double size = gs_max (fabs (a->last[i]), fabs (a->older[i]));
  a->fresh[i] = 1;
  if (l == k || fabs (a->g[i] - old) > 0.0)
    a->level[i] = 0.0;
  if (l == k && fabs (g - old) <= 1e-2 * size
      && fabs (a->g[i] - g) <= gs_max (0.5 * fabs (g), 1e-8 * size))
    {
      a->level[i] = a->g[i];
      levels_like (a, i, size);
    }
  if (a->kind[i] == 4 && *a->ended == 0)
    *a->ended = l;
  hold (a, l, v);
}

void
gsusd (const gs_events *a, double *g)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      {
        if (fabs (g[i] - a->level[i]) > fabs (a->level[i]))
          a->level[i] = 0.0;
        g[i] -= a->level[i];
      }
}

void
gsusg (const gs_events *a)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      a->now[i] -= a->level[i];
}

void
gsusc (const gs_events *a)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      {
        a->fresh[i] = 0;
        const double g = a->g[i] + a->level[i];
        if (g * a->g[i] > 0.0)
          {
            a->g[i] = g;
            a->level[i] = 0.0;
          }
      }
}

/* The times of the last four events of function i (from 0) among the last 100 of all; how many
 * there are; did the last one change states? */
static int
last_four (const gs_events *a, int i, int nx, double *t, int *reset)
{
  int n = 0;
  *reset = 0;
  for (int j = *a->count - 1; j >= gs_most (0, *a->count - 100) && n < 4; j--)
    {
      const double *r = a->record + j * (3 + 2 * nx);
      if (lround (r[1]) != i + 1)
        continue;
      for (int k = 0; n == 0 && k < nx; k++)
        *reset |= fabs (r[3 + k] - r[3 + nx + k]) > 0.0;
      t[n++] = r[0];
    }
  return n;
}

/* A function has had infinitely many where four of its events lie within 1e-9 of the time since the
 * last one, in which it has not risen; where three intervals between them fell one after the other,
 * the last event has changed states and it has not risen for twice the last interval (bounces that
 * drown in rounding errors); and where it has its fourth event within 1000 units of rounding of the
 * time. */
static int
infinitely_many (const gs_events *a, int i, int now, double end, int nx, int *reset)
{
  double t[4];
  int n = last_four (a, i, nx, t, reset);
  if (now)
    return n >= 3 && ! (t[2] < end - 1e3 * gseps () * fabs (end));
  if (n < 4)
    return 0;
  return ! (t[3] < t[0] - 1e-9 * (end - t[0]))
         || (*reset && t[0] - t[1] < t[1] - t[2] && t[1] - t[2] < t[2] - t[3]
             && end - t[0] > 2.0 * (t[0] - t[1]));
}

int
gsusz (const gs_events *a, double t, double h, int nx, int but, int *which)
{
  int info = 0;
  if (*a->count > a->nr)
    return info;
  for (int i = 0; i < a->ne; i++)
    {
      int reset;
      const int now = i + 1 == but;
      if (gs_is_own (a, i) && (now || a->mark[i] + a->marks[i] == 0)
          && infinitely_many (a, i, now, t + h, nx, &reset))
        {
          if (info == 0 || reset)
            *which = i + 1;
          info = 10;
        }
    }
  return info;
}

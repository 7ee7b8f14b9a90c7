/* GSUSE, GSUSL, GSUSD, GSUSG, GSUSC, GSUSZ: events of the user within gsres and gsevn.
 *
 * Where an event was looked for within a step and what it sets has not changed its own function,
 * this is 0 but for rounding errors: its level. It is taken for 0, or a body that has just left the
 * ground would be below it yet. */
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

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

void
gsusl (const gs_events *a, int l, int k, double g, const double *v)
{
  const int i = l - 1;
  const double old = a->level[i];
  const double size = gs_max (fabs (a->last[i]), fabs (a->older[i]));
  a->fresh[i] = 1;
  a->level[i] = 0.0;
  if (l == k && fabs (g - old) <= 1e-2 * size
      && fabs (a->g[i] - g) <= gs_max (0.5 * fabs (g), 1e-8 * size))
    a->level[i] = a->g[i];
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

/* events of function i (from 0) since `from`, as far as the record goes back */
static int
since (const gs_events *a, int i, double from, int nx)
{
  int n = 0;
  for (int j = gs_least (a->nr, *a->count) - 1; j >= 0; j--)
    {
      const double *r = a->record + j * (3 + 2 * nx);
      if (r[0] < from)
        break;
      n += lround (r[1]) == i + 1;
    }
  return n;
}

/* a function that has just had four events within 1e-9 of the step, and does not rise again in it,
 * has had infinitely many */
int
gsusz (const gs_events *a, double t, double h, int nx, int but, int *which)
{
  int info = 0;
  for (int i = 0; i < a->ne; i++)
    if (i + 1 != but && a->fresh[i] == 1 && a->marks[i] == 0 && since (a, i, t - 1e-9 * h, nx) >= 4
        && *a->count <= a->nr)
      {
        info = 10;
        *which = i + 1;
      }
  return info;
}

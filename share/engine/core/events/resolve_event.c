/* gs_resolve_event: an event of a run, and those that follow from it at the same instant.
 *
 * Where an event changes accelerations, ports that are held may no longer be: they are let go, the
 * most violated first. Those that stick then come to rest exactly. An event of the user that falls
 * to 0 at the same instant, or by what another one sets, follows that one. */
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"

/* event l > 0 is counted; its record with the state before it, or a null pointer where there is no
 * place for one */
static gs_real *
new_record (const gs_events *a, gs_real t, const gs_real *x, int nx, int l)
{
  *a->count += 1;
  if (a->times[l - 1]++ == 0)
    a->first[l - 1] = t;
  a->latest[l - 1] = t;
  *a->newest = l;
  if (*a->count > a->nr)
    return NULL;
  gs_real *r = a->record + (*a->count - 1) * (3 + 2 * nx);
  r[0] = t;
  r[1] = (gs_real)l;
  gs_copy (nx, x, r + 3);
  return r;
}

/* after event l the next one at this instant: a port that cannot be held, another stop that is hit
 * just now, also at the start (k = 0); 0: none */
static int
next (const gs_events *a, int l, int k)
{
  int n = 0;
  gs_real least = 0;
  for (int i = 0; i < a->ne; i++)
    if (gs_is_held (a, i) && a->g[i] < least)
      {
        n = i + 1;
        least = a->g[i];
      }
  for (int i = 0; i < a->ne && n == 0; i++)
    if (i + 1 != l && a->kind[i] >= 2 && a->mode[i] == 0
        && a->g[i] - (gs_is_own (a, i) ? a->level[i] : 0) <= 0
        && (a->mark[i] == 1 || (k == 0 && l <= 0 && a->kind[i] == 2)))
      n = i + 1;
  return n;
}

/* ... friction at rest that slides against its push, a stop that a port at rest is pushed
 * against */
static int
against (const gs_scene *s, const gs_events *a, gs_real t, gs_real *x, gs_real *v,
         const gs_real *cst, int l, int *n)
{
  int some = 0;
  for (int i = 0; i < a->ne; i++)
    {
      a->marks[i] = a->mode[i];
      some |= a->kind[i] <= 2 && ! gs_is_held (a, i);
    }
  int info = some ? s->rst (t, x, v, a->mode, -3, cst) : 0;
  if (info != 0)
    return info;
  for (int i = 0; i < a->ne; i++)
    {
      if (a->mode[i] != a->marks[i] && i + 1 != l)
        *n = i + 1;
      a->mode[i] = a->marks[i];
    }
  return 0;
}

/* do the modes that are given at the start agree with the state? info: 13, ended: the first one
 * that does not */
int
gs_check_given_modes (const gs_scene *s, const gs_events *a, gs_real t, gs_real *x, gs_real *v,
                      const gs_real *cst)
{
  int ports = 0, info = 0;
  for (int i = 0; i < a->ne; i++)
    {
      a->marks[i] = a->mode[i];
      ports |= ! gs_is_own (a, i);
    }
  if (ports && (info = s->rst (t, x, v, a->mode, -4, cst)) != 0)
    return info;
  for (int i = a->ne - 1; i >= 0; i--)
    {
      if (a->mode[i] != a->marks[i] || (gs_is_own (a, i) && a->mode[i] != 0))
        {
          *a->ended = i + 1;
          info = 13;
        }
      a->mode[i] = a->marks[i];
    }
  return info;
}

int
gs_resolve_event (const gs_scene *s, gs_real t, gs_real *x, int nx, gs_real *v, const gs_real *cst,
                  int k, int *ie, gs_real *re)
{
  const gs_events a = gs_events_of (nx, ie, re);
  const size_t state = (size_t)nx * sizeof (gs_real);
  int l = k == 0 && a.given == 1 ? -1 : k;
  int sticks = l == 0;      /* does anything come to rest? */
  gs_real *stuck = NULL;    /* ... and its record */
  *a.cause = k;
  *a.ended = 0;
  gs_user_events_begin (&a, k);
  if (k == 0 && a.given == 1)
    {
      int info = gs_check_given_modes (s, &a, t, x, v, cst);
      if (info != 0)
        return info;
    }
  for (;;)
    {
      gs_real *r = NULL;
      if (l > 0)
        {
          *a.since += 1;
          if (*a.since > 100)
            return 9;
          if (*a.tells != 2 || gs_is_own (&a, l - 1))
            r = new_record (&a, t, x, nx, l);
        }
      gs_real g = 0;
      if (l > 0 && gs_is_own (&a, l - 1))
        {
          s->evt (t, x, v, a.mode, cst, a.now);
          g = a.now[l - 1];
          gs_user_before_event (&a, l, t, x);
        }
      if (l >= 0)
        {
          int info = s->rst (t, x, v, a.mode, l, cst);
          if (info != 0)
            return info;
        }
      if (l > 0 && a.kind[l - 1] == 1 && a.mode[l - 1] == 0)
        {
          sticks = 1;
          stuck = r;
        }
      if (r)
        {
          r[2] = (gs_real)a.mode[l - 1];
          memcpy (r + 3 + nx, x, state);
        }
      s->evt (t, x, v, a.mode, cst, a.g);
      if (l > 0 && gs_is_own (&a, l - 1))
        {
          gs_user_after_event (&a, l, x);
          gs_user_event (&a, l, k, g, v);
        }
      int n = next (&a, l, k);
      int info = n == 0 ? against (s, &a, t, x, v, cst, l, &n) : 0;
      if (info != 0)
        return info;
      if (l > 0)
        a.mark[l - 1] = 0;
      if (n == 0)
        break;
      l = n;
    }
  if (sticks)
    {
      int info = s->rst (t, x, v, a.mode, -1, cst);
      if (info != 0)
        return info;
      if (stuck)
        memcpy (stuck + 3 + nx, x, state);
      s->evt (t, x, v, a.mode, cst, a.g);
    }
  if (*a.tells == 1)
    {
      int info = s->rst (t, x, v, a.mode, -2, cst);
      if (info != 0)
        return info;
    }
  gs_user_from_levels (&a, a.g);
  for (int i = 0; i < a.ne; i++)
    a.mark[i] = (a.mark[i] == 1 && a.g[i] > 0) || gs_risen (&a, i, a.g[i])
                || (a.kind[i] == 1 && gs_is_held (&a, i));
  return 0;
}

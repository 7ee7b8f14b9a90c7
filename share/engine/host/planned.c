/* planned.c: the whole motion of a scene of which some coordinates are planned. */
#include <stdlib.h>

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"
#include "host/close_along.h"
#include "host/planned_parts.h"
#include "host/text.h"

/* ------------------------------------------------------------------------------- closed chains */

static int
cannot_follow (gs_plan_way *w, gs_real t, const char *where, const gs_real *planned, int info)
{
  const char *meaning = w->d->meaning ? w->d->meaning ("clo", info) : NULL;
  gs_writer s = { w->text, w->size, 0 };
  gs_put (&s, "the loop cannot follow the motion at t = %.9g s: it does not close %s", (double)t,
          where);
  for (int k = 0; k < w->a->nplanned; k++)
    gs_put (&s, " %.6g", (double)planned[k]);
  gs_put (&s, meaning ? " (%s)" : " (CLO: INFO = %d)", meaning ? meaning : "", info);
  return 0;
}

/* the first place: on the branch of the guess, along the straight way from it */
static int
close_first (gs_plan_way *w, gs_planned_place *place, gs_real t, int side)
{
  const gs_planned_asked *a = w->a;
  const gs_scene *s = w->d->scene;
  gs_real *target = w->close, *tried = target + a->nplanned, *rest = tried + a->nplanned;
  gs_real done = 1;
  gs_polynomials_at (a->nplanned, a->pieces, a->powers, a->breaks, a->coefficients, t, side, 0,
                     target, gs_most (1, a->nplanned));
  for (int k = 0; k < a->nplanned; k++)
    tried[k] = place->qj[a->planned[k] - 1];
  const int info = gs_close_along (s, t, a->order, a->nplanned, a->planned, target, a->cst,
                                   place->qj, &done, rest);
  if (info == 0)
    return 1;
  for (int k = 0; k < a->nplanned; k++)
    tried[k] += done * (target[k] - tried[k]);
  return cannot_follow (w, t, "at", tried, info);
}

/* to t at one go: the way of a plan that comes back in between would be seen at its ends alone */
static int
follow_to (gs_plan_way *w, gs_planned_place *place, gs_real t, int side)
{
  const gs_planned_asked *a = w->a;
  const int first = ! (place->kept[1] > 0);
  if (first && ! close_first (w, place, t, side))
    return 0;
  const int info = gs_follow_motion (w->d->scene, t, side, a->order, a->nplanned, a->planned,
                                     a->pieces, a->powers, a->breaks, a->coefficients, a->cst,
                                     place->qj, place->kept);
  if (info == 0)
    return 1;
  for (int k = 0; k < a->nplanned; k++)
    w->close[k] = place->qj[a->planned[k] - 1];
  return cannot_follow (w, t, first ? "at" : "beyond", w->close, info);
}

enum { PARTS = 8 }; /* of each piece of a plan */

/* stop k of the way along the plan, PARTS for each piece */
static gs_real
stop_at (const gs_planned_asked *a, int k)
{
  const gs_real *b = a->breaks + k / PARTS;
  return k % PARTS ? b[0] + (b[1] - b[0]) * (gs_real)(k % PARTS) / PARTS : b[0];
}

/* the first stop behind t */
static int
stop_behind (const gs_planned_asked *a, gs_real t)
{
  int low = 0, high = a->pieces * PARTS + 1;
  while (low < high)
    {
      const int middle = (low + high) / 2;
      if (stop_at (a, middle) > t)
        high = middle;
      else
        low = middle + 1;
    }
  return low;
}

/* from stop to stop between where it is and t */
static int
follow (gs_plan_way *w, gs_planned_place *place, gs_real t, int side)
{
  const gs_planned_asked *a = w->a;
  if (place->kept[1] > 0)
    {
      const gs_real from = place->kept[0];
      const int up = t > from, last = a->pieces * PARTS;
      for (int k = stop_behind (a, from) - ! up; k >= 0 && k <= last; k += up ? 1 : -1)
        {
          const gs_real stop = stop_at (a, k);
          if (up ? ! (stop < t) : ! (stop > t))
            break;
          if (! follow_to (w, place, stop, side))
            return 0;
        }
    }
  return follow_to (w, place, t, side);
}

/* a motion of all coordinates must fulfil the constraints; 1: it does; text "": no memory */
static int
is_consistent (gs_plan_way *w, gs_real t, const gs_real *qj)
{
  const gs_scene *s = w->d->scene;
  gs_real *x = calloc ((size_t)s->nx + 1, sizeof *x);
  char rows[900];
  int beside = -1;
  if (x)
    {
      gs_copy (s->nq, qj, x);
      gs_copy (s->nu, qj + s->nq, x + s->nq);
      beside = gs_beside_constraints (w->d, t, x, w->a->cst, rows, sizeof rows);
    }
  free (x);
  w->text[0] = 0;
  if (beside > 0)
    snprintf (w->text, (size_t)w->size,
              "expected a planned motion on the constraints, found at t = %.9g s %s", (double)t,
              rows);
  return beside == 0;
}

int
gs_planned_to (gs_plan_way *w, gs_planned_place *place, gs_real t, int side)
{
  const gs_planned_asked *a = w->a;
  const gs_scene *s = w->d->scene;
  if (w->closed)
    return follow (w, place, t, side);
  gs_planned_rows (t, side, s->nu, a->order, a->nplanned, a->planned, a->pieces, a->powers,
                   a->breaks, a->coefficients, w->close, place->qj);
  return s->nlam == 0 || ! s->con || place == &w->inner || is_consistent (w, t, place->qj);
}

/* --------------------------------------------------------------------------------- all times */

static int
take_room (gs_plan_way *w, gs_real **room)
{
  const gs_planned_asked *a = w->a;
  const gs_scene *s = w->d->scene;
  const int nj = s->nu * (a->order + 1), kept = 2 + a->nplanned * (a->order + 1) + 2 * s->nu;
  const int close = a->nplanned * (a->order + 5) + s->nu * (a->order + 5);
  const int devices = s->nx - s->nq - s->nu;
  const size_t all = (size_t)(2 * (nj + kept) + close + s->nv + devices + 1);
  gs_real *at = *room = calloc (all, sizeof *at);
  if (! at)
    return 0;
  w->place = (gs_planned_place){ at, at + nj };
  at += nj + kept;
  w->inner = (gs_planned_place){ at, at + nj };
  at += nj + kept;
  w->close = at;
  w->v = at + close;
  w->xid = w->v + s->nv;
  gs_copy (s->nu, a->guess, w->place.qj);
  gs_copy (s->nu, a->guess, w->inner.qj);
  return 1;
}

static int
go_along (gs_plan_way *w, gs_planned_found *found)
{
  const gs_planned_asked *a = w->a;
  const gs_scene *s = w->d->scene;
  const int nj = s->nu * (a->order + 1), devices = s->nx - s->nq - s->nu;
  const int carry = a->carry && s->cmd && w->d->nfollowed > 0;
  for (int k = 0; k < a->n; k++)
    {
      gs_real *xi = found->devices + devices * k;
      found->done = k;
      gs_copy (devices, k ? xi - devices : a->devices, xi);
      const int bad = carry && k > 0 ? gs_carry_states (w, a->t[k - 1], a->t[k], xi) : 0;
      if (bad)
        return bad;
      if (! gs_planned_to (w, &w->place, a->t[k], a->side))
        return w->text[0] ? 2 : 1;
      gs_copy (nj, w->place.qj, found->qj + nj * k);
    }
  found->done = a->n;
  return 0;
}

int
gs_whole_motion (const gs_description *d, const gs_planned_asked *a, gs_planned_found *found)
{
  gs_plan_way w = { .d = d, .a = a, .text = found->text, .size = sizeof found->text,
                    .closed = d->scene->nlam > 0 && a->nplanned < d->scene->nu };
  gs_real *room;
  found->text[0] = 0;
  const int bad = take_room (&w, &room) ? go_along (&w, found) : 1;
  free (room);
  return bad;
}

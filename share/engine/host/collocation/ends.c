/* ends.c: the ends of an optimal motion of a closed chain: the start on the constraints, what
 * follows at the end. */
#include <math.h>
#include <string.h>

#include "host/collocation/collocation_parts.h"
#include "host/text.h"

static int
is_actuated (const gs_motion_guess *g, int coordinate)
{
  for (int k = 0; k < g->nactuated; k++)
    if (g->actuated[k] == coordinate)
      return 1;
  return 0;
}

/* whether the driven joints are known in x, their coordinates (first 0) or speeds (first nq); there
 * are some */
static int
leads (const gs_motion_guess *g, const double *x, int first)
{
  for (int k = 0; k < g->nactuated; k++)
    if (isnan (x[first + g->actuated[k]]))
      return 0;
  return g->nactuated > 0;
}

int
gs_close_chain (gs_search *w, const gs_motion_guess *g, double t, const int *held, double *x,
                gs_assembly *found)
{
  const gs_description *d = w->d;
  const int nx = d->scene->nx;
  gs_real *start = gs_room_reals (&w->room, nx), *y = gs_room_reals (&w->room, nx);
  if (gs_search_bad (w))
    return 0;
  for (int j = 0; j < nx; j++)
    {
      start[j] = g->start[j];
      y[j] = x[j];
    }
  const gs_assembly_asked asked
      = { .t = t, .cst = w->p->cst, .held = held, .tolerance = 1e-10 };
  if (gs_assemble (d, &asked, start, y, found))
    w->bad = 1;
  for (int j = 0; found->n && j < nx; j++)
    x[j] = (double)y[j];
  return ! w->bad && found->n > 0;
}

/* why there is no such state; the coordinates are no option here */
static const char *
why_none (const gs_assembly *found)
{
  static const char option[] = "option hold: ";
  return found->text + (strncmp (found->text, option, sizeof option - 1) ? 0 : sizeof option - 1);
}

/* a start that is given must be on the constraints */
static void
check_start (gs_search *w, const double *x0)
{
  const int nx = w->d->scene->nx;
  gs_real *x = gs_room_reals (&w->room, nx);
  char rows[900];
  if (gs_search_bad (w))
    return;
  for (int j = 0; j < nx; j++)
    x[j] = isnan (x0[j]) ? 0 : x0[j];
  const int beside = gs_beside_constraints (w->d, w->p->t0, x, w->p->cst, rows, sizeof rows);
  w->bad = beside < 0 ? 1 : beside > 0 ? GS_MOTION_START : 0;
  if (beside > 0)
    snprintf (w->refused, sizeof w->refused,
              "x0: expected a state on the constraints, found %s; states that follow may be NaN",
              rows);
}

/* what follows where the driven joints are known */
static void
complete_start (gs_search *w, const gs_motion_guess *g, const char *missing, double *x0)
{
  const gs_scene *s = w->d->scene;
  int *held = gs_room_places (&w->room, s->nq);
  double *x = gs_room_numbers (&w->room, s->nx);
  gs_writer t = { w->refused, sizeof w->refused, 0 };
  gs_assembly *found = gs_room_take (&w->room, 1, sizeof *found);
  if (gs_search_bad (w))
    return;
  if (! leads (g, x0, 0) || ! leads (g, x0, s->nq))
    {
      w->bad = GS_MOTION_START;
      gs_put (&t, "x0: in a closed chain expected numbers for all coordinates and speeds");
      for (int k = 0; k < g->nactuated; k++)
        gs_put (&t, "%s%s", k ? ", " : ", or for those that others follow (with their speeds): ",
                w->d->states[g->actuated[k]]);
      gs_put (&t, "; found NaN for %s", missing);
      return;
    }
  for (int j = 0; j < s->nx; j++)
    {
      x[j] = isnan (x0[j]) ? g->start[j] : x0[j];
      if (j < s->nq)
        held[j] = ! isnan (x0[j]);
    }
  if (gs_close_chain (w, g, w->p->t0, held, x, found))
    memcpy (x0, x, (size_t)(s->nq + s->nu) * sizeof *x);
  else if (! w->bad)
    {
      w->bad = GS_MOTION_START;
      gs_put (&t, "x0: %s", why_none (found));
    }
}

/* hint: where the chain closes at the end xf, of which positions that follow have bounds there */
static void
close_end (gs_search *w, const gs_motion_guess *g, const double *xf, double *hint)
{
  const gs_scene *s = w->d->scene;
  const gs_motion_problem *p = w->p;
  int *held = gs_room_places (&w->room, s->nq);
  gs_assembly *found = gs_room_take (&w->room, 1, sizeof *found);
  gs_writer t = { w->told, sizeof w->told, 0 };
  if (gs_search_bad (w))
    return;
  const int led = leads (g, xf, 0);
  for (int j = 0; j < s->nq; j++)
    held[j] = ! isnan (xf[j]) && (! led || is_actuated (g, j));
  if (! gs_close_chain (w, g, w->p->t0, held, hint, found))
    {
      if (! w->bad)
        gs_put (&t, "; at the end: %s", why_none (found));
      return;
    }
  for (int j = 0; j < s->nq; j++)
    {
      const double room = 1e-6 * fmax (1, fabs (hint[j]));
      if (held[j]
          || (hint[j] >= p->last_low[j] - room && hint[j] <= p->last_high[j] + room))
        continue;
      gs_put (&t, "; the loops close at the end with %s = %.6g, found bounds of %g to %g there",
              w->d->states[j], hint[j], p->last_low[j], p->last_high[j]);
    }
}

/* Numbers for what follows the driven joints at the end are a guess; where one of these is free,
 * too, all numbers are demanded. */
static void
take_end (gs_search *w, const gs_motion_guess *g, const double *x0, double *xf, double *hint)
{
  const gs_scene *s = w->d->scene;
  for (int j = 0; j < s->nx; j++)
    hint[j] = ! isnan (xf[j]) ? xf[j] : ! isnan (x0[j]) ? x0[j] : g->start[j];
  close_end (w, g, xf, hint);
  for (int speeds = 0; speeds < 2; speeds++)
    {
      const int first = speeds ? s->nq : 0, many = speeds ? s->nu : s->nq;
      const int led = leads (g, xf, first);
      for (int j = 0; led && j < many; j++)
        if (! is_actuated (g, j))
          xf[first + j] = NAN;
    }
}

void
gs_take_ends (gs_search *w, gs_motion_problem *p, const gs_motion_guess *g)
{
  const gs_scene *s = w->d->scene;
  const int closed = gs_is_closed (s);
  double *x0 = gs_room_numbers (&w->room, s->nx), *xf = gs_room_numbers (&w->room, s->nx);
  double *hint = gs_room_numbers (&w->room, s->nx);
  int missing = -1;
  if (gs_search_bad (w))
    return;
  memcpy (x0, p->x0, (size_t)s->nx * sizeof *x0);
  memcpy (xf, p->xf, (size_t)s->nx * sizeof *xf);
  memcpy (hint, xf, (size_t)s->nx * sizeof *xf);
  for (int j = s->nq + s->nu - 1; j >= 0; j--)
    if (isnan (x0[j]))
      missing = j;
  if (missing < 0)
    check_start (w, x0);
  else if (closed)
    complete_start (w, g, w->d->states[missing], x0);
  p->x0 = x0;
  if (closed && ! w->bad)
    take_end (w, g, x0, xf, hint);
  p->xf = xf;
  w->hint = hint;
}

/* ends.c: the ends of an optimal motion of a closed chain: the start on the constraints, what
 * follows at the end. */
#include <math.h>
#include <string.h>

#include "gsmbp/limits.h"
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

/* is state j the coordinate or the speed of a joint that is driven? */
static int
is_leading (const gs_search *w, const gs_motion_guess *g, int j)
{
  const int nq = w->d->scene->nq;
  return is_actuated (g, j) || (j >= nq && is_actuated (g, j - nq));
}

/* whether the driven joints are known in x, coordinates (and speeds); there are some */
static int
leads (const gs_search *w, const gs_motion_guess *g, const double *x, int speeds)
{
  const int nq = w->d->scene->nq;
  for (int k = 0; k < g->nactuated; k++)
    if (isnan (x[g->actuated[k]]) || (speeds && isnan (x[nq + g->actuated[k]])))
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
  const gs_description *d = w->d;
  const int nx = d->scene->nx, n = gs_residual_rows (d);
  gs_real *x = gs_room_reals (&w->room, nx);
  double *scaled = gs_room_numbers (&w->room, n), *found = gs_room_numbers (&w->room, n);
  if (gs_search_bad (w))
    return;
  for (int j = 0; j < nx; j++)
    x[j] = isnan (x0[j]) ? 0 : x0[j];
  w->bad = gs_residuals (d, w->p->t0, x, w->p->cst, scaled, found);
  double most = 0;
  for (int k = 0; k < n && ! w->bad; k++)
    most = ! (fabs (scaled[k]) <= most) ? fabs (scaled[k]) : most;
  if (w->bad || most <= gs_limits.off_constraints)
    return;
  char rows[900];
  gs_worst_residuals (d, scaled, found, gs_limits.off_constraints, rows, sizeof rows);
  w->bad = GS_MOTION_START;
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
  if (! leads (w, g, x0, 1))
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
  const int led = leads (w, g, xf, 0);
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
      const int first = speeds ? s->nq : 0, last = speeds ? s->nq + s->nu : s->nq;
      int lead = g->nactuated > 0;
      for (int j = first; j < last; j++)
        lead = lead && ! (is_leading (w, g, j) && isnan (xf[j]));
      for (int j = first; j < last; j++)
        if (lead && ! is_leading (w, g, j))
          xf[j] = NAN;
    }
}

void
gs_take_ends (gs_search *w, gs_motion_problem *p, gs_motion_guess *g)
{
  const gs_scene *s = w->d->scene;
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
  else if (s->nlam > 0 && s->con)
    complete_start (w, g, w->d->states[missing], x0);
  p->x0 = x0;
  if (s->nlam > 0 && s->con && ! w->bad)
    take_end (w, g, x0, xf, hint);
  p->xf = xf;
  g->xf_hint = hint;
}

/* choices.c: choices from lists: all combinations, or branch and bound on the order of their
 * numbers: a choice that is free between two numbers of its list can only be better than those
 * between them, and what is no better than the best found is not looked at. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "host/optimize/optimize_parts.h"

/* choices between two places of their lists: from, to; what it can be at best; all variables where
 * it begins */
typedef struct
{
  int *from, *to;
  double bound, *start;
} node;

typedef struct
{
  gs_search_design *w;
  gs_design_result *r;
  int n;               /* choices: */
  const gs_free **of;
  node *open;
  int nopen, room;
  gs_best *best, refused;
  int failed;          /* why one of them could not be calculated */
  char why[2400];
} choosing;

static int
narrow_and_solve (choosing *c, const node *k, int solver, gs_best *b, int told)
{
  gs_room room = { NULL, 0 };
  double *low = gs_room_numbers (&room, 2 * c->n), *high = low + c->n;
  int bad = low ? 0 : gs_search_full (c->w);
  for (int i = 0; ! bad && i < c->n; i++)
    {
      low[i] = c->of[i]->list[k->from[i]];
      high[i] = c->of[i]->list[k->to[i]];
    }
  if (! bad)
    bad = gs_solve_design (c->w, low, high, k->start, solver, b, c->r, told);
  gs_room_free (&room);
  return bad;
}

/* an end that could not be calculated, with the values where it was to begin */
static void
add_failed (choosing *c, const node *k)
{
  const gs_design *d = c->w->d;
  double *values = gs_room_numbers (&c->w->room, d->nfree);
  for (int i = 0, choice = 0; values && i < d->nfree; i++)
    values[i] = d->free[i].nlist ? d->free[i].list[k->from[choice++]] : d->free[i].start;
  if (values)
    gs_add_end (c->w, c->r, values, NULL);
}

/* what ended a problem from outside: GS_INTERRUPTED, GS_TIMED_OUT, or 0 */
static int
ended (const choosing *c, int bad, const gs_best *b)
{
  if (! bad)
    return b->r.stopped;
  if (c->w->failed != GS_DESIGN_STOPPED)
    return 0;
  return gs_wall_clock () >= c->w->ends ? GS_TIMED_OUT : GS_INTERRUPTED;
}

static void
take (gs_best *to, gs_best *from)
{
  gs_best_free (to);
  *to = *from;
  *from = (gs_best){ .p = NULL };
}

/* failed, why: of the last one that could not be calculated */
static void
remember_failure (choosing *c)
{
  c->failed = c->w->failed;
  memcpy (c->why, c->w->why, sizeof c->why);
}

/* ------------------------------------------------------------------------- all of them */

static void
every_one (choosing *c, int *from)
{
  gs_search_design *w = c->w;
  gs_design_result *r = c->r;
  for (double k = 0; k < r->combinations && ! w->room.full; k++)
    {
      const node one = { from, from, 0, NULL };
      gs_best here;
      double rest = k;
      for (int i = 0; i < c->n; i++)
        {
          from[i] = (int)fmod (rest, c->of[i]->nlist);
          rest = floor (rest / c->of[i]->nlist);
        }
      if (k > 0 && gs_wall_clock () >= w->ends)
        {
          r->choices_stopped = GS_TIMED_OUT;
          break;
        }
      const int bad = narrow_and_solve (c, &one, w->o->solver, &here, 1);
      r->problems++;
      r->choices_stopped = ended (c, bad, &here);
      if (bad)
        {
          remember_failure (c);
          if (! r->choices_stopped)
            add_failed (c, &one);
        }
      else if (gs_better (&here, c->best))
        take (c->best, &here);
      gs_best_free (&here);
      if (r->choices_stopped)
        break;
    }
}

/* ------------------------------------------------------------------------- branch and bound */

static int
worth (double bound, const gs_best *best)
{
  return ! gs_is_end (best) || bound < best->r.e.J - 1e-9 * fmax (1, fabs (best->r.e.J));
}

/* a node as a copy of k that begins at START */
static node *
open_node (choosing *c, const node *k, double bound, const double *start)
{
  const int nfree = c->w->d->nfree;
  const size_t bytes = (size_t)c->n * sizeof (int);
  if (c->nopen == c->room)
    {
      node *more = realloc (c->open, (size_t)(2 * c->room + 8) * sizeof *more);
      if (! more)
        {
          gs_search_full (c->w);
          return NULL;
        }
      c->open = more;
      c->room = 2 * c->room + 8;
    }
  gs_room *room = &c->w->room;
  node new = { gs_room_places (room, c->n), gs_room_places (room, c->n), bound,
               gs_room_numbers (room, nfree) };
  if (room->full)
    return NULL;
  memcpy (new.from, k->from, bytes);
  memcpy (new.to, k->to, bytes);
  memcpy (new.start, start, (size_t)nfree * sizeof *start);
  c->open[c->nopen] = new;
  return c->open + c->nopen++;
}

/* The choice that lies farthest between two numbers of its list is below or above them; where all
 * lie on one at a solution (known), that combination alone, which is the best of them. */
static void
halve (choosing *c, const node *k, double bound, const double *values, int known)
{
  double most = -1;
  int at = -1, place = 0;
  int *here = gs_room_places (&c->w->room, c->n);
  for (int i = 0; here && i < c->n; i++)
    {
      const gs_free *v = c->of[i];
      const double x = values[v - c->w->d->free];
      int below = k->from[i];
      if (k->from[i] == k->to[i])
        {
          here[i] = below;
          continue;
        }
      while (below + 1 < k->to[i] && v->list[below + 1] <= x)
        below++;
      const double step = v->list[below + 1] - v->list[below];
      const double share = fmin (fmax ((x - v->list[below]) / step, 0), 1);
      here[i] = below + (share > 0.5);
      if (1e-12 + fmin (share, 1 - share) > most)
        {
          most = 1e-12 + fmin (share, 1 - share);
          at = i;
          place = below;
        }
    }
  if (at < 0 || ! here)
    return;
  if (known && most < 1e-9)
    {
      const node one = { here, here, bound, NULL };
      open_node (c, &one, bound, values);
      return;
    }
  node *low = open_node (c, k, bound, values);
  if (low)
    low->to[at] = place;
  node *high = open_node (c, k, bound, values);
  if (high)
    high->from[at] = place + 1;
}

static int
whole (const choosing *c, const node *k)
{
  return ! memcmp (k->from, k->to, (size_t)c->n * sizeof *k->from);
}

/* another solver, for a problem that seems to have no solution */
static int
other (const gs_design_options *o, int solver)
{
  return solver == GS_SOLVER_ipopt && o->nlopt ? GS_SOLVER_slsqp : GS_SOLVER_ipopt;
}

static int
solve_node (choosing *c, const node *k, gs_best *b)
{
  gs_search_design *w = c->w;
  int bad = narrow_and_solve (c, k, w->o->solver, b, whole (c, k));
  if (bad || b->r.violation <= GS_FEASIBLE || whole (c, k))
    return bad;
  gs_best again;
  const int lost = narrow_and_solve (c, k, other (w->o, b->r.solver), &again, 0);
  if (! lost && gs_better (&again, b))
    take (b, &again);
  else if (lost && w->failed == GS_DESIGN_STOPPED)
    bad = 1;
  gs_best_free (&again);
  return bad;
}

/* what follows from the end of a node */
static void
take_node (choosing *c, const node *k, int bad, gs_best *b)
{
  const int all = whole (c, k);
  if (bad)
    {
      remember_failure (c); /* nothing is known of it: its halves */
      if (all)
        add_failed (c, k);
      else
        halve (c, k, k->bound, k->start, 0);
    }
  else if (b->r.violation > GS_FEASIBLE)
    {
      if (gs_better (b, &c->refused))
        take (&c->refused, b);
    }
  else if (! b->solved && ! all)
    halve (c, k, k->bound, b->p, 0);
  else if (worth (b->r.e.J, c->best))
    {
      if (all)
        take (c->best, b);
      else
        halve (c, k, b->r.e.J, b->p, 1);
    }
}

/* the open node that can be best; it is open no more */
static node
next_node (choosing *c)
{
  int at = 0;
  for (int i = 1; i < c->nopen; i++)
    if (c->open[i].bound < c->open[at].bound)
      at = i;
  const node k = c->open[at];
  memmove (c->open + at, c->open + at + 1, (size_t)(c->nopen - at - 1) * sizeof k);
  c->nopen--;
  return k;
}

static void
branch (choosing *c)
{
  gs_search_design *w = c->w;
  gs_design_result *r = c->r;
  while (c->nopen && ! w->room.full)
    {
      const node k = next_node (c);
      r->open = k.bound;
      if (! worth (k.bound, c->best))
        break;
      const int late = r->problems > 0 && gs_wall_clock () >= w->ends;
      if (late || r->problems >= w->o->nodes)
        {
          r->choices_stopped = late ? GS_TIMED_OUT : 0;
          r->choices_limit = 1;
          break;
        }
      gs_best here;
      const int bad = solve_node (c, &k, &here);
      r->problems++;
      r->choices_stopped = ended (c, bad, &here);
      if (! r->choices_stopped)
        take_node (c, &k, bad, &here);
      else if (whole (c, &k) && ! bad && worth (here.r.e.J, c->best)
               && here.r.violation <= GS_FEASIBLE)
        take (c->best, &here);
      gs_best_free (&here);
      if (r->choices_stopped)
        {
          r->choices_limit = 1;
          break;
        }
    }
  if (! r->choices_limit)
    r->open = INFINITY;
  if (! gs_is_end (c->best) && ! r->choices_stopped)
    take (c->best, &c->refused);
}

/* from all of all lists */
static void
begin_branch (choosing *c, int *from)
{
  const gs_design *d = c->w->d;
  int *to = gs_room_places (&c->w->room, c->n);
  double *start = gs_room_numbers (&c->w->room, d->nfree);
  for (int i = 0; to && i < c->n; i++)
    {
      from[i] = 0;
      to[i] = c->of[i]->nlist - 1;
    }
  for (int i = 0; start && i < d->nfree; i++)
    start[i] = d->free[i].start;
  const node all = { from, to, -INFINITY, NULL };
  if (to && start)
    open_node (c, &all, -INFINITY, start);
}

/* ------------------------------------------------------------------------- what a limit leaves */

/* 1: nothing */
static int
leave (choosing *c)
{
  gs_search_design *w = c->w;
  gs_design_result *r = c->r;
  gs_best *b = c->best;
  if (r->choices_stopped)
    {
      if (! gs_is_end (b))
        {
          w->failed = 0;
          return gs_search_failed (
              w, r->choices_stopped == GS_TIMED_OUT ? GS_VALUES_LATE : GS_VALUES_INTERRUPTED, "",
              "before a combination of choices was completed");
        }
      b->r.stopped = r->choices_stopped;
      b->r.limit = 1;
      b->solved = 0;
      gs_writer t = { b->r.ended, sizeof b->r.ended, 0 };
      gs_put (&t, "%s", gs_stopped_text (b->r.stopped));
      if (r->combinations > 1)
        gs_put (&t, " after %d problems for %.0f combinations of choices", r->problems,
                r->combinations);
    }
  else if (r->choices_limit && ! gs_is_end (b))
    {
      w->failed = GS_DESIGN_REFUSED;
      snprintf (w->why, sizeof w->why,
                "no combination of choices was completed within the limit of %d problems (option "
                "nodes); the best may reach %g",
                w->o->nodes, r->open);
    }
  else if (r->choices_limit)
    {
      b->r.limit = 1;
      b->solved = 0;
      snprintf (b->r.ended, sizeof b->r.ended,
                "stopped at the limit of %d problems (option nodes); other choices may reach %.9g",
                w->o->nodes, r->open);
    }
  return w->room.full || ! gs_is_end (b);
}

/* too many for all of them? */
static int
refuse_many (gs_search_design *w, const gs_design_result *r)
{
  if (r->branched || r->combinations <= 1000)
    return 0;
  w->failed = GS_DESIGN_REFUSED;
  snprintf (w->why, sizeof w->why,
            "option choices: expected at most 1000 combinations for \"all\", found %.0f; "
            "\"branch\" looks at fewer",
            r->combinations);
  return 1;
}

int
gs_try_choices (gs_search_design *w, gs_best *best, gs_design_result *r)
{
  const gs_design *d = w->d;
  choosing c = { .w = w, .r = r, .best = best };
  int *from = gs_room_places (&w->room, d->nfree);
  c.of = gs_room_take (&w->room, d->nfree, sizeof *c.of);
  if (! from || ! c.of)
    return gs_search_full (w);
  r->combinations = 1;
  r->open = INFINITY;
  for (int i = 0; i < d->nfree; i++)
    if (d->free[i].nlist)
      {
        c.of[c.n++] = d->free + i;
        r->combinations *= d->free[i].nlist;
      }
  r->branched = w->o->choices == GS_CHOICES_branch
                || (w->o->choices == GS_CHOICES_auto && r->combinations > 100);
  if (refuse_many (w, r))
    return 1;
  if (r->branched)
    begin_branch (&c, from);
  if (r->branched)
    branch (&c);
  else
    every_one (&c, from);
  const int failed = ! gs_is_end (best) && c.failed && ! r->choices_limit
                     && (! r->choices_stopped || (! r->branched && r->combinations <= 1));
  if (failed)
    {
      w->failed = c.failed;
      memcpy (w->why, c.why, sizeof c.why);
    }
  const int bad = failed || leave (&c);
  gs_best_free (&c.refused);
  free (c.open);
  return bad;
}

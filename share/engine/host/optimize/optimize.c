/* optimize.c: a design from its problem to its result. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/optimize/optimize_parts.h"

static int
count_series (const gs_design *d)
{
  int n = 0;
  for (int i = 0; i < d->ngoal + d->ndemands; i++)
    n += gs_series_of (d->rows + i);
  return n;
}

static int
begin (gs_search_design *w)
{
  const gs_design *d = w->d;
  gs_room *room = &w->room;
  w->ends = w->o->timeout > 0 ? gs_wall_clock () + w->o->timeout : INFINITY;
  w->v.times = gs_room_take (room, d->ncases, sizeof *w->v.times);
  w->v.series = gs_room_take (room, count_series (d), sizeof *w->v.series);
  w->v.rough = gs_room_places (room, d->nfree);
  w->naturals = gs_room_numbers (room, d->ndemands);
  w->last_p = gs_room_numbers (room, d->nfree);
  w->last_rows = gs_room_places (room, d->ngoal + d->ndemands);
  w->last_free = gs_room_places (room, d->nfree);
  return room->full;
}

int
gs_optimize (const gs_design *d, const gs_design_options *o, gs_design_result *r)
{
  gs_search_design *w = calloc (1, sizeof *w);
  gs_best best = { .p = NULL };
  *r = (gs_design_result){ .verdict = GS_DESIGN_FOUND };
  if (! w)
    return 1;
  w->d = d;
  w->o = o;
  int bad = begin (w) || gs_try_choices (w, &best, r);
  bad = bad || gs_tell_design (w, &best, r);
  gs_best_free (&best);
  if (bad)
    {
      r->verdict = w->failed;
      snprintf (r->ended, sizeof r->ended, "%s", w->why);
    }
  r->room = w->room.last;
  bad = w->room.full || (bad && ! w->failed);
  free (w);
  return bad;
}

void
gs_design_free (gs_design_result *r)
{
  gs_room room = { r->room, 0 };
  gs_room_free (&room);
  free (r->ends);
  r->ends = NULL;
  r->room = NULL;
}

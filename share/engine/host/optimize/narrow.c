/* narrow.c: a problem where some choices are made, others free between two numbers; the unknowns
 * above its peaks. */
#include <math.h>

#include "host/optimize/optimize_parts.h"

/* variable i as the next unknown */
static void
add_unknown (gs_narrowed *q, int i, double low, double high, double start)
{
  const double scale = gs_scale_of (q->w->d->free + i);
  const int j = q->n++;
  q->at[j] = i;
  q->free[i] = 1;
  q->scale[j] = scale;
  q->low[j] = low / scale;
  q->high[j] = high / scale;
  q->start[j] = gs_within (start, low, high) / scale;
}

static int
take_room (gs_search_design *w, gs_room *room, gs_narrowed *q)
{
  const gs_design *d = w->d;
  const int n = d->nfree, peaks = gs_count_peaks (d), rows = d->ngoal + d->ndemands;
  *q = (gs_narrowed){ .w = w, .npeaks = peaks, .goals = 1, .ndemands = d->ndemands };
  q->at = gs_room_places (room, n);
  q->free = gs_room_places (room, n);
  q->idle = gs_room_places (room, n);
  q->rough = gs_room_places (room, n);
  q->rows = gs_room_places (room, rows);
  q->demands = gs_room_places (room, d->ndemands);
  q->p = gs_room_numbers (room, 2 * n);
  q->scale = gs_room_numbers (room, n);
  q->start = gs_room_numbers (room, n + peaks);
  q->low = gs_room_numbers (room, n + peaks);
  q->high = gs_room_numbers (room, n + peaks);
  q->sizes = gs_room_numbers (room, peaks);
  return room->full;
}

int
gs_narrow (gs_search_design *w, const double *low, const double *high, const double *start,
           gs_room *room, gs_narrowed *q)
{
  const gs_design *d = w->d;
  if (take_room (w, room, q))
    return gs_search_full (w);
  for (int k = 0; k < d->ngoal + d->ndemands; k++)
    q->rows[k] = 1;
  for (int k = 0; k < d->ndemands; k++)
    q->demands[k] = k;
  for (int i = 0, choice = 0; i < d->nfree; i++)
    {
      const gs_free *v = d->free + i;
      const double from = start ? start[i] : v->start;
      if (! v->nlist)
        add_unknown (q, i, v->low, v->high, from);
      else if (low[choice] < high[choice])
        add_unknown (q, i, low[choice], high[choice], from);
      else
        q->p[i] = low[choice];
      choice += v->nlist > 0;
    }
  for (int s = 0; s < q->npeaks; s++)
    {
      q->sizes[s] = 1;
      q->low[q->n + s] = -INFINITY;
      q->high[q->n + s] = INFINITY;
    }
  return GS_VALUES_FOUND;
}

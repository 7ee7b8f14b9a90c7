/* columns_lost.c: columns that have no derivatives from some event on. */
#include "host/derivatives/columns.h"

int
gs_derivatives_lost (const gs_derivatives *d, int k, int *event, double *time)
{
  *event = d->event[k];
  *time = d->lost_at[k];
  return d->why[k];
}

const char *
gs_derivatives_why (int why)
{
  switch (why)
    {
    case GS_GRAZES:
      return "the motion only grazes there";
    case GS_SEVERAL:
      return "another event at the same instant would come at another time";
    case GS_UNDEFINED:
      return "the equations there have no derivatives";
    case GS_CHOICE:
      return "what it resets is moved onto the constraints of a loop, which leave a choice";
    default:
      return "";
    }
}

int
gs_derivatives_changes (const gs_derivatives *d, int event)
{
  return d->changes[event - 1];
}

void
gs_derivatives_end (gs_derivatives *d, int event, double t)
{
  for (int k = 0; k < d->nc; k++)
    if (! d->why[k] || d->lost_at[k] > t)
      {
        d->why[k] = GS_GRAZES;
        d->event[k] = event;
        d->lost_at[k] = t;
      }
}

void
gs_derivatives_drop_times (gs_derivatives *d, int k, double t)
{
  const int width = d->has_events ? 3 + 2 * d->events.nx : 0;
  for (int i = 0; i < d->ntimes; i++)
    if ((double)d->events.record[(ptrdiff_t)width * i] >= t)
      d->times[d->nc * i + k] = NAN;
}

/* run_columns.c: derivatives by parameters and start values that a run carries. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/refusals.h"
#include "host/run/run_parts.h"
#include "host/text.h"

/* (4,nsets) of the description, from 1; a null pointer: no memory */
static int *
sets_from_one (const gs_description *d)
{
  int *sets = malloc ((size_t)(4 * d->nsets + 1) * sizeof *sets);
  for (int k = 0; sets && k < 4 * d->nsets; k++)
    sets[k] = d->sets[k] + 1;
  return sets;
}

/* what a run with columns does not have; gauss has them with partitioning, its own way */
static int
check_columns (gs_whole_run *w)
{
  const int way = w->iopt[GS_LOOPS];
  const int own = way == 3 && strcmp (w->o->method, "gauss") == 0;
  if (w->o->audit > 0 || (way > 2 && ! own))
    return gs_refuse (w->r, GS_REFUSED_COLUMNS, "sensitivity", "no derivatives with %s",
                      w->o->audit > 0 ? "audit" : "that way of the loops; expected "
                                          "\"projection\" or \"baumgarte\"");
  return 0;
}

/* columns of a start that do not follow from those of the fixed coordinates */
static int
refuse_fixed (gs_whole_run *w, int why)
{
  const gs_description *d = w->d;
  char found[400] = "none";
  gs_writer list = { found, (int)sizeof found, 0 };
  for (int k = 0; k < d->scene->nq; k++)
    if (w->o->fixed[k])
      gs_put (&list, list.length > 0 ? ", %s" : "%s", d->states[k]);
  if (why == GS_START_UNDEFINED)
    return gs_refuse (w->r, GS_REFUSED_COLUMNS, "sensitivity", "no derivatives with loops in a "
                      "scene whose speeds are not the rates of its coordinates");
  const int n = gs_derivatives_freedoms (w->r->derivatives, w->s->times[0], w->x0);
  return gs_refuse (w->r, GS_REFUSED_COLUMNS, "fixed", gs_refusals.fixed, n, found);
}

/* does the start rest on an end of a stop? places: as of gs_ports_at, of n ports */
static int
rests_on (const gs_real *places, int n, int port)
{
  const gs_real *ends = places + 2 * n + 4 * port;
  const double below = (double)(places[port] - ends[0]), above = (double)(ends[1] - places[port]),
               speed = (double)places[n + port];
  return (fabs (below) <= 1e-9 && speed <= 1e-9) || (fabs (above) <= 1e-9 && -speed <= 1e-9);
}

/* refused where the stop moves with a column and the start does not: with another parameter the run
 * would begin beside the stop, or beyond it. Without contact evp has how its nearer end moves
 * away. */
static int
leaves_stop (gs_whole_run *w, int port)
{
  const gs_scene *s = w->d->scene;
  const gs_run_options *o = w->o;
  gs_real g[s->nx + s->nv + s->nsp + 1], v[s->nv + 1];
  int mode[s->nev + 1];
  memset (g, 0, sizeof g);
  memset (v, 0, sizeof v);
  memset (mode, 0, sizeof mode);
  s->evp (w->s->times[0], w->x0, v, mode, port + 1, w->r->cst, g);
  for (int k = 0; k < o->ncolumns; k++)
    {
      gs_real slope = o->columns[k] > 0 ? g[s->nx + s->nv + o->columns[k] - 1] : 0;
      for (int i = 0; i < s->nx; i++)
        slope += g[i] * w->x0[s->nx * (k + 1) + i];
      if (fabs ((double)slope) * o->sizes[k] > 1e-6)
        return gs_refuse (w->r, GS_REFUSED_COLUMNS, "sensitivity", "the run starts on the stop %s, "
                          "whose place changes by %s otherwise than the start: give dx0 so that "
                          "they stay together", w->d->events[port],
                          o->names ? o->names[k] : "one of its columns");
    }
  return 0;
}

static int
leaves_stops (gs_whole_run *w)
{
  const gs_start_given g = { .t = w->s->times[0], .cst = w->r->cst };
  int n, refused = 0;
  gs_real *places = gs_ports_at (w->d, &g, w->x0, &n);
  if (n > 0 && ! places)
    return gs_refuse (w->r, GS_REFUSED_START, "", "there was no memory for the derivatives");
  for (int k = 0; k < n && ! refused; k++)
    if (w->d->scene->event_kinds[k] == 2 && rests_on (places, n, k))
      refused = leaves_stop (w, k);
  free (places);
  return refused;
}

int
gs_open_columns (gs_whole_run *w)
{
  const gs_run_options *o = w->o;
  gs_run_result *r = w->r;
  if (o->ncolumns == 0)
    return 0;
  if (check_columns (w))
    return 1;
  int *sets = sets_from_one (w->d);
  const char *missing = NULL;
  const gs_derivatives_given given = {
    .scene = &w->scene, .cst = r->cst, .ncst = w->d->ncst, .nc = o->ncolumns,
    .col = o->columns, .nsets = w->d->nsets, .sets = sets, .ip = r->ip, .rp = r->rp,
    .guess = w->w, .rtol = w->ropt[1], .atol = w->atol,
    .changes = o->changes
  };
  r->derivatives = sets ? gs_derivatives_open (&given, &missing) : NULL;
  free (sets);
  if (! r->derivatives && missing)
    return gs_lacks (w, 0, "option sensitivity", missing);
  if (! r->derivatives)
    return gs_refuse (r, GS_REFUSED_START, "", "there was no memory for the derivatives");
  const int why = gs_derivatives_start (r->derivatives, w->s->times[0], w->x0, o->fixed);
  return why ? refuse_fixed (w, why) : leaves_stops (w);
}

/* run_columns.c: derivatives by parameters and start values that a run carries. */
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
  return why && refuse_fixed (w, why);
}

/* start.c: what a run needs of the scene (host/start.h); margins of devices that are passed in
 * it. */
#include "fmu.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* names of the event functions: a port has the variable NAME.mode, then come those of the user */
static char *
event_names (const gsf_model *m, const char **names)
{
  size_t size = 1;
  for (int k = 0; k < m->nports; k++)
    size += strlen (m->names[gsf_first (m, GSF_MODE) + k]) + 1;
  char *text = malloc (size);
  char *next = text;
  for (int k = 0; k < m->nports && text; k++)
    {
      strcpy (next, m->names[gsf_first (m, GSF_MODE) + k]);
      *strrchr (next, '.') = 0;
      names[k] = next;
      next += strlen (next) + 1;
    }
  for (int k = m->nports; k < m->scene->nev; k++)
    names[k] = m->events[m->own[k - m->nports]];
  return text;
}

/* for gs_choose_method: that of this FMU, which has no other */
gs_implicit_method *
gs_method_named (const char *name)
{
  (void)name;
  return gsf_the_model.integrate;
}

int
gsf_describe (gsf_instance *a)
{
  const gsf_model *m = a->m;
  a->events = calloc ((size_t)m->scene->nev + 1, sizeof *a->events);
  a->event_text = a->events ? event_names (m, a->events) : NULL;
  a->about = (gs_description){
    .scene = m->scene, .mar = m->mar, .nmargins = m->nmargins, .nominal = m->nominal,
    .nsets = m->nsets, .sets = m->sets, .nspeedrows = m->nspeedrows, .speedrows = m->speedrows,
    .nsettled = m->nsettled, .settled = m->settled,
    .states = m->names + gsf_first (m, GSF_STATE), .events = a->events, .margins = m->margins,
    .meaning = gsf_meaning, .ncst = m->ncst, .npar = m->npar, .loop_method = -1
  };
  return a->event_text != NULL;
}

int
gsf_watch (gsf_instance *a)
{
  const int n = a->m->nmargins;
  if (n == 0)
    return GSF_OK;
  int *passed = calloc ((size_t)n, sizeof *passed);
  double *least = malloc ((size_t)n * sizeof *least);
  int status = passed && least ? gsf_inputs (a) : gsf_fail (a, GSF_ERROR, "out of memory");
  for (int k = 0; k < n && status == GSF_OK; k++)
    least[k] = HUGE_VAL;
  if (status == GSF_OK
      && gs_margins_at (&a->about, *a->t, a->x, a->v, a->cst, passed, least) < 0)
    status = gsf_fail (a, GSF_ERROR, "out of memory");
  for (int k = 0; k < n && status == GSF_OK; k++)
    {
      const int was = a->passed[k];
      char text[300];
      a->passed[k] = passed[k];
      if (! passed[k] || was)
        continue;
      gs_margin_text (&a->about, k, least[k], a->x, NULL, text, sizeof text);
      status = gsf_fail (a, GSF_WARNING, "a device has left the range of its laws at or before "
                         "t = %.9g s: %s", *a->t, text);
    }
  free (passed);
  free (least);
  return status;
}

/* start.c: what the start of a run needs of the scene (host/start.h); the state onto the
 * constraints; stops and margins of devices, those that are passed later. */
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
    .meaning = gsf_meaning
  };
  return a->event_text != NULL;
}

static gs_start_given
given (const gsf_instance *a, const double *v)
{
  return (gs_start_given){ .t = a->d[GSF_T], .cst = a->cst, .v = v };
}

/* a status by the verdict on a start */
static int
judged (gsf_instance *a, const gs_start *s)
{
  return s->verdict == GS_START_TAKEN ? GSF_OK : gsf_fail (a, GSF_ERROR, "%s", s->text);
}

int
gsf_close (gsf_instance *a)
{
  const gs_start_given g = given (a, NULL);
  gs_start s;
  gs_close_start (&a->about, &g, a->x, &s);
  return judged (a, &s);
}

int
gsf_possible (gsf_instance *a)
{
  if (gsf_inputs (a))
    return GSF_ERROR;
  const gs_start_given g = given (a, a->v);
  gs_start s;
  if (gs_check_margins (&a->about, &g, a->x, &s) == GS_START_TAKEN)
    gs_check_stops (&a->about, &g, a->x, &s);
  return judged (a, &s);
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
      && gs_margins_at (&a->about, a->d[GSF_T], a->x, a->v, a->cst, passed, least) < 0)
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
                         "t = %.9g s: %s", a->d[GSF_T], text);
    }
  free (passed);
  free (least);
  return status;
}

void
gsf_outside (gsf_instance *a, double t, const double *x, const double *v)
{
  const size_t n = strlen (a->text);
  gs_outside_text (&a->about, t, x, v, a->cst, NULL, a->text + n, (int)(sizeof a->text - n));
}

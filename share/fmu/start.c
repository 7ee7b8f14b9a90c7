/* start.c: where no run can start: a port beyond an end of its stop, a device where its laws do not
 * hold; devices that leave the range of their laws later. */
#include "fmu.h"
#include "gsmbp/limits.h"
#include "gsmbp/refusals.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* no port with a stop is beyond its ends; pos, speed, ends and row: as gs_hld writes them */
static int
within_stops (gsf_instance *a, double *pos, double *speed, double *ends, double *row)
{
  const gs_scene *s = a->m->scene;
  s->hld (a->d[GSF_T], a->x, a->v, a->cst, row, a->m->nports, pos, speed, ends);
  for (int k = 0; k < a->m->nports; k++)
    {
      const double low = ends[4 * k], high = ends[4 * k + 1], near = gs_limits.past_stop;
      if (s->event_kinds[k] == 2 && (pos[k] < low - near || pos[k] > high + near))
        {
          char event[200];
          gsf_event_name (a->m, k, event, sizeof event);
          return gsf_fail (a, GSF_ERROR, gs_refusals.past_stop, event, low, high, pos[k]);
        }
    }
  return GSF_OK;
}

/* is margin k kept at x, or close by? x is left as it is */
static int
is_kept (gsf_instance *a, int k, double *margin, double *size)
{
  const gsf_model *m = a->m;
  m->mar (a->d[GSF_T], a->x, a->v, a->cst, margin, size);
  int kept = margin[k] >= -gs_limits.margin_rounding * size[k];
  for (int i = 0; i < 2 * m->scene->nx && ! kept; i++)
    {
      const double x = a->x[i / 2], step = gs_limits.margin_near * m->nominal[i / 2];
      a->x[i / 2] = i % 2 ? x - step : x + step;
      m->mar (a->d[GSF_T], a->x, a->v, a->cst, margin, size);
      kept = margin[k] >= 0;
      a->x[i / 2] = x;
    }
  return kept;
}

/* does margin k hold? margin: what is found, then room for as many sizes */
static int
holds (gsf_instance *a, int k, double *margin)
{
  const gsf_model *m = a->m;
  double *size = margin + m->nmargins;
  const int kept = is_kept (a, k, margin, size);
  if (! kept)
    m->mar (a->d[GSF_T], a->x, a->v, a->cst, margin, size);
  return kept;
}

/* the laws of all devices hold */
static int
within_margins (gsf_instance *a, double *margin)
{
  for (int k = 0; k < a->m->nmargins; k++)
    if (! holds (a, k, margin))
      return gsf_fail (a, GSF_ERROR,
                       "a device cannot be there: %s: expected above 0, found %.6g",
                       a->m->margins[k], margin[k]);
  return GSF_OK;
}

int
gsf_possible (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  double *w = malloc (((6 + s->nu) * s->nev + 2 * a->m->nmargins + 1) * sizeof *w);
  if (! w)
    return gsf_fail (a, GSF_ERROR, "out of memory");
  int status = gsf_inputs (a);
  if (status == GSF_OK && a->m->nports > 0)
    status = within_stops (a, w, w + s->nev, w + 2 * s->nev, w + 6 * s->nev);
  if (status == GSF_OK)
    status = within_margins (a, w);
  free (w);
  return status;
}

int
gsf_watch (gsf_instance *a)
{
  const gsf_model *m = a->m;
  double *margin = malloc ((2 * m->nmargins + 1) * sizeof *margin);
  if (! margin)
    return gsf_fail (a, GSF_ERROR, "out of memory");
  int status = m->nmargins > 0 ? gsf_inputs (a) : GSF_OK;
  for (int k = 0; k < m->nmargins && status == GSF_OK; k++)
    {
      const int was = a->passed[k];
      a->passed[k] = ! holds (a, k, margin);
      if (a->passed[k] && ! was)
        status = gsf_fail (a, GSF_WARNING, "a device has left the range of its laws at or before "
                           "t = %.9g s: %s: expected above 0, found %g", a->d[GSF_T],
                           m->margins[k], margin[k]);
    }
  free (margin);
  return status;
}

void
gsf_outside (gsf_instance *a, double t, const double *x, const double *v)
{
  const gsf_model *m = a->m;
  const size_t n = strlen (a->text), nx = m->scene->nx;
  const double now = a->d[GSF_T];
  double *room = malloc ((2 * m->nmargins + nx) * sizeof *room);
  if (! room)
    return;
  memcpy (room, a->x, nx * sizeof *room);
  memcpy (a->x, x, nx * sizeof *room);
  memcpy (a->v, v, m->scene->nv * sizeof *v);
  a->d[GSF_T] = t;
  for (int k = 0; k < m->nmargins; k++)
    if (! holds (a, k, room + nx))
      {
        snprintf (a->text + n, sizeof a->text - n, "; outside a margin: %s: expected above 0, "
                  "found %g", m->margins[k], room[nx + k]);
        break;
      }
  memcpy (a->x, room, nx * sizeof *room);
  a->d[GSF_T] = now;
  a->known = 0;
  free (room);
}

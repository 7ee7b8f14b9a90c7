/* Runs of an ensemble in the arrays of a host. */
#include "host/ensemble/ensemble.h"

#include <stdlib.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/plan.h"
#include "host/output_rows.h"

int
gs_outputs_at (const gs_ensemble *e, const gs_member *m, int k, int at, gs_real *y)
{
  const gs_scene *s = e->scene;
  const gs_integration *r = &m->run;
  gs_real switches[s->nsw + 1], one[s->ny + 1];
  if (s->ny == 0)
    return 0;
  if (s->nsw > 0)
    s->swi (m->cst, switches);
  if (! gs_outputs (s, gs_row_time (r->tout, k, r->istat[GS_N_OUTPUTS], s->nsw, switches),
                    r->xout + (ptrdiff_t)r->ldx * at, r->vout + (ptrdiff_t)r->ldv * at, m->cst,
                    one))
    return 0;
  gs_copy (s->ny, one, y);
  return 1;
}

/* states, inputs and outputs of the first rows, of which those after the one that was reached are
 * as that one: a run that an event of the user has ended stays there */
static void
keep_rows (const gs_ensemble *e, const gs_member *m, int rows, gs_results *to)
{
  const gs_scene *s = e->scene;
  const gs_integration *r = &m->run;
  const ptrdiff_t nt = r->nt, i = m->row;
  const int reached = r->istat[GS_N_OUTPUTS], ended = m->info == GS_ENDED;
  gs_real y[s->ny + 1];
  for (int k = 0; k < rows; k++)
    {
      const int at = ended ? gs_least (k, reached) : k;
      const gs_real *x = r->xout + (ptrdiff_t)r->ldx * at, *v = r->vout + (ptrdiff_t)r->ldv * at;
      for (int j = 0; j < s->nx && to->x; j++)
        to->x[nt * (s->nx * i + j) + k] = (double)x[j];
      for (int j = 0; j < s->nv && to->v; j++)
        to->v[nt * (s->nv * i + j) + k] = (double)v[j];
      if (! to->y || (k >= reached && ! ended) || ! gs_outputs_at (e, m, k, at, y))
        continue;
      for (int j = 0; j < s->ny; j++)
        to->y[nt * (s->ny * i + j) + k] = (double)y[j];
    }
}

/* the margins of the devices in the first rows */
static void
keep_margins (const gs_ensemble *e, const gs_member *m, int rows, gs_results *to)
{
  const gs_integration *r = &m->run;
  const int n = e->about->nmargins, reached = r->istat[GS_N_OUTPUTS];
  if (n == 0 || ! to->margins)
    return;
  double *passed = to->margins + (ptrdiff_t)2 * n * m->row;
  int so_far[n];
  memset (so_far, 0, sizeof so_far);
  for (int k = 0; k < rows; k++)
    {
      const int at = gs_least (k, reached);
      if (gs_margins_at (e->about, r->tout[k], r->xout + (ptrdiff_t)r->ldx * at,
                         r->vout + (ptrdiff_t)r->ldv * at, m->cst, so_far, passed + n) < 0)
        to->no_memory = 1;
    }
  for (int k = 0; k < n; k++)
    passed[k] = so_far[k];
}

/* the events of the run */
static void
keep_events (const gs_member *m, gs_results *to)
{
  const gs_events a = gs_planned_events (m->run.nx, m->run.ip, m->run.rp);
  const int many = gs_least (a.nr, *a.count), width = 3 + 2 * a.nx;
  double *counted = to->counted ? to->counted + (ptrdiff_t)3 * a.ne * m->row : NULL;
  for (int k = 0; k < a.ne && counted; k++)
    {
      counted[k] = a.times[k];
      counted[a.ne + k] = a.times[k] > 0 ? (double)a.first[k] : NAN;
      counted[2 * a.ne + k] = a.times[k] > 0 ? (double)a.latest[k] : NAN;
    }
  if (! to->events || many == 0)
    return;
  double *list = malloc ((size_t)(3 * many) * sizeof (double));
  if (! list)
    {
      to->no_memory = 1;
      return;
    }
  for (int k = 0; k < 3 * many; k++)
    list[k] = (double)a.record[(ptrdiff_t)(k / 3) * width + k % 3];
  to->events[m->row] = list;
  to->nevents[m->row] = many;
}

static void
keep_reason (const gs_ensemble *e, const gs_member *m, gs_results *to)
{
  char text[2500];   /* the message of a refused start fits (gs_start) */
  if (! to->reason || gs_member_is_done (m))
    return;
  gs_member_failure (e, m, text, sizeof text);
  to->reason[m->row] = malloc (strlen (text) + 1);
  if (to->reason[m->row])
    strcpy (to->reason[m->row], text);
  else
    to->no_memory = 1;
}

void
gs_keep_member (void *results, const gs_ensemble *e, gs_member *m)
{
  gs_results *to = results;
  const gs_integration *r = &m->run;
  const int reached = r->istat[GS_N_OUTPUTS], ended = m->info == GS_ENDED;
  if (to->info)
    {
      to->info[2 * (ptrdiff_t)m->row] = m->info;
      to->info[2 * (ptrdiff_t)m->row + 1] = m->pre;
    }
  for (int k = 0; k < GS_COUNTED && to->counts; k++)
    to->counts[(ptrdiff_t)GS_COUNTED * m->row + k] = r->istat[k];
  for (int k = 0; k < GS_MEASURED && to->values; k++)
    to->values[(ptrdiff_t)GS_MEASURED * m->row + k] = (double)r->rstat[k];
  keep_reason (e, m, to);
  if (! m->begun)
    return;
  keep_rows (e, m, ended ? r->nt : gs_least (r->nt, reached + (m->info != 0)), to);
  keep_margins (e, m, ended ? r->nt : gs_least (r->nt, reached), to);
  if (e->scene->nev > 0 && r->ip[GS_EVENTS] > 0)
    keep_events (m, to);
}

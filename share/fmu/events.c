/* events.c: events of model exchange: ports that stick or hit a stop, events of the user (own.c),
 * samples, another choice of independent coordinates, Euler parameters of the length 1.
 *
 * An event of a port is where its function falls below its level: 0 where it was above 0 since its
 * last event, else a little below where that event left it. So a stop that was just left is not hit
 * by rounding errors, and is met again where it comes back before it has risen. */
#include "fmu.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/system.h"

#include <math.h>

#define GSF_LEVEL 1e-10

void
gsf_next_switch (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  double *ts = a->w + gs_room (s, s->nx, 0) - s->nsw;
  a->d[GSF_T_SWITCH] = 2e300;
  if (s->nsw == 0)
    return;
  s->swi (a->cst, ts);
  for (int k = 0; k < s->nsw; k++)
    if (ts[k] > *a->t && ts[k] < a->d[GSF_T_SWITCH])
      a->d[GSF_T_SWITCH] = ts[k];
}

double
gsf_time (const gsf_instance *a)
{
  const double t = *a->t, due = a->d[GSF_T_SWITCH];
  return t >= due ? gs_time_beside (due, -1) : t;
}

int
gsf_functions (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  if (gsf_inputs (a))
    return GSF_ERROR;
  s->evt (gsf_time (a), a->x, a->v, gsf_events (a).mode, a->cst, a->g);
  return GSF_OK;
}

static int
set_levels (gsf_instance *a)
{
  if (gsf_functions (a))
    return GSF_ERROR;
  for (int k = 0; k < a->m->nports; k++)
    a->level[k] = a->g[k] > 0 ? 0 : a->g[k] - GSF_LEVEL;
  return GSF_OK;
}

int
gsf_happens (gsf_instance *a, int k)
{
  const int own = a->m->nown > 0 && a->i[GSF_KIND] == GSF_EXCHANGE;
  if (own)
    gsf_before_own (a);
  if (gs_step_event (&a->run, k))
    return gsf_run_says (a);
  return own ? gsf_after_own (a) : GSF_OK;
}

int
gsf_begin_events (gsf_instance *a)
{
  if (a->m->scene->nev > 0 && set_levels (a))
    return GSF_ERROR;
  gsf_begin_own (a);
  return GSF_OK;
}

/* the function that fell below its level most, from 1, or 0 */
static int
fallen (const gsf_instance *a)
{
  int n = 0;
  double least = 0;
  for (int k = 0; k < a->m->scene->nev; k++)
    if (a->g[k] <= a->level[k] && (n == 0 || a->g[k] < least)
        && (k < a->m->nports || gsf_is_ready (a, k)))
      {
        n = k + 1;
        least = a->g[k];
      }
  return n;
}

/* ports and events of the user at an instant of event mode */
static int
ports (gsf_instance *a)
{
  if (a->m->scene->nev == 0)
    return GSF_OK;
  if (gsf_functions (a))
    return GSF_ERROR;
  for (int k = fallen (a); k > 0; k = fallen (a))
    if (gsf_happens (a, k) || set_levels (a))
      return GSF_ERROR;
  return gsf_happens (a, -1) ? GSF_ERROR : set_levels (a);
}

/* what sampled devices do at this instant, and when the next one is */
int
gsf_take_samples (gsf_instance *a, int *acted)
{
  int istat[GS_COUNTED] = { 0 };
  a->d[GSF_T_NEXT] = 2e300;
  *acted = 0;
  int info = gs_samples_due (a->m->scene, *a->t, a->x, a->m->scene->nx, a->run.r.ip,
                             a->run.r.rp, a->cst, a->v, a->w, istat, a->d + GSF_T_NEXT, acted);
  return info == 0 ? GSF_OK : gsf_failed (a, GSF_ERROR, istat[GS_FAILED],
                                          istat[GS_FAILED_INFO]);
}

/* other independent coordinates where these are near the end of their range, Euler parameters of
 * the length 1 */
static int
coordinates (gsf_instance *a, int *chosen)
{
  double range, normal;
  *chosen = 0;
  if (gsf_margins (a, &range, &normal))
    {
      *chosen = a->m->scene->nlam > 0;
      if (*chosen && gsf_choose (a))
        return GSF_ERROR;
    }
  return GSF_OK;
}

int
gsf_event (gsf_instance *a, int *changed, int *nominals)
{
  int acted, chosen, ns = gsf_ns (a->m), status = gsf_fresh (a);
  *changed = *nominals = 0;
  if (status)
    return GSF_ERROR;
  if (a->m->scene->nev > 0 && ! (*a->t == a->d[GSF_T_EVENT]))
    *gsf_events (a).since = 0;
  a->d[GSF_T_EVENT] = *a->t;
  const int switched = *a->t >= a->d[GSF_T_SWITCH];
  gsf_next_switch (a);
  /* what a switch alone would bring about does not count where samples are due, too */
  if ((! switched && ports (a)) || gsf_take_samples (a, &acted)
      || ((acted || switched) && ports (a)) || coordinates (a, &chosen))
    return GSF_ERROR;
  if (a->d[GSF_T_SWITCH] < a->d[GSF_T_NEXT])
    a->d[GSF_T_NEXT] = a->d[GSF_T_SWITCH];
  gs_copy (ns, a->z, a->w);
  gsf_take (a);
  for (int k = 0; k < ns; k++)
    *changed |= ! (a->w[k] == a->z[k]);
  *nominals = chosen;
  a->known = 0;
  return GSF_OK;
}

int
gsf_indicators (gsf_instance *a, double *z)
{
  int n = a->m->scene->nev, status = gsf_fresh (a);
  double range, normal;
  if (status)
    return status;
  if (n > 0 && gsf_functions (a))
    return GSF_ERROR;
  gsf_risen_own (a, 0);
  for (int k = 0; k < n; k++)
    z[k] = a->g[k] - a->level[k];
  gsf_margins (a, &range, &normal);
  if (a->m->scene->nlam > 0)
    z[n++] = range - 0.5;
  if (a->m->nsets > 0)
    z[n] = normal;
  return GSF_OK;
}

int
gsf_indicator (gsf_instance *a, int k, double *z)
{
  double *all = a->xout;   /* as long as nev + 2 */
  int status = gsf_indicators (a, all);
  *z = all[k];
  return status;
}

int
gsf_completed (gsf_instance *a, int *event)
{
  double range, normal;
  int status = gsf_fresh (a);
  *event = 0;
  if (status)
    return status;
  gs_copy (a->m->scene->nx, a->x, a->xr);
  *event = gsf_margins (a, &range, &normal);
  if (a->m->scene->nev == 0)
    return GSF_OK;
  if (gsf_functions (a))
    return GSF_ERROR;
  gsf_risen_own (a, 1);
  for (int k = 0; k < a->m->nports; k++)
    if (a->g[k] > 0)
      {
        a->level[k] = 0;
        gsf_events (a).mark[k] = 1;
      }
  *event |= fallen (a) > 0;
  return GSF_OK;
}

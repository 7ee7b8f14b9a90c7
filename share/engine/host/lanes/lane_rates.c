/* Right-hand sides of all lanes. */
#include "host/lanes/lanes.h"

#include <math.h>

#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"

/* For the rest of a step in which a stage has failed: the next trial begins with the same rates and
 * is shorter than this one. */
static void
rest (gs_lane_group *g, int lane)
{
  int known = 1;
  for (int k = 0; k < g->nx; k++)
    known &= fabs (g->f[k][lane]) <= 1e300;
  if (g->run[lane].joined)
    g->run[lane].e.h = g->step[lane];
  gs_park_lane (g, lane, known);
}

static void
fail (gs_lane_group *g, int lane, int info, int where)
{
  gs_lane_run *l = &g->run[lane];
  l->failed = info;
  g->failed = 1;
  l->m.run.istat[GS_FAILED_INFO] = info;
  l->m.run.istat[GS_FAILED] = where;
  rest (g, lane);
}

/* the inputs of a lane at a time and state */
static void
set_inputs (gs_lane_group *g, int lane, double t, int side, const double *x)
{
  gs_course *c = &g->run[lane].c;
  const gs_integration *r = c->run;
  const int info = gs_inputs_of_run (c->g.s, t, side, x, r->nx, r->ip, r->rp, r->cst, c->g.v, r->w);
  if (info != 0)
    fail (g, lane, info, GS_AT_INPUTS);
  else
    gs_put_lane (g->v, lane, c->g.v, g->nv);
}

void
gs_lane_rates (gs_lane_group *g, gs_lane *x, gs_lane *xd)
{
  const int n = GS_LANES;
  g->w->rhs (g->stage_t, x[0], g->v[0], g->cst[0], xd[0], g->info, &g->width, &n);
}

/* what gs_rates_from says of an info that is not 0 */
static void
count (gs_lane_group *g, int lane, int info, double t)
{
  int *istat = g->run[lane].m.run.istat;
  double *when = g->run[lane].m.run.rstat + 2 * (info + 5) - 5;
  if (info != 2 && info != 3)
    {
      fail (g, lane, info, GS_AT_RHS);
      return;
    }
  if (istat[info + 5] == 0)
    when[0] = t;
  when[1] = t;
  istat[info + 5]++;
}

void
gs_stage_rates (gs_lane_group *g, gs_lane *xd, const double *t, gs_lane *x, int last)
{
  for (int k = 0; k < GS_LANES; k++)
    g->stage_t[k] = last && g->at[k] < 0 ? gs_time_beside (t[k], -1) : t[k];
  for (int k = 0; g->of_time && k < GS_LANES; k++)
    if (g->active[k])
      {
        double one[g->nx];
        gs_get_lane (x, k, one, g->nx);
        set_inputs (g, k, t[k], last ? (int)g->at[k] : 1, one);
      }
  gs_lane_rates (g, x, xd);
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      g->calls[k] += g->active[k];
      some |= g->info[k];
    }
  for (int k = 0; some != 0 && k < GS_LANES; k++)
    if (g->active[k] && g->info[k] != 0)
      count (g, k, g->info[k], t[k]);
}

/* At the end of many runs, or with few, half of the lanes do. */
void
gs_activate_lanes (gs_lane_group *g)
{
  g->width = GS_LANES / 2;
  g->failed = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      g->active[k] = g->together || g->run[k].steps;
      g->calls[k] = 0;
      if (g->active[k] && k >= g->width)
        g->width = GS_LANES;
    }
}

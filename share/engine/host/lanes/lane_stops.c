/* Runs in lanes from stop to stop, each by itself: how they begin and end. */
#include "host/lanes/lanes.h"

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"

int
gs_any_lane (const gs_lane_group *g)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    some |= g->run[k].busy;
  return some;
}

/* the state, inputs and constants of the first lane that has a run */
static void
take_numbers (gs_lane_group *g, int lane)
{
  int from = 0;
  while (! g->run[from].busy)
    from++;
  const gs_lane_run *l = &g->run[from];
  gs_put_lane (g->x, lane, l->c.x, g->nx);
  gs_put_lane (g->v, lane, l->c.g.v, g->nv);
  gs_put_lane (g->cst, lane, l->m.cst, g->e->ncst);
}

void
gs_start_lanes (gs_lane_group *g)
{
  for (int k = 0; k < g->most; k++)
    gs_fill_lane (g, k);
  for (int k = 1; k < GS_LANES && gs_any_lane (g); k++)
    if (! g->run[k].started)   /* it goes on with numbers that are good */
      take_numbers (g, k);
}

/* Then those of the lanes are where they are. */
int
gs_left_lanes (gs_lane_group *g)
{
  const gs_integration *all = &g->e->run;
  const int info = all->ask ? all->ask (all->asked, all->t0) : 0;
  if (info == 0)
    return 0;
  for (int k = 0; k < GS_LANES; k++)
    if (g->run[k].busy)
      {
        gs_part_lane (g, k);
        gs_end_lane (g, k, info);
      }
  return 1;
}

/* at a stop: outputs, samples, the next stop; 0 at the end of the run */
static int
to_next_stop (gs_lane_group *g, gs_lane_run *l)
{
  gs_course *c = &l->c;
  int acted;
  c->g.rstat[GS_T_REACHED] = c->t;
  l->m.info = gs_integration_stop (c, &acted);
  if (l->m.info != 0 || c->it >= c->run->nt)
    return 0;
  if (acted == 1)
    {
      c->fresh = 1;
      c->after = 0;
    }
  if (g->method == 4)
    {
      l->way = (gs_equal_steps){ .ta = c->t, .hr = c->g.ropt[0] };
      gs_cut_way (c, &l->way);
    }
  return 1;
}

int
gs_lane_stopped (gs_lane_group *g, gs_lane_run *l)
{
  gs_course *c = &l->c;
  gs_integration *r = c->run;
  const int failed
      = gs_inputs_of_run (c->g.s, c->t, c->side, c->x, r->nx, r->ip, r->rp, r->cst, c->g.v, r->w);
  if (failed == 0)
    return to_next_stop (g, l);
  l->m.info = GS_ROUTINE_FAILED;
  r->istat[GS_FAILED_INFO] = failed;
  r->istat[GS_FAILED] = GS_AT_INPUTS;
  return 0;
}

/* the begin of gs_integrate; 0 where the run has ended */
static int
begin (gs_lane_group *g, gs_lane_run *l)
{
  gs_member *m = &l->m;
  l->c.x = NULL;
  m->info = gs_check_arguments (&m->scene, &m->run);
  if (m->info != 0)
    return 0;
  gs_integration_init (&m->scene, &m->run, &l->c);
  m->info = gs_integration_start (&l->c);
  return m->info == 0 && to_next_stop (g, l);
}

/* the run is over: where it came to if that is not its end; gs_integrate says the same of one whose
 * arguments are out of range */
static void
finish (gs_lane_group *g, gs_lane_run *l)
{
  gs_member *m = &l->m;
  gs_integration *r = &m->run;
  const int k = r->istat[GS_N_OUTPUTS];
  if (m->info >= 0 && l->c.x && k < r->nt)
    {
      gs_copy (r->nx, l->c.x, r->xout + (ptrdiff_t)r->ldx * k);
      gs_copy (g->nv, l->c.g.v, r->vout + (ptrdiff_t)r->ldv * k);
    }
  gs_go_on (g->e, m);
  g->source->done (g->source->data, m);
}

void
gs_fill_lane (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  for (l->busy = l->steps = l->alone = 0; ! l->busy && g->source->next (g->source->data, &l->m);)
    if (begin (g, l))
      l->busy = 1;
    else
      finish (g, l);
  if (! l->busy || g->method != 4)   /* the next step of rk4 writes all that it reads */
    gs_park_lane (g, lane, 0);
  if (! l->busy)
    return;
  l->started = 1;
  gs_lane_state (g, lane);
  gs_put_lane (g->cst, lane, l->m.cst, g->e->ncst);
}

void
gs_lane_state (gs_lane_group *g, int lane)
{
  gs_put_lane (g->x, lane, g->run[lane].c.x, g->nx);
  gs_put_lane (g->v, lane, g->run[lane].c.g.v, g->nv);
}

void
gs_park_lane (gs_lane_group *g, int lane, int known)
{
  for (int k = known * g->nx; k < (g->method == 4 ? 4 : 12) * g->nx; k++)
    g->f[k][lane] = 0;
  g->step[lane] = 0;
  g->active[lane] = 0;
}

void
gs_end_lane (gs_lane_group *g, int lane, int info)
{
  g->run[lane].m.info = info;
  finish (g, &g->run[lane]);
  gs_fill_lane (g, lane);
}

int
gs_lane_keeps_on (gs_lane_group *g, int lane)
{
  gs_lane_run *l = &g->run[lane];
  if (gs_lane_stopped (g, l))
    gs_lane_state (g, lane);
  else
    gs_end_lane (g, lane, l->m.info);
  return l->busy;
}

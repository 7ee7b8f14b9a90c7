/* The loops of the runs in lanes that have joined: projection, drift, rank, least pivots. */
#include "host/lanes/lanes.h"

#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"

/* whether what gs_take_passage and gs_check_constraints do for the run is done in vectors */
int
gs_lane_closes (const gs_lane_group *g, const gs_lane_run *l)
{
  const int *iopt = g->e->run.iopt;
  const gs_course *c = &l->c;
  if (g->nlam == 0)
    return g->nq == g->nu;
  return g->projects && iopt[GS_LOOPS] == 2 && iopt[GS_WATCH] == (iopt[GS_DRIFT] == 1)
         && c->a.begin <= 0 && c->repeated == 0
         && (g->method == 4 || g->e->run.ropt[1] >= c->loose);
}

static int
partition_size (const gs_lane_group *g)
{
  return 24 + 18 * g->nq + 7 * g->nlam + 2 * g->nlam * g->nq;
}

gs_lane *
gs_lane_sizes (const gs_lane_group *g)
{
  return g->p + g->sizes;
}

void
gs_join_loops (gs_lane_group *g, int lane)
{
  const gs_course *c = &g->run[lane].c;
  const double *rstat = c->g.rstat, *p = c->g.p;
  gs_put_lane (g->p, lane, p, partition_size (g));
  g->pivot[lane] = p[GS_PIVOT];
  g->highest[lane] = p[GS_LARGEST];
  g->phi_0[lane] = rstat[GS_R_PHI];
  g->rate_0[lane] = rstat[GS_R_RATE];
  g->t_phi[lane] = rstat[GS_T_PHI];
  g->t_rate[lane] = rstat[GS_T_RATE];
  g->projected[lane] = rstat[GS_R_BEFORE];
  g->smallest[lane] = rstat[GS_R_PIVOT];
  g->smallest_at[lane] = rstat[GS_T_PIVOT];
  g->projections[lane] = c->g.istat[GS_N_PROJECTIONS];
  g->past[lane] = c->a.not_before;
  g->turn[lane] = c->a.turn;
  g->known[lane] = 0;
}

void
gs_part_loops (gs_lane_group *g, int lane)
{
  gs_course *c = &g->run[lane].c;
  double *rstat = c->g.rstat;
  gs_get_lane (g->p, lane, c->g.p, partition_size (g));
  rstat[GS_R_PHI] = g->phi_0[lane];
  rstat[GS_R_RATE] = g->rate_0[lane];
  rstat[GS_T_PHI] = g->t_phi[lane];
  rstat[GS_T_RATE] = g->t_rate[lane];
  rstat[GS_R_BEFORE] = g->projected[lane];
  rstat[GS_R_PIVOT] = g->smallest[lane];
  rstat[GS_T_PIVOT] = g->smallest_at[lane];
  c->g.istat[GS_N_PROJECTIONS] = (int)g->projections[lane];
  c->a.turn = g->turn[lane];
}

void
gs_lane_jacobians (gs_lane_group *g, const double *t, gs_lane *q, gs_lane *cst,
                   gs_lane *hc)
{
  const int n = GS_LANES;
  g->w->con (t, q[0], cst[0], hc[0], g->info, &n, &n);
}

void
gs_know_jacobians (gs_lane_group *g)
{
  int all = 1;
  for (int k = 0; k < GS_LANES; k++)
    all &= g->runs[k] <= 0 || g->known[k] > 0;
  if (all)
    return;
  gs_lane_jacobians (g, g->t, g->x, g->cst, g->hn);
  for (int k = 0; k < GS_LANES; k++)
    if (g->runs[k] > 0 && g->known[k] <= 0)
      {
        for (int j = 0; j < g->nlam * g->nq; j++)
          g->hc[j][k] = g->hn[j][k];
        g->known[k] = 1;
      }
}

/* some turns of gs_project, then it is left to each alone */
static void
onto_constraints (gs_lane_group *g)
{
  const int n = GS_LANES;
  int again = 1;
  for (int turn = 1; turn <= 8 && again; turn++)
    {
      g->w->prj (g->tn, g->xn[0], g->cst[0], g->phi[0], g->rate[0], g->hn[0], g->dq[0], g->du[0],
                 g->info, &n, &n);
      again = gs_project_turn (g, turn);
    }
  for (int k = 0; k < GS_LANES; k++)
    if (g->live[k] > 0)
      g->slow[k] = 1;
  if (g->method != 4)
    gs_find_jumps (g);
}

/* the rank of the constraints, their least pivot */
static void
watch_loops (gs_lane_group *g)
{
  gs_lane_pivots (g, g->hn, gs_lane_sizes (g));
  gs_lane_turns (g, g->hn, g->hc, g->lengths);
  for (int k = 0; k < GS_LANES; k++)
    g->margin[k] = g->method == 4 ? 0.01 : g->tn[k] < g->stop[k] ? g->run[k].c.close : 0;
  gs_find_unusual (g);
}

static int
is_good (const gs_lane_group *g, int lane)
{
  return g->r[lane] > 0.5 && g->r[lane] < 1.5;
}

void
gs_project_lanes (gs_lane_group *g)
{
  const int watch = g->e->run.iopt[GS_WATCH] == 1;
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    {
      g->live[k] = is_good (g, k);
      g->slow[k] = 0;
      some |= is_good (g, k);
    }
  if (! some)
    return;
  if (watch)
    gs_know_jacobians (g);
  memcpy (g->rates, g->xn, (size_t)g->nx * sizeof (gs_lane));
  onto_constraints (g);
  if (watch)
    watch_loops (g);
  for (int k = 0; k < GS_LANES; k++)
    if (is_good (g, k) && g->slow[k] > 0)
      {
        for (int j = 0; j < g->nx; j++)
          g->xn[j][k] = g->rates[j][k];
        gs_part_lane (g, k);
        g->r[k] = 0;
      }
    else if (is_good (g, k))
      {
        g->projections[k]++;
        g->projected[k] = gs_max (g->projected[k], g->res[k]);
      }
  if (! watch)
    return;
  gs_remember_loops (g);
  for (int k = 0; k < GS_LANES; k++)
    for (int j = 0; is_good (g, k) && j < g->nlam * g->nq; j++)
      g->hc[j][k] = g->hn[j][k];
}

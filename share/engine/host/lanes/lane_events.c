/* The events of the runs in lanes that have joined: what gs_first_event does where a step has none,
 * by the event functions of all lanes at once. Where they do not say so the run parts, and
 * gs_first_event looks. */
#include "host/lanes/lanes.h"

#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/plan.h"

int
gs_lane_events (const gs_ensemble *e)
{
  const int *ip = e->run.ip;
  if (e->run.iopt[GS_METHOD] == 4 || ip[GS_EVENTS] == 0 || ip[GS_V0] != 0 || ip[GS_FEEDBACK] != 0)
    return 0;
  return e->lanes->evt ? ip[ip[GS_EVENTS] - 1] : 0;
}

static gs_events
events_of (const gs_lane_run *l)
{
  return gs_planned_events (l->m.run.nx, l->m.run.ip, l->m.run.rp);
}

/* From when on gs_user_accumulates may say that events of function i accumulate; a little
   before. */
static double
accumulate_from (const gs_events *a, int i)
{
  if (! gs_is_own (a, i))
    return 1e300;
  const double from = gs_accumulates_from (a, i);
  return from - 1e-9 * fabs (from);
}

/* does port i, one of nh that may be held, have loops or other speeds next to it? */
static int
has_others (const gs_lane_run *l, int nh, int i)
{
  const gs_course *c = &l->c;
  const gs_scene *s = c->g.s;
  gs_real row[nh * s->nu], pos[nh], sd[nh], prm[4 * nh];
  for (int k = 0; k < nh * s->nu; k++)
    row[k] = 0;
  s->hld (c->t, c->x, c->g.v, c->g.cst, row, nh, pos, sd, prm);
  int many = 0;
  for (int j = 0; j < s->nu; j++)
    many += fabs (row[i + nh * j]) > 0;
  return many > 1;
}

/* Are such ports held? After each step the state is moved to where they are held
   (gs_hold_after_step). */
static int
moves_held (const gs_events *a, const gs_lane_run *l)
{
  int nh = 0;
  while (nh < a->ne && ! gs_is_own (a, nh))
    nh++;
  for (int i = 0; i < nh; i++)
    if (gs_is_held (a, i) && (l->c.g.s->nlam > 0 || has_others (l, nh, i)))
      return 1;
  return 0;
}

/* Where a function has just had its event, counts from a level of its own or waits for its sign at
 * the end of a step the run looks by itself, and where it is moved after the step. */
void
gs_join_events (gs_lane_group *g, int lane)
{
  const gs_events a = events_of (&g->run[lane]);
  int looks = g->events > 0 && ! moves_held (&a, &g->run[lane]);
  for (int i = 0; i < g->events; i++)
    {
      const double *told = gs_told (&a, i);
      const int own = gs_is_own (&a, i);
      looks = looks && a.fresh[i] == 0 && ! (fabs (a.level[i]) > 0) && *a.tells != 1;
      g->g0[i][lane] = a.g[i];
      g->mark[i][lane] = a.mark[i];
      g->noise[i][lane] = own ? gs_max (told[GS_TOLD_RISEN], told[GS_TOLD_NOISE]) : 1e300;
      g->needs[i][lane] = ! own;
      g->until[i][lane] = accumulate_from (&a, i);
      g->repeats[i][lane] = gs_interval (&a, i) > 0 ? gs_repeats_until (&a, i) : -1e300;
    }
  g->looks[lane] = looks;
  if (! looks)
    g->due[lane] = -1e300;   /* gs_end_trial judges every step */
}

void
gs_part_events (gs_lane_group *g, int lane)
{
  if (g->moved[lane] <= 0)
    return;
  gs_events a = events_of (&g->run[lane]);
  *a.since = 0;
  for (int i = 0; i < g->events; i++)
    a.g[i] = g->g0[i][lane];
}

/* the event functions at point j of the steps, on the polynomial of that degree */
static void
functions_at (gs_lane_group *g, int j, int degree)
{
  const int n = GS_LANES;
  gs_event_states (g, j, degree);
  g->w->evt (g->stage_t, g->z[0], g->v[0], g->cst[0], g->g[0], g->info, &g->width, &n);
}

/* Does the step of a lane go past a time until which events of a function may repeat themselves? */
static int
past_repeats (const gs_lane_group *g, int lane)
{
  const double end = g->tn[lane], begin = end - g->step[lane], fuzz = 1e-12 * fabs (end);
  for (int i = 0; i < g->events; i++)
    if (begin < g->repeats[i][lane] + fuzz && end > g->repeats[i][lane] - fuzz)
      return 1;
  return 0;
}

static int
is_good (const gs_lane_group *g, int lane)
{
  return g->r[lane] > 0.5 && g->r[lane] < 1.5;
}

void
gs_look_for_events (gs_lane_group *g)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    some |= is_good (g, k);
  if (! some)
    return;
  for (int k = 0; k < GS_LANES; k++)
    g->stage_t[k] = g->at[k] < 0 ? gs_time_beside (g->tn[k], -1) : g->tn[k];
  gs_lane_rates (g, g->xn, g->fn);
  for (int k = 0; k < GS_LANES; k++)
    g->loud[k] = g->info[k] != 0 || past_repeats (g, k);
  for (int j = 1; j <= 8; j++)
    {
      functions_at (g, j, 5);
      gs_look_at_events (g, j);
      if (j != 4 && j != 6)
        continue;
      functions_at (g, j, 3);
      gs_events_apart (g, j);
    }
  gs_judge_events (g);
  for (int k = 0; k < GS_LANES; k++)
    if (is_good (g, k) && g->loud[k] > 0)
      g->r[k] = 3;
  gs_part_failed (g);
}

/* What gs_first_event and gs_end_trial remember of good steps without an event. */
void
gs_remember_quiet (gs_lane_group *g)
{
  const int known = g->nlam == 0 && g->nq == g->nu;   /* rates at the end are those of the next */
  gs_lane quiet;
  for (int l = 0; l < GS_LANES; l++)
    {
      quiet[l] = is_good (g, l) && g->looks[l] > 0;
      g->called[l] += quiet[l];
    }
  for (int i = 0; i < g->events; i++)
    for (int l = 0; l < GS_LANES; l++)
      g->g0[i][l] = quiet[l] > 0 ? g->g[i][l] : g->g0[i][l];
  if (! known)
    return;
  for (int l = 0; l < GS_LANES; l++)   /* unless inputs jump there */
    {
      quiet[l] = g->at[l] <= 0 ? 0 : quiet[l];
      g->wants[l] = quiet[l] > 0 ? 2 : g->wants[l];
    }
  for (int i = 0; i < g->nx; i++)
    for (int l = 0; l < GS_LANES; l++)
      g->f[i][l] = quiet[l] > 0 ? g->fn[i][l] : g->f[i][l];
}

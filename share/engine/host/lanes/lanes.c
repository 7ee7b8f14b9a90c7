/* A group of lanes: its arrays, and its runs until there is none left. */
#include "host/lanes/lanes.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/partition.h"

void
gs_put_lane (gs_lane *to, int lane, const double *from, int n)
{
  for (int k = 0; k < n; k++)
    to[k][lane] = from[k];
}

void
gs_get_lane (gs_lane *from, int lane, double *to, int n)
{
  for (int k = 0; k < n; k++)
    to[k] = from[k][lane];
}

int
gs_some_above (const double *a, double limit)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    some |= a[k] > limit;
  return some;
}

int
gs_some_below (const double *a, double limit)
{
  int some = 0;
  for (int k = 0; k < GS_LANES; k++)
    some |= a[k] < limit;
  return some;
}

/* an array of n numbers for each lane, from *at on, or counted where that is a null pointer */
static gs_lane *
array (gs_lane **at, size_t *count, int n)
{
  gs_lane *here = *at;
  *count += (size_t)n + 1;
  if (here)
    *at = here + n + 1;
  return here;
}

/* all arrays from here on, or, with a null pointer, how many rows they take */
static size_t
divide (gs_lane_group *g, gs_lane *here)
{
  const int nx = g->nx, nq = g->nq, nlam = g->nlam, ncst = g->e->ncst, ne = g->events;
  gs_lane **const states[] = { &g->x, &g->xs, &g->xn, &g->rates };
  gs_lane **const functions[] = { &g->g, &g->g0, &g->old, &g->older, &g->mark, &g->noise, &g->bend,
                                  &g->quiet, &g->apart, &g->needs, &g->until, &g->repeats };
  gs_lane **const positions[] = { &g->q, &g->dq, &g->du };
  gs_lane **const constraints[] = { &g->phi, &g->rate, &g->lengths };
  gs_lane **const jacobians[] = { &g->hc, &g->hn, &g->y };
  size_t n = 0;
  for (size_t k = 0; k < sizeof states / sizeof states[0]; k++)
    *states[k] = array (&here, &n, nx);
  g->f = array (&here, &n, 12 * nx);
  g->v = array (&here, &n, g->nv);
  g->cst = array (&here, &n, ncst);
  g->one_cst = array (&here, &n, nlam > 0 ? ncst : 0);
  for (size_t k = 0; k < sizeof functions / sizeof functions[0]; k++)
    *functions[k] = array (&here, &n, ne);
  g->fn = array (&here, &n, ne > 0 ? nx : 0);
  g->z = array (&here, &n, ne > 0 ? nx : 0);
  for (size_t k = 0; k < sizeof positions / sizeof positions[0]; k++)
    *positions[k] = array (&here, &n, nq);
  for (size_t k = 0; k < sizeof constraints / sizeof constraints[0]; k++)
    *constraints[k] = array (&here, &n, nlam);
  for (size_t k = 0; k < sizeof jacobians / sizeof jacobians[0]; k++)
    *jacobians[k] = array (&here, &n, nlam * nq);
  g->work = array (&here, &n, nlam + 8);
  g->p = array (&here, &n, 24 + 18 * nq + 7 * nlam + 2 * nlam * nq);
  return n;
}

static void
read_sizes (gs_lane_group *g)
{
  const gs_ensemble *e = g->e;
  const gs_scene *s = e->scene;
  g->nx = e->run.nx;
  g->nq = s->nq;
  g->nu = s->nu;
  g->nv = s->nv;
  g->nlam = s->nlam;
  g->method = e->run.iopt[GS_METHOD];
  g->w = e->lanes;
  g->width = GS_LANES;
  g->of_time = e->run.ip[GS_V0] != 0 || e->run.ip[GS_FEEDBACK] != 0;
  g->projects = s->nlam > 0 && g->w->prj && g->w->con;
  g->events = gs_lane_events (e);
}

static void
find_partition (gs_lane_group *g)
{
  double *p = g->run[0].m.run.w;   /* any array that is as long */
  const gs_partition a = gs_partition_of (g->nq, g->nu, g->nlam, p);
  g->sizes = (int)(a.size - p);
  g->path = (int)(a.path - p);
}

int
gs_make_lanes (gs_lane_group *g)
{
  read_sizes (g);
  const size_t rows = divide (g, NULL) + 1;
  g->room = calloc (rows * GS_LANES + 8, sizeof (double));
  if (! g->room)
    return GS_OUT_OF_MEMORY;
  /* at a multiple of 64 bytes */
  const size_t off = (uintptr_t)g->room % 64 / sizeof (double);
  divide (g, (gs_lane *)(g->room + (8 - off) % 8));
  for (int k = 0; k < GS_LANES; k++)
    g->limit[k] = 1e300;
  gs_lane_method (g);
  for (int k = 0; k < GS_LANES; k++)
    if (gs_make_member (g->e, &g->run[k].m) != 0)
      return GS_OUT_OF_MEMORY;
  find_partition (g);
  return 0;
}

void
gs_free_lanes (gs_lane_group *g)
{
  for (int k = 0; k < GS_LANES; k++)
    gs_free_member (&g->run[k].m);
  free (g->room);
}

int
gs_run_lanes (const gs_ensemble *e, const gs_lane_source *source, int most)
{
  void *room = calloc (1, sizeof (gs_lane_group) + 64);
  if (! room)
    return GS_OUT_OF_MEMORY;
  gs_lane_group *g = (gs_lane_group *)((char *)room + (64 - (uintptr_t)room % 64) % 64);
  g->e = e;
  g->source = source;
  g->most = most < GS_LANES ? most : GS_LANES;
  const int failed = gs_make_lanes (g);
  if (! failed)
    gs_start_lanes (g);
  while (! failed && gs_any_lane (g) && ! gs_left_lanes (g))
    (g->method == 4 ? gs_lanes_step_rk4 : gs_lanes_step_dp853) (g);
  gs_free_lanes (g);
  free (room);
  return failed;
}

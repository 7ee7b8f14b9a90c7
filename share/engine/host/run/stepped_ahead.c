/* stepped_ahead.c: a step that ends later than the time that was asked for: its polynomial, from
 * which the states at the next times come while no input changes.
 *
 * No step goes beyond a sample, a switch, an event or the stop, so that nothing happens between. */
#include "gsmbp/arith.h"
#include "gsmbp/expressions.h"
#include "gsmbp/loops.h"
#include "gsmbp/partition.h"
#include "host/run/run_parts.h"

/* steps go this many times as far at most: what happens in short times is seen */
enum { FARTHEST = 20 };

void
gs_step_forget (gs_stepped_run *a)
{
  a->clock[GS_STEP_AHEAD_LENGTH] = 0;
  *a->parts->quiet = 0;
}

gs_real
gs_step_beyond (const gs_stepped_run *a, gs_real t, gs_real h)
{
  const gs_real left = a->clock[GS_STEP_STOP] - t;
  if ((a->parts->whole.d->scene->nv > 0 && *a->parts->quiet < 2) || ! (left > 0))
    return 0;
  return gs_min (FARTHEST * h, left);
}

void
gs_step_keep (gs_stepped_run *a, const gs_dense *e)
{
  const int nx = a->r.nx;
  gs_real *to = a->parts->ahead;
  a->clock[GS_STEP_AHEAD_LENGTH] = e->h;
  if (! (e->h > 0))
    return;
  a->clock[GS_STEP_AHEAD] = e->t;
  gs_copy (nx, e->x, to);
  gs_copy (nx, e->xn, to + nx);
  gs_copy (9 * nx, e->f, to + 2 * nx);
}

/* r.x onto the constraints, as the ends of steps are; x, xn: those of its step */
static int
move (gs_stepped_run *a, gs_real t, const gs_real *x, const gs_real *xn)
{
  const gs_whole_run *w = &a->parts->whole;
  const gs_scene *s = w->d->scene;
  gs_real jump[3] = { 0 }, rstat[GS_MEASURED] = { 0 };
  int istat[GS_COUNTED] = { 0 };
  gs_partition_none (s->nq, s->nu, s->nlam, w->iopt, a->w);
  a->w[GS_WAY] = 0;
  gs_largest_move (s->nq, s->nu, x, xn, a->clock[GS_STEP_RTOL], a->r.atol, jump);
  return gs_move_onto (s, t, a->r.x, w->iopt, jump, a->r.cst, a->w, istat, rstat);
}

int
gs_step_within (gs_stepped_run *a, gs_real t)
{
  const int nx = a->r.nx;
  const gs_real h = a->clock[GS_STEP_AHEAD_LENGTH], from = a->clock[GS_STEP_AHEAD];
  const gs_real *x = a->parts->ahead, *xn = x + nx;
  if (! (t < from + h))
    {
      gs_copy (nx, xn, a->r.x);
      return 0;
    }
  gs_dense_at (nx, h, (t - from) / h, x, xn, x + 2 * nx, a->r.x);
  return move (a, t, x, xn);
}

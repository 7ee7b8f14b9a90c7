/* gs_integration_start: the start of a run: x is moved onto the constraints, what is due happens,
 * and it is looked whether the constraints have less than their rank there.
 *
 * The state is first moved without a partition: completed from others it would be moved close to a
 * singular position. Whether it lies in one gs_starts_singular tells by the speeds, and by the
 * accelerations where these hardly move the constraints. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

static const gs_real nojump[3] = { 0, 0, 0 };

/* onto the constraints, inputs, events, samples */
static int
what_is_due (gs_course *c)
{
  const gs_system *g = &c->g;
  gs_real ts;
  int acted;
  g->p[GS_WAY] = 0;
  int info
      = gs_check_constraints (g->s, c->t, c->x, g->iopt, nojump, g->cst, g->p, g->istat, g->rstat);
  g->p[GS_WAY] = c->job;
  if (info != 0)
    return info;
  info = gs_inputs_of_run (g->s, c->t, 1, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w);
  g->istat[GS_FAILED_INFO] = info;
  g->istat[GS_FAILED] = GS_AT_INPUTS;
  if (info != 0)
    return info;
  g->istat[GS_FAILED] = GS_AT_NOTHING;
  info = gs_resolve_under_inputs (g->s, c->t, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w,
                                  g->istat, 0);
  if (info != 0)
    return info;
  return gs_samples_due (g->s, c->t, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat, &ts,
                         &acted);
}

/* a start in a singular position? by its speeds, or at rest */
static int
singular (gs_course *c)
{
  const gs_system *g = &c->g;
  gs_passage *a = &c->a;
  gs_real *siz = c->f + g->nx;
  gs_zero (g->nx, c->f);
  gs_starts_singular (g->s, c->t, c->x, c->hmax, g->cst, c->f, c->xn, c->fn, c->hc, siz, g->p,
                      &a->begin);
  if (a->begin < 0)
    {
      int info = gs_rates_at (g, c->t, 1, c->x, c->f);
      if (info != 0)
        return info;
      gs_starts_singular (g->s, c->t, c->x, c->hmax, g->cst, c->f, c->xn, c->fn, c->hc, siz, g->p,
                          &a->begin);
      a->begin = gs_most (0, a->begin);
    }
  if (a->begin == 2 || (a->begin == 1 && g->iopt[GS_METHOD] == 4))
    {
      g->istat[GS_FAILED_INFO] = a->begin;
      g->istat[GS_FAILED] = GS_AT_START;
      return a->begin;
    }

  /* dependent constraints: see gs_integrate */
  if (c->job < 2 && g->p[GS_RANK] < (gs_real)g->s->nlam)
    {
      c->job = 2;
      g->p[GS_WAY] = c->job;
    }
  return 0;
}

int
gs_integration_start (gs_course *c)
{
  const gs_system *g = &c->g;
  if (what_is_due (c) != 0)
    return GS_ROUTINE_FAILED;
  if (g->s->nlam > 0 && g->iopt[GS_WATCH] == 1 && g->iopt[GS_LOOPS] != 1 && singular (c) != 0)
    return GS_ROUTINE_FAILED;
  if (c->job > 0 && c->a.begin == 0
      && gs_partition_choose_in_run (g->s, c->t, c->x, g->cst, g->p, g->istat) != 0)
    return GS_ROUTINE_FAILED;
  return 0;
}

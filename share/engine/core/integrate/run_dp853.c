/* gs_run_dp853: from one stop to the next by the method of Dormand and Prince, or through a
 * singular position. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"

/* one trial step, or a passage; taken: 1 if it was good */
static int
trial (gs_course *c, int *taken)
{
  gs_real hlim;
  int info = gs_take_passage (c, gs_min (c->next, c->hmax), &hlim, taken);
  if (*taken == 0 && info == 0)
    {
      if (c->a.begin > 0)
        {
          c->g.istat[GS_FAILED_INFO] = 3;
          c->g.istat[GS_FAILED] = GS_AT_START;
          return GS_ROUTINE_FAILED;
        }
      return gs_dp853_trial (c, gs_min (gs_min (c->next, c->hmax), hlim), taken);
    }
  if (*taken == 1)
    {
      c->fresh = 1;
      c->after = 0;
    }
  return info;
}

int
gs_run_dp853 (gs_course *c)
{
  do
    {
      int info = gs_ask (c), taken;
      if (info == 0 && c->fresh > 0)
        {
          info = gs_dp853_before (c);
          c->fresh = 0;
        }
      if (info != 0)
        return info;
      info = trial (c, &taken);
      if (taken == 1)
        {
          gs_real *x = c->x;
          c->x = c->xn;
          c->xn = x;
        }
      if (info != 0)
        return info;
    }
  while (c->t < c->tb);
  return 0;
}

int
gs_dp853_before (gs_course *c)
{
  const gs_system *g = &c->g;
  if (c->fresh == 2)
    gs_copy (g->nx, c->f + g->nx, c->f);
  else if (gs_rates_at (g, c->t, 1, c->x, c->f) != 0)
    return GS_ROUTINE_FAILED;
  if (gs_not_finite (g->nx, c->f) != 0)
    return GS_RATE_NOT_FINITE;
  if (c->after == 1)
    {
      gs_watch_stiffness (g, c->t, c->last, c->x, c->f);
      if (g->istat[GS_IS_STIFF] > 0 && g->iopt[GS_METHOD] == 9)
        return GS_STIFF;
    }
  if (c->next <= 0
      && gs_first_step (g, c->t, gs_min (c->hmax, c->tb - c->t), c->x, c->f, &c->next) != 0)
    return GS_ROUTINE_FAILED;
  return 0;
}

/* gs_dense_outputs: the outputs within a step of gs_step_dp853, from its polynomial
 * (gs_dense_dp853), moved onto the constraints as the ends of steps are. */
#include <stddef.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"
#include "gsmbp/plan.h"

/* the polynomial of the step, that of gs_first_event where off is not below 0; z (nx): workspace */
static int
polynomial (gs_course *c, gs_real tn, int side, gs_real h, gs_real *z, gs_real *off)
{
  const gs_system *g = &c->g;
  const int nx = g->nx;
  if (*off >= 0)
    {
      gs_move (4 * nx, c->f + nx, c->f + 5 * nx);
      gs_copy (nx, gs_planned_events (g->nx, g->ip, g->rp).xdn, c->f + nx);
      return 0;
    }
  *off = 1;
  const int info = gs_dense_dp853 (g, c->t, tn, side, h, c->x, c->xn, c->f, z);
  if (info != 0)
    return info;
  *off = gs_dense_error (g, h, c->x, c->xn, c->f, z, c->f + 2 * nx);
  /* gs_first_event has seen the step; it is none but for rounding, as at a jump */
  const int seen = g->ip[GS_EVENTS] > 0,
            tiny = gs_abs (h) <= GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (c->t), gs_abs (tn));
  return *off <= 1 || seen || tiny ? 0 : 90;
}

int
gs_dense_outputs (gs_course *c, gs_real tn, int side, gs_real h, gs_real *off)
{
  const gs_system *g = &c->g;
  const gs_integration *r = c->run;
  gs_real jump[3];
  int k = c->it;
  gs_largest_move (g->s->nq, g->s->nu, c->x, c->xn, g->ropt[1], g->atol, jump);
  int info = polynomial (c, tn, side, h, r->xout + (ptrdiff_t)r->ldx * k, off);
  for (; info == 0 && k < r->nt && r->tout[k] < tn; k++)
    {
      const gs_real t = r->tout[k];
      gs_real *x = r->xout + (ptrdiff_t)r->ldx * k, *v = r->vout + (ptrdiff_t)r->ldv * k;
      gs_dense_at (g->nx, h, (t - c->t) / h, c->x, c->xn, c->f, x);
      info = gs_move_onto (g->s, t, x, g->iopt, jump, g->cst, g->p, g->istat, g->rstat);
      if (info != 0)
        return info;
      info = gs_inputs_of_run (g->s, t, 1, x, g->nx, g->ip, g->rp, g->cst, v, g->w);
      if (info != 0)
        {
          g->istat[GS_FAILED_INFO] = info;
          g->istat[GS_FAILED] = GS_AT_INPUTS;
          return info;
        }
    }
  if (info == 0)
    {
      c->it = k;
      g->istat[GS_N_OUTPUTS] = k;
    }
  return info;
}

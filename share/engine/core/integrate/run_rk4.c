/* gs_run_rk4: from one stop to the next by the classical method of Runge and Kutta, in equal steps
 * of at most ropt[0], and ropt[2] where that is above 0.
 *
 * Time is ta + k*h, ta being the last place where the length of the steps changed. gs_first_event
 * may want shorter steps: a tenth, until the event or the stop is there. */
#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

static const gs_real nojump[3] = { 0, 0, 0 };

/* gs_step_rk4 made the step e: up to the event in it, onto the constraints; event: its number, 0,
 * or -1: too long, nothing is done. info as gs_integrate */
static int
accept (gs_course *c, gs_step *e, int *event)
{
  const gs_system *g = &c->g;
  const gs_scene *s = g->s;
  *event = 0;
  if (g->ip[GS_EVENTS] > 0)
    {
      if (gs_first_event (g, e, event) != 0)
        return GS_ROUTINE_FAILED;
      if (*event < 0)
        return 0;
    }
  g->rstat[GS_T_REACHED] = e->tn;
  if (gs_not_finite (g->nx, c->xn) != 0)
    return GS_NOT_FINITE;
  c->x = e->xn;
  c->xn = e->x;
  g->istat[GS_N_STEPS]++;
  if (gs_check_constraints (s, e->tn, c->x, g->iopt, nojump, g->cst, g->p, g->istat, g->rstat) != 0)
    return GS_ROUTINE_FAILED;
  if (g->ip[GS_EVENTS] > 0 && *event == 0)
    gs_hold_after_step (s, g->iopt[GS_METHOD], e->tn, c->x, g->nx, g->ip, g->rp, g->cst, g->v,
                        g->ropt[1], g->atol);
  if (*event > 0
      && gs_resolve_under_inputs (s, e->tn, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat,
                                  *event)
             != 0)
    return GS_ROUTINE_FAILED;
  return *event > 0 && gs_ended (g->ip) ? GS_ENDED : 0;
}

void
gs_cut_way (gs_course *c, gs_equal_steps *w)
{
  gs_real *rstat = c->g.rstat;
  const gs_real most = c->g.ropt[2] > 0 ? c->g.ropt[2] : c->g.ropt[0];
  const gs_real at_most = gs_min (w->hr, most);
  const gs_real many = (c->tb - w->ta) / at_most * (1 - GS_R2 (1e-9, 1e-6));
  w->k = 1;
  w->n = gs_most (1, (int) gs_min (many, GS_R (2e9)) + 1);
  /* the first, then longer ones */
  w->h = many > GS_R (2e9) ? at_most : (c->tb - w->ta) / (gs_real)w->n;
  rstat[GS_H_LEAST] = gs_min (rstat[GS_H_LEAST], w->h);
  rstat[GS_H_LARGEST] = gs_max (rstat[GS_H_LARGEST], w->h);
}

gs_step
gs_begin_equal (gs_course *c, const gs_equal_steps *w)
{
  gs_step e = { .method = c->g.iopt[GS_METHOD], .h = w->h, .side = 1, .x = c->x, .xn = c->xn,
                .f = c->f };
  c->t = e.t = w->ta + (gs_real)(w->k - 1) * w->h;
  e.tn = w->ta + (gs_real)w->k * w->h;
  if (w->k == w->n)
    {
      e.tn = c->tb;
      e.side = c->side;
    }
  return e;
}

int
gs_end_equal (gs_course *c, gs_step *e, gs_equal_steps *w)
{
  int event;
  const int info = accept (c, e, &event);
  if (info != 0)
    return info;
  if (event < 0)
    {
      w->ta = c->t;
      w->hr = GS_R (0.1) * w->h;
      gs_cut_way (c, w);
    }
  else if (e->tn < c->tb && (event > 0 || w->hr < c->g.ropt[0]))
    {
      w->ta = e->tn;
      w->hr = c->g.ropt[0];
      gs_cut_way (c, w);
    }
  else
    w->k++;
  return 0;
}

int
gs_run_rk4 (gs_course *c)
{
  const gs_system *g = &c->g;
  gs_equal_steps w = { .ta = c->t, .hr = g->ropt[0] };
  for (gs_cut_way (c, &w); w.k <= w.n;)
    {
      gs_step e = gs_begin_equal (c, &w);
      int info = gs_ask (c);
      if (info == 0 && g->iopt[GS_MOST_STEPS] > 0 && g->istat[GS_N_STEPS] >= g->iopt[GS_MOST_STEPS])
        info = GS_TOO_MANY;
      if (info != 0)
        return info;
      gs_watch_stiffness (g, c->t, e.h, c->x, c->f);
      info = gs_step_rk4 (g, c->t, e.tn, e.side, e.h, c->x, c->xn, c->f) != 0
                 ? GS_ROUTINE_FAILED
                 : gs_end_equal (c, &e, &w);
      if (info != 0)
        return info;
    }
  c->t = c->tb;
  return 0;
}

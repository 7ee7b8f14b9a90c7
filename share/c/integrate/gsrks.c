/* GSRKS: from one stop to the next by the classical method of Runge and Kutta, in equal steps of at
 * most ropt[0], and ropt[2] where that is above 0.
 *
 * Time is ta + k*h, ta being the last place where the length of the steps changed. GSEVN may want
 * shorter steps: a tenth, until the event or the stop is there. */
#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

static const gs_real nojump[3] = { 0, 0, 0 };

/* one step from c->t to e->tn, or to the event in it; event: its number, 0, or -1: too long,
 * nothing is done. info as gssim */
static int
step (gs_course *c, gs_step *e, int *event)
{
  const gs_system *g = &c->g;
  const gs_scene *s = g->s;
  *event = 0;
  if (g->iopt[GS_MOST_STEPS] > 0 && g->istat[GS_N_STEPS] >= g->iopt[GS_MOST_STEPS])
    return GS_TOO_MANY;
  gsstd (g, c->t, e->h, c->x, c->f);
  if (gsrk4 (g, c->t, e->tn, e->side, e->h, c->x, c->xn, c->f) != 0)
    return GS_ROUTINE_FAILED;
  if (g->ip[GS_EVENTS] > 0)
    {
      if (gsevn (g, e, event) != 0)
        return GS_ROUTINE_FAILED;
      if (*event < 0)
        return 0;
    }
  g->rstat[GS_T_REACHED] = e->tn;
  if (gsfin (g->nx, c->xn) != 0)
    return GS_NOT_FINITE;
  c->x = e->xn;
  c->xn = e->x;
  g->istat[GS_N_STEPS]++;
  if (gschk (s, e->tn, c->x, g->iopt, nojump, g->cst, g->p, g->istat, g->rstat) != 0)
    return GS_ROUTINE_FAILED;
  if (g->ip[GS_EVENTS] > 0 && *event == 0)
    gsevo (s, g->iopt[GS_METHOD], e->tn, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->ropt[1],
           g->atol);
  if (*event > 0
      && gsevr (s, e->tn, c->x, g->nx, g->ip, g->rp, g->cst, g->v, g->w, g->istat, *event) != 0)
    return GS_ROUTINE_FAILED;
  return *event > 0 && gs_ended (g->ip) ? GS_ENDED : 0;
}

/* n steps of the length h from *ta on; n: how many were not taken, *ta and *hr being changed. info
 * as gssim */
static int
equal_steps (gs_course *c, gs_real *ta, gs_real *hr, gs_real h, int *n)
{
  const int all = *n;
  for (int k = 1; k <= all; k++, --*n)
    {
      gs_step e = { .method = c->g.iopt[GS_METHOD], .h = h, .side = 1, .x = c->x, .xn = c->xn,
                    .f = c->f };
      int event;
      c->t = e.t = *ta + (gs_real)(k - 1) * h;
      e.tn = *ta + (gs_real)k * h;
      if (k == all)
        {
          e.tn = c->tb;
          e.side = c->side;
        }
      int info = gs_ask (c);
      if (info == 0)
        info = step (c, &e, &event);
      if (info != 0)
        return info;
      if (event < 0)
        {
          *ta = c->t;
          *hr = GS_R (0.1) * h;
          return 0;
        }
      if (e.tn < c->tb && (event > 0 || *hr < c->g.ropt[0]))
        {
          *ta = e.tn;
          *hr = c->g.ropt[0];
          return 0;
        }
    }
  return 0;
}

int
gsrks (gs_course *c)
{
  gs_real *rstat = c->g.rstat;
  const gs_real most = c->g.ropt[2] > 0 ? c->g.ropt[2] : c->g.ropt[0];
  gs_real ta = c->t, hr = c->g.ropt[0];
  for (int n = 1; n > 0;)
    {
      const gs_real at_most = gs_min (hr, most);
      const gs_real many = (c->tb - ta) / at_most * (1 - GS_R2 (1e-9, 1e-6));
      n = gs_most (1, (int) gs_min (many, GS_R (2e9)) + 1);
      /* the first, then longer ones */
      const gs_real h = many > GS_R (2e9) ? at_most : (c->tb - ta) / (gs_real)n;
      rstat[GS_H_LEAST] = gs_min (rstat[GS_H_LEAST], h);
      rstat[GS_H_LARGEST] = gs_max (rstat[GS_H_LARGEST], h);
      int info = equal_steps (c, &ta, &hr, h, &n);
      if (info != 0)
        return info;
    }
  c->t = c->tb;
  return 0;
}

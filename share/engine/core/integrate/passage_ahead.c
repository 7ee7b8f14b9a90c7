/* gs_passage_ahead: looks for a position where the constraints lose rank, from t on until they have
 * turned by 1.2 rad, or where t lies close to one, before and behind. The path is one by rates of
 * the coordinates that are linear in time. */
#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* rates that are linear in time need two points of Gauss */
#define TWO 2

/* how far one can see: the time in which the constraints turn by 1.2 rad; sp: the least pivot at
 * t */
static gs_real
sight (const gs_system *g, gs_real t, const gs_real *x, gs_real h, gs_real *f, gs_real *xt,
       gs_real *hc, gs_real *sp)
{
  const gs_scene *s = g->s;
  gs_real far = GS_R (0.01) * h, turn = 0, other;
  for (int i = 0; i < 12; i++)
    {
      gs_passage_linear (g, t, x, t, far, TWO, f, xt);
      gs_passage_pivot (g, t, x, t, far, 0, TWO, f, xt, sp);
      gs_jacobian_turn (s->nq, s->nu, s->nlam, g->p, hc, 0, &turn);
      gs_passage_pivot (g, t, x, t, far, 1, TWO, f, xt, &other);
      gs_jacobian_turn (s->nq, s->nu, s->nlam, g->p, hc, 1, &turn);
      if (turn <= GS_R (0.3))
        break;
      far = GS_R (0.1) * far;
    }
  return GS_R (1.2) * far / gs_max (turn, GS_R (1e-10));
}

/* the eighth of the way, from 1, behind which the least pivot, s0 at t, has passed its next
 * minimum; 0: it passes none, or none that a line twice as steep as the looks beside it brings
 * near to 0 */
static int
next_minimum (const gs_system *g, gs_real t, const gs_real *x, gs_real way, gs_real s0,
              const gs_real *f, gs_real *xt)
{
  gs_real s1 = s0, s2;
  for (int k = 1; k <= 9; k++)
    {
      gs_passage_pivot (g, t, x, t, way, GS_R (0.125) * (gs_real)k, TWO, f, xt, &s2);
      if (k > 1 && s1 < s0 && s1 <= s2)
        return 3 * s1 - 2 * gs_max (s0, s2) > GS_R (0.25) * g->p[GS_LARGEST] ? 0 : k;
      s0 = s1;
      s1 = s2;
    }
  return 0;
}

void
gs_passage_ahead (const gs_system *g, gs_real t, const gs_real *x, gs_real *h, gs_real rest,
                  gs_passage *a, gs_real *f, gs_real *xt, gs_real *hc)
{
  const gs_real big = g->p[GS_LARGEST];
  gs_real s0, smin, cs, from = -GS_R (0.6), to = 1;
  a->d = 0;
  a->turn = sight (g, t, x, *h, f, xt, hc, &s0);
  *h = gs_min (*h, a->turn);
  const gs_real way = s0 >= GS_R (0.3) * big ? gs_min (a->turn, rest) : a->turn;
  if (way < GS_R (0.1) * a->turn) /* constraints that turn by 0.12 rad do not lose their rank */
    return;
  gs_passage_linear (g, t, x, t, way, TWO, f, xt);
  if (! (s0 < GS_R (0.3) * big))
    {
      int k = next_minimum (g, t, x, way, s0, f, xt);
      if (k == 0)
        return;
      from = GS_R (0.125) * (gs_real)(k - 2);
      to = GS_R (0.125) * (gs_real)k;
    }
  gs_passage_least_pivot (g, t, x, t, way, from, to, TWO, f, xt, &cs, &smin);
  if (smin > GS_R (0.2) * big)
    return;
  gs_passage_linear (g, t, x, t, a->turn, a->ns, f, xt);
  a->tc = t + cs * way;
  a->d = GS_R (0.8) * a->turn;
}

void
gs_passage_linear (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d, int ns,
                   gs_real *f, gs_real *xt)
{
  const int nx = g->nx, nq = g->s->nq;
  gs_real c[12], wt[12];
  gs_gauss_points (ns, c, wt);
  g->s->kin (t, x, f + nq, g->cst, xt);
  for (int k = 0; k < ns; k++)
    {
      gs_real *rate = f + nx * (k + 1);
      for (int i = 0; i < nx; i++)
        rate[i] = f[i];
      for (int i = 0; i < nq; i++)
        rate[i] += (tc + c[k] * d - t) * xt[i];
    }
}

/* GSAHD: looks for a position where the constraints lose rank, from t on until they have turned by
 * 1.2 rad, or where t lies close to one, before and behind. The path is one by rates of the
 * coordinates that are linear in time. */
#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* rates that are linear in time need two points of Gauss */
#define TWO 2

/* how far one can see: the time in which the constraints turn by 1.2 rad; sp: the least pivot at
 * t */
static double
sight (const gs_system *g, double t, const double *x, double h, double *f, double *xt, double *hc,
       double *sp)
{
  const gs_scene *s = g->s;
  double far = 0.01 * h, turn = 0.0, other;
  for (int i = 0; i < 12; i++)
    {
      gsprd (g, t, x, t, far, TWO, f, xt);
      gspvt (g, t, x, t, far, 0.0, TWO, f, xt, sp);
      gspch (s->nq, s->nu, s->nlam, g->p, hc, 0, &turn);
      gspvt (g, t, x, t, far, 1.0, TWO, f, xt, &other);
      gspch (s->nq, s->nu, s->nlam, g->p, hc, 1, &turn);
      if (turn <= 0.3)
        break;
      far = 0.1 * far;
    }
  return 1.2 * far / gs_max (turn, 1e-10);
}

/* the eighth of the way, from 1, behind which the least pivot, s0 at t, has passed its next
 * minimum; 0: it passes none, or none that a line twice as steep as the looks beside it brings
 * near to 0 */
static int
next_minimum (const gs_system *g, double t, const double *x, double way, double s0,
              const double *f, double *xt)
{
  double s1 = s0, s2;
  for (int k = 1; k <= 9; k++)
    {
      gspvt (g, t, x, t, way, 0.125 * k, TWO, f, xt, &s2);
      if (k > 1 && s1 < s0 && s1 <= s2)
        return 3.0 * s1 - 2.0 * gs_max (s0, s2) > 0.25 * g->p[GS_LARGEST] ? 0 : k;
      s0 = s1;
      s1 = s2;
    }
  return 0;
}

void
gsahd (const gs_system *g, double t, const double *x, double *h, double rest, gs_passage *a,
       double *f, double *xt, double *hc)
{
  const double big = g->p[GS_LARGEST];
  double s0, smin, cs, from = -0.6, to = 1.0;
  a->d = 0.0;
  a->turn = sight (g, t, x, *h, f, xt, hc, &s0);
  *h = gs_min (*h, a->turn);
  const double way = s0 >= 0.3 * big ? gs_min (a->turn, rest) : a->turn;
  if (way < 0.1 * a->turn)   /* constraints that turn by 0.12 rad do not lose their rank */
    return;
  gsprd (g, t, x, t, way, TWO, f, xt);
  if (! (s0 < 0.3 * big))
    {
      int k = next_minimum (g, t, x, way, s0, f, xt);
      if (k == 0)
        return;
      from = 0.125 * (k - 2);
      to = 0.125 * k;
    }
  gspmn (g, t, x, t, way, from, to, TWO, f, xt, &cs, &smin);
  if (smin > 0.2 * big)
    return;
  gsprd (g, t, x, t, a->turn, a->ns, f, xt);
  a->tc = t + cs * way;
  a->d = 0.8 * a->turn;
}

void
gsprd (const gs_system *g, double t, const double *x, double tc, double d, int ns, double *f,
       double *xt)
{
  const int nx = g->nx, nq = g->s->nq;
  double c[12], wt[12];
  gsgln (ns, c, wt);
  g->s->kin (t, x, f + nq, g->cst, xt);
  for (int k = 0; k < ns; k++)
    {
      double *rate = f + nx * (k + 1);
      for (int i = 0; i < nx; i++)
        rate[i] = f[i];
      for (int i = 0; i < nq; i++)
        rate[i] += (tc + c[k] * d - t) * xt[i];
    }
}

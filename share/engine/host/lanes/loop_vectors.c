/* The projection onto loops and what is remembered of it, all lanes at once. */
#include "host/lanes/lanes.h"

#include <float.h>
#include <math.h>

#include "gsmbp/arith.h"
#include "gsmbp/partition.h"

/* a[j] += the entries of n rows of lanes, the largest by modulus */
static void
largest_of (int n, gs_lane *x, double *most)
{
  for (int i = 0; i < n; i++)
    {
      const double *one = x[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        most[l] = gs_max (most[l], fabs (one[l]));
    }
}

/* Turn number turn of gs_project from what prj_w gives at xn: constraints phi, their rates and
 * Jacobian hn, the steps dq and du. live is 1 where there is something to do, slow where it has to
 * be done by itself; res becomes |phi| of the first turn, gap of the last one, left what is left of
 * the rates. 1 if another turn is wanted. */
int
gs_project_turn (gs_lane_group *g, int turn)
{
  const int n = g->nq, m = g->nlam;
  const double eps = 4 * DBL_EPSILON;
  gs_lane r = { 0 }, fq, fu;
  int again = 0;
  for (int l = 0; l < GS_LANES; l++)
    fq[l] = 0.5;
  largest_of (m, g->phi, r);
  largest_of (n, g->dq, fq);
  for (int l = 0; l < GS_LANES; l++)
    {
      fu[l] = 0;
      if (g->live[l] <= 0)
        fq[l] = 0;
      else if (g->info[l] != 0 || ! (r[l] <= 1e300))
        {
          fq[l] = 0;
          g->live[l] = 0;
          g->slow[l] = 1;
        }
      else
        {
          g->res[l] = turn == 1 ? r[l] : g->res[l];
          fq[l] = 0.5 / fq[l];
          if (r[l] <= eps || (turn > 2 && r[l] >= g->gap[l] && r[l] <= 1e-11))
            {
              fq[l] = 0;
              fu[l] = 1;
              g->live[l] = 0;
              g->left[l] = 0;
            }
          else
            again = 1;
          g->gap[l] = r[l];
        }
    }
  for (int i = 0; i < n; i++)
    {
      const double *dq = g->dq[i], *du = g->du[i];
      double *q = g->xn[i], *u = g->xn[n + i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          q[l] = fq[l] <= 0 ? q[l] : q[l] + fq[l] * dq[l];
          u[l] = fu[l] <= 0 ? u[l] : u[l] + du[l];
        }
    }
  for (int i = 0; i < m; i++)
    {
      gs_lane s;
      for (int l = 0; l < GS_LANES; l++)
        s[l] = g->rate[i][l];
      for (int j = 0; j < n; j++)
        {
          const double *hc = g->hn[i + m * j], *du = g->du[j];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            s[l] += hc[l] * du[l];
        }
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double most = gs_max (g->left[l], fabs (s[l]));
          g->left[l] = fu[l] > 0 ? most : g->left[l];
        }
    }
  return again;
}

/* gs_largest_move: slow is 1 where the way of the projection, to xn after the step from x to what
 * g->rates keeps, is a jump. */
void
gs_find_jumps (gs_lane_group *g)
{
  const int n = g->nq;
  const double root = 10 * sqrt (DBL_EPSILON), rtol = g->e->run.ropt[1];
  for (int part = 0; part < 2; part++)
    {
      gs_lane far, moved = { 0 };
      for (int l = 0; l < GS_LANES; l++)
        far[l] = part == 0 ? root : 0;
      for (int i = part * n; i < part * n + n; i++)
        {
          const double atol = g->e->run.atol[i], *x = g->x[i], *xn = g->xn[i], *xo = g->rates[i];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            {
              const double size = fabs (x[l]), tolerance = 100 * (atol + rtol * size);
              const double step = 0.1 * fabs (xo[l] - x[l]);
              far[l] = gs_max (gs_max (far[l], step), gs_max (tolerance, root * size));
              moved[l] = gs_max (moved[l], fabs (xn[l] - xo[l]));
            }
        }
      for (int l = 0; l < GS_LANES; l++)
        g->slow[l] = moved[l] <= far[l] ? g->slow[l] : 1;
    }
}

/* gs_jacobian_turn: how far the Jacobians ha and hb differ relative to the sizes of their rows, the
 * largest of the rows: turned. */
void
gs_lane_turns (gs_lane_group *g, gs_lane *ha, gs_lane *hb, gs_lane *size)
{
  const int n = g->nq, m = g->nlam;
  for (int l = 0; l < GS_LANES; l++)
    g->turned[l] = 0;
  for (int i = 0; i < m; i++)
    {
      gs_lane s = { 0 };
      for (int j = 0; j < n; j++)
        {
          const double *a = ha[i + m * j], *b = hb[i + m * j];
          GS_EACH_LANE
          for (int l = 0; l < GS_LANES; l++)
            s[l] += (a[l] - b[l]) * (a[l] - b[l]);
        }
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        g->turned[l] = gs_max (g->turned[l], sqrt (s[l]) / size[i][l]);
    }
}

/* gs_check_constraints after the projection: slow is 1 where it is not the usual case. margin: how
 * far the least pivot may fall relative to its largest value. */
void
gs_find_unusual (gs_lane_group *g)
{
  enum { THEN = GS_TIMES + 3, NOW = GS_TIMES + 5 };   /* the last pivots but one, the last ones */
  gs_lane *p = g->p;
  gs_lane big;
  for (int l = 0; l < GS_LANES; l++)
    big[l] = 1;
  largest_of (g->nq, g->xn, big);
  for (int l = 0; l < GS_LANES; l++)
    {
      const double s = g->lowest[l];
      const int bad = g->rank[l] < p[GS_RANK][l] || s < g->margin[l] * p[GS_LARGEST][l]
                      || ! (g->gap[l] <= 1e-6 * big[l])
                      || (g->turned[l] > 0.3 && p[GS_STEPS][l] >= 1);
      /* a minimum between the last steps, see gs_follow_pivot */
      const int least = p[GS_STEPS][l] >= 2 && p[NOW][l] <= p[THEN][l] && p[NOW][l] < s
                        && p[NOW][l] <= 0.5 * gs_max (p[GS_LARGEST][l], s);
      g->slow[l] = bad || least ? 1 : g->slow[l];
    }
}

/* the rows of the partition become these, where r is 1 */
static void
put_rows (gs_lane_group *g, int to, gs_lane *from, int n)
{
  for (int i = 0; i < n; i++)
    {
      const double *r = g->r, *one = from[i];
      double *p = g->p[to + i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        p[l] = (r[l] > 0.5) & (r[l] < 1.5) ? one[l] : p[l];
    }
}

/* ... those of a later one */
static void
shift (gs_lane_group *g, int to, int from, int n)
{
  put_rows (g, to, g->p + from, n);
}

/* What gs_check_constraints remembers of a step, in the lanes where r is 1. */
void
gs_remember_loops (gs_lane_group *g)
{
  const int n = g->nq;
  gs_lane *p = g->p;
  shift (g, GS_TIMES, GS_TIMES + 2, 4);
  shift (g, g->path, g->path + 2 * n, 4 * n);
  put_rows (g, g->path + 4 * n, g->xn, 2 * n);
  put_rows (g, g->sizes, g->lengths, g->nlam);
  for (int l = 0; l < GS_LANES; l++)
    {
      if (! (g->r[l] > 0.5 && g->r[l] < 1.5))
        continue;
      p[GS_STEPS][l] += 1;
      p[GS_TIMES + 4][l] = g->tn[l];
      p[GS_TIMES + 5][l] = g->lowest[l];
      p[GS_RANK][l] = gs_max (p[GS_RANK][l], g->rank[l]);
      p[GS_PIVOT][l] = g->pivot[l] = g->lowest[l];
      p[GS_LARGEST][l] = g->highest[l] = gs_max (p[GS_LARGEST][l], g->lowest[l]);
      if (g->gap[l] > g->phi_0[l])
        {
          g->phi_0[l] = g->gap[l];
          g->t_phi[l] = g->tn[l];
        }
      if (g->left[l] > g->rate_0[l])
        {
          g->rate_0[l] = g->left[l];
          g->t_rate[l] = g->tn[l];
        }
      if (g->lowest[l] < g->smallest[l])
        {
          g->smallest[l] = g->lowest[l];
          g->smallest_at[l] = g->tn[l];
        }
    }
}

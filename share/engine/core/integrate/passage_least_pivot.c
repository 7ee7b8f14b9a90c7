/* gs_passage_least_pivot: the least pivot of the constraints, and its place, on the path of
 * gs_step_passage. 0 where the rank is lower than elsewhere. */

#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* Thirteen places, then finer and finer about the lowest. */
void
gs_passage_least_pivot (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d,
                        gs_real ca, gs_real cb, int ns, const gs_real *f, gs_real *xt, gs_real *cs,
                        gs_real *smin)
{
  gs_real w = (cb - ca) / 12;
  *smin = GS_HUGE;
  *cs = GS_R (0.5) * (ca + cb);
  for (int l = 0; l < 4; l++)
    {
      const gs_real middle = *cs;
      for (int k = -6; k <= 6; k++)
        {
          gs_real s = middle + (gs_real)k * w, sp;
          if (! (s >= ca - GS_R (0.1) * w && s <= cb + GS_R (0.1) * w))
            continue;
          gs_passage_pivot (g, t, x, tc, d, s, ns, f, xt, &sp);
          if (sp < *smin)
            {
              *smin = sp;
              *cs = s;
            }
        }
      w = GS_R (0.2) * w;
    }
}

void
gs_passage_pivot (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d,
                  gs_real ct, int ns, const gs_real *f, gs_real *xt, gs_real *sp)
{
  const gs_scene *s = g->s;
  const gs_partition p = gs_partition_of (s->nq, s->nu, s->nlam, g->p);
  gs_real c[12], wt[12], b[12];
  *sp = GS_HUGE;
  gs_gauss_points (ns, c, wt);
  gs_gauss_weights (ns, c, wt, (t - tc) / d, ct, b);
  gs_passage_path (s->nq, ns, g->nx, x, d, b, f, xt);
  int info = s->con (tc + ct * d, xt, x + s->nq, g->cst, p.phi, p.phit, p.hc, s->nlam, p.gam);
  if (info != 0 && info != 2)
    return;

  /* with lengths of rows of its own: those of p are of states that the motion had */
  gs_real *size = p.phi;
  for (int i = 0; i < s->nlam; i++)
    size[i] = p.size[i];
  int rank;
  gs_constraint_pivots (s->nu, s->nlam, p.hc, size, p.y, p.piv, p.beta, p.siz, &rank, sp);
  const int usual = (int)gs_lround (g->p[GS_RANK]);
  *sp = usual > 0 && rank >= usual ? p.siz[usual - 1] / p.siz[0] : 0;
}

void
gs_passage_path (int n, int ns, int ldf, const gs_real *x, gs_real d, const gs_real *b,
                 const gs_real *f, gs_real *xt)
{
  for (int i = 0; i < n; i++)
    {
      gs_real s = 0;
      for (int k = 0; k < ns; k++)
        s += b[k] * f[i + ldf * (k + 1)];
      xt[i] = x[i] + d * s;
    }
}

/* GSPMN: the least pivot of the constraints, and its place, on the path of GSPSG. 0 where the rank
 * is lower than elsewhere. */
#include <math.h>

#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* Thirteen places, then finer and finer about the lowest. */
void
gspmn (const gs_system *g, double t, const double *x, double tc, double d, double ca, double cb,
       int ns, const double *f, double *xt, double *cs, double *smin)
{
  double w = (cb - ca) / 12.0;
  *smin = 1e300;
  *cs = 0.5 * (ca + cb);
  for (int l = 0; l < 4; l++)
    {
      const double middle = *cs;
      for (int k = -6; k <= 6; k++)
        {
          double s = middle + k * w, sp;
          if (! (s >= ca - 0.1 * w && s <= cb + 0.1 * w))
            continue;
          gspvt (g, t, x, tc, d, s, ns, f, xt, &sp);
          if (sp < *smin)
            {
              *smin = sp;
              *cs = s;
            }
        }
      w = 0.2 * w;
    }
}

void
gspvt (const gs_system *g, double t, const double *x, double tc, double d, double ct, int ns,
       const double *f, double *xt, double *sp)
{
  const gs_scene *s = g->s;
  const gs_partition p = gs_partition_of (s->nq, s->nu, s->nlam, g->p);
  double c[12], wt[12], b[12];
  *sp = 1e300;
  gsgln (ns, c, wt);
  gsglq (ns, c, wt, (t - tc) / d, ct, b);
  gspth (s->nq, ns, g->nx, x, d, b, f, xt);
  int info = s->con (tc + ct * d, xt, x + s->nq, g->cst, p.phi, p.phit, p.hc, s->nlam, p.gam);
  if (info != 0 && info != 2)
    return;

  /* with lengths of rows of its own: those of p are of states that the motion had */
  double *size = p.phi;
  for (int i = 0; i < s->nlam; i++)
    size[i] = p.size[i];
  int rank;
  gslpv (s->nu, s->nlam, p.hc, size, p.y, p.piv, p.beta, p.siz, &rank, sp);
  const int usual = (int)lround (g->p[GS_RANK]);
  *sp = usual > 0 && rank >= usual ? p.siz[usual - 1] / p.siz[0] : 0.0;
}

void
gspth (int n, int ns, int ldf, const double *x, double d, const double *b, const double *f,
       double *xt)
{
  for (int i = 0; i < n; i++)
    {
      double s = 0.0;
      for (int k = 0; k < ns; k++)
        s += b[k] * f[i + ldf * (k + 1)];
      xt[i] = x[i] + d * s;
    }
}

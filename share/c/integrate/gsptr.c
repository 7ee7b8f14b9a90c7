/* GSPTR: one trial step of GSPSG from tc - d to tc + d within a run, with the partition that holds
 * at its far end and the inputs between two breaks continued beyond these. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

int
gsptr (gs_course *c)
{
  const gs_run *r = c->run;
  gs_passage *a = &c->a;
  gs_real *p = c->g.p, *tv = a->tv;
  p[GS_WAY] = 2;
  p[GS_DEPENDENT] = -1;
  gspfe (c);
  tv[0] = gs_last_break (c);
  tv[1] = gs_min (gs_next_break (c), r->tout[r->nt - 1]);
  tv[2] = 0;
  if (gs_max (tv[0] - a->tc, a->tc - tv[1]) + a->d > tv[1] - tv[0])
    tv[2] = tv[1] - tv[0];
  int info = gspsg (&c->g, c->t, c->x, a, c->f, c->xn, c->fn);
  p[GS_WAY] = c->job;
  p[GS_DEPENDENT] = -1;
  return info;
}

/* By a path with linear rates of the coordinates. Lengths of rows stay those of states that the
 * motion had. */
void
gspfe (gs_course *c)
{
  const gs_system *g = &c->g;
  const gs_scene *s = g->s;
  const gs_passage *a = &c->a;
  gs_real *const siz = c->hc, *const size = gs_partition_of (s->nq, s->nu, s->nlam, g->p).size;
  gs_real b[12], points[12], wt[12];
  if (gs_abs (c->t - a->tc) > GS_R (0.6) * a->d)
    {
      gspnw (s, c->t, c->x, g->cst, g->p);
      return;
    }
  const gs_real tf = a->tc + gs_copysign (a->d, a->tc - c->t);
  gsprd (g, c->t, c->x, a->tc, a->d, a->ns, c->f, c->xn);
  gsgln (a->ns, points, wt);
  gsglq (a->ns, points, wt, (c->t - a->tc) / a->d, (tf - a->tc) / a->d, b);
  gspth (g->nx, a->ns, g->nx, c->x, a->d, b, c->f, c->xn);
  for (int i = 0; i < s->nlam; i++)
    siz[i] = size[i];
  gspnw (s, tf, c->xn, g->cst, g->p);
  for (int i = 0; i < s->nlam; i++)
    size[i] = siz[i];
}

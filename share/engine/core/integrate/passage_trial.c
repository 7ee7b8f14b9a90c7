/* gs_passage_trial: one trial step of gs_step_passage from tc - d to tc + d within a run, with the
 * partition that holds at its far end and the inputs between two breaks continued beyond these. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

int
gs_passage_trial (gs_course *c)
{
  const gs_integration *r = c->run;
  gs_passage *a = &c->a;
  gs_real *p = c->g.p, *tv = a->tv;
  p[GS_WAY] = 2;
  p[GS_DEPENDENT] = -1;
  gs_passage_far_end (c);
  tv[0] = gs_last_break (c);
  tv[1] = gs_min (gs_next_break (c), r->tout[r->nt - 1]);
  tv[2] = 0;
  if (gs_max (tv[0] - a->tc, a->tc - tv[1]) + a->d > tv[1] - tv[0])
    tv[2] = tv[1] - tv[0];
  int info = gs_step_passage (&c->g, c->t, c->x, a, c->f, c->xn, c->fn);
  p[GS_WAY] = c->job;
  p[GS_DEPENDENT] = -1;
  return info;
}

/* By a path with linear rates of the coordinates. Lengths of rows stay those of states that the
 * motion had. */
void
gs_passage_far_end (gs_course *c)
{
  const gs_system *g = &c->g;
  const gs_scene *s = g->s;
  const gs_passage *a = &c->a;
  gs_real *const siz = c->hc, *const size = gs_partition_of (s->nq, s->nu, s->nlam, g->p).size;
  gs_real b[12], points[12], wt[12];
  if (gs_abs (c->t - a->tc) > GS_R (0.6) * a->d)
    {
      gs_partition_choose (s, c->t, c->x, g->cst, g->p);
      return;
    }
  const gs_real tf = a->tc + gs_copysign (a->d, a->tc - c->t);
  gs_passage_linear (g, c->t, c->x, a->tc, a->d, a->ns, c->f, c->xn);
  gs_gauss_points (a->ns, points, wt);
  gs_gauss_weights (a->ns, points, wt, (c->t - a->tc) / a->d, (tf - a->tc) / a->d, b);
  gs_passage_path (g->nx, a->ns, g->nx, c->x, a->d, b, c->f, c->xn);
  for (int i = 0; i < s->nlam; i++)
    siz[i] = size[i];
  gs_partition_choose (s, tf, c->xn, g->cst, g->p);
  for (int i = 0; i < s->nlam; i++)
    size[i] = siz[i];
}

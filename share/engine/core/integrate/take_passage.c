/* gs_take_passage: the passage of a position where the constraints lose rank, if one is ahead: by
 * one step of gs_step_passage to its end, or to the next break, sample or end of the run.
 *
 * Where the position does not settle, the iteration does not converge or the error is too large,
 * with more stages, then shorter, from where that length begins (see gs_integrate). */

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"

/* no passage is tried before the end of this one */
static int
give_up (gs_passage *a)
{
  a->not_before = a->tc + a->d;
  a->share = 1;
  return 0;
}

/* is a step with the error err good, or as good as it can be? */
static int
good_enough (const gs_passage *a)
{
  return a->err <= 1 || a->err <= 3 * a->eit || (a->share < GS_R (0.15) && a->err <= GS_R (1e4));
}

/* tries until it is good */
static int
passage (gs_course *c, gs_real *hlim, int *taken)
{
  gs_passage *a = &c->a;
  const gs_real dfull = a->share * a->d;
  gs_real moved = GS_HUGE;
  a->d = dfull;
  if (c->t < a->tc - GS_R (0.5) * a->d)
    a->d = gs_min (a->d, a->tc - c->t);
  for (int tries = 0; ! (c->t > a->tc + GS_R (0.5) * a->d) && tries <= 12; tries++)
    {
      if (c->t < a->tc - GS_R (1.05) * a->d)
        {
          *hlim = gs_min (*hlim, a->tc - a->d - c->t);
          return 0;
        }
      a->d = gs_max (a->d, a->tc - c->t);
      const int failed = gs_passage_trial (c);
      if (failed == 1 && gs_abs (a->tmin - a->tc) < GS_R (0.7) * moved)
        {
          moved = gs_abs (a->tmin - a->tc);
          a->tc = a->tmin;
          if (c->t < a->tc - a->d && c->t > a->tc - GS_R (1.4) * a->d)
            a->d = a->tc - c->t;
          continue;
        }
      moved = GS_HUGE;

      /* where the rank is kept after all the usual steps do better */
      if (failed == 0 && a->smin > GS_R (1e-3) * c->g.p[GS_LARGEST])
        return give_up (a);
      gs_real fac = GS_R (0.5);
      if (failed == 0)
        fac = GS_R (0.9)
              * gs_pow (gs_max (a->err, GS_R (1e-8)), -1 / (gs_real)(a->ns + 1));
      if (failed == 0 && good_enough (a))
        {
          int again;
          a->share = gs_min (1, a->share * gs_min (GS_R (1.5), gs_max (1, fac)));
          const int info = gs_passage_end (c, taken, &again);
          if (again == 1)
            continue;
          return info;
        }
      if (a->share < GS_R (0.02))
        return give_up (a);
      if (a->ns == 8 && fac < GS_R (0.8))
        {
          a->ns = 12;
          continue;
        }
      fac = gs_max (GS_R (0.25), fac);
      a->share = fac * a->share * gs_min (1, a->d / dfull);
      a->d = fac * a->d;
    }
  return 0;
}

int
gs_take_passage (gs_course *c, gs_real h, gs_real *hlim, int *taken)
{
  const gs_system *g = &c->g;
  gs_passage *a = &c->a;
  *taken = 0;
  *hlim = GS_HUGE;
  a->d = 0;
  if (g->s->nlam > 0 && g->iopt[GS_WATCH] == 1 && g->iopt[GS_LOOPS] != 1 && c->t >= a->not_before)
    gs_passage_watch (c, h, hlim);
  if (! (a->d > 0) || ! (c->t <= a->tc + GS_R (0.5) * a->d))
    return 0;
  return passage (c, hlim, taken);
}

/* Where the step h is so long, or the least pivot so small or falling so fast, that one may be
 * near. */
void
gs_passage_watch (gs_course *c, gs_real h, gs_real *hlim)
{
  const gs_system *g = &c->g;
  gs_passage *a = &c->a;
  const gs_real *p = g->p, *then = p + GS_TIMES + 2, *now = p + GS_TIMES + 4; /* time, pivot */
  const int near = p[GS_STEPS] < 3 || h > GS_R (0.25) * a->turn
                   || p[GS_PIVOT] < GS_R (0.25) * p[GS_LARGEST];
  const int falls = now[1] < then[1]
                    && now[1] * (now[0] - then[0])
                         < gs_max (3 * h, a->turn) * (then[1] - now[1]);
  a->d = 0;
  if (! near && ! falls)
    return;
  *hlim = h;
  const gs_real rest = 2 * (c->run->tout[c->run->nt - 1] - c->t);
  gs_passage_ahead (g, c->t, c->x, hlim, rest, a, c->f, c->xn, c->hc);
}

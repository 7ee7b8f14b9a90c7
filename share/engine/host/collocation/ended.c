/* ended.c: why a search ended, in words: of the solver, of singular arcs, an equation that does not
 * hold. */
#include <math.h>

#include "host/collocation/collocation_parts.h"
#include "host/text.h"

static void
name_equation (const gs_solution *s, int k, gs_writer *t)
{
  const gs_program *c = s->c;
  const gs_description *d = c->d;
  const int stages = c->points - c->first, rest = k - (c->nr + c->p->nbounded) * stages;
  if (rest >= 0)
    gs_put (t, "state %s", d->states[rest % c->s->nx]);
  else if (k >= c->nr * stages)
    gs_put (t, "output %s",
            c->p->outputs[c->p->bounded[(k - c->nr * stages) % c->p->nbounded]]);
  else if (k % c->nr < c->s->nu)
    gs_put (t, "the equation of motion of %s", d->states[c->s->nq + k % c->nr]);
  else
    gs_put (t, "loop %s", d->constraints ? d->constraints[k % c->nr - c->s->nu] : "");
}

/* the equation that holds least */
static void
put_worst (const gs_solution *s, gs_writer *t)
{
  double most = 1e-6;
  int worst = -1;
  for (int k = 0; k < s->c->m; k++)
    {
      const double miss = fmax (s->glow[k] - s->r.g[k], s->r.g[k] - s->ghigh[k]);
      if (miss > most)
        {
          most = miss;
          worst = k;
        }
    }
  if (worst < 0)
    return;
  gs_put (t, "; the equations miss by %.2g at most (", most);
  name_equation (s, worst, t);
  gs_put (t, ")");
}

void
gs_say_end (const gs_search *w, const gs_solution *s, gs_motion *r)
{
  gs_writer t = { r->ended, sizeof r->ended, 0 };
  if (r->stopped && s->stopped)
    gs_put (&t, "%s on the first mesh", s->r.ended);
  else if (r->stopped)
    gs_put (&t, "%s; solved on %d intervals, with an error of %.2g", s->r.ended, s->mesh.n,
            s->error);
  else if (s->r.solved && ! r->solved)
    gs_put (&t,
            "stopped at the limit of %d refinements: the estimated error of the states is %.2g",
            w->o->refinements, s->error);
  else
    gs_put (&t, "%s", s->r.ended);
  for (int k = 0; k < r->narcs; k++)
    gs_put (&t, "; %s is singular from %.4g to %.4g s%s", w->p->inputs[r->arcs[k].input],
            r->arcs[k].from, r->arcs[k].until, r->arcs[k].weight > 0 ? " (made smooth there)" : "");
  if (! s->r.solved && ! r->stopped)
    {
      put_worst (s, &t);
      gs_put (&t, "%s", w->told);
    }
}

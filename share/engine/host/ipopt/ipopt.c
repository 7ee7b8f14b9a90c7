/* ipopt.c: a non-linear program solved by Ipopt, by its interface in C (Debian:
 * coinor-libipopt-dev). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "header_ipopt.h"
#include "host/collocation/nlp.h"

typedef struct
{
  const gs_nlp *p;
  const gs_nlp_options *o;
  gs_nlp_result *r;
  double *last, begin; /* last: iterate */
  double points;
  int stopped;
} task;

/* ------------------------------------------------------------------------- what Ipopt calls */

static Bool
ask (task *t, int part, const double *x, int count, double *out, double factor,
     const double *lambda)
{
  if (! t->r->interrupted && t->o->ask)
    t->r->interrupted = t->o->ask (t->o->asked) != 0;
  if (t->r->interrupted || ! t->p->evaluate (t->p->data, part, x, factor, lambda, out))
    return FALSE;
  for (int k = 0; k < count; k++)
    if (! (fabs (out[k]) <= 1e300))
      return FALSE;
  return TRUE;
}

static Bool
value (Index n, Number *x, Bool fresh, Number *out, UserDataPtr data)
{
  task *t = data;
  (void)n;
  t->points += fresh ? 1 : 0;
  return ask (t, GS_GOAL, x, 1, out, 1, NULL);
}

static Bool
gradient (Index n, Number *x, Bool fresh, Number *out, UserDataPtr data)
{
  (void)fresh;
  return ask (data, GS_GRADIENT, x, n, out, 1, NULL);
}

static Bool
constraints (Index n, Number *x, Bool fresh, Index m, Number *out, UserDataPtr data)
{
  task *t = data;
  (void)n;
  t->points += fresh ? 1 : 0;
  return ask (t, GS_EQUATIONS, x, m, out, 1, NULL);
}

static Bool
jacobian (Index n, Number *x, Bool fresh, Index m, Index count, Index *rows, Index *columns,
          Number *out, UserDataPtr data)
{
  task *t = data;
  (void)fresh;
  (void)m;
  if (out)
    {
      memcpy (t->last, x, (size_t)n * sizeof *x);
      return ask (t, GS_JACOBIAN, x, count, out, 1, NULL);
    }
  for (int k = 0; k < count; k++)
    {
      rows[k] = t->p->jac_rows[k];
      columns[k] = t->p->jac_columns[k];
    }
  return TRUE;
}

static Bool
hessian (Index n, Number *x, Bool fresh, Number factor, Index m, Number *lambda, Bool fresh_lambda,
         Index count, Index *rows, Index *columns, Number *out, UserDataPtr data)
{
  task *t = data;
  (void)n;
  (void)m;
  (void)fresh;
  (void)fresh_lambda;
  if (out)
    return ask (t, GS_HESSIAN, x, count, out, factor, lambda);
  for (int k = 0; k < count; k++)
    {
      rows[k] = t->p->hess_rows[k];
      columns[k] = t->p->hess_columns[k];
    }
  return TRUE;
}

static Bool
after_each (Index mode, Index iteration, Number goal, Number primal, Number dual, Number mu,
            Number step, Number size, Number alpha_dual, Number alpha_primal, Index trials,
            UserDataPtr data)
{
  task *t = data;
  (void)mode, (void)goal, (void)primal, (void)dual, (void)mu, (void)step;
  (void)size, (void)alpha_dual, (void)alpha_primal, (void)trials;
  t->r->iterations = iteration;
  if (! t->r->interrupted && t->o->ask)
    t->r->interrupted = t->o->ask (t->o->asked) != 0;
  if (t->points > t->o->evaluations || gs_wall_clock () - t->begin > t->o->seconds)
    t->stopped = 1;
  return ! t->stopped && ! t->r->interrupted;
}

/* ------------------------------------------------------------------------- options, the end */

static Bool
take_word (IpoptProblem nlp, const gs_nlp_word *word, gs_nlp_result *r)
{
  char name[100], text[100];
  snprintf (name, sizeof name, "%s", word->name);
  snprintf (text, sizeof text, "%s", word->text ? word->text : "");
  const Bool good = word->text ? AddIpoptStrOption (nlp, name, text)
                    : word->whole ? AddIpoptIntOption (nlp, name, (int)word->number)
                                  : AddIpoptNumOption (nlp, name, word->number);
  if (! good)
    snprintf (r->ended, sizeof r->ended, "Ipopt: option %s cannot be so", name);
  return good;
}

static Bool
take_words (IpoptProblem nlp, const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r)
{
  const gs_nlp_word words[]
      = { { "print_level", NULL, 0, 1 }, { "sb", "yes", 0, 0 }, { "tol", NULL, o->tolerance, 0 },
          { "max_iter", NULL, o->iterations, 1 }, { "acceptable_tol", NULL, 1e-7, 0 },
          { "acceptable_iter", NULL, 8, 1 }, { "bound_relax_factor", NULL, 1e-10, 0 },
          { "hessian_approximation", p->hessian < 0 ? "limited-memory" : "exact", 0, 0 } };
  Bool good = TRUE;
  for (size_t k = 0; good && k < sizeof words / sizeof *words; k++)
    good = take_word (nlp, words + k, r);
  for (int k = 0; good && k < o->nwords; k++)
    good = take_word (nlp, o->words + k, r);
  return good;
}

static void
say_end (const gs_nlp_options *o, gs_nlp_result *r)
{
  static const struct
  {
    int status;
    const char *text;
  } table[] = { { 0, "solved" },
                { 1, "solved to an acceptable level" },
                { 6, "a feasible point was found" },
                { 2, "no point that fulfils the constraints was found" },
                { 3, "the steps became too small" },
                { 4, "the iterates diverge" },
                { -2, "the search for a feasible point failed" },
                { -3, "no step could be computed" },
                { -10, "more equations than unknowns" },
                { -13, "a value was no finite number" } };
  snprintf (r->ended, sizeof r->ended, "Ipopt ended with %d", r->status);
  for (size_t k = 0; k < sizeof table / sizeof *table; k++)
    if (table[k].status == r->status)
      snprintf (r->ended, sizeof r->ended, "%s", table[k].text);
  if (r->status == 5)
    gs_nlp_say_limit (o, r);
  if (r->status == -1)
    snprintf (r->ended, sizeof r->ended, "stopped at the limit of %d iterations", o->iterations);
}

/* the last iterate, without multipliers */
static void
take_last (const task *t)
{
  const gs_nlp *p = t->p;
  gs_nlp_result *r = t->r;
  memcpy (r->x, t->last, (size_t)p->n * sizeof *r->x);
  for (int k = 0; k < p->n; k++)
    r->zl[k] = r->zu[k] = NAN;
  for (int k = 0; k < p->m; k++)
    r->g[k] = r->lambda[k] = NAN;
  r->goal = NAN;
  p->evaluate (p->data, GS_GOAL, r->x, 1, NULL, &r->goal);
  p->evaluate (p->data, GS_EQUATIONS, r->x, 1, NULL, r->g);
  r->status = 5;
}

/* ------------------------------------------------------------------------- the way through */

static void
solve (IpoptProblem nlp, task *t)
{
  gs_nlp_result *r = t->r;
  memcpy (r->x, t->p->x0, (size_t)t->p->n * sizeof *r->x);
  memcpy (t->last, t->p->x0, (size_t)t->p->n * sizeof *r->x);
  SetIntermediateCallback (nlp, after_each);
  r->status = IpoptSolve (nlp, r->x, r->g, &r->goal, r->lambda, r->zl, r->zu, t);
  if (r->interrupted)
    take_last (t);
  r->solved = ! r->interrupted && (r->status == 0 || r->status == 1 || r->status == 6);
  r->limit = r->interrupted || r->status == 5 || r->status == -1 || r->status == -4;
  r->infeasible = r->status == 2;
  say_end (t->o, r);
}

int
gs_ipopt (const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r)
{
  task t = { p, o, r, malloc (((size_t)p->n + 1) * sizeof (double)), gs_wall_clock (), 0, 0 };
  double *bounds = malloc (2 * ((size_t)p->n + (size_t)p->m + 1) * sizeof (double));
  int bad = 1;
  IpoptProblem nlp = NULL;
  if (t.last && bounds)
    {
      double *high = bounds + p->n, *glow = high + p->n, *ghigh = glow + p->m;
      memcpy (bounds, p->low, (size_t)p->n * sizeof *bounds);
      memcpy (high, p->high, (size_t)p->n * sizeof *bounds);
      memcpy (glow, p->glow, (size_t)p->m * sizeof *bounds);
      memcpy (ghigh, p->ghigh, (size_t)p->m * sizeof *bounds);
      nlp = CreateIpoptProblem (p->n, bounds, high, p->m, glow, ghigh, p->jacobian,
                                p->hessian < 0 ? 0 : p->hessian, 0, value, constraints, gradient,
                                jacobian, hessian);
      bad = nlp ? 0 : 2;
      snprintf (r->ended, sizeof r->ended, "Ipopt: the problem could not be set up");
    }
  if (nlp && ! take_words (nlp, p, o, r))
    bad = 2;
  if (! bad)
    solve (nlp, &t);
  if (nlp)
    FreeIpoptProblem (nlp);
  free (bounds);
  free (t.last);
  return bad;
}

/* nlopt.c: a non-linear program of few unknowns, whose Jacobian has all entries, by columns, solved
 * by NLopt (Debian: libnlopt-dev). Word algorithm: "slsqp", "mma" or "cobyla". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "header_nlopt.h"
#include "host/collocation/nlp.h"

/* least, near: the best goal and the least violation so far; idle: evaluations without a better
 * one */
typedef struct
{
  const gs_nlp *p;
  const gs_nlp_options *o;
  gs_nlp_result *r;
  nlopt_opt opt;
  int *place, *side; /* of each inequality, then of each equation: its number, 1: from above */
  int inequalities, equations;
  double *g, *jacobian, least, near;
  int idle;
} task;

/* ------------------------------------------------------------------------- what NLopt calls */

/* 0: there is no value */
static int
ask (task *t, int part, const double *x, double *out)
{
  if (! t->r->interrupted && t->o->ask)
    t->r->interrupted = t->o->ask (t->o->asked) != 0;
  const int there = ! t->r->interrupted && t->p->evaluate (t->p->data, part, x, 1, NULL, out);
  if (! t->r->interrupted && ! there && t->o->ask)
    t->r->interrupted = t->o->ask (t->o->asked) != 0;
  if (t->r->interrupted)
    nlopt_force_stop (t->opt);
  return there;
}

/* SLSQP goes on for ever where the equations contradict each other: 30 evaluations that brought
 * neither a better goal nor a point nearer to what is demanded are the end. */
static void
count_idle (task *t, double goal, const double *x)
{
  double off = 0;
  if (! ask (t, GS_EQUATIONS, x, t->g))
    return;
  for (int i = 0; i < t->p->m; i++)
    off = fmax (off, fmax (t->p->glow[i] - t->g[i], t->g[i] - t->p->ghigh[i]));
  t->idle++;
  if (off < t->near - 1e-6 * fabs (t->near) || (off <= 1e-8 && goal < t->least)
      || ! (t->near < INFINITY))
    t->idle = 0;
  t->near = fmin (t->near, off);
  if (off <= 1e-8)
    t->least = fmin (t->least, goal);
  if (t->idle > 30)
    nlopt_force_stop (t->opt);
}

static double
goal (unsigned n, const double *x, double *gradient, void *data)
{
  task *t = data;
  double value = HUGE_VAL;
  if (! ask (t, GS_GOAL, x, &value) || (gradient && ! ask (t, GS_GRADIENT, x, gradient)))
    {
      if (gradient)
        memset (gradient, 0, n * sizeof *gradient);
      return HUGE_VAL;
    }
  count_idle (t, value, x);
  return value;
}

/* some of the constraints, from FIRST on, as numbers <= 0 or = 0 */
static void
constraints (task *t, int first, unsigned m, double *out, unsigned n, const double *x,
             double *gradient)
{
  const gs_nlp *p = t->p;
  const int there = ask (t, GS_EQUATIONS, x, t->g)
                    && (! gradient || ask (t, GS_JACOBIAN, x, t->jacobian));
  for (unsigned k = 0; k < m; k++)
    {
      const int i = t->place[first + (int)k], up = t->side[first + (int)k];
      out[k] = ! there ? HUGE_VAL : up ? t->g[i] - p->ghigh[i] : p->glow[i] - t->g[i];
      for (unsigned j = 0; gradient && j < n; j++)
        gradient[k * n + j] = ! there ? 0 : (up ? 1 : -1) * t->jacobian[i + p->m * (int)j];
    }
}

static void
inequalities (unsigned m, double *out, unsigned n, const double *x, double *gradient, void *data)
{
  constraints (data, 0, m, out, n, x, gradient);
}

static void
equations (unsigned m, double *out, unsigned n, const double *x, double *gradient, void *data)
{
  task *t = data;
  constraints (t, t->inequalities, m, out, n, x, gradient);
}

/* ------------------------------------------------------------------------- the way through */

/* upper bounds, lower bounds, equations */
static void
sort_constraints (task *t)
{
  const gs_nlp *p = t->p;
  int at = 0;
  for (int pass = 0; pass < 3; pass++)
    {
      for (int i = 0; i < p->m; i++)
        {
          const int equal = p->glow[i] == p->ghigh[i];
          const int bounded = pass == 1 ? p->glow[i] > -1e19 : p->ghigh[i] < 1e19;
          if (equal != (pass == 2) || ! (equal || bounded))
            continue;
          t->place[at] = i;
          t->side[at++] = pass != 1;
        }
      if (pass == 1)
        t->inequalities = at;
    }
  t->equations = at - t->inequalities;
}

static nlopt_algorithm
algorithm (const gs_nlp_options *o)
{
  const char *word = o->nwords ? o->words[0].text : "";
  return ! strcmp (word, "mma")      ? NLOPT_LD_MMA
         : ! strcmp (word, "cobyla") ? NLOPT_LN_COBYLA
                                     : NLOPT_LD_SLSQP;
}

static void
say_end (const gs_nlp_options *o, gs_nlp_result *r)
{
  static const struct
  {
    int status;
    const char *text;
  } table[] = { { NLOPT_SUCCESS, "solved" },
                { NLOPT_FTOL_REACHED, "the goal changes no more" },
                { NLOPT_XTOL_REACHED, "the variables change no more" },
                { NLOPT_FORCED_STOP, "no progress in 30 evaluations" },
                { NLOPT_ROUNDOFF_LIMITED, "rounding hides further progress" },
                { NLOPT_FAILURE, "the solver failed" } };
  snprintf (r->ended, sizeof r->ended, "NLopt ended with %d", r->status);
  for (size_t k = 0; k < sizeof table / sizeof *table; k++)
    if (table[k].status == r->status)
      snprintf (r->ended, sizeof r->ended, "%s", table[k].text);
  if (r->status == NLOPT_MAXEVAL_REACHED)
    snprintf (r->ended, sizeof r->ended, "stopped at the limit of %g evaluations",
              o->evaluations);
  if (r->status == NLOPT_MAXTIME_REACHED)
    snprintf (r->ended, sizeof r->ended, "stopped at the limit of %g s", o->seconds);
}

/* those of the unknowns; large ones are none */
static void
set_bounds (task *t)
{
  const gs_nlp *p = t->p;
  for (int j = 0; j < p->n; j++)
    {
      nlopt_set_lower_bound (t->opt, j, p->low[j] > -1e19 ? p->low[j] : -HUGE_VAL);
      nlopt_set_upper_bound (t->opt, j, p->high[j] < 1e19 ? p->high[j] : HUGE_VAL);
    }
}

static void
solve (task *t)
{
  const gs_nlp *p = t->p;
  gs_nlp_result *r = t->r;
  double *tolerances = t->jacobian; /* until it is needed */
  for (int i = 0; i < t->inequalities + t->equations; i++)
    tolerances[i] = 1e-10;
  set_bounds (t);
  nlopt_set_ftol_rel (t->opt, 1e-15);
  nlopt_set_xtol_rel (t->opt, t->o->tolerance);
  nlopt_set_maxeval (t->opt, (int)fmin (t->o->evaluations, 2e9));
  nlopt_set_maxtime (t->opt, t->o->seconds);
  nlopt_set_min_objective (t->opt, goal, t);
  if (t->inequalities)
    nlopt_add_inequality_mconstraint (t->opt, (unsigned)t->inequalities, inequalities, t,
                                      tolerances);
  if (t->equations)
    nlopt_add_equality_mconstraint (t->opt, (unsigned)t->equations, equations, t, tolerances);
  memcpy (r->x, p->x0, (size_t)p->n * sizeof *r->x);
  r->status = nlopt_optimize (t->opt, r->x, &r->goal);
  r->iterations = -1;
  r->solved = r->status == NLOPT_SUCCESS || r->status == NLOPT_FTOL_REACHED
              || r->status == NLOPT_XTOL_REACHED;
  r->limit = r->interrupted || r->status == NLOPT_MAXEVAL_REACHED
             || r->status == NLOPT_MAXTIME_REACHED;
  say_end (t->o, r);
}

int
gs_nlopt (const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r)
{
  const size_t n = (size_t)p->n, m = (size_t)p->m;
  task t = { .p = p, .o = o, .r = r, .least = INFINITY, .near = INFINITY };
  t.place = malloc (4 * (m + 1) * sizeof *t.place);
  t.g = malloc ((m * (n + 2) + 2 * m + 1) * sizeof *t.g);
  t.opt = nlopt_create (algorithm (o), (unsigned)p->n);
  const int bad = ! t.place || ! t.g || ! t.opt;
  if (! bad)
    {
      t.side = t.place + 2 * m + 1;
      t.jacobian = t.g + m;
      sort_constraints (&t);
      solve (&t);
    }
  nlopt_destroy (t.opt);
  free (t.g);
  free (t.place);
  return bad;
}

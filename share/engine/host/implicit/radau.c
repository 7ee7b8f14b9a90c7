/* Collocation of Radau, IIA, of the orders 5, 9 and 13 with the emitted Jacobian, as a method of
   implicit.c: for stiff scenes and small errors.

   The stages of a step, Z(I) = X(I) - X, solve F - INVERSE*Z/H = 0 by a simplified Newton method,
   one real and some complex systems of NX equations a turn (radau_rule.h, radau_solve.h).  Error,
   step and order are chosen as Hairer and Wanner do (Stiff differential equations solved by Radau
   methods, J. Comput. Appl. Math. 111, 1999).  Output times may lie within a step, where the
   polynomial through its stages gives the state. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "implicit_run.h"
#include "gsmbp/inputs.h"
#include "radau_index2.h"
#include "radau_rule.h"

enum { AGAIN = 1, FATAL = -1 };                     /* flags */
enum { GOOD, SLOW, NO_STATE };                      /* of an attempt; -1: it is over */

typedef struct
{
  int n, own, stages, newton_limit;                 /* states, and those without columns */
  const radau_rule *rule;
  double *scale, enough;                            /* of errors; of the turns beside them */
  radau_order order;                                /* of elimination */
  gs_loops *loops;                                  /* null: there are none */
  gs_index2 *index2;                                /* null: they are not in index 2 */
  double *J, *ordered, *ordered_x, *lu, *z, *g, *dz, *f0, *error, *x1, *past, *v;
  double complex *lus, *y, *ordered_y;
  int *pivots;
  double factored;                                  /* the step of the factors, 0: there are none */
  double shift;                                     /* the real ones are those of SHIFT*I - J */
  double theta, contraction;                        /* of the last turns of Newton's method */
  int of_time, turns, past_stages;
  int settles;                                      /* are the constraints known where J is of? */
  int fresh, stale;                                 /* Jacobian: of this state; to be taken anew */
  int first, after_rejection, quiet;                /* QUIET: steps without a change of order */
  int wait;                                         /* ... after the next fall behind a rise */
  int risen;                                        /* steps since the order rose */
  double past_h, wish, old_h, old_error;
  int tests, jacobians, newton, diverged, projections;   /* rejected steps by cause, work */
} radau;

/* ------------------------------------------------------------
 * tolerances and order */

static void
take_order (gs_stepper *s, int stages)
{
  radau *w = s->memory;
  w->stages = stages;
  w->rule = gsmbp_radau_rule (stages);
  w->enough = fmax (10 * DBL_EPSILON / s->r->ropt[1], 0.02);
  w->newton_limit = 7 + 5 * (stages - 3) / 2;
  w->factored = 0;
}

/* what an error is measured by, at the state of the run */
static void
take_scale (gs_stepper *s)
{
  radau *w = s->memory;
  for (int i = 0; i < w->n; i++)
    w->scale[i] = 1 / (s->r->atol[i] + s->r->ropt[1] * fabs (s->x[i]));
}

static double
norm (const radau *w, int columns, const double *d)
{
  double sum = 0;
  for (int k = 0; k < columns; k++)
    for (int i = 0; i < w->n; i++)
      sum += pow (d[i + w->n * k] * w->scale[i], 2);
  return sqrt (sum / (w->n * columns));
}

/* ------------------------------------------------------------
 * one step */

static int
no_index2 (gs_stepper *s)
{
  snprintf (s->o->text, s->o->length, "loops in index 2 need M of the tree positive definite");
  return FATAL;
}

static int
take_jacobian (gs_stepper *s)
{
  radau *w = s->memory;
  w->jacobians++;
  w->fresh = 1;
  w->stale = 0;
  w->factored = 0;
  int info = gs_jacobian (s, s->t, s->x, w->J);
  if (info == 0 && w->loops)
    w->settles = gs_take_loops (s, w->loops) == 0;
  if (info == 0 && w->index2)
    {
      if (! w->settles)
        return no_index2 (s);
      gs_index2_jacobian (s, w->index2, w->J);
    }
  if (info == 0)
    gsmbp_take_order (&w->order, w->J, w->ordered);
  return info;
}

/* LU of one system: the real one (0) or a pair; 1: singular */
static int
factors (radau *w, double h, int k)
{
  const ptrdiff_t n = w->own;
  return k == 0 ? gsmbp_real_factors (&w->order, w->rule->root / h, w->ordered, w->lu, w->pivots)
                : gsmbp_complex_factors (&w->order, w->rule->roots[k - 1] / h, w->ordered,
                                         w->lus + n * n * (k - 1), w->pivots + n * k);
}

/* the factors for the step H; 1: singular */
static int
factorize (radau *w, double h)
{
  int info = 0;
  if (fabs (h - w->factored) <= 1e-9 * h)
    return 0;
  w->factored = h;
  w->shift = w->rule->root / h;
  for (int k = 0; info == 0 && k <= w->rule->pairs; k++)
    info = factors (w, h, k);
  if (info == SMALL_PIVOT)   /* once in a run: all in one dense matrix */
    {
      gsmbp_take_order (&w->order, w->J, w->ordered);
      info = 0;
      for (int k = 0; info == 0 && k <= w->rule->pairs; k++)
        info = factors (w, h, k);
    }
  return info;
}

/* the own states */
static void
solve_own (const void *of, double *x)
{
  const radau *w = of;
  gsmbp_real_solve (&w->order, w->lu, w->pivots, x, w->ordered_x);
}

/* the states, then every column of derivatives */
static void
solve_real (const radau *w, double *x)
{
  for (int i = 0; i < w->n; i += w->own)
    solve_own (w, x + i);
  if (w->index2)
    gs_speeds (w->loops, x);
}

static void
solve_pair (const radau *w, int k, double complex *x)
{
  const ptrdiff_t n = w->own;
  for (int i = 0; i < w->n; i += w->own)
    gsmbp_complex_solve (&w->order, w->lus + n * n * k, w->pivots + n * (k + 1), x + i,
                         w->ordered_y);
  if (w->index2)
    gs_index2_speeds (w->index2, x);
}

/* X += what the polynomial of the last step is at AT, in its lengths, above its end, at AT = 1 */
static void
add_past (const radau *w, double at, double *x)
{
  int n = w->n, m = w->past_stages;
  const double *c = gsmbp_radau_rule (m)->c;
  for (int j = 1; j <= m; j++)
    {
      double weight = 1;
      for (int k = 0; k <= m; k++)
        if (k != j)
          weight *= (at - c[k]) / (c[j] - c[k]);
      weight -= j == m;
      for (int l = 0; l < n; l++)
        x[l] += weight * w->past[l + n * (j - 1)];
    }
}

/* The stages as the polynomial of the step before goes on, or zero. */
static void
predict (radau *w, double h)
{
  gs_zero (w->n * w->stages, w->z);
  for (int i = 0; w->past_stages > 0 && i < w->stages; i++)
    add_past (w, 1 + w->rule->c[i + 1] * h / w->past_h, w->z + w->n * i);
}

/* the inputs at the stages, where they follow the time alone: once for all turns */
static int
stage_inputs (gs_stepper *s, double h)
{
  radau *w = s->memory;
  int info = 0;
  for (int i = 0; info == 0 && s->scene->nv > 0 && i < w->stages; i++)
    {
      gs_copy (s->scene->nv, s->v, w->v + s->scene->nv * i);
      if (s->r->ip[GS_V0] != 0)
        info = gs_inputs (s, s->t + w->rule->c[i + 1] * h, w->v + s->scene->nv * i);
    }
  return info;
}

static int
stage_rate (gs_stepper *s, int i, double h, const double *x, double *xd)
{
  radau *w = s->memory;
  double t = s->t + w->rule->c[i + 1] * h;
  return w->of_time ? gs_rate_by (s, t, x, w->v + s->scene->nv * i, xd) : gs_rate (s, t, x, xd);
}

/* G: what the stages Z miss */
static int
defects (gs_stepper *s, double h)
{
  radau *w = s->memory;
  const radau_rule *rule = w->rule;
  int n = w->n;
  for (int i = 0; i < w->stages; i++)
    {
      double *g = w->g + n * i;
      for (int l = 0; l < n; l++)
        w->x1[l] = s->x[l] + w->z[l + n * i];
      int info = stage_rate (s, i, h, w->x1, g);
      if (info != 0)
        return info;
      for (int j = 0; j < w->stages; j++)
        for (int l = 0; l < n; l++)
          g[l] -= rule->inverse[i][j] / h * w->z[l + n * j];
      double t = s->t + rule->c[i + 1] * h;
      if (w->index2 && (info = gs_index2_stage (s, w->index2, i, t, w->x1)) != 0)
        return info;
    }
  if (w->index2)
    gs_index2_defects (w->index2, rule, h, w->g, n);
  return 0;
}

/* DZ: the step of Newton's method */
static void
correct (radau *w)
{
  const radau_rule *rule = w->rule;
  const int n = w->n;
  double *y0 = w->error;
  gs_zero (n, y0);
  for (int i = 0; i < w->stages; i++)
    for (int l = 0; l < n; l++)
      y0[l] += rule->left[i] * w->g[l + n * i];
  solve_real (w, y0);
  for (int i = 0; i < w->stages; i++)
    for (int l = 0; l < n; l++)
      w->dz[l + n * i] = rule->right[i] * y0[l];
  for (int k = 0; k < rule->pairs; k++)
    {
      for (int l = 0; l < n; l++)
        w->y[l] = 0;
      for (int i = 0; i < w->stages; i++)
        for (int l = 0; l < n; l++)
          w->y[l] += rule->lefts[k][i] * w->g[l + n * i];
      solve_pair (w, k, w->y);
      for (int i = 0; i < w->stages; i++)
        for (int l = 0; l < n; l++)
          w->dz[l + n * i] += 2 * creal (rule->rights[k][i] * w->y[l]);
    }
}

/* are the inputs at the last state no numbers? */
static int
no_inputs (const gs_stepper *s)
{
  for (int k = 0; k < s->scene->nv; k++)
    if (! (fabs (s->v[k]) <= 1e300))
      return 1;
  return 0;
}

/* Are the stages going to be found, after a turn of the size SIZE behind one of the size LAST?  The
 * second turn puts right what the first did to stiff springs and may be as large: then the third
 * tells.  RATIO: of the sizes of the turns before.  SHRINK: as in STAGES. */
static int
converges (radau *w, double size, double last, double *ratio, double *shrink)
{
  int left = w->newton_limit - w->turns;
  double now = size / last;
  w->theta = w->turns == 2 ? now : sqrt (now * *ratio);
  *ratio = now;
  w->contraction = w->theta < 0.99 ? w->theta / (1 - w->theta) : 99;
  if (w->turns == 2 && now < 2)
    return 1;
  if (w->theta >= 0.99)
    return 0;
  double end = w->contraction * size * pow (w->theta, left) / w->enough;
  if (end >= 1)
    *shrink = 0.8 * pow (fmin (end, 20), -1.0 / (4 + left));
  return end < 1;
}

/* The stages of the step H.  SHRINK: by what the step is to be multiplied where they were not
 * found. */
static int
stages (gs_stepper *s, double h, double *shrink)
{
  radau *w = s->memory;
  double last = 0, ratio = 0;
  w->contraction = pow (fmax (w->contraction, 0.2), 0.8);
  w->theta = 0;
  *shrink = 0.5;
  predict (w, h);
  int info = w->of_time ? stage_inputs (s, h) : 0;
  if (info != 0)
    return info < 0 ? -1 : NO_STATE;
  for (w->turns = 1; w->turns <= w->newton_limit; w->turns++)
    {
      if ((info = defects (s, h)) != 0)
        return info < 0 && ! (w->turns > 1 && no_inputs (s)) ? -1 : NO_STATE;
      correct (w);
      w->newton++;
      double size = norm (w, w->stages, w->dz);
      if (! (size < 1e30) || (w->turns > 1 && ! converges (w, size, last, &ratio, shrink)))
        return SLOW;
      last = fmax (size, DBL_EPSILON);
      for (int i = 0; i < w->n * w->stages; i++)
        w->z[i] += w->dz[i];
      if (w->contraction * size <= w->enough)
        return GOOD;
    }
  return SLOW;
}

static void
filter (radau *w, double *e)
{
  if (w->index2)
    gs_index2_along (w->index2, e);
  solve_real (w, e);
}

/* the estimated error beside the tolerance */
static int
estimate (gs_stepper *s, double h, double *error)
{
  radau *w = s->memory;
  const radau_rule *rule = w->rule;
  int n = w->n;
  double *sum = w->g, *e = w->error;
  for (int l = 0; l < n; l++)
    {
      sum[l] = 0;
      for (int i = 0; i < w->stages; i++)
        sum[l] += rule->root / h * rule->estimate[i] * w->z[l + n * i];
      e[l] = w->f0[l] + sum[l];
    }
  filter (w, e);
  *error = fmax (norm (w, 1, e), 1e-10);
  if (*error < 1 || ! (w->first || w->after_rejection))
    return 0;
  for (int l = 0; l < n; l++)
    w->x1[l] = s->x[l] + e[l];
  int info = gs_rate (s, s->t, w->x1, e);
  if (info != 0)
    return info;
  for (int l = 0; l < n; l++)
    e[l] += sum[l];
  filter (w, e);
  *error = fmax (norm (w, 1, e), 1e-10);
  return 0;
}

/* ------------------------------------------------------------
 * from step to step */

/* the step to be taken where H is wished: to STOP (TO, else it is HUGE_VAL), or half way to it */
static double
landing (const gs_stepper *s, double h, double *to)
{
  double way = s->stop - s->t;
  *to = h >= way * (1 - 1e-10) ? s->stop : HUGE_VAL;
  return h >= way * (1 - 1e-10) ? way : fmin (h, way / 2);
}

/* the length of the next step after one of H with the error ERROR */
static double
next_length (const radau *w, double h, double error)
{
  double limit = 2 * w->newton_limit, safe = 0.9 * fmin (1, (1 + limit) / (w->turns + limit)),
         power = 1.0 / (w->stages + 1), by = safe * pow (error, -power);
  if (error < 1 && w->old_h > 0)   /* as the errors of two steps foresee it */
    by = fmin (by, 0.9 * h / w->old_h * pow (w->old_error / (error * error), power));
  return h * fmin (8, fmax (0.2, by));
}

/* Order: up where the iteration hardly needs its second turn and steps do not change much, down
 * where it is slow. */
static void
next_order (gs_stepper *s, double growth)
{
  radau *w = s->memory;
  w->risen++;
  if (w->quiet > 0)
    w->quiet--;
  else if (w->turns > 1 && w->theta >= 0.8 && w->stages > 3)
    {
      take_order (s, w->stages - 2);
      w->quiet = 10;
    }
  else if ((w->turns == 1 || w->theta <= 0.002) && growth > 0.8 && growth < 1.2
           && 2 * w->stages + 3 <= s->o->order)
    {
      take_order (s, w->stages + 2);
      w->risen = 0;
    }
}

/* The step H, to TO or by its length, is good: what the next one begins with.  Factors may stay
 * where the iteration is quick and the step would hardly be longer. */
static void
keep (gs_stepper *s, double h, double to, double error)
{
  radau *w = s->memory;
  double *swap = w->past, wish = next_length (w, h, error), growth = wish / h;
  w->past = w->z;
  w->z = swap;
  w->past_stages = w->stages;
  w->past_h = h;
  w->old_h = h;
  w->old_error = fmax (error, 1e-2);
  w->fresh = 0;
  w->stale = w->theta > 1e-3;
  s->t = to < HUGE_VAL ? to : s->t + h;
  s->h = h;
  if (to < HUGE_VAL)
    wish = fmax (wish, w->wish);
  else if (! w->stale && growth >= 1 && growth <= 1.2)
    wish = h;
  w->wish = s->next = wish;
  if (! w->first)
    next_order (s, growth);
  w->first = w->after_rejection = 0;
}

/* The step H was not good: one BY times as long, with a Jacobian of its state if ANEW. */
static int
again (gs_stepper *s, double h, double by, int anew)
{
  radau *w = s->memory;
  w->wish = h * by;
  w->after_rejection = 1;
  if (w->wish <= 16 * DBL_EPSILON * fabs (s->t) || w->wish < 1e-300)
    return GS_NO_STEP;
  return anew && ! w->fresh && take_jacobian (s) != 0 ? FATAL : AGAIN;
}

/* after stages that were not found */
static int
diverged (gs_stepper *s, double h, double by, int outcome)
{
  radau *w = s->memory;
  w->diverged++;
  if (w->stages > 3 && w->theta >= 0.99)
    {
      take_order (s, w->stages - 2);
      w->wait = w->risen > 20 ? 10 : w->wait < 500 ? 2 * w->wait : w->wait;
      w->quiet = w->wait;
    }
  return again (s, h, by, outcome == SLOW);
}

/* X at T along what the scene does under forces of its constraints; as gs_settle */
static int
settle (gs_stepper *s, double t, double *x)
{
  radau *w = s->memory;
  double *end = w->error;
  gs_factors by = { .shift = w->shift, .solve = solve_own, .of = w };
  if (! w->settles || gs_completes (s))
    return -1;
  gs_copy (w->n, x, end);
  int left = gs_settle (s, w->loops, &by, w->scale, t, end);
  if (left >= 0)
    gs_copy (w->n, end, x);
  return left;
}

/* X1: the end of the step H, at TO or by its length, on the constraints */
static int
end_of_step (gs_stepper *s, double h, double to)
{
  radau *w = s->memory;
  double *end = w->error, t = to < HUGE_VAL ? to : s->t + h;
  for (int l = 0; l < w->n; l++)
    w->x1[l] = s->x[l] + w->z[l + w->n * (w->stages - 1)];
  if (! gs_projects (s) || settle (s, t, w->x1) == 0)
    return 0;
  int info = gs_moved (s, t, w->x1, end);
  gs_copy (w->n, end, w->x1);
  return info;
}

/* one step of the length that is wished, if it is good; 0, a flag or AGAIN */
static int
attempt (gs_stepper *s)
{
  radau *w = s->memory;
  double most = s->r->ropt[2] > 0 ? s->r->ropt[2] : HUGE_VAL,
         to, by, error, h = landing (s, fmin (w->wish, most), &to);
  if (factorize (w, h))
    return again (s, h, 0.5, 0);
  int info = stages (s, h, &by);
  if (info != GOOD)
    return info < 0 ? FATAL : diverged (s, h, by, info);
  info = estimate (s, h, &error);
  if (info < 0)
    return FATAL;
  if (info > 0 || ! (error < 1))
    {
      w->tests++;
      return again (s, h, info > 0 ? 0.5 : w->first ? 0.1 : next_length (w, h, error) / h, 1);
    }
  if ((info = end_of_step (s, h, to)) != 0)
    {
      w->projections++;
      return info < 0 ? FATAL : again (s, h, 0.25, 0);
    }
  keep (s, h, to, error);
  return 0;
}

static int
step (gs_stepper *s)
{
  radau *w = s->memory;
  take_scale (s);
  if (gs_rate (s, s->t, s->x, w->f0) != 0)
    return GS_NO_RATES;
  if (w->stale && take_jacobian (s) != 0)
    return FATAL;
  int outcome = AGAIN;
  while (outcome == AGAIN)
    outcome = attempt (s);
  s->y = w->x1;
  return outcome;
}

/* nothing is known of how its polynomial goes on: that was of the last step, from here as well */
static int
again_ (gs_stepper *s)
{
  radau *w = s->memory;
  w->past_stages = 0;
  w->wish = fmax (w->wish, s->stop - s->t);
  return step (s);
}

/* ------------------------------------------------------------
 * the method */

static int
open_ (gs_stepper *s)
{
  const ptrdiff_t n = s->r->nx, own = gs_own_states (s), m = n * STAGES;
  radau *w = s->memory = gs_allocate (1, sizeof (radau));
  if (! w)
    return 0;
  w->n = s->r->nx;
  w->own = gs_own_states (s);
  w->J = gs_allocate (3 * own * own + own + 4 * m + 4 * n + STAGES * (ptrdiff_t) s->scene->nv,
                 sizeof (double));
  w->lus = gs_allocate (PAIRS * own * own + n + own, sizeof (double complex));
  w->pivots = gs_allocate (own * (PAIRS + 1), sizeof (int));
  if (! w->J || ! w->lus || ! w->pivots || ! gsmbp_new_order (&w->order, w->own))
    return 0;
  int failed;
  w->loops = gs_new_loops (s, &failed);
  if (failed)
    return 0;
  if (s->o->index2 && w->loops && ! (w->index2 = gs_new_index2 (w->loops)))
    return 0;
  w->ordered = w->J + own * own;
  w->ordered_x = w->ordered + own * own;
  w->lu = w->ordered_x + own;
  w->z = w->lu + own * own;
  w->g = w->z + m;
  w->dz = w->g + m;
  w->past = w->dz + m;
  w->f0 = w->past + m;
  w->error = w->f0 + n;
  w->x1 = w->error + n;
  w->scale = w->x1 + n;
  w->v = w->scale + n;
  w->y = w->lus + PAIRS * own * own;
  w->ordered_y = w->y + n;
  return 1;
}

static void
close_ (gs_stepper *s)
{
  radau *w = s->memory;
  if (! w)
    return;
  gsmbp_free_order (&w->order);
  gs_free_loops (w->loops);
  gs_free_index2 (w->index2);
  free (w->J);
  free (w->lus);
  free (w->pivots);
  free (w);
}

/* a first step that changes the state by a hundredth of it */
static int
restart (gs_stepper *s)
{
  radau *w = s->memory;
  take_scale (s);
  w->first = 1;
  w->of_time = gs_inputs_of_time (s);
  w->wait = 10;
  w->past_stages = w->quiet = w->after_rejection = w->stale = 0;
  w->contraction = 1;
  w->old_h = 0;
  if (gs_rate (s, s->t, s->x, w->f0) != 0)
    return GS_NO_RATES;
  if (take_jacobian (s) != 0)
    return FATAL;
  double rate = norm (w, 1, w->f0);
  w->wish = rate > 0 ? 0.01 * fmax (norm (w, 1, s->x), 1) / rate : 1e-6;
  return 0;
}

static int
begin (gs_stepper *s)
{
  radau *w = s->memory;
  const int order = s->o->order;
  if (order != 5 && order != 9 && order != 13)
    {
      snprintf (s->o->text, s->o->length, "expected order 5, 9 or 13; found %d", order);
      return FATAL;
    }
  take_order (s, s->o->order >= 9 && s->r->ropt[1] < 1e-6 ? 5 : 3);
  int flag = restart (s);
  if (s->r->ropt[0] > 0 && ! s->o->resume)
    w->wish = s->r->ropt[0];
  return flag;
}

static int
between (gs_stepper *s, double t, double *x)
{
  const radau *w = s->memory;
  gs_copy (w->n, s->y, x);
  add_past (w, 1 + (t - s->t) / w->past_h, x);
  return 0;
}

static int
rejected (gs_stepper *s)
{
  return ((radau *) s->memory)->tests;
}

static void
count (gs_stepper *s)
{
  radau *w = s->memory;
  int *istat = s->r->istat;
  istat[GS_N_REJECTED] += w->tests + w->diverged + w->projections;
  istat[GS_N_REPEATED] += w->projections;
  istat[GS_N_JACOBIANS] += w->jacobians;
  istat[GS_N_NEWTON] += w->newton;
  istat[GS_N_DIVERGED] += w->diverged;
  w->tests = w->diverged = w->projections = w->jacobians = w->newton = 0;
}

int
gs_radau (const gs_scene *scene, gs_integration *run, const gs_implicit *options)
{
  static const gs_method collocation
    = { open_, close_, begin, restart, step, again_, between, settle, rejected, count, 0, 1, 0 };
  return gs_implicit_run (scene, run, options, &collocation);
}

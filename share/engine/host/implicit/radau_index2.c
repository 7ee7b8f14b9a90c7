/* Loops in index 2: a stage has

     M (u' - f) = H' kappa,   H u + phit = 0,

   f being the accelerations that RHS gives, which kappa, what the multipliers are more than those
   of RHS, leads away from what keeps accelerations on the constraints: speeds are on them instead.
   Hairer, Wanner: Solving Ordinary Differential Equations II, VII.

   With W = M^-1 H' (H M^-1 H')^-1, which takes what goes across the constraints to speeds, and
   P = I - W H, what goes along them, that is

     P (f - u') - W (H u + phit)' = 0,

   the last rate being that of the polynomial through the stages.  P and W are those of the stage,
   so that no more than f is of another state than J in Newton's method.  Its matrix has P of where
   J is of, and H du + DV dq = 0 in the form that the speeds

     w = u + SLOPE q,   SLOPE = W DV,

   do not go across: the states and no multipliers are in the linear systems. */
#include "radau_index2.h"

/* the constraints at a stage */
typedef struct
{
  gs_rows gram;
  double *mass, *rows, *missed;   /* factors of M, gradients, what the speeds miss */
} gs_stage;

struct gs_index2
{
  gs_loops *loops;              /* of where J is of */
  gs_stage at[STAGES];
  int *orders;
  double *numbers;              /* all that follow */
  double *DP, *DV, *part, *speeds;   /* M x NQ; M; N */
};

static void
place_stages (gs_index2 *w, int n, int m, double *room)
{
  for (int i = 0; i < STAGES; i++)
    {
      gs_stage *at = &w->at[i];
      at->mass = room;
      at->rows = at->mass + n * n;
      at->missed = at->rows + n * m;
      place_rows (&at->gram, n, m, w->orders + m * i, at->missed + m);
      room = at->missed + m + rows_room (n, m);
    }
}

gs_index2 *
gs_new_index2 (gs_loops *loops)
{
  const ptrdiff_t n = loops->n, m = loops->m, nq = loops->nq;
  gs_index2 *w = gs_allocate (1, sizeof (gs_index2));
  int *orders = gs_allocate (STAGES * m, sizeof (int));
  const ptrdiff_t stage = n * n + n * m + m + rows_room (n, m);
  double *next = gs_allocate (n * nq + 2 * m * nq + m + n + STAGES * stage, sizeof (double));
  if (! w || ! orders || ! next)
    return free (next), free (orders), free (w), NULL;
  w->loops = loops;
  w->orders = orders;
  w->numbers = loops->slope = next;
  w->DP = loops->slope + n * nq;
  w->DV = w->DP + m * nq;
  w->part = w->DV + m * nq;
  w->speeds = w->part + m;
  place_stages (w, loops->n, loops->m, w->speeds + n);
  return w;
}

void
gs_free_index2 (gs_index2 *w)
{
  if (! w)
    return;
  free (w->orders);
  free (w->numbers);
  free (w);
}

/* V less W times PART, which is overwritten */
static void
take_away (gs_index2 *w, gs_rows *gram, const double *mass, double *v)
{
  int n = gram->n;
  double *d = w->speeds;
  gs_zero (n, d);
  solve_rows (gram, w->part);
  for (int k = 0; k < gram->m; k++)
    for (int j = 0; j < n; j++)
      d[j] += gram->solved[j + n * k] * w->part[k];
  backward (n, mass, d);
  for (int j = 0; j < n; j++)
    v[j] -= d[j];
}

/* PART: of V across the constraints */
static void
look_across (gs_index2 *w, const double *rows, const double *v)
{
  int n = w->loops->n, m = w->loops->m;
  for (int k = 0; k < m; k++)
    {
      w->part[k] = 0;
      for (int j = 0; j < n; j++)
        w->part[k] += rows[k + m * j] * v[j];
    }
}

void
gs_index2_along (gs_index2 *w, double *f)
{
  gs_loops *l = w->loops;
  look_across (w, l->rows, f + l->nq);
  take_away (w, &l->gram, l->mass, f + l->nq);
}

static void
take_slope (gs_stepper *s, gs_index2 *w)
{
  gs_loops *l = w->loops;
  int n = l->n, m = l->m;
  s->scene->tan (s->t, s->x, s->r->cst, w->DP, m, w->DV, m);
  gs_zero (n * l->nq, l->slope);
  for (int j = 0; j < l->nq; j++)
    {
      for (int k = 0; k < m; k++)
        w->part[k] = -w->DV[k + m * j];
      take_away (w, &l->gram, l->mass, l->slope + n * j);
    }
}

void
gs_index2_jacobian (gs_stepper *s, gs_index2 *w, double *J)
{
  const ptrdiff_t n = w->loops->n, nq = w->loops->nq, own = w->loops->own;
  take_slope (s, w);
  for (ptrdiff_t j = 0; j < own; j++)
    gs_index2_along (w, J + own * j);
  for (ptrdiff_t j = 0; j < nq; j++)
    for (ptrdiff_t i = 0; i < n; i++)
      {
        double factor = w->loops->slope[i + n * j];
        for (ptrdiff_t l = 0; factor != 0 && l < own; l++)
          J[l + own * j] -= factor * J[l + own * (nq + i)];
      }
}

void
gs_index2_speeds (const gs_index2 *w, double complex *x)
{
  int n = w->loops->n, nq = w->loops->nq;
  for (int j = 0; j < nq; j++)
    for (int i = 0; i < n; i++)
      x[nq + i] -= w->loops->slope[i + n * j] * x[j];
}

int
gs_index2_stage (gs_stepper *s, gs_index2 *w, int i, double t, const double *x)
{
  gs_loops *l = w->loops;
  gs_stage *at = &w->at[i];
  if (gs_constraints (s, l, t, x, at->rows) != 0)
    return -1;
  gs_rates_missed (l, at->rows, x);
  gs_copy (l->m, l->gap, at->missed);
  s->scene->mas (t, x, s->r->cst, at->mass, l->n);
  return ! cholesky (l->n, at->mass)
         || ! factorize_like (&at->gram, &l->gram, at->rows, at->mass);
}

void
gs_index2_defects (gs_index2 *w, const radau_rule *rule, double h, double *g, int n)
{
  for (int i = 0; i < rule->stages; i++)
    {
      gs_stage *at = &w->at[i];
      double *u = g + (ptrdiff_t) n * i + w->loops->nq;
      look_across (w, at->rows, u);
      for (int j = 0; j < rule->stages; j++)
        for (int k = 0; k < w->loops->m; k++)
          w->part[k] += rule->inverse[i][j] / h * w->at[j].missed[k];
      take_away (w, &at->gram, at->mass, u);
    }
}

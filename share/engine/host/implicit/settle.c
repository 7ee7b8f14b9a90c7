/* How the end of a step comes onto the constraints.

   The nearest state in the metric of the masses is moved along all coordinates, those of stiff
   springs too: as far as the tolerance, beside which a spring of 1e9 N/m begins to swing.  So the
   state goes along what the scene does when forces of the constraints work on it through an
   implicit step,

     (SHIFT*I - J) D = (0, M^-1 H', 0),

   whose springs hold: positions by the coordinates of D, speeds by its speeds over SHIFT. */
#include <float.h>
#include "settle.h"

enum { TURNS = 5, FAR = 100 };   /* at most; in tolerances */

gs_loops *
gs_new_loops (const gs_stepper *s, int *failed)
{
  const ptrdiff_t n = s->scene->nu, m = s->scene->nlam, own = gs_own_states (s);
  *failed = 0;
  if (m == 0 || ! s->scene->mas || ! s->scene->con)
    return NULL;
  *failed = 1;
  gs_loops *w = gs_allocate (1, sizeof (gs_loops));
  int *order = gs_allocate (2 * m, sizeof (int));
  double *next = gs_allocate (n * n + 2 * n * m + own * m + m * m + 4 * m + rows_room (n, m),
                         sizeof (double));
  if (! w || ! order || ! next)
    return free (order), free (next), free (w), NULL;
  *failed = 0;
  w->n = s->scene->nu;
  w->m = s->scene->nlam;
  w->nq = s->scene->nq;
  w->own = gs_own_states (s);
  w->pivots = order + m;
  w->numbers = w->mass = next;
  w->rows = w->mass + n * n;
  w->here = w->rows + n * m;
  w->D = w->here + n * m;
  w->B = w->D + own * m;
  w->gap = w->B + m * m;
  w->phit = w->gap + m;
  w->gamma = w->phit + m;
  w->side = w->gamma + m;
  place_rows (&w->gram, w->n, w->m, order, w->side + m);
  return w;
}

void
gs_free_loops (gs_loops *w)
{
  if (! w)
    return;
  free (w->gram.order);
  free (w->numbers);
  free (w);
}

int
gs_constraints (gs_stepper *s, gs_loops *w, double t, const double *x, double *rows)
{
  int info = s->scene->con (t, x, x + w->nq, s->r->cst, w->gap, w->phit, rows, w->m, w->gamma);
  return info == 0 || info == 2 ? 0 : -1;
}

int
gs_take_loops (gs_stepper *s, gs_loops *w)
{
  w->of = 0;
  w->gram.rank = 0;
  s->scene->mas (s->t, s->x, s->r->cst, w->mass, w->n);
  if (! cholesky (w->n, w->mass) || gs_constraints (s, w, s->t, s->x, w->rows) != 0)
    return -1;
  factorize_rows (&w->gram, w->rows, w->mass);
  return 0;
}

void
gs_rates_missed (gs_loops *w, const double *rows, const double *x)
{
  for (int k = 0; k < w->m; k++)
    {
      w->gap[k] = w->phit[k];
      for (int j = 0; j < w->n; j++)
        w->gap[k] += rows[k + w->m * j] * x[w->nq + j];
    }
}

void
gs_speeds (const gs_loops *w, double *x)
{
  for (int j = 0; w->slope && j < w->nq; j++)
    for (int i = 0; i < w->n; i++)
      x[w->nq + i] -= w->slope[i + w->n * j] * x[j];
}

/* X, of forces: what they do through a step; speeds over SHIFT */
static void
respond (gs_loops *w, const gs_factors *by, double *x)
{
  double *u = x + w->nq;
  for (int j = 0; j < w->n; j++)
    u[j] *= by->shift * by->shift;
  forward (w->n, w->mass, u);
  backward (w->n, w->mass, u);
  by->solve (by->of, x);
  gs_speeds (w, x);
  for (int j = 0; j < w->n; j++)
    u[j] /= by->shift;
}

/* the kinetic energy of speeds, twice, MASS being the factors */
static double
energy (int n, const double *mass, const double *u)
{
  double sum = 0;
  for (int j = 0; j < n; j++)
    {
      double y = 0;
      for (int i = j; i < n; i++)
        y += mass[i + n * j] * u[i];
      sum += y * y;
    }
  return sum;
}

/* Does anything hold against forces of the constraints, all at once?  Else the metric of the masses
   says the same as D. */
static int
is_held (gs_loops *w, const gs_factors *by)
{
  int n = w->n;
  double *d = w->D, *u = d + w->nq, *free_ = w->here;
  gs_zero (w->own, d);
  for (int k = 0; k < w->gram.rank; k++)
    for (int j = 0; j < n; j++)
      u[j] += w->rows[w->gram.order[k] + w->m * j] / sqrt (w->gram.most[w->gram.order[k]]);
  gs_copy (n, u, free_);
  forward (n, w->mass, free_);
  backward (n, w->mass, free_);
  respond (w, by, d);
  double all = energy (n, w->mass, free_);
  for (int j = 0; j < n; j++)
    u[j] -= free_[j];
  return ! (energy (n, w->mass, u) < 1e-4 * all);
}

/* D, speeds over SHIFT: what they do to the rates of the constraints stands for what coordinates
   do to the constraints */
static void
responses (gs_loops *w, const gs_factors *by)
{
  if (w->of == by->shift)
    return;
  w->of = by->shift;
  w->held = w->gram.rank > 0 && is_held (w, by);
  if (! w->held)
    return;
  gs_zero (w->own * w->m, w->D);
  for (int k = 0; k < w->gram.rank; k++)
    {
      double *d = w->D + (ptrdiff_t) w->own * k;
      for (int j = 0; j < w->n; j++)
        d[w->nq + j] = w->rows[w->gram.order[k] + w->m * j];
      respond (w, by, d);
    }
}

/* B = HERE D of the rows that do not depend on others, as factors */
static int
take_matrix (gs_loops *w)
{
  int r = w->gram.rank;
  for (int k = 0; k < r; k++)
    for (int i = 0; i < r; i++)
      {
        w->B[i + r * k] = 0;
        for (int j = 0; j < w->n; j++)
          w->B[i + r * k] += w->here[w->gram.order[i] + w->m * j]
                             * w->D[w->nq + j + (ptrdiff_t) w->own * k];
      }
  return gsmbp_dense_factors (r, w->B, w->pivots);
}

/* X, N of its places from FROM on, goes along D so that GAP vanishes; how far that is at most */
static double
go (gs_loops *w, const double *scale, double *x, int from, int n)
{
  int r = w->gram.rank;
  double most = 0;
  for (int i = 0; i < r; i++)
    w->side[i] = w->gap[w->gram.order[i]];
  gsmbp_dense_solve (r, w->B, w->pivots, w->side);
  for (int l = from; l < from + n; l++)
    {
      double d = 0;
      for (int k = 0; k < r; k++)
        d += w->D[l + (ptrdiff_t) w->own * k] * w->side[k];
      x[l] -= d;
      most = fmax (most, fabs (d * scale[l]));
    }
  return most;
}

/* Turns until they are no more than rounding, SPEEDS or positions; 0, or 1: something is left, or
   -1: it leads too far. */
static int
go_on (gs_stepper *s, gs_loops *w, const double *scale, double t, double *x, int speeds)
{
  double last = HUGE_VAL, rounding = 8 * DBL_EPSILON / s->r->ropt[1],
         *before = &s->r->rstat[GS_R_BEFORE];
  for (int turn = 0; turn < TURNS; turn++)
    {
      if (gs_constraints (s, w, t, x, w->here) != 0 || (turn == 0 && take_matrix (w) != 0))
        return -1;
      for (int k = 0; k < w->m && turn == 0 && ! speeds; k++)
        *before = fmax (*before, fabs (w->gap[k]));
      if (speeds)
        gs_rates_missed (w, w->here, x);
      double size = speeds ? go (w, scale, x, w->nq, w->n) : go (w, scale, x, 0, w->nq);
      if (! (size < FAR))
        return -1;
      if (size <= rounding)
        return 0;
      if (size > 0.25 * last)
        return 1;
      last = size;
    }
  return 1;
}

int
gs_settle (gs_stepper *s, gs_loops *w, const gs_factors *by, const double *scale, double t,
           double *x)
{
  responses (w, by);
  if (! w->held)
    return -1;
  int positions = go_on (s, w, scale, t, x, 0);
  int speeds = positions < 0 ? -1 : go_on (s, w, scale, t, x, 1);
  int whole = positions == 0 && speeds == 0 && w->nq == w->n && s->o->columns == 0;
  s->r->istat[GS_N_PROJECTIONS] += whole;
  return speeds < 0 ? -1 : ! whole;
}

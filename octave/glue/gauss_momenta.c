/* Collocation of Gauss in coordinates and momenta p = M u, for scenes whose speeds are the rates of
   their coordinates: symplectic, so that the energy of a free motion has no drift, whether it goes
   to and fro or turns on and on.

   A stage has p' = -B + (dM/dt) u, B from BIA, (dM/dt) u from two calls of LIN, whose C is
   linear in the accelerations that it is given: with UD = u and with UD = 0.  Constraints stand at
   the points of Lobatto, as impulses along their gradients there; the last impulse puts the
   speeds onto them: Jay, Specialized partitioned additive Runge-Kutta methods for systems of
   overdetermined DAEs with holonomic constraints, SIAM J. Numer. Anal. 45, 2007.  No coordinates
   are chosen.

   An angle that turns on loses digits as it grows, and the energy with them.  Coordinates that
   nothing but whole turns of leaves alone are therefore kept within half a turn, the turns apart;
   every step looks whether that is still so. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "gauss_momenta.h"
#include "gsmbp/inputs.h"

enum { TURNS = 100, BEFORE = 3 };

typedef void con_type (const double *t, const double *q, const double *u, double *cst, double *phi,
                       double *phit, double *hc, const int *ldh, double *gam, int *info);
typedef void lin_type (const double *t, const double *q, const double *u, const double *ud,
                       const double *v, double *cst, double *m, double *b, double *c,
                       const int *ld);
typedef void bia_type (const double *t, const double *q, const double *u, const double *v,
                       double *cst, double *b);
typedef void mas_type (const double *t, const double *q, double *cst, double *m, const int *ldm);

struct gs_momenta
{
  const gauss_rule *rule;
  int n, m;                     /* speeds, constraints */
  const double *size;           /* usual sizes of the states */
  double *numbers;              /* all that follow */
  double *p, *lost_q, *lost_p;  /* the momenta, what rounding took from them and the coordinates */
  double *u, *f, *old;          /* of the stages: speeds, rates of momenta; one of both before */
  double *x, *pi, *trial;       /* a state, the momenta of a stage, another state */
  double *mass, *masses, *B, *C, *C0, *bias, *zero;   /* MASSES: factors, at the end of the step */
  double *force, *past;         /* multipliers, those of steps before */
  double *phi, *phit, *gamma, *rows, *turned;   /* constraints, their gradients */
  double *before;               /* coordinates, momenta, what they lost, before the step */
  int *turning;                 /* coordinates of which whole turns change nothing */
  double *S, *solved, *scale, *side;                  /* rows M^-1 rows' at the start, factors */
  int *order, rank;             /* ... in the order of their pivots */
  double large;                 /* the largest momentum of usual speeds, at the start */
  int known, remembered;        /* is there a step before; how many sets of multipliers */
  long turns;
};

int
gs_settled (gs_settling *k, double change)
{
  k->idle = change < k->least ? 0 : k->idle + 1;
  k->least = fmin (k->least, change);
  return change == 0 || (k->idle > 0 && k->least < 1e-13) || (k->idle > 4 && k->least < 1e-10);
}

/* ------------------------------------------------------------
 * linear equations */

/* A = L L'; 0: A is not positive definite */
static int
cholesky (int n, double *a)
{
  for (int j = 0; j < n; j++)
    {
      double scale = a[j + n * j];
      for (int k = 0; k < j; k++)
        for (int i = j; i < n; i++)
          a[i + n * j] -= a[i + n * k] * a[j + n * k];
      if (! (a[j + n * j] > 1e-14 * fabs (scale)))
        return 0;
      double root = sqrt (a[j + n * j]);
      for (int i = j; i < n; i++)
        a[i + n * j] /= root;
    }
  return 1;
}

static void
forward (int n, const double *l, double *x)
{
  for (int j = 0; j < n; j++)
    {
      x[j] /= l[j + n * j];
      for (int i = j + 1; i < n; i++)
        x[i] -= l[i + n * j] * x[j];
    }
}

static void
backward (int n, const double *l, double *x)
{
  for (int j = n - 1; j >= 0; j--)
    {
      for (int i = j + 1; i < n; i++)
        x[j] -= l[i + n * j] * x[i];
      x[j] /= l[j + n * j];
    }
}

/* S = ROWS M^-1 ROWS'; MASS: factors of M */
static void
gram (gs_momenta *w, const double *rows, const double *mass)
{
  int n = w->n, m = w->m;
  for (int k = 0; k < m; k++)
    {
      for (int j = 0; j < n; j++)
        w->solved[j + n * k] = rows[k + m * j];
      forward (n, mass, w->solved + n * k);
    }
  for (int i = 0; i < m; i++)
    for (int k = 0; k < m; k++)
      {
        double sum = 0;
        for (int j = 0; j < n; j++)
          sum += w->solved[j + n * i] * w->solved[j + n * k];
        w->S[i + m * k] = sum;
      }
}

/* rows and columns A and B change places */
static void
exchange (gs_momenta *w, int a, int b)
{
  int m = w->m, number = w->order[a];
  double *S = w->S, swap = w->scale[a];
  w->scale[a] = w->scale[b], w->scale[b] = swap;
  w->order[a] = w->order[b], w->order[b] = number;
  for (int j = 0; j < m; j++)
    swap = S[a + m * j], S[a + m * j] = S[b + m * j], S[b + m * j] = swap;
  for (int j = 0; j < m; j++)
    swap = S[j + m * a], S[j + m * a] = S[j + m * b], S[j + m * b] = swap;
}

/* S = L L', its rows in the order of their pivots, as far as they are independent */
static void
factorize (gs_momenta *w, const double *rows, const double *mass)
{
  int m = w->m;
  double *S = w->S, *scale = w->scale;
  gram (w, rows, mass);
  for (int k = 0; k < m; k++)
    w->order[k] = k, scale[k] = S[k + m * k];
  for (w->rank = 0; w->rank < m; w->rank++)
    {
      int k = w->rank, best = k;
      for (int i = k + 1; i < m; i++)
        if (S[i + m * i] * scale[best] > S[best + m * best] * scale[i])
          best = i;
      if (! (S[best + m * best] > 1e-10 * scale[best]))
        return;
      exchange (w, k, best);
      double root = sqrt (S[k + m * k]);
      for (int i = k; i < m; i++)
        S[i + m * k] /= root;
      for (int j = k + 1; j < m; j++)
        for (int i = k + 1; i < m; i++)
          S[i + m * j] -= S[i + m * k] * S[j + m * k];
    }
}

/* what solves S X = X; zero for rows that depend on others */
static void
solve_rows (gs_momenta *w, double *x)
{
  int m = w->m, r = w->rank;
  double *y = w->side;
  for (int i = 0; i < r; i++)
    {
      y[i] = x[w->order[i]];
      for (int j = 0; j < i; j++)
        y[i] -= w->S[i + m * j] * y[j];
      y[i] /= w->S[i + m * i];
    }
  for (int i = r - 1; i >= 0; i--)
    {
      for (int j = i + 1; j < r; j++)
        y[i] -= w->S[j + m * i] * y[j];
      y[i] /= w->S[i + m * i];
    }
  memset (x, 0, sizeof (double) * m);
  for (int i = 0; i < r; i++)
    x[w->order[i]] = y[i];
}

/* ------------------------------------------------------------
 * the emitted routines */

static int
mass_at (gs_run *s, gs_momenta *w, double t, const double *q, double *mass)
{
  ((mas_type *) s->r->mas) (&t, q, s->r->cst, mass, &w->n);
  return cholesky (w->n, mass);
}

/* constraints and their gradients, ROWS; 0 or a flag */
static int
constraints_at (gs_run *s, gs_momenta *w, double t, const double *q, double *phi, double *rows)
{
  int info = 0;
  ((con_type *) s->r->con) (&t, q, w->zero, s->r->cst, phi, w->phit, rows, &w->m, w->gamma, &info);
  return info == 0 || info == 2 ? 0 : -1;
}

/* X += FACTOR ROWS' FORCES */
static void
add_forces (const gs_momenta *w, const double *rows, double factor, const double *forces, double *x)
{
  for (int j = 0; j < w->n; j++)
    for (int k = 0; k < w->m; k++)
      x[j] += factor * rows[k + w->m * j] * forces[k];
}

/* at the state X: M, and F = -B + (dM/dt) u; 0 or a flag */
static int
rate_at (gs_run *s, gs_momenta *w, double t, const double *x, double *f)
{
  const gsmbp_run *r = s->r;
  int n = w->n;
  const double *u = x + n;
  if ((r->ip[GS_V0] != 0 || r->ip[GS_FEEDBACK] != 0) && gs_inputs_at (s, t, x, s->v) != 0)
    return -1;
  ((lin_type *) r->lin) (&t, x, u, w->zero, s->v, r->cst, w->mass, w->B, w->C0, &n);
  ((lin_type *) r->lin) (&t, x, u, u, s->v, r->cst, w->mass, w->B, w->C, &n);
  ((bia_type *) r->bia) (&t, x, u, s->v, r->cst, w->bias);
  r->istat[0]++;
  for (int i = 0; i < n; i++)
    {
      f[i] = -w->bias[i];
      for (int j = 0; j < n; j++)
        f[i] += (w->C[i + n * j] - w->C0[i + n * j]) * u[j];
      if (! (fabs (f[i]) <= 1e300))
        return -1;
    }
  return 0;
}

/* ------------------------------------------------------------
 * one step */

/* the first guess: the polynomials of the step before, or what is known at the start */
static int
predict (gs_run *s, gs_momenta *w)
{
  int n = w->n, m = w->m, stages = w->rule->stages, all = n * stages;
  double *uf[2] = { w->u, w->f };
  if (! w->known)
    {
      if (rate_at (s, w, s->t, s->x, w->f) != 0)
        return -1;
      memcpy (w->u, s->x + n, sizeof (double) * n);
      w->remembered = 0;
      memset (w->force, 0, sizeof (double) * m * stages);
    }
  for (int which = 0; which < 2; which++)
    {
      double *y = uf[which];
      memcpy (w->old, y, sizeof (double) * all);
      for (int i = 0; i < stages; i++)
        for (int l = 0; l < n; l++)
          {
            longer sum = w->known ? 0 : w->old[l];
            for (int j = 0; w->known && j < stages; j++)
              sum += w->rule->ahead[i][j] * w->old[l + n * j];
            y[l + n * i] = sum;
          }
    }
  return 0;
}

/* the multipliers as those of the steps before go on, which are moved up */
static void
predict_forces (gs_momenta *w)
{
  int all = w->m * w->rule->stages;
  double *f[BEFORE];
  for (int k = 0; k < BEFORE; k++)
    f[k] = w->past + (size_t) all * k;
  for (int l = 0; l < all; l++)
    {
      f[2][l] = f[1][l], f[1][l] = f[0][l], f[0][l] = w->force[l];
      w->force[l] = w->remembered >= 2   ? 3 * (f[0][l] - f[1][l]) + f[2][l]
                    : w->remembered == 1 ? 2 * f[0][l] - f[1][l]
                                         : f[0][l];
    }
  w->remembered++;
}

/* the multipliers, corrected by what the positions at the points of Lobatto miss */
static int
correct_forces (gs_run *s, gs_momenta *w, double h)
{
  const gauss_rule *rule = w->rule;
  int n = w->n, m = w->m, stages = rule->stages;
  for (int k = 0; k < stages; k++)
    {
      for (int l = 0; l < n; l++)
        {
          longer sum = 0;
          for (int j = 0; j < stages; j++)
            sum += rule->to[k][j] * w->u[l + n * j];
          w->x[l] = s->x[l] + (w->lost_q[l] + h * sum);
        }
      if (constraints_at (s, w, s->t + (double) rule->at[k + 1] * h, w->x, w->phi + m * k,
                          w->rows + n * m * (k + 1)) != 0)
        return -1;
      solve_rows (w, w->phi + m * k);
    }
  for (int i = 0; i < stages; i++)
    for (int k = 0; k < stages; k++)
      for (int l = 0; l < m; l++)
        w->force[l + m * i] += (double) rule->back[i][k] / (h * h) * w->phi[l + m * k];
  return 0;
}

/* Stage I: its state X, by M there its speeds, its rate.  CHANGE: the largest change of a state by
 * one of them.  Rounding of positions beside H is in the multipliers, not in what they do. */
static int
stage (gs_run *s, gs_momenta *w, int i, double h, double *change)
{
  const gauss_rule *rule = w->rule;
  int n = w->n, m = w->m;
  double *u = w->u + n * i, t = s->t + (double) rule->c[i] * h;
  for (int l = 0; l < n; l++)
    {
      longer q = 0, p = 0;
      for (int j = 0; j < rule->stages; j++)
        {
          q += rule->a[i][j] * w->u[l + n * j];
          p += rule->a[i][j] * w->f[l + n * j];
        }
      w->x[l] = s->x[l] + (w->lost_q[l] + h * q);
      w->pi[l] = w->p[l] + (w->lost_p[l] + h * p);
    }
  for (int k = 0; k < rule->stages && m > 0; k++)
    add_forces (w, w->rows + n * m * k, -h * (double) rule->force[i][k], w->force + m * k, w->pi);
  if (! mass_at (s, w, t, w->x, w->mass))
    return -1;
  forward (n, w->mass, w->pi);
  backward (n, w->mass, w->pi);
  for (int l = 0; l < n; l++)
    {
      *change = fmax (*change, h * fabs (w->pi[l] - u[l]) / w->size[l]);
      u[l] = w->x[n + l] = w->pi[l];
    }
  memcpy (w->pi, w->f + n * i, sizeof (double) * n);
  if (rate_at (s, w, t, w->x, w->f + n * i) != 0)
    return -1;
  for (int l = 0; l < n; l++)
    *change = fmax (*change, h * fabs (w->pi[l] - w->f[l + n * i]) / w->large);
  return 0;
}

/* the stages; 0, a flag, GS_NO_END */
static int
solve (gs_run *s, gs_momenta *w, double h)
{
  gs_settling so_far = { HUGE_VAL, 0 };
  if (predict (s, w) != 0)
    return -1;
  if (w->m > 0 && w->known)
    predict_forces (w);
  for (int turn = 0; turn < TURNS; turn++)
    {
      double change = 0;
      w->turns++;
      if (w->m > 0 && correct_forces (s, w, h) != 0)
        return -1;
      for (int i = 0; i < w->rule->stages; i++)
        if (stage (s, w, i, h, &change) != 0)
          return -1;
      if (gs_settled (&so_far, change))
        return 0;
    }
  return GS_NO_END;
}

/* coordinates and momenta at the end, and what rounding took from them */
static void
sum_up (gs_run *s, gs_momenta *w, double h, double *x)
{
  const gauss_rule *rule = w->rule;
  int n = w->n, m = w->m;
  for (int l = 0; l < n; l++)
    {
      longer q = 0, p = 0;
      for (int j = 0; j < rule->stages; j++)
        {
          q += rule->b[j] * w->u[l + n * j];
          p += rule->b[j] * w->f[l + n * j];
        }
      for (int k = 0; k < rule->stages; k++)
        for (int i = 0; i < m; i++)
          p -= rule->weight[k] * w->rows[i + m * l + n * m * k] * w->force[i + m * k];
      q = s->x[l] + (w->lost_q[l] + h * q);
      p = w->p[l] + (w->lost_p[l] + h * p);
      x[l] = q;
      w->lost_q[l] = q - x[l];
      w->p[l] = p;
      w->lost_p[l] = p - w->p[l];
    }
}

/* the speeds at the end from the momenta, these on the constraints */
static int
put_on (gs_run *s, gs_momenta *w, double t, double *x)
{
  int n = w->n, m = w->m;
  double *u = x + n, *rows = w->rows;
  if (! mass_at (s, w, t, x, w->masses))
    return -1;
  memcpy (u, w->p, sizeof (double) * n);
  forward (n, w->masses, u);
  backward (n, w->masses, u);
  if (m == 0)
    return 0;
  if (constraints_at (s, w, t, x, w->phi, rows) != 0)
    return -1;
  factorize (w, rows, w->masses);
  for (int k = 0; k < m; k++)
    {
      w->phi[k] = w->phit[k];
      for (int j = 0; j < n; j++)
        w->phi[k] += rows[k + m * j] * u[j];
    }
  solve_rows (w, w->phi);
  for (int j = 0; j < n; j++)
    {
      longer sum = 0;
      for (int k = 0; k < m; k++)
        sum += (longer) rows[k + m * j] * w->phi[k];
      sum = w->p[j] + (w->lost_p[j] - sum);
      w->p[j] = sum;
      w->lost_p[j] = sum - w->p[j];
      u[j] = w->p[j];
    }
  forward (n, w->masses, u);
  backward (n, w->masses, u);
  return 0;
}

/* ------------------------------------------------------------
 * whole turns */

static const longer turn_ = 6.283185307179586476925286766559005768L;

/* do A and B say the same, of a coordinate as far as FAR? */
static int
same_numbers (int n, const double *a, const double *b, double bound, double far)
{
  for (int i = 0; i < n; i++)
    bound = fmax (bound, fabs (a[i]));
  for (int i = 0; i < n; i++)
    if (! (fabs (a[i] - b[i]) <= bound * (1e-12 + 1e-14 * far)))
      return 0;
  return 1;
}

/* do efforts and constraints at the state X say the same where coordinates are TURNS farther? */
static int
same_turned (gs_run *s, gs_momenta *w, double t, const double *x, const double *turns)
{
  int n = w->n, m = w->m;
  double *other = w->trial, *bias = w->pi, *rows = w->turned, far = 0, bound = 0;
  memcpy (other, x, sizeof (double) * 2 * n);
  for (int l = 0; l < n; l++)
    {
      other[l] += turn_ * turns[l];
      far = fmax (far, fabs (other[l]));
    }
  ((bia_type *) s->r->bia) (&t, x, x + n, s->v, s->r->cst, w->bias);
  ((bia_type *) s->r->bia) (&t, other, x + n, s->v, s->r->cst, bias);
  if (! same_numbers (n, w->bias, bias, w->large, far))
    return 0;
  if (m == 0)
    return 1;
  if (constraints_at (s, w, t, x, w->phi, rows) != 0
      || constraints_at (s, w, t, other, w->phi + m, rows + n * m) != 0)
    return 0;
  for (int k = 0; k < n * m; k++)
    bound = fmax (bound, fabs (rows[k]));
  return same_numbers (n * m, rows, rows + n * m, bound, far)
         && same_numbers (m, w->phi, w->phi + m, bound, far);
}

/* which coordinates are angles, of which one turn, or some, change nothing at the start */
static void
find_turning (gs_run *s, gs_momenta *w)
{
  static const int tried[] = { 1, -1, 3, -10, 100 };
  double *turns = w->old;
  for (int l = 0; l < w->n; l++)
    {
      w->turning[l] = gs_inputs_of_time (s);
      memset (turns, 0, sizeof (double) * w->n);
      for (size_t k = 0; w->turning[l] && k < sizeof tried / sizeof tried[0]; k++)
        {
          turns[l] = tried[k];
          w->turning[l] = same_turned (s, w, s->t, s->x, turns);
        }
    }
}

/* what turns on by more than half a turn in X loses a whole one */
static void
take_turns (gs_run *s, gs_momenta *w, double *x)
{
  for (int l = 0; l < w->n; l++)
    if (w->turning[l] && fabs (x[l]) > 0.51 * (double) turn_)
      {
        double turns = rint (x[l] / (double) turn_);
        longer rest = x[l] + (w->lost_q[l] - turns * turn_);
        s->turns[l] += turns;
        x[l] = rest;
        w->lost_q[l] = rest - x[l];
      }
}

/* no turns are kept apart from here on, in the state X */
static void
give_turns (gs_run *s, gs_momenta *w, double *x)
{
  for (int l = 0; l < w->n; l++)
    {
      longer whole = x[l] + (w->lost_q[l] + s->turns[l] * turn_);
      x[l] = whole;
      w->lost_q[l] = whole - x[l];
      w->turning[l] = s->turns[l] = 0;
    }
}

/* ------------------------------------------------------------
 * the method */

static int
one_step (gs_run *s, gs_momenta *w, double h, double t, double *x)
{
  int n = w->n;
  memcpy (w->before, w->p, sizeof (double) * 3 * n);
  int flag = solve (s, w, h);
  if (flag != 0)
    return flag;
  sum_up (s, w, h, x);
  w->known = 1;
  return put_on (s, w, t, x);
}

int
gs_momenta_step (gs_run *s, gs_momenta *w, double h, double t, double *x)
{
  int n = w->n, turned = 0;
  if (fabs (h - s->h) > 1e-9 * h)
    w->known = 0;
  int flag = one_step (s, w, h, t, x);
  for (int l = 0; l < n; l++)
    turned |= s->turns[l] != 0;
  if (flag == 0 && turned && ! same_turned (s, w, t, x, s->turns))
    {
      memcpy (w->p, w->before, sizeof (double) * 3 * n);   /* and what was lost */
      give_turns (s, w, s->x);
      w->known = 0;
      if ((flag = put_on (s, w, s->t, s->x)) != 0)
        return flag;
      flag = one_step (s, w, h, t, x);
    }
  if (flag == 0)
    take_turns (s, w, x);
  return flag;
}

/* ------------------------------------------------------------
 * whether, and from where */

int
gs_has_momenta (const gsmbp_run *r)
{
  int loops = r->nlam > 0;
  return r->lin && r->bia && r->mas && r->nq == r->nu && r->nx == 2 * r->nu && r->columns == 0
         && r->nu > 0 && (! loops || (r->iopt[1] == 3 && r->iopt[5] == 0));
}

gs_momenta *
gs_new_momenta (const gs_run *s, const gauss_rule *rule, const double *size)
{
  size_t n = s->r->nu, m = s->r->nlam, k = GAUSS + 1;
  gs_momenta *w = calloc (1, sizeof (gs_momenta));
  double *next = calloc (14 * n + 5 * n * n + 3 * k * n + (BEFORE + 2) * k * m + 4 * m
                         + (k + 3) * n * m + m * m, sizeof (double));
  if (! w || ! next || ! (w->order = calloc (m + n + 1, sizeof (int))))
    return free (next), free (w), NULL;
  w->turning = w->order + m;
  w->rule = rule;
  w->n = n;
  w->m = m;
  w->size = size;
  w->numbers = next;
  struct { double **place; size_t room; } parts[]
    = { { &w->p, n }, { &w->lost_q, n }, { &w->lost_p, n }, { &w->x, 2 * n }, { &w->pi, n },
        { &w->bias, n }, { &w->zero, n }, { &w->trial, 2 * n }, { &w->mass, n * n },
        { &w->masses, n * n }, { &w->B, n * n }, { &w->C, n * n }, { &w->C0, n * n },
        { &w->u, k * n }, { &w->f, k * n }, { &w->old, k * n }, { &w->force, k * m },
        { &w->past, BEFORE * k * m }, { &w->phi, k * m }, { &w->phit, m }, { &w->gamma, m },
        { &w->scale, m }, { &w->side, m }, { &w->rows, k * n * m }, { &w->solved, n * m },
        { &w->turned, 2 * n * m }, { &w->before, 3 * n }, { &w->S, m * m } };
  for (size_t i = 0; i < sizeof parts / sizeof parts[0]; next += parts[i++].room)
    *parts[i].place = next;
  return w;
}

void
gs_free_momenta (gs_momenta *w)
{
  if (! w)
    return;
  free (w->numbers);
  free (w->order);
  free (w);
}

int
gs_restart_momenta (gs_run *s, gs_momenta *w)
{
  int n = w->n;
  memset (w->lost_q, 0, sizeof (double) * n);
  memset (w->lost_p, 0, sizeof (double) * n);
  w->known = w->remembered = 0;
  w->large = 0;
  ((mas_type *) s->r->mas) (&s->t, s->x, s->r->cst, w->mass, &n);
  for (int i = 0; i < n; i++)
    {
      longer sum = 0;
      for (int j = 0; j < n; j++)
        {
          sum += (longer) w->mass[i + n * j] * s->x[n + j];
          w->large = fmax (w->large, fabs (w->mass[i + n * j]) * w->size[n + j]);
        }
      w->p[i] = sum;
      w->lost_p[i] = sum - w->p[i];
    }
  if (gs_inputs_at (s, s->t, s->x, s->v) != 0)
    return -1;
  find_turning (s, w);
  take_turns (s, w, s->x);
  memcpy (w->x, s->x, sizeof (double) * 2 * n);
  return put_on (s, w, s->t, w->x);
}

/* (dM/dt) u of LIN against differences of MAS, at the state X */
static int
same_mass (gs_run *s, gs_momenta *w, const double *x)
{
  int n = w->n;
  double e = 1e-5, t = s->t, bound = 0, gap = 0, *sum = w->f, *q = w->trial;
  memset (sum, 0, sizeof (double) * n);
  for (int side = -1; side <= 1; side += 2)
    {
      double at = t + side * e;
      for (int l = 0; l < n; l++)
        q[l] = x[l] + side * e * x[n + l];
      ((mas_type *) s->r->mas) (&at, q, s->r->cst, w->mass, &n);
      for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
          {
            sum[i] += side * w->mass[i + n * j] * x[n + j] / (2 * e);
            bound = fmax (bound, fabs (w->mass[i + n * j] * x[n + j]));
          }
    }
  if (rate_at (s, w, t, x, w->old) != 0)
    return 0;
  for (int i = 0; i < n; i++)
    {
      gap = fmax (gap, fabs (w->old[i] + w->bias[i] - sum[i]));
      bound = fmax (bound, fabs (sum[i]));
    }
  return gap <= 1e-6 * bound;
}

int
gs_agree (gs_run *s, gs_momenta *w)
{
  int n = w->n, m = w->m;
  double bound = 0, gap = 0, *x = w->x, *miss = w->pi;
  memcpy (x, s->x, sizeof (double) * 2 * n);
  for (int l = 0; l < n; l++)   /* some speeds of the usual sizes */
    x[n + l] = w->size[n + l] * (l % 2 ? -0.7 : 1) / (1 + 0.3 * l);
  if (! same_mass (s, w, x) || gs_rate (s, s->t, s->x, s->work) != 0
      || rate_at (s, w, s->t, s->x, w->f) != 0)
    return 0;
  for (int i = 0; i < n; i++)   /* M u' + B is a force of constraints */
    {
      miss[i] = w->bias[i];
      bound = fmax (bound, fabs (w->bias[i]));
      for (int j = 0; j < n; j++)
        {
          miss[i] += w->mass[i + n * j] * s->work[n + j];
          bound = fmax (bound, fabs (w->mass[i + n * j] * s->work[n + j]));
        }
      if (! (fabs (s->work[i] - s->x[n + i]) <= 1e-12 * w->size[n + i]))
        return 0;   /* no rates of the coordinates */
    }
  if (! mass_at (s, w, s->t, s->x, w->masses))
    return 0;
  if (m > 0)
    {
      if (constraints_at (s, w, s->t, s->x, w->phi, w->rows) != 0)
        return 0;
      factorize (w, w->rows, w->masses);
      memcpy (w->trial, miss, sizeof (double) * n);
      forward (n, w->masses, w->trial);
      backward (n, w->masses, w->trial);
      for (int k = 0; k < m; k++)
        {
          w->phi[k] = 0;
          for (int j = 0; j < n; j++)
            w->phi[k] += w->rows[k + m * j] * w->trial[j];
        }
      solve_rows (w, w->phi);
      add_forces (w, w->rows, -1, w->phi, miss);
    }
  for (int i = 0; i < n; i++)
    gap = fmax (gap, fabs (miss[i]));
  return gap <= 1e-8 * bound;
}

long
gs_momenta_turns (gs_momenta *w)
{
  long turns = w->turns;
  w->turns = 0;
  return turns;
}

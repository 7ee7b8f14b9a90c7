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
#include "gauss_turns.h"

int
gs_settled (gs_settling *k, double change)
{
  k->idle = change < k->least ? 0 : k->idle + 1;
  k->least = fmin (k->least, change);
  return change == 0 || (k->idle > 0 && k->least < 1e-13) || (k->idle > 4 && k->least < 1e-10);
}

/* ------------------------------------------------------------
 * one step */

/* the first guess: the polynomials of the step before, or what is known at the start */
static int
predict (gs_stepper *s, gs_momenta *w)
{
  int n = w->n, m = w->m, stages = w->rule->stages, all = n * stages;
  double *uf[2] = { w->u, w->f };
  if (! w->known)
    {
      if (rate_at (s, w, s->t, s->x, w->f) != 0)
        return -1;
      gs_copy (n, s->x + n, w->u);
      w->remembered = 0;
      gs_zero (m * stages, w->force);
    }
  for (int which = 0; which < 2; which++)
    {
      double *y = uf[which];
      gs_copy (all, y, w->old);
      for (int i = 0; i < stages; i++)
        for (int l = 0; l < n; l++)
          {
            longer sum = w->known ? 0 : w->old[l];
            for (int j = 0; w->known && j < stages; j++)
              sum += w->rule->ahead[i][j] * w->old[l + n * j];
            y[l + n * i] = (double) sum;
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
    f[k] = w->past + (ptrdiff_t) all * k;
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
correct_forces (gs_stepper *s, gs_momenta *w, double h)
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
          w->x[l] = (double) (s->x[l] + (w->lost_q[l] + h * sum));
        }
      if (constraints_at (s, w, s->t + (double) rule->at[k + 1] * h, w->x, w->phi + m * k,
                          w->rows + n * m * (k + 1)) != 0)
        return -1;
      solve_rows (&w->gram, w->phi + m * k);
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
stage (gs_stepper *s, gs_momenta *w, int i, double h, double *change)
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
      w->x[l] = (double) (s->x[l] + (w->lost_q[l] + h * q));
      w->pi[l] = (double) (w->p[l] + (w->lost_p[l] + h * p));
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
  gs_copy (n, w->f + n * i, w->pi);
  if (rate_at (s, w, t, w->x, w->f + n * i) != 0)
    return -1;
  for (int l = 0; l < n; l++)
    *change = fmax (*change, h * fabs (w->pi[l] - w->f[l + n * i]) / w->large);
  return 0;
}

/* the stages; 0, a flag, GS_NO_END */
static int
solve (gs_stepper *s, gs_momenta *w, double h)
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
sum_up (gs_stepper *s, gs_momenta *w, double h, double *x)
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
      gs_round_off (s->x[l] + (w->lost_q[l] + h * q), &x[l], &w->lost_q[l]);
      gs_round_off (w->p[l] + (w->lost_p[l] + h * p), &w->p[l], &w->lost_p[l]);
    }
}

/* what a step finds of its start, X at T: masses, the gradients of the constraints */
static int
place_at (gs_stepper *s, gs_momenta *w, double t, const double *x)
{
  if (! mass_at (s, w, t, x, w->masses))
    return -1;
  if (w->m == 0)
    return 0;
  if (constraints_at (s, w, t, x, w->phi, w->rows) != 0)
    return -1;
  factorize_rows (&w->gram, w->rows, w->masses);
  return 0;
}

/* the speeds at the end from the momenta, these on the constraints */
static int
put_on (gs_stepper *s, gs_momenta *w, double t, double *x)
{
  int n = w->n, m = w->m;
  double *u = x + n, *rows = w->rows;
  if (place_at (s, w, t, x) != 0)
    return -1;
  gs_copy (n, w->p, u);
  forward (n, w->masses, u);
  backward (n, w->masses, u);
  if (m == 0)
    return 0;
  for (int k = 0; k < m; k++)
    {
      w->phi[k] = w->phit[k];
      for (int j = 0; j < n; j++)
        w->phi[k] += rows[k + m * j] * u[j];
    }
  solve_rows (&w->gram, w->phi);
  for (int j = 0; j < n; j++)
    {
      longer sum = 0;
      for (int k = 0; k < m; k++)
        sum += (longer) rows[k + m * j] * w->phi[k];
      gs_round_off (w->p[j] + (w->lost_p[j] - sum), &w->p[j], &w->lost_p[j]);
      u[j] = w->p[j];
    }
  forward (n, w->masses, u);
  backward (n, w->masses, u);
  return 0;
}

/* ------------------------------------------------------------
 * the method */

static int
one_step (gs_stepper *s, gs_momenta *w, double h, double t, double *x)
{
  int n = w->n;
  gs_copy (3 * n, w->p, w->before);
  int flag = solve (s, w, h);
  if (flag != 0)
    return flag;
  sum_up (s, w, h, x);
  w->known = 1;
  return put_on (s, w, t, x);
}

int
gs_momenta_step (gs_stepper *s, gs_momenta *w, double h, double t, double *x)
{
  int n = w->n, turned = 0;
  if (fabs (h - s->h) > 1e-9 * h)
    w->known = 0;
  int flag = one_step (s, w, h, t, x);
  for (int l = 0; l < n; l++)
    turned |= s->turns[l] != 0;
  if (flag == 0 && turned && ! same_turned (s, w, t, x, s->turns))
    {
      if ((flag = gs_take_back (s, w)) != 0)
        return flag;
      give_turns (s, w, s->x);
      if ((flag = put_on (s, w, s->t, s->x)) != 0)
        return flag;
      flag = one_step (s, w, h, t, x);
    }
  if (flag == 0)
    take_turns (s, w, x);
  return flag;
}

int
gs_take_back (gs_stepper *s, gs_momenta *w)
{
  gs_copy (3 * w->n, w->before, w->p);   /* and what was lost */
  w->known = 0;
  return place_at (s, w, s->t, s->x);
}

int
gs_momenta_between (gs_stepper *s, gs_momenta *w, const double *start, longer at, double *x)
{
  longer b[GAUSS], v[GAUSS + 2];
  int n = w->n, stages = w->rule->stages;
  gsmbp_gauss_weights (w->rule, at, b);
  gsmbp_gauss_values (w->rule, at, v);
  for (int l = 0; l < n; l++)
    {
      longer q = 0, u = v[0] * start[n + l] + v[stages + 1] * s->y[n + l];
      for (int j = 0; j < stages; j++)
        {
          q += b[j] * w->u[l + n * j];
          u += v[j + 1] * w->u[l + n * j];
        }
      x[l] = (double) (start[l] + s->h * q);
      x[n + l] = (double) u;
    }
  return 0;
}

/* ------------------------------------------------------------
 * whether, and from where */

int
gs_has_momenta (const gs_stepper *s)
{
  const gs_scene *scene = s->scene;
  const int *iopt = s->r->iopt;
  return scene->lin && scene->bia && scene->mas && scene->nq == scene->nu
         && s->r->nx == 2 * scene->nu && s->o->columns == 0 && scene->nu > 0 && ! gs_has_ports (s)
         && (scene->nlam == 0 || (iopt[GS_LOOPS] == 3 && iopt[GS_ON_SPEEDS] == 0));
}

gs_momenta *
gs_new_momenta (const gs_stepper *s, const gauss_rule *rule, const double *size)
{
  const ptrdiff_t n = s->scene->nu, m = s->scene->nlam, k = GAUSS + 1;
  gs_momenta *w = gs_allocate (1, sizeof (gs_momenta));
  double *next = gs_allocate (14 * n + 5 * n * n + 3 * k * n + (BEFORE + 2) * k * m + 5 * m
                         + (k + 3) * n * m + m * m, sizeof (double));
  int *order = gs_allocate (m + n + 1, sizeof (int));
  double *gram;
  if (! w || ! next || ! order)
    return free (order), free (next), free (w), NULL;
  w->turning = order + m;
  w->rule = rule;
  w->n = s->scene->nu;
  w->m = s->scene->nlam;
  w->size = size;
  w->numbers = next;
  struct { double **place; ptrdiff_t room; } parts[]
    = { { &w->p, n }, { &w->lost_q, n }, { &w->lost_p, n }, { &w->x, 2 * n }, { &w->pi, n },
        { &w->bias, n }, { &w->zero, n }, { &w->trial, 2 * n }, { &w->mass, n * n },
        { &w->masses, n * n }, { &w->B, n * n }, { &w->C, n * n }, { &w->C0, n * n },
        { &w->u, k * n }, { &w->f, k * n }, { &w->old, k * n }, { &w->force, k * m },
        { &w->past, BEFORE * k * m }, { &w->phi, k * m }, { &w->phit, m }, { &w->gamma, m },
        { &w->rows, k * n * m }, { &w->turned, 2 * n * m }, { &w->before, 3 * n },
        { &gram, rows_room (n, m) } };
  for (size_t i = 0; i < sizeof parts / sizeof parts[0]; next += parts[i++].room)
    *parts[i].place = next;
  place_rows (&w->gram, w->n, w->m, order, gram);
  return w;
}

void
gs_free_momenta (gs_momenta *w)
{
  if (! w)
    return;
  free (w->numbers);
  free (w->gram.order);
  free (w);
}

int
gs_restart_momenta (gs_stepper *s, gs_momenta *w)
{
  int n = w->n;
  gs_zero (n, w->lost_q);
  gs_zero (n, w->lost_p);
  w->known = w->remembered = 0;
  w->large = 0;
  s->scene->mas (s->t, s->x, s->r->cst, w->mass, n);
  for (int i = 0; i < n; i++)
    {
      longer sum = 0;
      for (int j = 0; j < n; j++)
        {
          sum += (longer) w->mass[i + n * j] * s->x[n + j];
          w->large = fmax (w->large, fabs (w->mass[i + n * j]) * w->size[n + j]);
        }
      gs_round_off (sum, &w->p[i], &w->lost_p[i]);
    }
  if (gs_inputs_at (s, s->t, s->x, s->v) != 0)
    return -1;
  find_turning (s, w);
  take_turns (s, w, s->x);
  gs_copy (2 * n, s->x, w->x);
  return put_on (s, w, s->t, w->x);
}

/* (dM/dt) u of LIN against differences of MAS, at the state X */
static int
same_mass (gs_stepper *s, gs_momenta *w, const double *x)
{
  int n = w->n;
  double e = 1e-5, t = s->t, bound = 0, gap = 0, *sum = w->f, *q = w->trial;
  gs_zero (n, sum);
  for (int side = -1; side <= 1; side += 2)
    {
      double at = t + side * e;
      for (int l = 0; l < n; l++)
        q[l] = x[l] + side * e * x[n + l];
      s->scene->mas (at, q, s->r->cst, w->mass, n);
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

/* what M u' + B at T and X under the inputs V is beside a force of the constraints, into MISS; XD:
   the rates there.  BOUND: how large its terms are; 0 or a flag */
static int
forces_missed (gs_stepper *s, gs_momenta *w, double t, const double *x, const double *v,
               const double *xd, double *miss, double *bound)
{
  int n = w->n, m = w->m;
  *bound = 0;
  s->scene->bia (t, x, x + n, v, s->r->cst, w->bias);
  s->scene->mas (t, x, s->r->cst, w->mass, n);
  for (int i = 0; i < n; i++)
    {
      miss[i] = w->bias[i];
      *bound = fmax (*bound, fabs (w->bias[i]));
      for (int j = 0; j < n; j++)
        {
          miss[i] += w->mass[i + n * j] * xd[n + j];
          *bound = fmax (*bound, fabs (w->mass[i + n * j] * xd[n + j]));
        }
    }
  if (! mass_at (s, w, t, x, w->masses))
    return -1;
  if (m == 0)
    return 0;
  if (constraints_at (s, w, t, x, w->phi, w->rows) != 0)
    return -1;
  factorize_rows (&w->gram, w->rows, w->masses);
  gs_copy (n, miss, w->trial);
  forward (n, w->masses, w->trial);
  backward (n, w->masses, w->trial);
  for (int k = 0; k < m; k++)
    {
      w->phi[k] = 0;
      for (int j = 0; j < n; j++)
        w->phi[k] += w->rows[k + m * j] * w->trial[j];
    }
  solve_rows (&w->gram, w->phi);
  add_forces (w, w->rows, -1, w->phi, miss);
  return 0;
}

/* is it one, and are the speeds the rates of the coordinates? */
static int
same_forces (gs_stepper *s, gs_momenta *w, double t, const double *x, const double *v,
             const double *xd)
{
  int n = w->n;
  double bound, gap = 0, *miss = w->pi;
  for (int i = 0; i < n; i++)
    if (! (fabs (xd[i] - x[n + i]) <= 1e-12 * w->size[n + i]))
      return 0;
  if (forces_missed (s, w, t, x, v, xd, miss, &bound) != 0)
    return 0;
  for (int i = 0; i < n; i++)
    gap = fabs (miss[i]) <= gap ? gap : fabs (miss[i]);   /* what is no number stays */
  return gap <= 1e-8 * bound;
}

/* The same elsewhere, for forces that vanish at the start: at the end of the run, in a state beside
   the start, under other inputs. */
static int
same_elsewhere (gs_stepper *s, gs_momenta *w)
{
  const gs_integration *r = s->r;
  int n = w->n;
  double t = r->tout[r->nt - 1], *x = w->x, *v = s->dv;
  for (int l = 0; l < n; l++)
    {
      x[l] = s->x[l] + 1e-3 * w->size[l] / (1 + 0.3 * l);
      x[n + l] = s->x[n + l] + 1e-3 * w->size[n + l] * (l % 2 ? -0.7 : 1) / (1 + 0.3 * l);
    }
  for (int k = 0; k < s->scene->nv; k++)
    v[k] = s->v[k] + (1 + fabs (s->v[k])) / (1 + 0.3 * k);
  int info = s->scene->rhs (t, x, v, r->cst, s->work);
  return (info == 0 || info == 2 || info == 3) && same_forces (s, w, t, x, v, s->work);
}

int
gs_agree (gs_stepper *s, gs_momenta *w)
{
  int n = w->n;
  double *x = w->x;
  gs_copy (2 * n, s->x, x);
  for (int l = 0; l < n; l++)   /* some speeds of the usual sizes */
    x[n + l] = w->size[n + l] * (l % 2 ? -0.7 : 1) / (1 + 0.3 * l);
  return same_mass (s, w, x) && gs_rate (s, s->t, s->x, s->work) == 0
         && rate_at (s, w, s->t, s->x, w->f) == 0
         && same_forces (s, w, s->t, s->x, s->v, s->work) && same_elsewhere (s, w);
}

int
gs_momenta_turns (gs_momenta *w)
{
  int turns = w->turns;
  w->turns = 0;
  return turns;
}

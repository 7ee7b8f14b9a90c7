/* eliminate.c: host/collocation/eliminate.h: a program of which two blocks of two unknowns are
 * taken out, by its derivatives: those of what is left beside differences, multipliers of the whole
 * program by the condition of an optimum; programs that must stay as they are. The solver of the
 * test looks at what it gets. A line for each check. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/collocation/eliminate.h"

enum { N = 7, M = 6, LEFT = 3, EQUATIONS = 2, LOWER = N * (N + 1) / 2 };

/* unknowns: x0, x1, a0, b0, a1, b1, T; of each block k: 2 a + b x_k - sin x_k + a^3 and
 * b + 0.3 a T + x_k T - 1; two more equations */
static void
equations (const double *z, double *g)
{
  for (int k = 0; k < 2; k++)
    {
      const double x = z[k], a = z[2 + 2 * k], b = z[3 + 2 * k], T = z[6];
      g[2 * k] = 2 * a + b * x - sin (x) + a * a * a;
      g[2 * k + 1] = b + 0.3 * a * T + x * T - 1;
    }
  g[4] = z[2] * z[1] + z[0] * z[5] + z[6];
  g[5] = z[1] * z[4] * z[6] + z[3] * z[2];
}

static double
goal (const double *z)
{
  return z[2] * z[2] + z[3] * z[6] + z[0] * z[5] + z[4] * z[5] * z[1] + z[6] * z[6];
}

/* factor times the goal plus lambda times the equations */
static double
lagrangian (const double *z, double factor, const double *lambda)
{
  double g[M], sum = factor * goal (z);
  equations (z, g);
  for (int i = 0; i < M; i++)
    sum += lambda[i] * g[i];
  return sum;
}

/* differences of order 4; of which: 0 the goal, 1 to M an equation, M + 1 the lagrangian */
static double
value (const double *z, int which, double factor, const double *lambda)
{
  double g[M];
  equations (z, g);
  return which == 0 ? goal (z) : which <= M ? g[which - 1] : lagrangian (z, factor, lambda);
}
static double
slope (const double *z, int j, int which, double factor, const double *lambda)
{
  static const double at[] = { -2, -1, 1, 2 }, by[] = { 1, -8, 8, -1 };
  const double h = 1e-3;
  double y[N], sum = 0;
  for (int k = 0; k < 4; k++)
    {
      memcpy (y, z, sizeof y);
      y[j] += at[k] * h;
      sum += by[k] * value (y, which, factor, lambda) / (12 * h);
    }
  return sum;
}
static double
second (const double *z, int i, int j, double factor, const double *lambda)
{
  static const double at[] = { -2, -1, 1, 2 }, by[] = { 1, -8, 8, -1 };
  const double h = 1e-3;
  double y[N], sum = 0;
  for (int k = 0; k < 4; k++)
    {
      memcpy (y, z, sizeof y);
      y[i] += at[k] * h;
      sum += by[k] * slope (y, j, M + 1, factor, lambda) / (12 * h);
    }
  return sum;
}

static int jac_rows[2 * M * N], jac_columns[2 * M * N], njac;
static int hess_rows[LOWER], hess_columns[LOWER], nhess;

static int
evaluate (void *data, int part, const double *z, double factor, const double *lambda, double *out)
{
  (void)data;
  if (part == GS_GOAL)
    *out = goal (z);
  else if (part == GS_EQUATIONS)
    equations (z, out);
  for (int j = 0; j < N && part == GS_GRADIENT; j++)
    out[j] = slope (z, j, 0, 1, NULL);
  for (int k = 0; k < njac && part == GS_JACOBIAN; k++)   /* each in two parts */
    out[k] = slope (z, jac_columns[k], jac_rows[k] + 1, 1, NULL) / 2;
  for (int k = 0; k < nhess && part == GS_HESSIAN; k++)
    out[k] = second (z, hess_rows[k], hess_columns[k], factor, lambda);
  return 1;
}

/* the block of an unknown, -1: none */
static int
block (int j)
{
  return j >= 2 && j < 6 ? (j - 2) / 2 : -1;
}

static void
lay (int across)
{
  njac = nhess = 0;
  for (int i = 0; i < M; i++)
    for (int j = 0; j < N; j++)
      for (int twice = 0; twice < 2; twice++)
        if (i >= 4 || block (j) == i / 2 || j == i / 2 || j == 6)
          {
            jac_rows[njac] = i;
            jac_columns[njac++] = j;
          }
  for (int i = 0; i < N; i++)
    for (int j = 0; j <= i; j++)
      if (across || block (i) < 0 || block (j) < 0 || block (i) == block (j))
        {
          hess_rows[nhess] = i;
          hess_columns[nhess++] = j;
        }
}

/* --------------------------------------------------------------------------- what is looked at */

static void
check (const char *what, int true_)
{
  printf ("%sok %s\n", true_ ? "" : "not ", what);
}
static void
small (const char *what, double error, double most)
{
  printf ("%sok %s: %.1e (at most %.0e)\n", error <= most ? "" : "not ", what, error, most);
}

/* of what is left: a part at x moved along unknown j */
static void
moved (const gs_nlp *p, int part, const double *x, int j, double by, double *out)
{
  double y[N];
  memcpy (y, x, sizeof (double) * (size_t)p->n);
  y[j] += by;
  p->evaluate (p->data, part, y, 1, NULL, out);
}

/* the gradient of the lagrangian of what is left */
static void
whole_gradient (const gs_nlp *p, const double *x, double factor, const double *lambda, double *out)
{
  double jac[200];
  p->evaluate (p->data, GS_GRADIENT, x, 1, NULL, out);
  p->evaluate (p->data, GS_JACOBIAN, x, 1, NULL, jac);
  for (int j = 0; j < p->n; j++)
    out[j] *= factor;
  for (int k = 0; k < p->jacobian; k++)
    out[p->jac_columns[k]] += lambda[p->jac_rows[k]] * jac[k];
}

static void
look (const gs_nlp *p)
{
  static const double at[] = { -2, -1, 1, 2 }, by[] = { 1, -8, 8, -1 };
  const double x[] = { 0.4, -0.7, 0.9 }, lambda[] = { 0.6, -1.3 }, h = 1e-3;
  double values[200], found[LEFT][LEFT], e0 = 0, e1 = 0, e2 = 0;
  for (int j = 0; j < LEFT; j++)
    {
      double gradient[LEFT] = { 0 }, rows[EQUATIONS] = { 0 }, second_[LEFT] = { 0 }, part[N];
      for (int k = 0; k < 4; k++)
        {
          double y[LEFT];
          moved (p, GS_GOAL, x, j, at[k] * h, part);
          gradient[j] += by[k] * part[0] / (12 * h);
          moved (p, GS_EQUATIONS, x, j, at[k] * h, part);
          for (int i = 0; i < EQUATIONS; i++)
            rows[i] += by[k] * part[i] / (12 * h);
          memcpy (y, x, sizeof y);
          y[j] += at[k] * h;
          whole_gradient (p, y, 0.8, lambda, part);
          for (int i = 0; i < LEFT; i++)
            second_[i] += by[k] * part[i] / (12 * h);
        }
      p->evaluate (p->data, GS_GRADIENT, x, 1, NULL, values);
      e0 = fmax (e0, fabs (values[j] - gradient[j]));
      p->evaluate (p->data, GS_JACOBIAN, x, 1, NULL, values);
      for (int k = 0; k < p->jacobian; k++)
        if (p->jac_columns[k] == j)
          rows[p->jac_rows[k]] -= values[k];
      e1 = fmax (e1, fmax (fabs (rows[0]), fabs (rows[1])));
      memset (found, 0, sizeof found);
      p->evaluate (p->data, GS_HESSIAN, x, 0.8, lambda, values);
      for (int k = 0; k < p->hessian; k++)
        {
          found[p->hess_rows[k]][p->hess_columns[k]] += values[k];
          if (p->hess_rows[k] != p->hess_columns[k])
            found[p->hess_columns[k]][p->hess_rows[k]] += values[k];
        }
      for (int i = 0; i < LEFT; i++)
        e2 = fmax (e2, fabs (found[i][j] - second_[i]));
    }
  small ("the gradient of what is left beside differences", e0, 1e-9);
  small ("... the Jacobian", e1, 1e-9);
  small ("... the Hessian", e2, 1e-7);
}

static int got;

static int
solver (const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r)
{
  const double x[] = { 0.4, -0.7, 0.9 };
  (void)o;
  got = p->n;
  if (p->n != LEFT)
    return 0;
  look (p);
  for (int j = 0; j < LEFT; j++)
    {
      r->x[j] = x[j];
      r->zl[j] = 0.1 + j;
      r->zu[j] = 0.2 + j;
    }
  r->lambda[0] = 0.5;
  r->lambda[1] = -0.25;
  return 0;
}

int
main (void)
{
  double x0[N] = { 0.1, 0.2, 0, 0, 0, 0, 1 }, low[N], high[N], zero[M] = { 0 };
  double x[N], zl[N], zu[N], g[M], lambda[M], worst = 0;
  for (int j = 0; j < N; j++)
    {
      low[j] = -INFINITY;
      high[j] = INFINITY;
    }
  lay (0);
  gs_nlp p = { N, M, x0, low, high, zero, zero, njac, nhess, jac_rows, jac_columns, hess_rows,
               hess_columns, NULL, evaluate };
  const gs_determined d = { 2, 2, 2, 2, 0, 2 };
  const gs_nlp_options o = { 0 };
  gs_nlp_result r = { .x = x, .zl = zl, .zu = zu, .g = g, .lambda = lambda };
  check ("a program without what is determined is solved",
         gs_solve_eliminated (solver, &p, &d, &o, &r) == 0 && got == LEFT);
  for (int i = 0; i < 4; i++)
    worst = fmax (worst, fabs (g[i]));
  small ("the whole result: the equations that were taken out", worst, 1e-13);
  worst = 0;
  for (int j = 2; j < 6; j++)
    worst = fmax (worst, fabs (slope (x, j, M + 1, 1, lambda)));
  small ("... their multipliers: the derivatives by their unknowns vanish", worst, 1e-9);
  check ("... the others as the solver has them", x[0] == 0.4 && x[1] == -0.7 && x[6] == 0.9
         && lambda[4] == 0.5 && lambda[5] == -0.25 && zl[1] == 1.1 && zu[6] == 2.2 && zl[3] == 0);
  lay (1);
  p.hessian = nhess;
  gs_solve_eliminated (solver, &p, &d, &o, &r);
  check ("unknowns of two blocks in one second derivative: the whole program", got == N);
  lay (0);
  p.hessian = nhess;
  low[3] = -5;
  gs_solve_eliminated (solver, &p, &d, &o, &r);
  check ("an unknown with bounds: the whole program", got == N);
  low[3] = -INFINITY;
  high[6] = low[6] = x0[6] = 0;
  gs_solve_eliminated (solver, &p, &d, &o, &r);
  check ("... one of the others may have them", got == LEFT);
  return 0;
}

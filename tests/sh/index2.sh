# The stages of radau_index2.c of share/engine/host/implicit on a point on a circle that grows,
# with a mass matrix that depends on its place: what the defects say of multipliers and speeds, the
# matrix of Newton's method.
. tests/tools/check.sh
work_folder

cat >"$work/stages.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
#include "radau_index2.h"

enum { Q = 2, M = 2, ALL = 5 };   /* two coordinates, a state of a device; a row twice */

int gs_own_states (const gs_stepper *s) { return s->r->nx; }

/* q1^2 + q2^2 = 1 + t/10, twice */
static int
con (double t, const double *q, const double *u, const double *cst, double *phi, double *phit,
     double *hc, int ldh, double *gam)
{
  (void) u, (void) cst, (void) gam;
  for (int k = 0; k < M; k++)
    {
      phi[k] = (k + 1) * (q[0] * q[0] + q[1] * q[1] - 1 - t / 10);
      phit[k] = (k + 1) * -0.1;
      for (int j = 0; j < Q; j++)
        hc[k + ldh * j] = (k + 1) * 2 * q[j];
    }
  return 0;
}

static void
mas (double t, const double *q, const double *cst, double *m, int ldm)
{
  (void) t, (void) cst;
  m[0] = 2 + q[0] * q[0], m[1] = m[ldm] = 0.3 * q[1], m[1 + ldm] = 1 + q[1] * q[1];
}

static void
tan_ (double t, const double *x, const double *cst, double *dp, int ldp, double *dv, int ldv)
{
  (void) t, (void) cst;
  for (int k = 0; k < M; k++)
    for (int j = 0; j < Q; j++)
      dp[k + ldp * j] = (k + 1) * 2 * x[j], dv[k + ldv * j] = (k + 1) * 2 * x[Q + j];
}

static double
some (void)
{
  return rand () / (double) RAND_MAX - 0.5;
}

/* the speeds of the states X miss this much */
static double
missed (const double *x)
{
  return 2 * (x[0] * x[Q] + x[1] * x[Q + 1]) - 0.1;
}

/* M D across H: zero where D is of a multiplier */
static double
not_a_force (const double *x, const double *d)
{
  double m[Q * Q];
  mas (0, x, NULL, m, Q);
  return (m[0] * d[0] + m[Q] * d[1]) * x[1] - (m[1] * d[0] + m[1 + Q] * d[1]) * x[0];
}

/* G of stages at some states against what index 2 says */
static double
defects (gs_stepper *s, gs_index2 *w, const radau_rule *rule)
{
  double x[STAGES][ALL], g[STAGES * ALL], before[STAGES * ALL], h = 0.1, worst = 0;
  for (int i = 0; i < rule->stages; i++)
    {
      for (int l = 0; l < ALL; l++)
        x[i][l] = s->x[l] + 0.1 * some (), before[l + ALL * i] = g[l + ALL * i] = some ();
      if (gs_index2_stage (s, w, i, s->t, x[i]) != 0)
        return 1;
    }
  gs_index2_defects (w, rule, h, g, ALL);
  for (int i = 0; i < rule->stages; i++)
    {
      double *u = g + ALL * i + Q, d[Q], sum = 2 * (x[i][0] * u[0] + x[i][1] * u[1]);
      for (int j = 0; j < rule->stages; j++)
        sum += rule->inverse[i][j] / h * missed (x[j]);
      for (int l = 0; l < Q; l++)
        d[l] = u[l] - before[l + ALL * i + Q];
      worst = fmax (worst, fabs (sum));
      worst = fmax (worst, fabs (not_a_force (x[i], d)));
      for (int l = 0; l < ALL; l++)
        if (l < Q || l >= 2 * Q)
          worst = fmax (worst, fabs (g[l + ALL * i] - before[l + ALL * i]));
    }
  return worst;
}

/* (SHIFT - J) X = R with the matrix of index 2 against its equations */
static double
newton (gs_stepper *s, gs_loops *loops, gs_index2 *w)
{
  double J[ALL * ALL], A[ALL * ALL], x[ALL], r[ALL], miss[Q], shift = 7, worst = 0;
  int pivots[ALL];
  for (int k = 0; k < ALL * ALL; k++)
    A[k] = J[k] = some ();
  for (int l = 0; l < ALL; l++)
    x[l] = r[l] = some ();
  gs_index2_jacobian (s, w, J);
  for (int k = 0; k < ALL * ALL; k++)
    J[k] = (k % (ALL + 1) == 0 ? shift : 0) - J[k];
  if (gsmbp_dense_factors (ALL, J, pivots) != 0)
    return 1;
  gsmbp_dense_solve (ALL, J, pivots, x);
  gs_speeds (loops, x);
  for (int i = 0; i < ALL; i++)
    {
      double sum = shift * x[i] - r[i];
      for (int j = 0; j < ALL; j++)
        sum -= A[i + ALL * j] * x[j];
      if (i >= Q && i < 2 * Q)
        miss[i - Q] = sum;   /* a force of the constraint */
      else
        worst = fmax (worst, fabs (sum));
    }
  double rate = 0;
  for (int j = 0; j < Q; j++)
    rate += 2 * s->x[j] * (shift * x[Q + j] - r[Q + j]) + 2 * s->x[Q + j] * shift * x[j];
  return fmax (fmax (worst, fabs (rate)), fabs (not_a_force (s->x, miss)));
}

int
main (void)
{
  const gs_scene scene
      = { .nq = Q, .nu = Q, .nx = ALL, .nlam = M, .con = con, .mas = mas, .tan = tan_ };
  gs_integration r = { .nx = ALL };
  double x[ALL] = { 0.6, 0.8, -0.8, 0.6625, 3 }, worst[2] = { 0, 0 };
  gs_stepper s = { .scene = &scene, .r = &r, .x = x };
  int failed;
  gs_loops *loops = gs_new_loops (&s, &failed);
  gs_index2 *w = gs_new_index2 (loops);
  if (gs_take_loops (&s, loops) != 0)
    return 1;
  for (int stages = 3; stages <= 7; stages += 2)
    worst[0] = fmax (worst[0], defects (&s, w, gsmbp_radau_rule (stages)));
  for (int turn = 0; turn < 20; turn++)
    worst[1] = fmax (worst[1], newton (&s, loops, w));
  printf ("%s %s %d\n", worst[0] < 1e-12 ? "small" : "large", worst[1] < 1e-12 ? "small" : "large",
          loops->gram.rank);
  gs_free_index2 (w);
  gs_free_loops (loops);
  return 0;
}
END
(cd share/engine/host/implicit && gcc -std=gnu11 -O1 -fsanitize=address,undefined -Wall -Wextra \
  -Werror -I. -I../.. -I../../core -o "$work/stages" "$work/stages.c" \
  radau_index2.c settle.c radau_rule.c radau_solve.c radau_order.c -lm -lpthread) >"$report" 2>&1
told $? 'the stages compile' "$report"
"$work/stages" >"$report" 2>&1
[ "$(cat "$report")" = 'small small 1' ]
told $? 'what differs is a force, speeds are on the constraints; the matrix of Newton turns' \
  "$report"

#include <math.h>
#include <pthread.h>
#include <string.h>
#include "radau_rule.h"

typedef long double real;
typedef long double complex number;

/* polynomial of Legendre P(N) on [0, 1] at X, its derivative in *SLOPE */
static real
legendre (int n, real x, real *slope)
{
  real y = 2 * x - 1, p = 1, q = 0, dp = 0, dq = 0;
  for (int k = 0; k < n; k++)
    {
      real next = ((2 * k + 1) * y * p - k * q) / (k + 1);
      real dnext = ((2 * k + 1) * (p + y * dp) - k * dq) / (k + 1);
      q = p, dq = dp, p = next, dp = dnext;
    }
  *slope = 2 * dp;
  return p;
}

/* the zeros of P(N) - P(N-1), rising: between those of neighbours, by Newton's method with the
 * zeros that are known divided out */
static void
places (int n, real *c)
{
  for (int k = 0; k < n; k++)
    {
      real x = k == 0 ? 0.01L : c[k - 1] + 0.01L;
      for (int turn = 0; turn < 100; turn++)
        {
          real d1, d0, p = legendre (n, x, &d1) - legendre (n - 1, x, &d0), sum = 0;
          for (int j = 0; j < k; j++)
            sum += 1 / (x - c[j]);
          real step = p / (d1 - d0 - p * sum);
          x -= step;
          if (fabsl (step) < 1e-19L)
            break;
        }
      c[k] = x;
    }
  c[n - 1] = 1;
}

/* the polynomial of Lagrange that is 1 at the place J of N, at X */
static real
lagrange (int n, const real *c, int j, real x)
{
  real value = 1;
  for (int k = 0; k < n; k++)
    if (k != j)
      value *= (x - c[k]) / (c[j] - c[k]);
  return value;
}

/* its integral from 0 to X: by four points of Gauss, exact to degree seven */
static real
area (int n, const real *c, int j, real x)
{
  static const real u[2] = { 0.33998104358485626480266575910324469L,
                             0.86113631159405257522394648889280950L },
                    w[2] = { 0.65214515486254614262693605077800059L,
                             0.34785484513745385737306394922199941L };
  real sum = 0;
  for (int k = 0; k < 2; k++)
    sum += w[k] * (lagrange (n, c, j, x * (1 - u[k]) / 2) + lagrange (n, c, j, x * (1 + u[k]) / 2));
  return sum * x / 2;
}

/* A X = B of order N, pivots by columns; both are overwritten, X in B */
static void
solve (int n, number a[STAGES][STAGES], number *b)
{
  for (int k = 0; k < n; k++)
    {
      int p = k;
      for (int i = k + 1; i < n; i++)
        if (cabsl (a[i][k]) > cabsl (a[p][k]))
          p = i;
      for (int j = 0; p != k && j < n; j++)
        {
          number swap = a[k][j];
          a[k][j] = a[p][j], a[p][j] = swap;
        }
      number swap = b[k];
      b[k] = b[p], b[p] = swap;
      for (int i = k + 1; i < n; i++)
        {
          number factor = a[i][k] / a[k][k];
          for (int j = k; j < n; j++)
            a[i][j] -= factor * a[k][j];
          b[i] -= factor * b[k];
        }
    }
  for (int i = n - 1; i >= 0; i--)
    {
      for (int j = i + 1; j < n; j++)
        b[i] -= a[i][j] * b[j];
      b[i] /= a[i][i];
    }
}

/* the eigenvalue of A nearest to GUESS, its eigenvector V (TRANSPOSED: of the transpose), by
 * inverse iteration; V is 1 at its largest entry */
static number
eigenvector (int n, real a[STAGES][STAGES], int transposed, number guess, number *v)
{
  number root = guess;
  for (int i = 0; i < n; i++)
    v[i] = 1 + 0.1L * i;
  for (int turn = 0; turn < 4; turn++)
    {
      number m[STAGES][STAGES], w[STAGES], top = 0;
      memcpy (w, v, sizeof w);
      for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
          m[i][j] = (transposed ? a[j][i] : a[i][j]) - (i == j ? guess : 0);
      solve (n, m, w);
      for (int i = 0; i < n; i++)
        if (cabsl (w[i]) > cabsl (top))
          top = w[i], root = guess + v[i] / w[i];
      for (int i = 0; i < n; i++)
        v[i] = w[i] / top;
    }
  return root;
}

/* the eigenvalues of the inverse of A, one of each pair, to some digits */
static const double roots[3][2 * PAIRS + 1] = {
  { 3.6378342527445, 2.6810828736278, 3.0504301992474 },
  { 6.2867047517293, 5.7009532986718, 3.2102656003083, 3.6556943254636, 6.5437368993601 },
  { 8.9368327884052, 8.5118348251029, 3.2810136243251, 7.1410552191876, 6.6230459226393,
    4.3786935615068, 10.169693283795 }
};

/* eigenvectors of the inverse of A, LEFT times RIGHT being 1 */
static void
split (int n, real inverse[STAGES][STAGES], radau_rule *rule)
{
  const double *known = roots[(n - 3) / 2];
  for (int k = 0; k <= rule->pairs; k++)
    {
      number guess = k == 0 ? known[0] : known[2 * k - 1] + known[2 * k] * I;
      number v[STAGES], w[STAGES], product = 0, root = 0;
      eigenvector (n, inverse, 0, guess, v);
      root = eigenvector (n, inverse, 1, guess, w);
      for (int i = 0; i < n; i++)
        product += w[i] * v[i];
      for (int i = 0; i < n && k == 0; i++)
        {
          rule->right[i] = (double) creall (v[i]);
          rule->left[i] = (double) creall (w[i] / product);
        }
      for (int i = 0; i < n && k > 0; i++)
        {
          rule->rights[k - 1][i] = (double complex) v[i];
          rule->lefts[k - 1][i] = (double complex) (w[i] / product);
        }
      if (k == 0)
        rule->root = (double) creall (root);
      else
        rule->roots[k - 1] = (double complex) root;
    }
}

/* The estimate of the error: the rule of quadrature with the start among its places and the weight
 * 1/ROOT there, of order STAGES, less that of the step: in F, then in Z by the inverse of A. */
static void
estimate (int n, const real *c, real a[STAGES][STAGES], real inverse[STAGES][STAGES],
          radau_rule *rule)
{
  number m[STAGES][STAGES], b[STAGES];
  for (int q = 0; q < n; q++)
    {
      for (int j = 0; j < n; j++)
        m[q][j] = powl (c[j], q);
      b[q] = 1 / (real) (q + 1) - (q == 0 ? 1 / (real) rule->root : 0);
    }
  solve (n, m, b);
  for (int j = 0; j < n; j++)
    {
      real sum = 0;
      for (int i = 0; i < n; i++)
        sum += (creall (b[i]) - a[n - 1][i]) * inverse[i][j];
      rule->estimate[j] = (double) sum;
    }
}

static void
compute (int n, radau_rule *rule)
{
  real c[STAGES], a[STAGES][STAGES], inverse[STAGES][STAGES];
  memset (rule, 0, sizeof *rule);
  rule->stages = n;
  rule->pairs = n / 2;
  places (n, c);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      {
        a[i][j] = area (n, c, j, c[i]);
        rule->a[i][j] = (double) a[i][j];
      }
  for (int j = 0; j < n; j++)
    {
      number m[STAGES][STAGES], b[STAGES] = { 0 };
      for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
          m[i][k] = a[i][k];
      b[j] = 1;
      solve (n, m, b);
      for (int i = 0; i < n; i++)
        {
          inverse[i][j] = creall (b[i]);
          rule->inverse[i][j] = (double) inverse[i][j];
        }
      rule->c[j + 1] = (double) c[j];
    }
  split (n, inverse, rule);
  estimate (n, c, a, inverse, rule);
}

static radau_rule rules[3];
static pthread_once_t once = PTHREAD_ONCE_INIT;

static void
compute_all (void)
{
  for (int k = 0; k < 3; k++)
    compute (2 * k + 3, &rules[k]);
}

const radau_rule *
gsmbp_radau_rule (int n)
{
  pthread_once (&once, compute_all);
  return &rules[(n - 3) / 2];
}

#include <math.h>
#include <string.h>
#include "gauss_rule.h"

/* the roots of the Legendre polynomials, on [0, 1] */
static void
nodes (gauss_rule *w)
{
  if (w->stages == 2)
    w->c[1] = sqrtl (1 / 3.0L);
  else if (w->stages == 3)
    w->c[2] = sqrtl (3 / 5.0L);
  else
    {
      w->c[2] = sqrtl ((3 - 2 * sqrtl (6 / 5.0L)) / 7);
      w->c[3] = sqrtl ((3 + 2 * sqrtl (6 / 5.0L)) / 7);
    }
  for (int i = 0; i < w->stages / 2; i++)
    w->c[i] = -w->c[w->stages - 1 - i];
  if (w->stages == 3)
    w->c[1] = 0;
  for (int i = 0; i < w->stages; i++)
    w->c[i] = (1 + w->c[i]) / 2;
}

/* ... of their derivatives, with the ends */
static void
nodes_with_ends (gauss_rule *w)
{
  longer inner = w->stages == 3 ? sqrtl (1 / 5.0L) : w->stages == 4 ? sqrtl (3 / 7.0L) : 0;
  w->at[0] = 0;
  w->at[w->stages] = 1;
  if (w->stages != 3)
    w->at[w->stages / 2] = 0.5L;
  if (w->stages > 2)
    {
      w->at[1] = (1 - inner) / 2;
      w->at[w->stages - 1] = (1 + inner) / 2;
    }
}

/* coefficients of the polynomial of Lagrange of N points C that is 1 at point J, the constant
   first */
static void
lagrange (int n, const longer *c, int j, longer *p)
{
  memset (p, 0, (GAUSS + 1) * sizeof (longer));
  p[0] = 1;
  for (int k = 0; k < n; k++)
    if (k != j)
      for (int l = n - 1; l >= 0; l--)
        p[l] = ((l > 0 ? p[l - 1] : 0) - c[k] * p[l]) / (c[j] - c[k]);
}

static longer
value (int n, const longer *p, longer at)
{
  longer sum = 0;
  for (int l = n - 1; l >= 0; l--)
    sum = sum * at + p[l];
  return sum;
}

static longer
integral (int n, const longer *p, longer to)
{
  longer sum = 0;
  for (int l = n - 1; l >= 0; l--)
    sum = sum * to + p[l] / (l + 1);
  return sum * to;
}

/* the inverse of an N x N matrix whose leading minors are not zero */
static void
invert (int n, longer m[GAUSS][GAUSS], longer inverse[GAUSS][GAUSS])
{
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      inverse[i][j] = i == j;
  for (int k = 0; k < n; k++)
    {
      longer pivot = m[k][k];
      for (int j = 0; j < n; j++)
        m[k][j] /= pivot, inverse[k][j] /= pivot;
      for (int i = 0; i < n; i++)
        {
          longer factor = m[i][k];
          for (int j = 0; i != k && j < n; j++)
            m[i][j] -= factor * m[k][j], inverse[i][j] -= factor * inverse[k][j];
        }
    }
}

/* FORCE is what keeps the method symplectic: WEIGHT(k) TO(k,i) + B(i) FORCE(i,k) =
   B(i) WEIGHT(k) (Jay, Specialized partitioned additive Runge-Kutta methods for systems of
   overdetermined DAEs with holonomic constraints, SIAM J. Numer. Anal. 45, 2007). */
static void
loops (gauss_rule *w)
{
  int n = w->stages;
  longer p[GAUSS + 1], product[GAUSS][GAUSS];
  nodes_with_ends (w);
  for (int k = 0; k <= n; k++)
    {
      lagrange (n + 1, w->at, k, p);
      w->weight[k] = integral (n + 1, p, 1);
    }
  for (int i = 0; i < n; i++)
    {
      lagrange (n, w->c, i, p);
      for (int k = 0; k < n; k++)
        {
          w->to[k][i] = integral (n, p, w->at[k + 1]);
          w->force[i][k] = w->weight[k] * (1 - integral (n, p, w->at[k]) / w->b[i]);
        }
    }
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++)
      {
        product[i][k] = 0;
        for (int j = 0; j < n; j++)
          product[i][k] += w->to[i][j] * w->force[j][k];
      }
  invert (n, product, w->back);
}

void
gsmbp_gauss_rule (gauss_rule *w, int order)
{
  longer p[GAUSS + 1];
  int n = w->stages = order / 2;
  nodes (w);
  for (int j = 0; j < n; j++)
    {
      lagrange (n, w->c, j, p);
      w->b[j] = integral (n, p, 1);
      for (int i = 0; i < n; i++)
        {
          w->a[i][j] = integral (n, p, w->c[i]);
          w->ahead[i][j] = value (n, p, 1 + w->c[i]);
        }
    }
  loops (w);
}

void
gsmbp_gauss_weights (const gauss_rule *w, longer at, longer *b)
{
  longer p[GAUSS + 1];
  for (int j = 0; j < w->stages; j++)
    {
      lagrange (w->stages, w->c, j, p);
      b[j] = integral (w->stages, p, at);
    }
}

void
gsmbp_gauss_values (const gauss_rule *w, longer at, longer *b)
{
  longer c[GAUSS + 2] = { 0 };
  int n = w->stages + 2;
  for (int j = 0; j < w->stages; j++)
    c[j + 1] = w->c[j];
  c[n - 1] = 1;
  for (int j = 0; j < n; j++)
    {
      b[j] = 1;
      for (int k = 0; k < n; k++)
        b[j] *= k == j ? 1 : (at - c[k]) / (c[j] - c[k]);
    }
}

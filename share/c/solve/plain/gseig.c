#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

#include <math.h>

int
gseig (int n, double *a, int lda, double *wr, double *wi, double *w)
{
  gshes (n, a, lda, w);
  return gshqr (n, a, lda, wr, wi);
}

/* the reflection v of the rows below k (from 0) of column k and its length; 0 if they are zero */
static double
reflection (int n, int k, const double *a, int lda, double *v)
{
  double s = 0.0, t = 0.0;
  for (int i = k + 1; i < n; i++)
    s = gs_max (s, fabs (a[i + lda * k]));
  if (! (s > 0.0))
    return 0.0;
  for (int i = k + 1; i < n; i++)
    {
      v[i] = a[i + lda * k] / s;
      t = t + v[i] * v[i];
    }
  t = copysign (sqrt (t), v[k + 1]);
  v[k + 1] = v[k + 1] + t;
  return t * v[k + 1];
}

/* Householder reflections from both sides */
void
gshes (int n, double *a, int lda, double *v)
{
  for (int k = 0; k < n - 2; k++)
    {
      double h = reflection (n, k, a, lda, v);
      if (! (h > 0.0))
        continue;
      for (int j = k; j < n; j++)
        {
          double *col = a + lda * j, t = gs_dot (n - k - 1, 0.0, v + k + 1, col + k + 1);
          for (int i = k + 1; i < n; i++)
            col[i] = col[i] - v[i] * (t / h);
        }
      for (int i = 0; i < n; i++)
        {
          double t = 0.0;
          for (int j = k + 1; j < n; j++)
            t = t + a[i + lda * j] * v[j];
          for (int j = k + 1; j < n; j++)
            a[i + lda * j] = a[i + lda * j] - v[j] * (t / h);
        }
      for (int i = k + 2; i < n; i++)
        a[i + lda * k] = 0.0;
    }
}

/* the last row l (from 0) up to en with a small subdiagonal element before it */
static int
block (const double *a, int lda, int en, double eps)
{
  int l = en;
  for (; l > 0; l--)
    {
      double z = fabs (a[l - 1 + lda * (l - 1)]) + fabs (a[l + lda * l]);
      if (z <= 0.0)
        z = 1e-300;
      if (fabs (a[l + lda * (l - 1)]) <= eps * z)
        break;
    }
  return l;
}

/* the two eigenvalues of rows en-1 and en, shifted by t; b: the entry (en-1,en-1) */
static void
two (const double *b, int lda, double t, double *wr, double *wi)
{
  double x = b[1 + lda], y = b[0], z = b[1] * b[lda];
  double p = 0.5 * (y - x), q = p * p + z;
  z = sqrt (fabs (q));
  if (q >= 0.0)
    p = p + copysign (z, p);
  wr[0] = wr[1] = x + t + p;
  wi[0] = q >= 0.0 ? 0.0 : z;
  wi[1] = q >= 0.0 ? 0.0 : -z;
  if (q >= 0.0 && fabs (p) > 0.0)
    wr[1] = x + t - b[1] * b[lda] / p;
}

/* a double step on rows l to en, every tenth with an exceptional shift; t: the shifts so far */
static void
step (int n, double *a, int lda, int l, int en, int its, double *t)
{
  const double *b = a + en - 1 + lda * (en - 1);
  double x = b[1 + lda], y = b[0], z = b[1] * b[lda];
  if (its % 10 == 0)
    {
      *t = *t + x;
      for (int i = 0; i <= en; i++)
        a[i + lda * i] = a[i + lda * i] - x;
      x = 0.75 * (fabs (b[1]) + fabs (a[en - 1 + lda * (en - 2)]));
      y = x;
      z = -0.4375 * x * x;
    }
  gshqs (n, a, lda, l + 1, en + 1, x, y, z);
}

/* from the last row on; at most 60 steps an eigenvalue */
int
gshqr (int n, double *a, int lda, double *wr, double *wi)
{
  double eps = gseps (), t = 0.0;
  for (int en = n - 1, its = 0; en >= 0;)
    {
      int l = block (a, lda, en, eps);
      if (l < en - 1)
        {
          if (its >= 60)
            return en + 1;
          step (n, a, lda, l, en, ++its, &t);
          continue;
        }
      if (l == en)
        {
          wr[en] = a[en + lda * en] + t;
          wi[en] = 0.0;
        }
      else
        two (a + l + lda * l, lda, t, wr + l, wi + l);
      en = l - 1;
      its = 0;
    }
  return 0;
}

/* the row where the step begins, counted from 1, and p, q, r of its first column in c */
static int
beginning (const double *a, int lda, int l, int en, double x, double y, double z, double *c)
{
  int m = en - 2;
  for (;; m--)
    {
      const double *d = a + (m - 1) * (lda + 1);
      double u = d[0], r = x - u, s = y - u;
      double p = (r * s - z) / d[1] + d[lda];
      double q = d[1 + lda] - u - r - s;
      r = d[2 + lda];
      s = fabs (p) + fabs (q) + fabs (r);
      c[0] = p / s;
      c[1] = q / s;
      c[2] = r / s;
      if (m == l)
        return m;
      double f = fabs (d[-lda]) * (fabs (c[1]) + fabs (c[2]));
      double g = fabs (c[0]) * (fabs (d[-lda - 1]) + fabs (u) + fabs (d[1 + lda]));
      if (f <= 2e-16 * g)
        return m;
    }
}

/* rows and columns k to k+2 (from 1; to k+1 where k = en-1) by the reflection u, v, w, q, r */
static void
reflect (int n, double *a, int lda, int k, int en, const double *h)
{
  const double u = h[0], v = h[1], w = h[2], q = h[3], r = h[4];
  const int three = k < en - 1, last = gs_least (k + 3, en);
  for (int j = k - 1; j < n; j++)
    {
      double *e = a + k - 1 + lda * j, f = e[0] + q * e[1];
      if (three)
        {
          f = f + r * e[2];
          e[2] = e[2] - f * w;
        }
      e[1] = e[1] - f * v;
      e[0] = e[0] - f * u;
    }
  for (int i = 0; i < last; i++)
    {
      double *e = a + i + lda * (k - 1), f = u * e[0] + v * e[lda];
      if (three)
        {
          f = f + w * e[2 * lda];
          e[2 * lda] = e[2 * lda] - f * r;
        }
      e[lda] = e[lda] - f * q;
      e[0] = e[0] - f;
    }
}

/* the size of the column c of the bulge in row k (from 1) behind its first one, which is divided by
 * it */
static double
bulge (const double *e, int three, double *c)
{
  c[0] = e[0];
  c[1] = e[1];
  c[2] = three ? e[2] : 0.0;
  double u = fabs (c[0]) + fabs (c[1]) + fabs (c[2]);
  for (int i = 0; i < 3 && ! (u <= 0.0); i++)
    c[i] = c[i] / u;
  return u;
}

/* the first column of the step, then the bulge is chased down */
void
gshqs (int n, double *a, int lda, int l, int en, double x, double y, double z)
{
  double c[3];
  const int m = beginning (a, lda, l, en, x, y, z, c);
  for (int i = m + 2; i <= en; i++)
    {
      a[i - 1 + lda * (i - 3)] = 0.0;
      if (i > m + 2)
        a[i - 1 + lda * (i - 4)] = 0.0;
    }
  for (int k = m; k < en; k++)
    {
      double *e = a + k - 1 + lda * (k - 2), u = 1.0;
      if (k > m)
        {
          u = bulge (e, k < en - 1, c);
          if (u <= 0.0)
            continue;
        }
      double s = copysign (sqrt (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]), c[0]);
      if (k > m)
        e[0] = -s * u;
      else if (l != m)
        e[0] = -e[0];
      double p = c[0] + s;
      reflect (n, a, lda, k, en, (double[]){ p / s, c[1] / s, c[2] / s, c[1] / p, c[2] / p });
    }
}

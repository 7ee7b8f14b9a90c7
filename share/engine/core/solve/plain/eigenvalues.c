#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

int
gs_eigenvalues (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi, gs_real *w)
{
  gs_hessenberg (n, a, lda, w);
  return gs_hessenberg_eigenvalues (n, a, lda, wr, wi);
}

/* the reflection v of the rows below k (from 0) of column k and its length; 0 if they are zero */
static gs_real
reflection (int n, int k, const gs_real *a, int lda, gs_real *v)
{
  gs_real s = 0, t = 0;
  for (int i = k + 1; i < n; i++)
    s = gs_max (s, gs_abs (a[i + lda * k]));
  if (! (s > 0))
    return 0;
  for (int i = k + 1; i < n; i++)
    {
      v[i] = a[i + lda * k] / s;
      t = t + v[i] * v[i];
    }
  t = gs_copysign (gs_sqrt (t), v[k + 1]);
  v[k + 1] = v[k + 1] + t;
  return t * v[k + 1];
}

/* Householder reflections from both sides */
void
gs_hessenberg (int n, gs_real *a, int lda, gs_real *v)
{
  for (int k = 0; k < n - 2; k++)
    {
      gs_real h = reflection (n, k, a, lda, v);
      if (! (h > 0))
        continue;
      for (int j = k; j < n; j++)
        {
          gs_real *col = a + lda * j, t = gs_dot (n - k - 1, 0, v + k + 1, col + k + 1);
          for (int i = k + 1; i < n; i++)
            col[i] = col[i] - v[i] * (t / h);
        }
      for (int i = 0; i < n; i++)
        {
          gs_real t = 0;
          for (int j = k + 1; j < n; j++)
            t = t + a[i + lda * j] * v[j];
          for (int j = k + 1; j < n; j++)
            a[i + lda * j] = a[i + lda * j] - v[j] * (t / h);
        }
      for (int i = k + 2; i < n; i++)
        a[i + lda * k] = 0;
    }
}

/* the last row l (from 0) up to en with a small subdiagonal element before it */
static int
block (const gs_real *a, int lda, int en, gs_real eps)
{
  int l = en;
  for (; l > 0; l--)
    {
      gs_real z = gs_abs (a[l - 1 + lda * (l - 1)]) + gs_abs (a[l + lda * l]);
      if (z <= 0)
        z = GS_TINY;
      if (gs_abs (a[l + lda * (l - 1)]) <= eps * z)
        break;
    }
  return l;
}

/* the two eigenvalues of rows en-1 and en, shifted by t; b: the entry (en-1,en-1) */
static void
two (const gs_real *b, int lda, gs_real t, gs_real *wr, gs_real *wi)
{
  gs_real x = b[1 + lda], y = b[0], z = b[1] * b[lda];
  gs_real p = GS_R (0.5) * (y - x), q = p * p + z;
  z = gs_sqrt (gs_abs (q));
  if (q >= 0)
    p = p + gs_copysign (z, p);
  wr[0] = wr[1] = x + t + p;
  wi[0] = q >= 0 ? 0 : z;
  wi[1] = q >= 0 ? 0 : -z;
  if (q >= 0 && gs_abs (p) > 0)
    wr[1] = x + t - b[1] * b[lda] / p;
}

/* a double step on rows l to en, every tenth with an exceptional shift; t: the shifts so far */
static void
step (int n, gs_real *a, int lda, int l, int en, int its, gs_real *t)
{
  const gs_real *b = a + en - 1 + lda * (en - 1);
  gs_real x = b[1 + lda], y = b[0], z = b[1] * b[lda];
  if (its % 10 == 0)
    {
      *t = *t + x;
      for (int i = 0; i <= en; i++)
        a[i + lda * i] = a[i + lda * i] - x;
      x = GS_R (0.75) * (gs_abs (b[1]) + gs_abs (a[en - 1 + lda * (en - 2)]));
      y = x;
      z = -GS_R (0.4375) * x * x;
    }
  gs_hessenberg_step (n, a, lda, l + 1, en + 1, x, y, z);
}

/* from the last row on; at most 60 steps an eigenvalue */
int
gs_hessenberg_eigenvalues (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi)
{
  gs_real eps = gs_epsilon (), t = 0;
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
          wi[en] = 0;
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
beginning (const gs_real *a, int lda, int l, int en, gs_real x, gs_real y, gs_real z, gs_real *c)
{
  int m = en - 2;
  for (;; m--)
    {
      const gs_real *d = a + (m - 1) * (lda + 1);
      gs_real u = d[0], r = x - u, s = y - u;
      gs_real p = (r * s - z) / d[1] + d[lda];
      gs_real q = d[1 + lda] - u - r - s;
      r = d[2 + lda];
      s = gs_abs (p) + gs_abs (q) + gs_abs (r);
      c[0] = p / s;
      c[1] = q / s;
      c[2] = r / s;
      if (m == l)
        return m;
      gs_real f = gs_abs (d[-lda]) * (gs_abs (c[1]) + gs_abs (c[2]));
      gs_real g = gs_abs (c[0]) * (gs_abs (d[-lda - 1]) + gs_abs (u) + gs_abs (d[1 + lda]));
      if (f <= GS_R2 (2e-16, 1e-7) * g)
        return m;
    }
}

/* rows and columns k to k+2 (from 1; to k+1 where k = en-1) by the reflection u, v, w, q, r */
static void
reflect (int n, gs_real *a, int lda, int k, int en, const gs_real *h)
{
  const gs_real u = h[0], v = h[1], w = h[2], q = h[3], r = h[4];
  const int three = k < en - 1, last = gs_least (k + 3, en);
  for (int j = k - 1; j < n; j++)
    {
      gs_real *e = a + k - 1 + lda * j, f = e[0] + q * e[1];
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
      gs_real *e = a + i + lda * (k - 1), f = u * e[0] + v * e[lda];
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
static gs_real
bulge (const gs_real *e, int three, gs_real *c)
{
  c[0] = e[0];
  c[1] = e[1];
  c[2] = three ? e[2] : 0;
  gs_real u = gs_abs (c[0]) + gs_abs (c[1]) + gs_abs (c[2]);
  for (int i = 0; i < 3 && ! (u <= 0); i++)
    c[i] = c[i] / u;
  return u;
}

/* the first column of the step, then the bulge is chased down */
void
gs_hessenberg_step (int n, gs_real *a, int lda, int l, int en, gs_real x, gs_real y, gs_real z)
{
  gs_real c[3];
  const int m = beginning (a, lda, l, en, x, y, z, c);
  for (int i = m + 2; i <= en; i++)
    {
      a[i - 1 + lda * (i - 3)] = 0;
      if (i > m + 2)
        a[i - 1 + lda * (i - 4)] = 0;
    }
  for (int k = m; k < en; k++)
    {
      gs_real *e = a + k - 1 + lda * (k - 2), u = 1;
      if (k > m)
        {
          u = bulge (e, k < en - 1, c);
          if (u <= 0)
            continue;
        }
      gs_real s = gs_copysign (gs_sqrt (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]), c[0]);
      if (k > m)
        e[0] = -s * u;
      else if (l != m)
        e[0] = -e[0];
      gs_real p = c[0] + s;
      reflect (n, a, lda, k, en, (gs_real[]){ p / s, c[1] / s, c[2] / s, c[1] / p, c[2] / p });
    }
}

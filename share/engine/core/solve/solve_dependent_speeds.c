#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* what the helpers share: A with rows and columns in the order of piv, r of them dependent; C lies
 * in the columns of dh behind r */
typedef struct
{
  int n, m, r;
  const gs_real *a;
  int lda;
  gs_real *e, *dh, *piv;
} kane;

/* entry (i,j) of A in the order of piv */
static gs_real
mass (const kane *s, int i, int j)
{
  int k = (int)s->piv[i] - 1, l = (int)s->piv[j] - 1;
  return s->a[gs_most (k, l) + s->lda * gs_least (k, l)];
}

/* entry (i,j) of C: how the dependent speed i follows from the independent one j */
static gs_real
follows (const kane *s, int i, int j)
{
  return s->dh[i + s->m * (s->r + j)];
}

/* x := inv(R1)*x, or -inv(R1)*x */
static void
upper (const kane *s, int negative, gs_real *x)
{
  for (int i = s->r - 1; i >= 0; i--)
    {
      gs_real t = negative ? -x[i] : x[i];
      for (int k = i + 1; k < s->r; k++)
        t -= s->dh[i + s->m * k] * x[k];
      x[i] = t / s->dh[i + s->m * i];
    }
}

/* e = A11*C + A12 (r by n-r); c = f - A*(d,0) in the order of piv */
static void
forces (const kane *s, const gs_real *f, const gs_real *d, gs_real *c)
{
  for (int j = 0; j < s->n - s->r; j++)
    for (int i = 0; i < s->r; i++)
      {
        gs_real t = mass (s, i, s->r + j);
        for (int k = 0; k < s->r; k++)
          t += mass (s, i, k) * follows (s, k, j);
        s->e[i + s->n * j] = t;
      }
  for (int i = 0; i < s->n; i++)
    {
      gs_real t = f[(int)s->piv[i] - 1];
      for (int k = 0; k < s->r; k++)
        t -= mass (s, i, k) * d[k];
      c[i] = t;
    }
}

/* the reduced equations: A22 + C'*e + A12'*C in b, c2 + C'*c1 in the rows of c from r on */
static void
reduce (const kane *s, gs_real *b, gs_real *c)
{
  int n = s->n, r = s->r;
  for (int j = 0; j < n - r; j++)
    {
      for (int i = j; i < n - r; i++)
        {
          gs_real t = mass (s, r + i, r + j);
          for (int k = 0; k < r; k++)
            t = t + follows (s, k, i) * s->e[k + n * j] + mass (s, r + i, k) * follows (s, k, j);
          b[r + i + n * (r + j)] = t;
        }
      for (int k = 0; k < r; k++)
        c[r + j] += follows (s, k, j) * c[k];
    }
}

/* ud from d and the independent ones, in c from r on */
static void
speeds (const kane *s, const gs_real *d, const gs_real *c, gs_real *ud)
{
  for (int i = 0; i < s->n; i++)
    {
      gs_real t = i < s->r ? d[i] : c[i];
      if (i < s->r)
        for (int j = 0; j < s->n - s->r; j++)
          t += follows (s, i, j) * c[s->r + j];
      ud[(int)s->piv[i] - 1] = t;
    }
}

/* lam = inv(R1')*(A*ud - f)1, what acts on the dependent speeds */
static void
reactions (const kane *s, const gs_real *c, gs_real *lam)
{
  for (int i = 0; i < s->r; i++)
    {
      gs_real t = -c[i];
      for (int j = 0; j < s->n - s->r; j++)
        t += s->e[i + s->n * j] * c[s->r + j];
      for (int k = 0; k < i; k++)
        t -= s->dh[k + s->m * i] * lam[k];
      lam[i] = t / s->dh[i + s->m * i];
    }
}

/* D*H*P = Q*(R1,R2) (D scales the rows, columns are chosen by size); the first r speeds depend on
 * the others: ud1 = d + C*ud2, C = -inv(R1)*R2, d = inv(R1)*Q1'*D*g. The partial velocities of the
 * others are those of Kane's equations:
 *    (C'*A11*C + C'*A12 + A21*C + A22)*ud2 = f2 + C'*f1 - (A21 + C'*A11)*d,
 * lam = D*Q1*inv(R1')*(A*ud - f)1 if the rank is full. */
int
gs_solve_dependent_speeds (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                           const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                           gs_real *ud, gs_real *lam, gs_real *w)
{
  gs_real *e = w + n * n, *dh = e + n * n, *beta = dh + n * m, *piv = beta + n, *siz = piv + n,
         *c = siz + n, *scale = c + n, *d = scale + m;
  int r;
  gs_scaled_rows (n, m, h, ldh, grp, dh, scale);
  for (int k = 0; k < m; k++)
    d[k] = scale[k] * g[k];
  gs_qr_columns (m, n, dh, m, tol, piv, beta, siz, &r);
  gs_qr_times (m, r, dh, m, beta, d, 1);

  kane s = { n, m, r, a, lda, e, dh, piv };
  for (int j = r; j < n; j++)
    upper (&s, 1, dh + m * j);
  upper (&s, 0, d);
  forces (&s, f, d, c);
  reduce (&s, w, c);
  if (gs_solve_reduced (n, r, a, lda, w, c) != 0)
    return 1;
  speeds (&s, d, c, ud);
  if (r < m)
    {
      gs_least_multipliers (n, m, a, lda, h, ldh, f, tol, grp, ud, lam, w);
      return 2;
    }
  reactions (&s, c, lam);
  gs_qr_times (m, r, dh, m, beta, lam, 0);
  for (int k = 0; k < m; k++)
    lam[k] *= scale[k];
  return 0;
}

/* gs_rates_with_columns: the rates of states and, behind them, of their derivatives by parameters:
   S' = A*S + P. */
#include "gsmbp/integrate.h"

int
gs_rates_with_columns (const gs_scene *s, gs_real t, int ntop, int np, int nc, const int *col,
                       const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *w,
                       gs_real *xd)
{
  const int n = s->nx;
  gs_real *const wp = w + n * n, *const wb = wp + n * np, *const zeros = wb + n * s->nv;
  const gs_real *p[4];
  const int info = s->rhp (t, x, v, cst, wp, n, w, n, wb, n, xd);
  if (info != 0)
    return info == 2 ? 9 : info;
  for (int i = 0; i < n; i++) /* for start values */
    zeros[i] = 0;
  for (int k = 0; k < nc; k++)
    {
      p[k % 4] = col[k] == 0 ? zeros : wp + n * (col[k] - 1);
      if (k % 4 == 3)
        gs_columns_times_four (ntop, n, w, p[0], p[1], p[2], p[3], x + n * (k - 2),
                               xd + n * (k - 2));
      else if (k >= nc - nc % 4)
        gs_columns_times_one (ntop, n, w, p[k % 4], x + n * (k + 1), xd + n * (k + 1));
    }
  return 0;
}

void
gs_columns_times_four (int ntop, int n, const gs_real *a, const gs_real *p1, const gs_real *p2,
                       const gs_real *p3, const gs_real *p4, const gs_real *y, gs_real *r)
{
  const gs_real *y1 = y, *y2 = y1 + n, *y3 = y2 + n, *y4 = y3 + n;
  gs_real *r1 = r, *r2 = r1 + n, *r3 = r2 + n, *r4 = r3 + n;
  for (int i = 0; i < ntop; i++)
    {
      r1[i] = p1[i] + y1[ntop + i];
      r2[i] = p2[i] + y2[ntop + i];
      r3[i] = p3[i] + y3[ntop + i];
      r4[i] = p4[i] + y4[ntop + i];
    }
  for (int i = ntop; i < n; i++)
    {
      gs_real s1 = p1[i], s2 = p2[i], s3 = p3[i], s4 = p4[i];
      for (int j = 0; j < n; j++)
        {
          const gs_real e = a[i + n * j];
          s1 += e * y1[j];
          s2 += e * y2[j];
          s3 += e * y3[j];
          s4 += e * y4[j];
        }
      r1[i] = s1;
      r2[i] = s2;
      r3[i] = s3;
      r4[i] = s4;
    }
}

void
gs_columns_times_one (int ntop, int n, const gs_real *a, const gs_real *p, const gs_real *y,
                      gs_real *r)
{
  for (int i = 0; i < ntop; i++)
    r[i] = p[i] + y[ntop + i];
  for (int i = ntop; i < n; i++)
    {
      gs_real s = p[i];
      for (int j = 0; j < n; j++)
        s += a[i + n * j] * y[j];
      r[i] = s;
    }
}

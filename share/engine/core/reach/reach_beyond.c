#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <string.h>

/* the squared length of e */
static gs_real
squared_length (const gs_real *e)
{
  return e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
}

/* the damped step s of least squares: (j'j + mu) s = j'e */
static void
step (int n, const gs_real *j, const gs_real *e, gs_real mu, gs_real *s)
{
  gs_real a[9];
  for (int i = 0; i < n; i++)
    {
      const gs_real *ji = j + 3 * i;
      s[i] = gs_dot (3, 0, ji, e);
      for (int l = 0; l < n; l++)
        a[l + 3 * i] = j[3 * l] * ji[0] + j[3 * l + 1] * ji[1] + j[3 * l + 2] * ji[2];
      a[i + 3 * i] = a[i + 3 * i] + mu;
    }
  (void)gs_solve_spd (n, 1, a, 3, s, 3);
}

/* the least square near the guess q, by Levenberg and Marquardt, at most 1000 steps */
static gs_real
closest (gs_ikc *ikc, int n, const gs_real *p, const gs_real *r, const gs_real *qg,
         const gs_real *cst, gs_real *q)
{
  gs_real qn[3] = { 0 }, e[3], en[3], j[9] = { 0 }, jn[9] = { 0 }, s[3], mu = GS_R (1e-4);
  ikc (p, r, qg, cst, q, e, j);
  gs_real f = squared_length (e);
  for (int it = 0; it < 1000; it++)
    {
      step (n, j, e, mu, s);
      for (int i = 0; i < n; i++)
        qn[i] = q[i] + s[i];
      ikc (p, r, qg, cst, qn, en, jn);
      gs_real fn = squared_length (en);
      if (fn < f)
        {
          mu = gs_max (GS_R (0.1) * mu, GS_R (1e-15));
          gs_copy (n, qn, q);
          memcpy (e, en, sizeof e);
          gs_copy (3 * n, jn, j);
          f = fn;
          continue;
        }
      mu = 10 * mu;
      if (mu > GS_R (1e6))
        break;
    }
  return f;
}

void
gs_reach_beyond (gs_ikc *ikc, int n, int nc, int nb, int at, const gs_real *p, const gs_real *r,
                 const gs_real *qg, const gs_real *cst, const gs_real *qc, gs_real *dst)
{
  gs_real q[3];
  *dst = -1;
  for (int k = 0; k < nb; k++)
    {
      for (int i = 0; i < n; i++)
        q[i] = qc[at + i + nc * k];
      gs_real f = closest (ikc, n, p, r, qg, cst, q);
      if (*dst < 0 || f < *dst)
        *dst = f;
    }
  *dst = gs_sqrt (gs_max (*dst, 0));
}

#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <string.h>

/* the length of e (3) */
static gs_real
length (const gs_real *e)
{
  return gs_sqrt (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
}

/* least squares from every guess */
void
gs_reach_closest (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                  const gs_real *p, const gs_real *x0, int nb, const gs_real *qc, gs_real *dst)
{
  gs_real px[18], d[3], q[6], e[6], f, least = -1;
  for (int i = 0; i < 3; i++)
    {
      d[i] = r[i] * x0[0] + r[i + 3] * x0[1] + r[i + 6] * x0[2] + p[i] - x0[i];
      for (int j = 0; j < 6; j++)
        px[i + 3 * j] = pa[i + 3 * j] - x0[i];
    }
  for (int k = 1; k <= (nb == 0 ? 8 : nb); k++)
    {
      for (int i = 0; i < 6; i++)
        q[i] = nb == 0 ? GS_R (1.1) * (gs_real)(k * (2 * i + 3) % 7 - 3) : qc[i + 6 * (k - 1)];
      gs_reach_closest_near (kind, ka, px, r, d, q, e, &f);
      if (! (least < 0 || f < least))
        continue;
      least = f;
      dst[0] = length (e);
      dst[1] = length (e + 3);
    }
}

/* the damped step s: (j'j + mu) s = j'e */
static void
step (const gs_real *j, const gs_real *e, gs_real mu, gs_real *s)
{
  gs_real a[36];
  for (int i = 0; i < 6; i++)
    {
      s[i] = gs_dot (6, 0, j + 6 * i, e);
      for (int k = 0; k < 6; k++)
        a[k + 6 * i] = gs_dot (6, 0, j + 6 * k, j + 6 * i);
      a[i + 6 * i] = a[i + 6 * i] + mu;
    }
  (void)gs_solve_spd (6, 1, a, 6, s, 6);
}

/* Levenberg and Marquardt, at most 100 steps */
void
gs_reach_closest_near (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                       const gs_real *p, gs_real *q, gs_real *e, gs_real *f)
{
  gs_real j[36], jn[36], en[6], qn[6], s[6], miss, mu = GS_R (1e-4);
  gs_arm_missed (kind, ka, pa, r, p, q, j, e, &miss);
  *f = gs_dot (6, 0, e, e);
  for (int it = 0; it < 100; it++)
    {
      step (j, e, mu, s);
      for (int i = 0; i < 6; i++)
        qn[i] = q[i] + s[i];
      gs_arm_missed (kind, ka, pa, r, p, qn, jn, en, &miss);
      gs_real fn = gs_dot (6, 0, en, en);
      if (fn < *f)
        {
          mu = gs_max (GS_R (0.1) * mu, GS_R (1e-15));
          memcpy (q, qn, sizeof qn);
          memcpy (e, en, sizeof en);
          memcpy (j, jn, sizeof jn);
          *f = fn;
          continue;
        }
      mu = 10 * mu;
      if (mu > GS_R (1e6))
        return;
    }
}

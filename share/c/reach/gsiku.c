#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

/* the length of e (3) */
static double
length (const double *e)
{
  return sqrt (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
}

/* least squares from every guess */
void
gsiku (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *x0, int nb, const double *qc, double *dst)
{
  double px[18], d[3], q[6], e[6], f, least = -1.0;
  for (int i = 0; i < 3; i++)
    {
      d[i] = r[i] * x0[0] + r[i + 3] * x0[1] + r[i + 6] * x0[2] + p[i] - x0[i];
      for (int j = 0; j < 6; j++)
        px[i + 3 * j] = pa[i + 3 * j] - x0[i];
    }
  for (int k = 1; k <= (nb == 0 ? 8 : nb); k++)
    {
      for (int i = 0; i < 6; i++)
        q[i] = nb == 0 ? 1.1 * (k * (2 * i + 3) % 7 - 3) : qc[i + 6 * (k - 1)];
      gsiky (kind, ka, px, r, d, q, e, &f);
      if (! (least < 0.0 || f < least))
        continue;
      least = f;
      dst[0] = length (e);
      dst[1] = length (e + 3);
    }
}

/* the damped step s: (j'j + mu) s = j'e */
static void
step (const double *j, const double *e, double mu, double *s)
{
  double a[36];
  for (int i = 0; i < 6; i++)
    {
      s[i] = gs_dot (6, 0.0, j + 6 * i, e);
      for (int k = 0; k < 6; k++)
        a[k + 6 * i] = gs_dot (6, 0.0, j + 6 * k, j + 6 * i);
      a[i + 6 * i] = a[i + 6 * i] + mu;
    }
  (void)gsspd (6, 1, a, 6, s, 6);
}

/* Levenberg and Marquardt, at most 100 steps */
void
gsiky (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       double *q, double *e, double *f)
{
  double j[36], jn[36], en[6], qn[6], s[6], miss, mu = 1e-4;
  gsikj (kind, ka, pa, r, p, q, j, e, &miss);
  *f = gs_dot (6, 0.0, e, e);
  for (int it = 0; it < 100; it++)
    {
      step (j, e, mu, s);
      for (int i = 0; i < 6; i++)
        qn[i] = q[i] + s[i];
      gsikj (kind, ka, pa, r, p, qn, jn, en, &miss);
      double fn = gs_dot (6, 0.0, en, en);
      if (fn < *f)
        {
          mu = gs_max (0.1 * mu, 1e-15);
          memcpy (q, qn, sizeof qn);
          memcpy (e, en, sizeof en);
          memcpy (j, jn, sizeof jn);
          *f = fn;
          continue;
        }
      mu = 10.0 * mu;
      if (mu > 1e6)
        return;
    }
}

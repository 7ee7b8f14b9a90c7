/* GSCLO. Positions: Newton's method on the dependent coordinates, at most 60 steps, until |phi|
 * falls no more (below 1e-11) or is 0; above 1e-9 at the end the loops do not close. Derivatives of
 * order 1, 2, ...: the same linear system with other right sides. */
#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

int
gsclo (const gs_scene *s, double t, double *qj, int r, const int *id, const int *ia,
       const double *cst, double *res, double *w, int *iw)
{
  const int nu = s->nu, m = s->nlam;
  double *const h = w + m * m, *const p = h + m * nu, *const pt = p + m, *const g = pt + m,
         *const q = g + m, *const u = q + nu;
  int info = gsclq (s, t, qj, id, cst, res, w, h, p, pt, g, q, u, iw);
  return info != 0 ? info : gscld (s, t, qj, r, id, ia, cst, w, h, p, pt, g, q, u, iw);
}

int
gsclq (const gs_scene *s, double t, double *qj, const int *id, const double *cst, double *res,
       double *m, double *h, double *p, double *pt, double *g, double *q, double *u, int *iw)
{
  double old = 0.0;
  for (int k = 1; k <= 60; k++)
    {
      int info = gsclc (s, t, qj, cst, q, u, p, pt, h, g);
      if (info != 0)
        return info;
      *res = 0.0;
      for (int i = 0; i < s->nlam; i++)
        *res = gs_max (*res, fabs (p[i]));
      if (*res <= 0.0 || (k > 2 && *res >= old && *res <= 1e-11))
        return 0;
      old = *res;
      info = gscls (s->nlam, id, h, m, p, iw);
      if (info != 0)
        return info;
      for (int i = 0; i < s->nlam; i++)
        qj[id[i] - 1] -= p[i];
    }
  return *res > 1e-9 ? 2 : 0;
}

/* of order k from HC_dep*x_dep = right - HC_ind*x_ind */
int
gscld (const gs_scene *s, double t, double *qj, int r, const int *id, const int *ia,
       const double *cst, double *m, double *h, double *p, double *pt, double *g, double *q,
       double *u, int *iw)
{
  const int nu = s->nu, nlam = s->nlam;
  for (int k = 1; k <= r; k++)
    {
      double *const qk = qj + nu * k;
      int info = 0;
      if (k <= 2)
        info = gsclc (s, t, qj, cst, q, u, p, pt, h, g);
      if (info != 0)
        return info;
      if (k == 3)
        s->gad (t, qj, cst, g);
      for (int i = 0; i < nlam; i++)
        {
          p[i] = k == 1 ? -pt[i] : g[i];
          for (int j = 0; j < nu - nlam; j++)
            p[i] -= h[i + nlam * (ia[j] - 1)] * qk[ia[j] - 1];
        }
      info = gscls (nlam, id, h, m, p, iw);
      if (info != 0)
        return info;
      for (int i = 0; i < nlam; i++)
        qk[id[i] - 1] = p[i];
    }
  return 0;
}

int
gsclc (const gs_scene *s, double t, const double *qj, const double *cst, double *q, double *u,
       double *p, double *pt, double *h, double *g)
{
  memcpy (q, qj, s->nu * sizeof (double));
  memcpy (u, qj + s->nu, s->nu * sizeof (double));
  return s->con (t, q, u, cst, p, pt, h, s->nlam, g);
}

int
gscls (int nlam, const int *id, const double *h, double *m, double *p, int *iw)
{
  for (int j = 0; j < nlam; j++)
    memcpy (m + nlam * j, h + nlam * (id[j] - 1), nlam * sizeof (double));
  return gsleq (nlam, 1, m, nlam, p, nlam, iw) != 0;
}

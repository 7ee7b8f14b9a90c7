#include "controllers.h"

#include <math.h>

#include "gsmbp/solve.h"

/* axes r (3,3) turned by the rotation vector w, and their rate of turn om when it changes at wd */
static void
turned (const double *w, const double *wd, double *r, double *om)
{
  double x = sqrt (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), s, c, b;
  if (x > 1.0e-2)
    {
      double h = sin (0.5 * x) / x;
      s = sin (x) / x;
      c = 2.0 * (h * h);
      b = (1.0 - s) / (x * x);
    }
  else
    {
      double x2 = x * x;
      s = 1.0 - x2 / 6.0 * (1.0 - x2 / 20.0);
      c = 0.5 - x2 / 24.0 * (1.0 - x2 / 30.0);
      b = 1.0 / 6.0 - x2 / 120.0 * (1.0 - x2 / 42.0);
    }
  for (int i = 0; i < 3; i++)
    {
      for (int j = 0; j < 3; j++)
        r[i + 3 * j] = c * w[i] * w[j];
      r[i + 3 * i] = r[i + 3 * i] + 1.0 - c * (x * x);
    }
  for (int i = 0; i < 3; i++)
    {
      int j = (i + 1) % 3, k = (i + 2) % 3;
      r[k + 3 * j] += s * w[i];
      r[j + 3 * k] -= s * w[i];
    }
  double wx[] = { w[1] * wd[2] - w[2] * wd[1], w[2] * wd[0] - w[0] * wd[2],
                  w[0] * wd[1] - w[1] * wd[0] };
  double ww[] = { w[1] * wx[2] - w[2] * wx[1], w[2] * wx[0] - w[0] * wx[2],
                  w[0] * wx[1] - w[1] * wx[0] };
  for (int i = 0; i < 3; i++)
    om[i] = wd[i] + c * wx[i] + b * ww[i];
}

/* rotation vector w of the axes r: Euler parameters from the largest of four (Shepperd) */
static void
vector_of (const double *r, double *w)
{
  double s = r[0] + r[4] + r[8], b;
  int i = 0;
  if (r[4] > r[4 * i])
    i = 1;
  if (r[8] > r[4 * i])
    i = 2;
  int j = (i + 1) % 3, k = (j + 1) % 3;
  if (s >= r[4 * i])
    {
      s = sqrt (fmax (1.0 + s, 0.0));
      w[0] = (r[2 + 3 * 1] - r[1 + 3 * 2]) / s;
      w[1] = (r[0 + 3 * 2] - r[2 + 3 * 0]) / s;
      w[2] = (r[1 + 3 * 0] - r[0 + 3 * 1]) / s;
    }
  else
    {
      b = sqrt (fmax (1.0 + r[4 * i] - r[4 * j] - r[4 * k], 0.0));
      s = (r[k + 3 * j] - r[j + 3 * k]) / b;
      w[i] = b;
      w[j] = (r[j + 3 * i] + r[i + 3 * j]) / b;
      w[k] = (r[k + 3 * i] + r[i + 3 * k]) / b;
      for (int l = 0; l < 3 && s < 0.0; l++)
        w[l] = -w[l];
      s = fabs (s);
    }
  b = sqrt (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  double f = b > 1.0e-8 ? 2.0 * atan2 (b, s) / b : 1.0;
  for (int l = 0; l < 3; l++)
    w[l] = f * w[l];
}

/* two vectors w (6) from ground into the axes r, and back */
static void
into (const double *r, double *w)
{
  for (int k = 0; k < 6; k += 3)
    {
      double a[3];
      for (int i = 0; i < 3; i++)
        a[i] = r[3 * i] * w[k] + r[1 + 3 * i] * w[k + 1] + r[2 + 3 * i] * w[k + 2];
      for (int i = 0; i < 3; i++)
        w[k + i] = a[i];
    }
}
static void
back (const double *r, double *w)
{
  for (int k = 0; k < 6; k += 3)
    {
      double a[3];
      for (int i = 0; i < 3; i++)
        a[i] = r[i] * w[k] + r[i + 3] * w[k + 1] + r[i + 6] * w[k + 2];
      for (int i = 0; i < 3; i++)
        w[k + i] = a[i];
    }
}

/* force and moment w (6) of the springs and dampers on the tool at p with the axes r, in ground */
static void
wrench (const gs_machine *m, const gs_tool *tool, const double *p, const double *r,
        const double *jp, const double *u, double *w)
{
  double e[6], ed[6], rw[9], re[9];
  turned (tool->pr + 3, tool->pdr + 3, rw, ed + 3);
  for (int i = 0; i < 3; i++)
    {
      e[i] = tool->pr[i] - p[i];
      ed[i] = tool->pdr[i];
      for (int j = 0; j < 3; j++)
        re[i + 3 * j] = rw[i] * r[j] + rw[i + 3] * r[j + 3] + rw[i + 6] * r[j + 6];
    }
  vector_of (re, e + 3);
  for (int i = 0; i < 6; i++)
    for (int l = 0; l < m->n; l++)
      ed[i] = ed[i] - jp[i + 6 * l] * u[l];
  if (tool->in_tool)
    {
      into (r, e);
      into (r, ed);
    }
  for (int i = 0; i < 6; i++)
    {
      w[i] = 0.0;
      for (int j = 0; j < 6; j++)
        w[i] = w[i] + tool->k[i + 6 * j] * e[j] + tool->d[i + 6 * j] * ed[j];
    }
  if (tool->in_tool)
    back (r, w);
}

/* The wrench on the independent speeds, as accelerations by their mass matrix. */
int
gscim (const gs_machine *m, const gs_sample *s, const gs_tool *tool, double *qg, double *a,
       double *qj, double *wj, double *mt, double *tr, double *mr, double *p, double *r,
       double *jp, double *dju, double *v, int *iw)
{
  int n = m->n, na = m->na, at = tool->ip - 1;
  double w[6];
  for (int i = 0; i < na; i++)
    a[i] = 0.0;
  int info = gsmot (m, s->t, s->q, s->u, a, qg, qj);
  if (info == 0)
    info = gsmor (m, s->t, qj, wj, mt, tr, mr);
  if (info != 0)
    return info;
  m->points (s->t, qj, m->cst, p, r);
  m->jacobians (s->t, qj, qj + n, m->cst, jp, dju);
  const double *own = jp + 6 * n * at;
  wrench (m, tool, p + 3 * at, r + 9 * at, own, qj + n, w);
  for (int i = 0; i < na; i++)
    a[i] = -tool->dq[i] * s->u[i];
  for (int l = 0; l < n; l++)
    {
      double f = 0.0;
      for (int j = 0; j < 6; j++)
        f = f + own[j + 6 * l] * w[j];
      for (int i = 0; i < na; i++)
        a[i] = a[i] + tr[l + n * i] * f;
    }
  info = gs_solve_general (na, 1, mr, na, a, na, iw);
  if (info == 0)
    info = gsmot (m, s->t, s->q, s->u, a, qg, qj);
  return info != 0 ? info : m->command (s->t, qj, m->cst, v);
}

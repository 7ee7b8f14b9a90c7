#include "controllers.h"

/* The loops closed around the independent coordinates. */
int
gsmot (const gs_machine *m, double t, const double *q, const double *u, const double *a,
       double *qg, double *qj)
{
  int n = m->n;
  for (int i = 0; i < n; i++)
    {
      qj[i] = qg[i];
      for (int j = 1; j <= m->order; j++)
        qj[i + n * j] = 0.0;
    }
  for (int i = 0; i < m->na; i++)
    {
      int k = m->independent[i] - 1;
      qj[k] = q[i];
      qj[k + n] = u[i];
      qj[k + 2 * n] = a[i];
    }
  int info = m->closure (t, qj, m->cst);
  for (int i = 0; i < n && info == 0; i++)
    qg[i] = qj[i];
  return info;
}

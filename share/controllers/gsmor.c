#include "controllers.h"

/* Speeds of all by unit speeds of the independent ones, less those that are there at rest. */
static int
speeds (const gs_machine *m, double t, const double *qj, double *wj, double *rest, double *tr)
{
  int n = m->n;
  for (int k = 0; k <= m->na; k++)
    {
      for (int i = 0; i < n; i++)
        {
          wj[i] = qj[i];
          for (int j = 1; j <= m->order; j++)
            wj[i + n * j] = 0.0;
        }
      if (k > 0)
        wj[m->independent[k - 1] - 1 + n] = 1.0;
      int info = m->closure (t, wj, m->cst);
      if (info != 0)
        return info;
      for (int i = 0; i < n; i++)
        if (k == 0)
          rest[i] = wj[i + n];
        else
          tr[i + n * (k - 1)] = wj[i + n] - rest[i];
    }
  return 0;
}

/* TR'*M*TR. */
int
gsmor (const gs_machine *m, double t, const double *qj, double *wj, double *mt, double *tr,
       double *mr)
{
  int n = m->n, info = speeds (m, t, qj, wj, mt, tr);
  if (info != 0)
    return info;
  m->mass (t, qj, m->cst, mt, n);
  for (int j = 0; j < m->na; j++)
    {
      for (int i = 0; i < n; i++)
        {
          wj[i] = 0.0;
          for (int l = 0; l < n; l++)
            wj[i] += mt[i + n * l] * tr[l + n * j];
        }
      for (int i = 0; i < m->na; i++)
        {
          double s = 0.0;
          for (int l = 0; l < n; l++)
            s += tr[l + n * i] * wj[l];
          mr[i + m->na * j] = s;
        }
    }
  return 0;
}

#include "controllers.h"

#include <math.h>

#include "gsmbp/solve.h"

/* Springs and dampers as accelerations by the mass matrix of the independent speeds. */
int
gsimd (const gs_machine *m, const gs_sample *s, const gs_gains *k, double *qg, double *a,
       double *qj, double *wj, double *mt, double *tr, double *mr, double *v, int *iw)
{
  int na = m->na, info = gsmot (m, s->t, s->q, s->u, s->ar, qg, qj);
  if (info == 0)
    info = gsmor (m, s->t, qj, wj, mt, tr, mr);
  if (info != 0)
    return info;
  for (int i = 0; i < na; i++)
    {
      double d = k->zeta > 0.0 ? 2.0 * k->zeta * sqrt (k->kp[i] * mr[i + na * i]) : k->kd[i];
      a[i] = k->kp[i] * (s->qr[i] - s->q[i]) + d * (s->ur[i] - s->u[i]);
    }
  info = gs_solve_general (na, 1, mr, na, a, na, iw);
  if (info != 0)
    return info;
  for (int i = 0; i < na; i++)
    a[i] = s->ar[i] + a[i];
  info = gsmot (m, s->t, s->q, s->u, a, qg, qj);
  return info != 0 ? info : m->command (s->t, qj, m->cst, v);
}

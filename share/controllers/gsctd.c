#include "controllers.h"

/* Feedback linearization: one call of the command. */
int
gsctd (const gs_machine *m, const gs_sample *s, const gs_gains *k, const double *z, double *qg,
       double *a, double *qj, double *v)
{
  for (int i = 0; i < m->na; i++)
    a[i] = s->ar[i] + k->kp[i] * (s->qr[i] - s->q[i]) + k->kd[i] * (s->ur[i] - s->u[i])
           + k->ki[i] * z[i];
  int info = gsmot (m, s->t, s->q, s->u, a, qg, qj);
  return info != 0 ? info : m->command (s->t, qj, m->cst, v);
}

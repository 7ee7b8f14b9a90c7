#include "controllers.h"

/* The command along the wanted motion. */
int
gsffd (const gs_machine *m, const gs_sample *s, const double *rj, const gs_gains *k,
       const double *z, const int *id, double *qg, double *qj, double *v)
{
  int n = m->n, na = m->na;
  for (int i = 0; i < n; i++)
    {
      qj[i] = qg[i];
      for (int j = 1; j <= m->order; j++)
        qj[i + n * j] = 0.0;
    }
  for (int i = 0; i < na; i++)
    for (int j = 0; j <= m->order; j++)
      qj[m->independent[i] - 1 + n * j] = rj[i + na * j];
  int info = m->closure (s->t, qj, m->cst);
  if (info != 0)
    return info;
  for (int i = 0; i < n; i++)
    qg[i] = qj[i];
  info = m->command (s->t, qj, m->cst, v);
  for (int i = 0; i < na && info == 0; i++)
    v[id[i] - 1] = v[id[i] - 1] + k->kp[i] * (rj[i] - s->q[i]) + k->kd[i] * (rj[i + na] - s->u[i])
                   + k->ki[i] * z[i];
  return info;
}

#include "controllers.h"

#include <math.h>

/* INV at the measured state with the wanted accelerations. */
void
gsimt (gs_inv *inv, gs_mas *mas, int n, const gs_sample *s, const gs_gains *k, const double *v,
       const double *cst, double *mt, double *tau)
{
  inv (s->t, s->q, s->u, s->ar, v, cst, tau);
  if (k->zeta > 0.0)
    mas (s->t, s->q, cst, mt, n);
  for (int i = 0; i < n; i++)
    {
      double d = k->zeta > 0.0 ? 2.0 * k->zeta * sqrt (k->kp[i] * mt[i + n * i]) : k->kd[i];
      tau[i] = tau[i] + k->kp[i] * (s->qr[i] - s->q[i]) + d * (s->ur[i] - s->u[i]);
    }
}

#include "controllers.h"

/* Feedback linearization by one call of INV. */
void
gsctq (gs_inv *inv, int n, const gs_sample *s, const gs_gains *k, const double *z,
       const double *v, const double *cst, double *a, double *tau)
{
  for (int i = 0; i < n; i++)
    a[i] = s->ar[i] + k->kp[i] * (s->qr[i] - s->q[i]) + k->kd[i] * (s->ur[i] - s->u[i])
           + k->ki[i] * z[i];
  inv (s->t, s->q, s->u, a, v, cst, tau);
}

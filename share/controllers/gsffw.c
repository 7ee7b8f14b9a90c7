#include "controllers.h"

/* INV along the wanted motion. */
void
gsffw (gs_inv *inv, int n, const gs_sample *s, const gs_gains *k, const double *z,
       const double *v, const double *cst, double *tau)
{
  inv (s->t, s->qr, s->ur, s->ar, v, cst, tau);
  for (int i = 0; i < n; i++)
    tau[i] = tau[i] + k->kp[i] * (s->qr[i] - s->q[i]) + k->kd[i] * (s->ur[i] - s->u[i])
             + k->ki[i] * z[i];
}

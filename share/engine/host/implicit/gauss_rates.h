/* The emitted routines as gauss_momenta.c calls them. */
#ifndef GS_HOST_GAUSS_RATES_H
#define GS_HOST_GAUSS_RATES_H
#include "gauss_state.h"
#include "gsmbp/inputs.h"

static int
mass_at (gs_stepper *s, gs_momenta *w, double t, const double *q, double *mass)
{
  s->scene->mas (t, q, s->r->cst, mass, w->n);
  return cholesky (w->n, mass);
}

/* constraints and their gradients, ROWS; 0 or a flag */
static int
constraints_at (gs_stepper *s, gs_momenta *w, double t, const double *q, double *phi, double *rows)
{
  int info = s->scene->con (t, q, w->zero, s->r->cst, phi, w->phit, rows, w->m, w->gamma);
  return info == 0 || info == 2 ? 0 : -1;
}

/* X += FACTOR ROWS' FORCES */
static void
add_forces (const gs_momenta *w, const double *rows, double factor, const double *forces, double *x)
{
  for (int j = 0; j < w->n; j++)
    for (int k = 0; k < w->m; k++)
      x[j] += factor * rows[k + w->m * j] * forces[k];
}

/* at the state X: M, and F = -B + (dM/dt) u; 0 or a flag */
static int
rate_at (gs_stepper *s, gs_momenta *w, double t, const double *x, double *f)
{
  gs_integration *r = s->r;
  int n = w->n;
  const double *u = x + n;
  if ((r->ip[GS_V0] != 0 || r->ip[GS_FEEDBACK] != 0) && gs_inputs_at (s, t, x, s->v) != 0)
    return -1;
  s->scene->lin (t, x, u, w->zero, s->v, r->cst, w->mass, w->B, w->C0, n);
  s->scene->lin (t, x, u, u, s->v, r->cst, w->mass, w->B, w->C, n);
  s->scene->bia (t, x, u, s->v, r->cst, w->bias);
  r->istat[GS_N_RHS]++;
  for (int i = 0; i < n; i++)
    {
      f[i] = -w->bias[i];
      for (int j = 0; j < n; j++)
        f[i] += (w->C[i + n * j] - w->C0[i + n * j]) * u[j];
      if (! (fabs (f[i]) <= 1e300))
        return -1;
    }
  return 0;
}
#endif

/* derivative.c: directional derivatives, exact: the Jacobians of the scene times the tangent of the
 * state that the importer's states give. */
#include "fmu.h"
#include "gsmbp/loops.h"

#include <math.h>
#include <stdlib.h>

/* arrays of one call */
typedef struct
{
  double *dx, *dv;         /* of the state and the inputs */
  double *dxd, *dy;        /* of rates and outputs */
  double *a, *b, *c, *d;   /* Jacobians */
  double *dp, *dq;         /* tangents of the constraints */
  double *w;
} work;

static double *
divide (const gs_scene *s, work *k)
{
  const int nx = s->nx, nv = s->nv, ny = s->ny, m = s->nlam, nq = s->nq;
  const int n = 2 * nx + nv + ny + nx * (nx + nv + 2) + (ny + 1) * (nx + nv) + 2 * (m + 1) * nq
                + 2 * m + nx + 8;
  double *all = calloc ((size_t)n, sizeof (double));
  if (! all)
    return NULL;
  k->dx = all;
  k->dv = k->dx + nx;
  k->dxd = k->dv + nv;
  k->dy = k->dxd + nx;
  k->a = k->dy + ny;
  k->b = k->a + nx * nx;
  k->c = k->b + nx * nv;
  k->d = k->c + gs_most (1, ny) * nx;
  k->dp = k->d + gs_most (1, ny) * nv;
  k->dq = k->dp + m * nq;
  k->w = k->dq + m * nq;
  return all;
}

/* ------------------------------------------------------------------------------------ the state */

/* dx of Euler parameters that are divided by their length */
static void
normalized (const gsf_instance *a, int set, double *dx)
{
  const int *k = a->m->sets + 4 * set;
  double n = 0, along = 0;
  for (int l = 0; l < 4; l++)
    for (int i = 0; i < gsf_ns (a->m); i++)
      if (a->place[i] == k[l])
        n += a->z[i] * a->z[i];
  n = sqrt (n);
  for (int l = 0; l < 4; l++)
    along += a->x[k[l]] * dx[k[l]];
  for (int l = 0; l < 4; l++)
    dx[k[l]] = (dx[k[l]] - along * a->x[k[l]]) / n;
}

/* b = -(D*dq), D (m,nq) */
static void
minus (int m, int nq, const double *d, const double *dq, double *b)
{
  for (int i = 0; i < m; i++)
    {
      b[i] = 0;
      for (int j = 0; j < nq; j++)
        b[i] -= d[i + m * j] * dq[j];
    }
}

/* the dependent displacements and speeds of dx, as gs_complete_state completes them */
static int
completed (gsf_instance *a, work *k)
{
  const gs_scene *s = a->m->scene;
  gs_partition p = gs_partition_of (s->nq, s->nu, s->nlam, a->p);
  double *du = k->dx + s->nq, *ones = k->w + s->nlam;
  const int m = s->nlam, r = (int)a->p[GS_DEPENDENT], r2 = (int)a->p[GS_DISPLACED];
  int rank, info = s->con (*a->t, a->x, a->x + s->nq, a->cst, p.phi, p.phit, p.hc, m, p.gam);
  if (info != 0 && info != 2)
    return gsf_failed (a, GSF_DISCARD, GS_AT_CON, info);
  a->m->tan (*a->t, a->x, a->cst, k->dp, m, k->dq, m);
  if (r2 > 0)
    {
      gs_partition_factors (m, r2, p.hc, p.displ, p.rows, p.y, p.piv, p.beta, p.siz, &rank);
      minus (m, s->nq, k->dp, k->dx, k->w);
      for (int i = 0; i < m; i++)
        k->w[i] *= p.rows[i];
      gs_partition_solve (m, r2, rank, p.y, p.piv, p.beta, k->w, s->nu, p.displ, p.du);
      s->kin (*a->t, a->x, p.du, a->cst, p.dq);
      for (int i = 0; i < s->nq; i++)
        k->dx[i] += p.dq[i];
    }
  minus (m, s->nq, k->dq, k->dx, k->w);
  for (int i = 0; i < m; i++)
    {
      ones[i] = 1;
      for (int j = 0; j < s->nu; j++)
        k->w[i] -= p.hc[i + m * j] * du[j];
    }
  gs_partition_factors (m, r, p.hc, p.order, ones, p.y, p.piv, p.beta, p.siz, &rank);
  gs_partition_solve (m, r, rank, p.y, p.piv, p.beta, k->w, s->nu, p.order, p.du);
  for (int j = 0; j < s->nu; j++)
    du[j] += p.du[j];
  return GSF_OK;
}

/* --------------------------------------------------------------------------------------- knowns */

/* the state of x that a reference is, if the importer has it as a state, else -1 */
static int
state_of (const gsf_instance *a, int block, int k)
{
  const gsf_model *m = a->m;
  if (block == GSF_CHOSEN)
    return a->place[m->nsq == m->scene->nq ? m->nsq + k : k];
  if (block != GSF_STATE)
    return -1;
  if (m->scene->nlam > 0 && k < m->scene->nq + m->scene->nu
      && ! (k < m->scene->nq && m->nsq == m->scene->nq))
    return -1;
  return k;
}

static int
seeds (gsf_instance *a, size_t nk, const unsigned *knowns, const double *seed, work *w)
{
  for (size_t i = 0; i < nk; i++)
    {
      int k, block = gsf_locate (a->m, knowns[i], &k);
      int state = block == GSF_BLOCKS ? -1 : state_of (a, block, k);
      if (! (fabs (seed[i]) <= 1e300))
        return gsf_fail (a, GSF_ERROR, "directional derivative: expected finite seeds, found %g",
                         seed[i]);
      if (block == GSF_INPUT)
        w->dv[a->m->inputs[k]] += gsf_is_overridden (a, a->m->inputs[k]) ? 0 : seed[i];
      else if (state >= 0)
        w->dx[state] += seed[i];
      else
        return gsf_fail (a, GSF_ERROR, "directional derivative: the value reference %u is no "
                         "input and no continuous state", knowns[i]);
    }
  return GSF_OK;
}

/* y (n) = A*dx + B*dv */
static void
product (const gs_scene *s, int n, const double *a, const double *b, const work *w, double *y)
{
  const int ld = gs_most (1, n);
  for (int j = 0; j < s->nx; j++)
    for (int i = 0; i < n; i++)
      y[i] += a[i + ld * j] * w->dx[j];
  for (int j = 0; j < s->nv; j++)
    for (int i = 0; i < n; i++)
      y[i] += b[i + ld * j] * w->dv[j];
}

static int
linear (gsf_instance *a, work *w)
{
  const gs_scene *s = a->m->scene;
  const int ny = gs_most (1, s->ny);
  for (int set = 0; set < a->m->nsets; set++)
    normalized (a, set, w->dx);
  if (s->nlam > 0 && completed (a, w))
    return GSF_DISCARD;
  int info = a->m->jac (gsf_time (a), a->x, a->v, a->cst, w->a, s->nx, w->b, s->nx, w->c, ny, w->d,
                        ny);
  if (! gsf_is_usable (info))
    return gsf_failed (a, GSF_DISCARD, GS_AT_JAC, info);
  product (s, s->nx, w->a, w->b, w, w->dxd);
  product (s, s->ny, w->c, w->d, w, w->dy);
  return GSF_OK;
}

static int
unknown (gsf_instance *a, unsigned reference, const work *w, double *result)
{
  int k, block = gsf_locate (a->m, reference, &k);
  if (block == GSF_RATE)
    *result = w->dxd[a->place[k]];
  else if (block == GSF_OUTPUT)
    *result = w->dy[k];
  else
    return gsf_fail (a, GSF_ERROR, "directional derivative: the value reference %u is no output "
                     "and no rate of a state", reference);
  return GSF_OK;
}

int
gsf_directional (gsf_instance *a, size_t nu, const unsigned *unknowns, size_t nk,
                 const unsigned *knowns, const double *seed, double *result)
{
  work w;
  if (! a->m->jac || (a->m->scene->nlam > 0 && ! a->m->tan))
    return gsf_fail (a, GSF_ERROR, "this FMU has no directional derivatives");
  int status = gsf_show_samples (a);
  if (status == GSF_OK)
    status = gsf_fresh (a);
  if (status == GSF_OK)
    status = gsf_inputs (a);
  if (status)
    return status;
  double *all = divide (a->m->scene, &w);
  if (! all)
    return gsf_fail (a, GSF_ERROR, "out of memory");
  status = seeds (a, nk, knowns, seed, &w);
  if (status == GSF_OK)
    status = linear (a, &w);
  for (size_t i = 0; i < nu && status == GSF_OK; i++)
    status = unknown (a, unknowns[i], &w, result + i);
  free (all);
  return status;
}

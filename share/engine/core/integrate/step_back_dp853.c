/* gs_step_back_dp853: one step of gs_step_dp853 backwards: from the derivatives of a goal by the
 * state at its end to those by the state at its beginning and, added up, by parameters: the
 * discrete adjoint, of the steps as they were taken.
 *
 * With k[i] = f(x + h*sum a[i,j]*k[j]) and the end x + h*sum b[i]*k[i], from the last stage to the
 * first: l[i] = h*(b[i]*lx + sum a[m,i]*xb[m]), xb[i] = (df/dx)'*l[i]; then lx + sum xb[i]. */
#include <string.h>

#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

/* the state z of stage s and the weights l of its rates; xb (nx,12): those of the stages behind */
static void
at_stage (int s, int nx, gs_real h, const gs_real *a, gs_real b, const gs_real *x, const gs_real *k,
          const gs_real *lx, const gs_real *xb, gs_real *z, gs_real *l)
{
  for (int i = 0; i < nx; i++)
    {
      z[i] = x[i];
      l[i] = b * lx[i];
    }
  for (int j = 0; j < s; j++)
    for (int i = 0; i < nx; i++)
      z[i] += h * a[s + 12 * j] * k[i + nx * j];
  for (int j = s + 1; j < 12; j++)
    for (int i = 0; i < nx; i++)
      l[i] += a[j + 12 * s] * xb[i + nx * j];
  for (int i = 0; i < nx; i++)
    l[i] *= h;
}

int
gs_step_back_dp853 (const gs_scene *s, gs_real t, gs_real tn, int side, gs_real h, const gs_real *x,
                    const gs_real *k, int np, const int *ip, const gs_real *rp, const gs_real *cst,
                    gs_real *v, gs_real *lx, gs_real *pb, gs_real *w, gs_real *wi)
{
  const int nx = s->nx;
  gs_real a[12 * 12], b[12], c[12];
  gs_real *const z = w + 12 * nx, *const l = z + nx, *const vb = l + nx, *const p = vb + s->nv;
  memset (a, 0, sizeof a);
  memset (b, 0, sizeof b);
  c[0] = 0;
  c[11] = 1;
  gs_dp853_table (a, b, c);
  for (int m = 11; m >= 0; m--)
    {
      const gs_real at = m == 11 ? tn : t + c[m] * h;
      const int side_here = m == 11 ? side : 1;
      int info = 0;
      at_stage (m, nx, h, a, b[m], x, k, lx, w, z, l);
      if (ip[GS_V0] != 0)
        info = gs_inputs_of_run (s, at, side_here, z, nx, ip, rp, cst, v, wi);
      if (info != 0)
        return info;
      info = s->adj (gs_time_beside (at, side_here), z, v, cst, l, w + nx * m, vb, p);
      if (info != 0 && info != 3)
        return info;
      for (int i = 0; i < np; i++)
        pb[i] += p[i];
    }
  for (int m = 0; m < 12; m++)
    for (int i = 0; i < nx; i++)
      lx[i] += w[i + nx * m];
  return 0;
}

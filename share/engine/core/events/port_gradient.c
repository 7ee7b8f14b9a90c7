/* gs_port_gradient, gs_held_jacobian: derivatives of event functions, and of accelerations where
   ports are held. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/loops.h"

void
gs_port_gradient (int n, int nh, int nc, int k, const int *kind, const int *mode, const gs_real *s,
                  const gs_real *prm, const gs_real *hold, const gs_real *d, const gs_real *z,
                  gs_real *g)
{
  const int port = k - 1, ld = 6 * nh;
  const gs_real side = (gs_real)mode[port], *const p = prm + 4 * port;
  d += 6 * port;
  z += n + port;
  if (kind[port] == 1 && mode[port] != 0)
    for (int j = 0; j < nc; j++, d += ld)
      g[j] = side * d[1] + GS_R2 (1e-9, 1e-5) * d[3];
  else if (kind[port] == 2 && mode[port] == 0)
    {
      const gs_real r = p[1] - p[0], a = (p[1] - s[port]) / r, b = (s[port] - p[0]) / r;
      for (int j = 0; j < nc; j++, d += ld)
        g[j] = (a - b) * d[0] + b * b * d[3] - a * a * d[2];
    }
  else if (kind[port] == 2)
    for (int j = 0; j < nc; j++, z += n + nh)
      g[j] = -side * z[0];
  else
    for (int j = 0; j < nc; j++, d += ld, z += n + nh)
      g[j] = d[2] - (hold[port] < 0 ? -z[0] : z[0]);
}

void
gs_held_repack (int n, int l, int m, gs_real *a, int way)
{
  if (l == n)
    return;
  for (int j = 1; j < m && way > 0; j++)
    gs_move (l, a + n * j, a + l * j);
  for (int j = m - 1; j > 0 && way < 0; j--)
    gs_move (l, a + l * j, a + n * j);
}

int
gs_held_duplicates (int nu, int nlam, int nh, int *act, gs_real *k)
{
  const int n = nu + nlam + nh;
  int twice = 0, r = 0;
  for (int l = 0; l < nlam + nh; l++)
    {
      if (l >= nlam && act[l - nlam] != 1)
        continue;
      gs_real size = 0, left = 0, *const v = k + n * r;
      for (int j = 0; j < nu && r < nu; j++)
        {
          v[j] = k[nu + l + n * j];
          size += v[j] * v[j];
        }
      for (int i = 0; i < 2 * r && r < nu; i++)
        {
          const gs_real *const b = k + n * (i % r);
          gs_real s = 0;
          for (int j = 0; j < nu; j++)
            s += v[j] * b[j];
          for (int j = 0; j < nu; j++)
            v[j] -= s * b[j];
        }
      for (int j = 0; j < nu && r < nu; j++)
        left += v[j] * v[j];
      if (r < nu && left > GS_R2 (1e-20, 1e-10) * size)
        {
          for (int j = 0; j < nu; j++)
            v[j] /= gs_sqrt (left);
          r++;
        }
      else if (l >= nlam)
        {
          act[l - nlam] = 0;
          twice++;
        }
    }
  return twice;
}

int
gs_held_jacobian (int nu, int nlam, int nh, int nq, int nz, int *act, const gs_real *lm,
                  const gs_real *lb, const gs_real *lc, gs_real *k, gs_real *z, int *iw)
{
  const int n = nu + nlam + nh, twice = gs_held_duplicates (nu, nlam, nh, act, k);
  int l = nu + nlam;
  for (int i = 0; i < nh; i++)
    if (act[i] == 1)
      {
        const int from = nu + nlam + i;
        for (int j = 0; j < nu; j++)
          {
            k[l + n * j] = k[from + n * j];
            k[j + n * l] = k[j + n * from];
          }
        for (int j = 0; j < nz; j++)
          z[l + n * j] = z[from + n * j];
        l++;
      }
  gs_held_repack (n, l, l, k, 1);
  gs_held_repack (n, l, nz, z, 1);
  const int info = gs_loop_jacobian (nu, l - nu, nq, nz, lm, lb, lc, k, z, iw, 0);
  gs_held_repack (n, l, nz, z, -1);
  for (int i = nh - 1; i >= 0; i--)
    {
      l -= act[i] == 1;
      for (int j = 0; j < nz; j++)
        z[nu + nlam + i + n * j] = act[i] == 1 ? z[l + n * j] : 0;
    }
  if (info != 0)
    return 2;
  return twice > 0 ? 3 : 0;
}

/* GSEVG, GSHJC: derivatives of event functions, and of accelerations where ports are held. */
#include "gsmbp/events.h"
#include "gsmbp/loops.h"

void
gsevg (int n, int nh, int nc, int k, const int *kind, const int *mode, const double *s,
       const double *prm, const double *hold, const double *d, const double *z, double *g)
{
  const int port = k - 1, ld = 6 * nh;
  const double side = mode[port], *const p = prm + 4 * port;
  d += 6 * port;
  z += n + port;
  if (kind[port] == 1 && mode[port] != 0)
    for (int j = 0; j < nc; j++, d += ld)
      g[j] = side * d[1] + 1e-9 * d[3];
  else if (kind[port] == 2 && mode[port] == 0)
    {
      const double r = p[1] - p[0], a = (p[1] - s[port]) / r, b = (s[port] - p[0]) / r;
      for (int j = 0; j < nc; j++, d += ld)
        g[j] = (a - b) * d[0] + b * b * d[3] - a * a * d[2];
    }
  else if (kind[port] == 2)
    for (int j = 0; j < nc; j++, z += n + nh)
      g[j] = -side * z[0];
  else
    for (int j = 0; j < nc; j++, d += ld, z += n + nh)
      g[j] = d[2] - (hold[port] < 0.0 ? -z[0] : z[0]);
}

int
gshjc (int nu, int nlam, int nh, int nq, int nz, const int *act, const double *lm,
       const double *lb, const double *lc, double *k, double *z, int *iw)
{
  const int n = nu + nlam + nh;
  for (int i = 0; i < nh; i++)
    if (act[i] != 1)
      {
        const int l = nu + nlam + i;
        for (int j = 0; j < n; j++)
          k[l + n * j] = k[j + n * l] = 0.0;
        k[l + n * l] = 1.0;
        for (int j = 0; j < nz; j++)
          z[l + n * j] = 0.0;
      }
  return gsjac (nu, nlam + nh, nq, nz, lm, lb, lc, k, z, iw, 0) == 0 ? 0 : 2;
}

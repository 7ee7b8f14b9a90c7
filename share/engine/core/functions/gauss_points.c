#include "gsmbp/functions.h"

static const gs_real points2[1] = { -GS_R (5.77350269189625764509148780501957456e-1) };
static const gs_real weights2[1] = { 1 };
static const gs_real points8[4] = { -GS_R (9.602898564975362316835608685694729904e-1),
                                   -GS_R (7.966664774136267395915539364758304368e-1),
                                   -GS_R (5.25532409916328985817739049189246349e-1),
                                   -GS_R (1.834346424956498049394761423601839807e-1) };
static const gs_real weights8[4] = { GS_R (1.012285362903762591525313543099621901e-1),
                                    GS_R (2.223810344533744705443559944262408844e-1),
                                    GS_R (3.137066458778872873379622019866013133e-1),
                                    GS_R (3.626837833783619829651504492771956122e-1) };
static const gs_real points12[6] = { -GS_R (9.81560634246719250690549090149280823e-1),
                                    -GS_R (9.041172563704748566784658661190961925e-1),
                                    -GS_R (7.69902674194304687036893833212818076e-1),
                                    -GS_R (5.873179542866174472967024189405342804e-1),
                                    -GS_R (3.678314989981801937526915366437175613e-1),
                                    -GS_R (1.2523340851146891547244136946385313e-1) };
static const gs_real weights12[6] = { GS_R (4.717533638651182719461596148501706032e-2),
                                     GS_R (1.069393259953184309602547181939962242e-1),
                                     GS_R (1.600783285433462263346525295433590719e-1),
                                     GS_R (2.031674267230659217490644558097983765e-1),
                                     GS_R (2.334925365383548087608498989248780563e-1),
                                     GS_R (2.491470458134027850005624360429512108e-1) };

void
gs_gauss_points (int ns, gs_real *c, gs_real *wt)
{
  const gs_real *points = ns == 2 ? points2 : ns == 8 ? points8 : points12;
  const gs_real *weights = ns == 2 ? weights2 : ns == 8 ? weights8 : weights12;
  for (int k = 0; k < ns / 2; k++)
    {
      c[k] = points[k];
      wt[k] = weights[k];
      c[ns - 1 - k] = -c[k];
      wt[ns - 1 - k] = wt[k];
    }
}

void
gs_legendre (int n, gs_real x, gs_real *p)
{
  p[0] = 1;
  p[1] = x;
  for (int j = 2; j < n; j++)
    p[j] = ((gs_real)(2 * j - 1) * x * p[j - 1] - (gs_real)(j - 1) * p[j - 2]) / (gs_real)j;
}

/* By polynomials of Legendre, one degree after the other, of all points together. */
void
gs_gauss_weights (int ns, const gs_real *c, const gs_real *wt, gs_real ca, gs_real cb, gs_real *b)
{
  gs_real p[12], old[12], pa[13], pb[13];
  gs_legendre (ns + 1, ca, pa);
  gs_legendre (ns + 1, cb, pb);
  for (int k = 0; k < ns; k++)
    {
      old[k] = 1;
      p[k] = c[k];
      b[k] = cb - ca;
    }
  for (int j = 2; j <= ns; j++)
    {
      gs_real s = (pb[j] - pb[j - 2]) - (pa[j] - pa[j - 2]);
      gs_real x = (gs_real)(2 * j - 1) / (gs_real)j, y = (gs_real)(j - 1) / (gs_real)j;
      for (int k = 0; k < ns; k++)
        {
          b[k] += p[k] * s;
          gs_real next = x * c[k] * p[k] - y * old[k];
          old[k] = p[k];
          p[k] = next;
        }
    }
  for (int k = 0; k < ns; k++)
    b[k] = GS_R (0.5) * wt[k] * b[k];
}

/* how many of z are nearer to cb than z[k]; of two as near the first counts as nearer */
static int
nearer (int n, const gs_real *z, int k, gs_real cb)
{
  int count = 0;
  gs_real own = gs_abs (z[k] - cb);
  for (int j = 0; j < n; j++)
    count += j < k ? gs_abs (z[j] - cb) <= own : j > k && gs_abs (z[j] - cb) < own;
  return count;
}

/* four points and weights of Gauss */
static void
four_points (gs_real *g, gs_real *wg)
{
  gs_real root = gs_sqrt (GS_R (1.2));
  g[3] = gs_sqrt (GS_R (3.0) / 7 + GS_R (2.0) / 7 * root);
  g[2] = gs_sqrt (GS_R (3.0) / 7 - GS_R (2.0) / 7 * root);
  wg[3] = GS_R (0.5) - gs_sqrt (30) / 36;
  wg[2] = GS_R (0.5) + gs_sqrt (30) / 36;
  for (int i = 0; i < 2; i++)
    {
      g[i] = -g[3 - i];
      wg[i] = wg[3 - i];
    }
}

void
gs_interpolation_weights (int n, const gs_real *z, gs_real ca, gs_real cb, gs_real *b)
{
  int near[7], m = 0;
  for (int k = 0; k < n; k++)
    {
      b[k] = 0;
      if (m < 7 && nearer (n, z, k, cb) < 7)
        near[m++] = k;
    }

  gs_real g[4], wg[4];
  four_points (g, wg);
  for (int i = 0; i < 4; i++)
    {
      gs_real x = GS_R (0.5) * (ca + cb) + GS_R (0.5) * (cb - ca) * g[i];
      for (int k = 0; k < m; k++)
        {
          gs_real s = GS_R (0.5) * (cb - ca) * wg[i];
          for (int j = 0; j < m; j++)
            if (j != k)
              s = s * (x - z[near[j]]) / (z[near[k]] - z[near[j]]);
          b[near[k]] += s;
        }
    }
}

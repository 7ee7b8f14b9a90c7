/* gs_port_reset: what happens at an event: modes change, speeds jump at an impact.
 *
 * Friction that comes to rest sticks, as one that starts slower than 1e-9 of its Stribeck speed
 * does; one whose holding force passes its limit slides to where it is pushed. What sticks at last
 * comes to rest exactly (l = -1), not before: where the loops stop a port by their geometry, as at
 * a dead centre, the rest of the machine would have to stop for it.
 * At a stop u+ = u + inv(A)*H'*p, so that the port's speed becomes -e times itself, without one
 * where the rebound would be slower than prm[3]: then the stop stays in contact, as one does
 * against which a port at rest is pushed. Constraints and
 * stops in contact take part in the impact and only push; friction does not: no finite force
 * resists an impulse. Then friction slides where its port moves. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/solve.h"

/* gs_stop_nearness: how near to an end of a stop a port at rest is at it: by rounding errors, and
 * by the way that a rebound that is none makes in 1e-9 of a second; never more than 1e-9 of its
 * travel */
gs_real
gs_stop_nearness (gs_real s, const gs_real *prm)
{
  return gs_min (GS_R2 (1e-9, 1e-5) * gs_stop_travel (s, prm),
                 GS_R2 (1e-9, 1e-5) * prm[3] + GS_R2 (1e-12, 1e-6) * gs_abs (s));
}

/* the modes at the start */
static void
start (int k, const int *kind, int *mode, const gs_real *s, const gs_real *sd, const gs_real *prm)
{
  for (int i = 0; i < k; i++, prm += 4)
    {
      gs_real e = GS_R2 (1e-9, 1e-5) * prm[1];
      mode[i] = 0;
      if (kind[i] == 1 && sd[i] > e)
        mode[i] = 1;
      if (kind[i] == 1 && sd[i] < -e)
        mode[i] = -1;
      if (kind[i] == 2 && gs_abs (sd[i]) <= prm[3])
        {
          e = gs_stop_nearness (s[i], prm);
          if (s[i] >= prm[1] - e)
            mode[i] = 1;
          if (s[i] <= prm[0] + e)
            mode[i] = -1;
        }
    }
}

int
gs_port_reset (int n, int m, int k, int l, const int *kind, int *mode, const gs_real *s,
               const gs_real *sd, const gs_real *prm, const gs_real *hold, const gs_real *a,
               int lda, const gs_real *h, int ldh, const gs_real *phit, gs_real *u, gs_real *w)
{
  const int i = l - 1;
  if (l == 0)
    start (k, kind, mode, s, sd, prm);
  else if (l < 0)
    return gs_port_impulse (n, m, k, 0, 0, kind, mode, a, lda, h, ldh, phit, u, w);
  else if (kind[i] == 1 && mode[i] != 0)
    mode[i] = 0;
  else if (kind[i] == 1)
    mode[i] = hold[i] > 0 ? -1 : 1;
  else if (mode[i] != 0)
    mode[i] = 0;
  else
    {
      const gs_real *stop = prm + 4 * i;
      const int end = stop[1] - s[i] < s[i] - stop[0] ? 1 : -1;
      if (gs_abs (sd[i]) <= GS_R2 (1e-9, 1e-5) * stop[3]
          && gs_min (stop[1] - s[i], s[i] - stop[0])
                 <= GS_R2 (1e-9, 1e-5) * gs_stop_travel (s[i], stop))
        mode[i] = end;
      if ((gs_real)end * sd[i] <= 0 || mode[i] != 0)
        return 0;
      gs_real e = stop[2];
      if (e * gs_abs (sd[i]) <= stop[3])
        {
          e = 0;
          mode[i] = end;
        }
      return gs_port_impulse (n, m, k, l, -e * sd[i], kind, mode, a, lda, h, ldh, phit, u, w);
    }
  return 0;
}

/* does row i of the constraints and ports take part in an impact at port l? Then what its speed
 * becomes */
static int
takes_part (int m, int i, int l, gs_real v, const int *kind, const int *mode, const gs_real *phit,
            gs_real *speed)
{
  *speed = 0;
  if (i < m)
    *speed = -phit[i];
  else if (i - m == l - 1)
    *speed = v;
  else
    return kind[i - m] == 2 ? mode[i - m] != 0
                            : kind[i - m] == 1 && mode[i - m] == 0 && l == 0;
  return 1;
}

/* the first stop in contact that would pull, lam being the impulses of the rows; -1: none */
static int
pulling (int m, int k, int l, const int *kind, const int *mode, const gs_real *lam)
{
  int r = m, bad = -1;
  for (int i = 0; i < k && l > 0; i++)
    if (i == l - 1)
      r++;
    else if (kind[i] == 2 && mode[i] != 0)
      {
        if ((gs_real)mode[i] * lam[r] > 0 && bad < 0)
          bad = i;
        r++;
      }
  return bad;
}

/* friction slides where its port moves, rows h of the ports; du is what the impact changed */
static void
slide (int n, int k, const int *kind, int *mode, const gs_real *h, int ldh, const gs_real *u,
       const gs_real *du)
{
  for (int i = 0; i < k; i++)
    if (kind[i] == 1)
      {
        gs_real x = 0, size = 0;
        for (int j = 0; j < n; j++)
          {
            const gs_real row = h[i + ldh * j];
            x += row * u[j];
            size = size + gs_abs (row * u[j]) + gs_abs (row * du[j]);
          }
        if (gs_abs (x) > GS_R2 (1e-10, 1e-5) * size)
          mode[i] = x < 0 ? -1 : 1;
      }
}

int
gs_port_impulse (int n, int m, int k, int l, gs_real v, const int *kind, int *mode,
                 const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *phit,
                 gs_real *u, gs_real *w)
{
  const int nr = m + k;
  gs_real *wa = w, *wh = wa + n * n, *wf = wh + nr * n, *wg = wf + n, *wd = wg + nr, *wl = wd + n,
         *ww = wl + nr, x;
  int info;
  for (int bad = 0; bad >= 0;)
    {
      int r = 0;
      for (int i = 0; i < nr; i++)
        {
          if (! takes_part (m, i, l, v, kind, mode, phit, &x))
            continue;
          for (int j = 0; j < n; j++)
            {
              wh[r + nr * j] = h[i + ldh * j];
              x -= h[i + ldh * j] * u[j];
            }
          wg[r++] = x;
        }
      if (r == 0)
        return 0;
      for (int j = 0; j < n; j++)
        {
          wf[j] = 0;
          for (int i = 0; i < n; i++)
            wa[i + n * j] = a[i + lda * j];
        }
      info = gs_solve_kkt (n, r, wa, n, wh, nr, wf, wg, wd, wl, ww);
      if (info != 0 && info != 2)
        return info;
      bad = pulling (m, k, l, kind, mode, wl);
      if (bad >= 0)
        mode[bad] = 0;
    }
  for (int j = 0; j < n; j++)
    u[j] += wd[j];
  for (int i = 0; i < k; i++)
    {
      int j = gs_only_entry (n, h + m + i, ldh);
      if (i + 1 != l && j > 0 && info == 0 && takes_part (m, m + i, l, v, kind, mode, phit, &x))
        u[j - 1] = 0;
    }
  if (l != 0)
    slide (n, k, kind, mode, h + m, ldh, u, wd);
  return 0;
}

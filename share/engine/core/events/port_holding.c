/* gs_port_holding: accelerations where some ports are held (friction that sticks, contact that
 * rests): the rows of h behind the constraints that are active count as constraints, the others do
 * not.
 *
 * Where the rows are dependent, each port is looked at beside the constraints alone: one whose row
 * depends on theirs (a slider at its dead centre) moves as they have it, whatever holds it. It does
 * not count as held; its effort would be without bound, towards rest. Else a speed that is a port's
 * alone has the acceleration 0, not what rounding makes of it. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/solve.h"

static const gs_real without_bound = GS_R (1e30);

static void
copy_row (int n, gs_real *h, int ldh, gs_real *g, int to, int from)
{
  for (int j = 0; j < n; j++)
    h[to + ldh * j] = h[from + ldh * j];
  g[to] = g[from];
}

/* the ports among rows m .. that the constraints, with their accelerations ud, move or hold by
 * themselves are left out; the number of rows that stay */
static int
leave_out (int n, int m, int k, const gs_real *a, int lda, gs_real *h, int ldh, gs_real *g,
           const int *act, const gs_real *ud, gs_real *hold, gs_real *w)
{
  int r = m, p = m;
  for (int i = 0; i < k; i++)
    if (act[i] == 1)
      {
        int free;
        gs_port_is_free (n, m, a, lda, h, ldh, p + 1, w, &free);
        if (free == 0)
          {
            gs_real s = -g[p];
            for (int j = 0; j < n; j++)
              s += h[p + ldh * j] * ud[j];
            hold[i] = gs_copysign (without_bound, -s);
          }
        else
          copy_row (n, h, ldh, g, r++, p);
        p++;
      }
  return r;
}

int
gs_only_entry (int n, const gs_real *row, int ldr)
{
  int many = 0, one = 0;
  for (int j = 0; j < n; j++)
    if (gs_abs (row[ldr * j]) > 0)
      {
        many++;
        one = j + 1;
      }
  return many > 1 ? 0 : one;
}

int
gs_port_holding (int n, int m, int k, const gs_real *a, int lda, gs_real *h, int ldh,
                 const gs_real *f, gs_real *g, const int *act, gs_real *ud, gs_real *lam,
                 gs_real *hold, gs_real *w)
{
  gs_real *const ww = w + m + k;
  int l = m;
  for (int i = 0; i < k; i++)
    {
      hold[i] = 0;
      if (act[i] == 1)
        {
          hold[i] = 1;
          copy_row (n, h, ldh, g, l++, m + i);
        }
    }
  int info = gs_solve_kkt (n, l, a, lda, h, ldh, f, g, ud, w, ww);
  for (int i = m; i < l && info == 0; i++)
    {
      int j = gs_only_entry (n, h + i, ldh);
      if (j > 0 && ! (gs_abs (g[i]) > 0))
        ud[j - 1] = 0;
    }
  if (info == 2 && l > m)
    {
      int r = l;
      if (gs_solve_kkt (n, m, a, lda, h, ldh, f, g, ud, w, ww) != 1)
        r = leave_out (n, m, k, a, lda, h, ldh, g, act, ud, hold, w);
      info = gs_solve_kkt (n, r, a, lda, h, ldh, f, g, ud, w, ww);
      if (info == 2 && r > m)
        info = 0;
    }
  for (int i = 0; i < m; i++)
    lam[i] = w[i];
  l = m;
  for (int i = 0; i < k; i++)
    if (gs_abs (hold[i]) < without_bound && act[i] == 1)
      hold[i] = w[l++];
  return info;
}

/* The acceleration under a unit effort along the row, with and without the constraints; 0 where
 * the square root of the ratio of their energies is below 1e-10, ten times the tolerance of
 * gs_solve_kkt. Where A is singular by itself, that of the row alone is one with the largest
 * mass. */
void
gs_port_is_free (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, int p,
                 gs_real *w, int *free)
{
  gs_real *wf = w, *wu = wf + n, *wg = wu + n, *wl = wg + m, *ww = wl + m;
  gs_real big = 0, s = 0, e = 0;
  for (int j = 0; j < n; j++)
    {
      wf[j] = h[p - 1 + ldh * j];
      big = gs_max (big, a[j + lda * j]);
      s += GS_R (0.5) * (wf[j] * wf[j]);
    }
  for (int i = 0; i < m; i++)
    wg[i] = 0;
  *free = 1;
  s /= big;
  for (int job = 0; job <= 1; job++)
    {
      int info = gs_solve_kkt (n, m * job, a, lda, h, ldh, wf, wg, wu, wl, ww);
      if (info == 1 && job == 0)
        continue;
      if (info == 1)
        return;
      e = 0;
      for (int j = 0; j < n; j++)
        {
          e += GS_R (0.5) * a[j + lda * j] * (wu[j] * wu[j]);
          for (int i = j + 1; i < n; i++)
            e += a[i + lda * j] * wu[i] * wu[j];
        }
      if (job == 0)
        s = e;
    }
  if (gs_sqrt (gs_max (0, e)) <= GS_R (5e5) * gs_epsilon () * gs_sqrt (s))
    *free = 0;
}

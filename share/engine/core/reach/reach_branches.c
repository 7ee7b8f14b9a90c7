#include "gsmbp/arith.h"
#include "gsmbp/reach.h"

/* what is large for every radicand */
static gs_real
large (int nm, const gs_real *lim)
{
  gs_real wide = GS_R (1e-6);
  for (int i = 0; i < nm; i++)
    wide = gs_max (wide, GS_R (1e7) * lim[i]);
  return wide;
}

/* of the radicands rad of a branch: is none negative, one at its limit, one close to it? Where all
 * are above wide, as they are as a rule, all is said. */
static int
is_real (int nm, const gs_real *rad, const gs_real *lim, gs_real wide, int *edge, int *beside)
{
  int real = 1, low = 0;
  *edge = *beside = 0;
  for (int i = 0; i < nm; i++)
    low += ! (rad[i] > wide);
  if (low == 0)
    return 1;
  for (int i = 0; i < nm; i++)
    {
      if (! (rad[i] >= -GS_R (1e-12)))
        real = 0;
      if (rad[i] <= lim[i])
        *edge = 1;
      if (lim[i] > GS_R (1e-20) && gs_abs (rad[i]) <= GS_R (1e7) * lim[i])
        *beside = 1;
      if (lim[i] <= GS_R (1e-20) && rad[i] > lim[i] && rad[i] <= GS_R (1e-6))
        *beside = 1;
    }
  return real;
}

/* does a branch reach the pose? If not, and it is the best so far, dst is what it misses. */
static int
reaches (int real, const gs_real *res, gs_real *least, gs_real *dst)
{
  gs_real miss = gs_max (res[0], res[1]);
  if (real && miss <= GS_R (1e-9))
    return 1;
  if (*least < 0 || miss < *least)
    {
      *least = miss;
      dst[0] = res[0];
      dst[1] = res[1];
    }
  return 0;
}

/* A branch is real where no radicand is below -1e-12, which is taken for the rounding of a double
 * root, and what it misses is below 1e-9. Of two branches equal to 1e-12 the first counts. */
int
gs_reach_branches (int n, int nb, int nm, const gs_real *qc, const gs_real *rad, const gs_real *lim,
                   const gs_real *res, gs_real *qs, int ldq, int *ns, int *br, gs_real *dst,
                   int *near)
{
  int info = 0, edge, beside;
  gs_real least = -1, wide = large (nm, lim);
  *ns = *near = 0;
  dst[0] = dst[1] = 0;
  if (ldq < n)
    return -9;
  for (int k = 0; k < nb; k++)
    {
      br[k] = 0;
      for (int i = 0; i < n; i++)
        qs[i + ldq * k] = 0;
    }
  for (int k = 0; k < nb; k++)
    {
      int real = is_real (nm, rad + nm * k, lim, wide, &edge, &beside);
      *near = *near || beside;
      if (! reaches (real, res + 2 * k, &least, dst))
        continue;
      *near = *near || gs_max (res[2 * k], res[2 * k + 1]) > GS_R (1e-13);
      if (gs_reach_which (n, qc + n * k, qs, ldq, *ns) == 0)
        {
          gs_copy (n, qc + n * k, qs + ldq * *ns);
          br[(*ns)++] = k + 1;
        }
      info = edge ? 2 : info;
    }
  if (*ns > 0)
    dst[0] = dst[1] = 0;
  return *ns == 0 ? 1 : info;
}

int
gs_reach_which (int n, const gs_real *q, const gs_real *qs, int ldq, int ns)
{
  for (int k = 0; k < ns; k++)
    {
      int i = 0;
      while (i < n && ! (gs_abs (q[i] - qs[i + ldq * k]) > GS_R (1e-12)))
        i++;
      if (i == n)
        return k + 1;
    }
  return 0;
}

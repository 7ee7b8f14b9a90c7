#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

/* the largest difference of two positions, modulo a turn */
static double
apart (const int *kind, const double *q, const double *z)
{
  double d = 0.0;
  for (int i = 0; i < 6; i++)
    {
      double t = fabs (q[i] - z[i]);
      if (kind[i] == 1)
        t = fabs (2.0 * sin (0.5 * t));
      d = gs_max (d, t);
    }
  return d;
}

/* is a branch almost real, and no coordinate free? */
static int
is_near (int nm, const double *rad, const double *lim)
{
  int good = 0, out = 0;
  for (int i = 0; i < nm; i++)
    {
      if (lim[i] > 1e-20 && fabs (rad[i]) <= 1e7 * lim[i])
        good = 1;
      if (lim[i] <= 1e-20 && rad[i] <= lim[i])
        out = 1;
      if (! (rad[i] >= -1e7 * lim[i]))
        out = 1;
    }
  return good && ! out;
}

/* Newton's method on the pose from every branch whose radicands are above -1e7 times lim, and from
 * places on both sides of it, where the Jacobian loses rank. A pair closer than 3e-8 (more where
 * the Jacobian is almost singular) counts once. New ones take the numbers of branches that have
 * none. */
int
gsikz (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       int nb, int nm, const double *qc, const double *rad, const double *lim, double *qs, int *ns,
       int *br, int info)
{
  double z[6], q[6], w[42], s;
  int iw[6], good;
  for (int k = 0; k < *ns; k++)
    {
      memcpy (q, qs + 6 * k, sizeof q);
      gsikn (kind, ka, pa, r, p, q, w, iw, &good);
      if (good && apart (kind, q, qs + 6 * k) <= 1e-2)
        memcpy (qs + 6 * k, q, sizeof q);
    }
  for (int k = 0; k < nb; k++)
    {
      if (! is_near (nm, rad + nm * k, lim))
        continue;
      gsiko (kind, ka, pa, r, p, qc + 6 * k, z, &s);
      double h = 1e-2;
      for (int l = 0; l < 5; l++, h = 0.1 * h)
        for (int way = -1; way <= 1; way += 2)
          {
            for (int i = 0; i < 6; i++)
              q[i] = qc[i + 6 * k] + way * h * z[i];
            gsikn (kind, ka, pa, r, p, q, w, iw, &good);
            if (good)
              info = gsikp (kind, q, s, nb, qs, ns, br, info);
          }
    }
  return info;
}

void
gsiko (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
       const double *q, double *z, double *s)
{
  double j[36], e[6], v[36], sv[6], miss;
  int rank;
  gsikj (kind, ka, pa, r, p, q, j, e, &miss);
  gssvd (6, 6, j, 6, v, 6, sv, 1e-14, &rank);
  memcpy (z, v + 30, 6 * sizeof (double));
  *s = sv[5];
}

int
gsikp (const int *kind, const double *q, double s, int nb, double *qs, int *ns, int *br, int info)
{
  double tol = 3e-8 + 1e-13 / gs_max (s, 1e-10);
  for (int k = 0; k < *ns; k++)
    if (apart (kind, q, qs + 6 * k) <= tol)
      return info;
  if (*ns >= nb)
    return info;
  memcpy (qs + 6 * *ns, q, 6 * sizeof (double));
  (*ns)++;
  for (int l = 1; l <= nb; l++)
    {
      int k = 0;
      while (k < *ns - 1 && br[k] != l)
        k++;
      if (k < *ns - 1)
        continue;
      br[*ns - 1] = l;
      return info == 1 ? 0 : info;
    }
  return info;
}

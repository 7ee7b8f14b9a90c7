#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

double
gsikk (int n, const int *kind, const double *q, const double *z)
{
  double d = 0.0;
  for (int i = 0; i < n; i++)
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

/* Newton's method on the pose from every solution */
static void
refined (int n, const int *kind, const double *ka, const double *pa, const double *r,
         const double *p, double *qs, int ns)
{
  double q[6] = { 0.0 }, w[42];
  int iw[6], good;
  for (int k = 0; k < ns; k++)
    {
      memcpy (q, qs + n * k, n * sizeof (double));
      gsikn (n, kind, ka, pa, r, p, q, w, iw, &good);
      if (good && gsikk (n, kind, q, qs + n * k) <= 1e-2)
        memcpy (qs + n * k, q, n * sizeof (double));
    }
}

/* from every solution, then from every branch whose radicands are above -1e7 times lim and one of
 * them close to 0, from places on both sides of it, where the Jacobian loses rank. A pair closer
 * than 3e-8 (more where the Jacobian is almost singular) counts once: the one that misses less. New
 * ones take the numbers of branches that have none. */
int
gsikz (int n, const int *kind, const double *ka, const double *pa, const double *r,
       const double *p, int nb, int nm, const double *qc, const double *rad, const double *lim,
       double *qs, int *ns, int *br, int info)
{
  double z[6], q[6], w[42], s;
  int iw[6], good;
  refined (n, kind, ka, pa, r, p, qs, *ns);
  for (int k = 0; k < nb; k++)
    {
      if (! is_near (nm, rad + nm * k, lim))
        continue;
      gsiko (n, kind, ka, pa, r, p, qc + n * k, z, &s);
      double h = 1e-2;
      for (int l = 0; l < 5; l++, h = 0.1 * h)
        for (int way = -1; way <= 1; way += 2)
          {
            for (int i = 0; i < 6; i++)
              q[i] = i < n ? qc[i + n * k] + way * h * z[i] : way * h * z[i];
            gsikn (n, kind, ka, pa, r, p, q, w, iw, &good);
            if (good)
              info = gsikp (n, kind, ka, pa, r, p, q, s, nb, qs, ns, br, info);
          }
    }
  return info;
}

void
gsiko (int n, const int *kind, const double *ka, const double *pa, const double *r,
       const double *p, const double *q, double *z, double *s)
{
  double qa[6] = { 0.0 }, j[36], e[6], v[36], sv[6], miss;
  int rank;
  memcpy (qa, q, n * sizeof (double));
  gsikj (kind, ka, pa, r, p, qa, j, e, &miss);
  gssvd (6, n, j, 6, v, 6, sv, 1e-14, &rank);
  memset (z, 0, 6 * sizeof (double));
  memcpy (z, v + 6 * (n - 1), n * sizeof (double));
  *s = sv[n - 1];
}

/* does q miss the pose by less than the solution of n coordinates? */
static int
is_closer (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, const double *q, const double *solution)
{
  double qa[6] = { 0.0 }, j[36], e[6], here, there;
  memcpy (qa, solution, n * sizeof (double));
  gsikj (kind, ka, pa, r, p, q, j, e, &here);
  gsikj (kind, ka, pa, r, p, qa, j, e, &there);
  return here + 1e-15 < 0.5 * there;
}

int
gsikp (int n, const int *kind, const double *ka, const double *pa, const double *r,
       const double *p, const double *q, double s, int nb, double *qs, int *ns, int *br, int info)
{
  double tol = 3e-8 + 1e-13 / gs_max (s, 1e-10);
  for (int k = 0; k < *ns; k++)
    if (gsikk (n, kind, q, qs + n * k) <= tol)
      {
        if (is_closer (n, kind, ka, pa, r, p, q, qs + n * k))
          memcpy (qs + n * k, q, n * sizeof (double));
        return info;
      }
  if (*ns >= nb)
    return info;
  memcpy (qs + n * *ns, q, n * sizeof (double));
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

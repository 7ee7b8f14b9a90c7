#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <string.h>

/* x within its limits */
static double
within (double x, double low, double high)
{
  return gs_min (gs_max (x, low), high);
}

/* Newton's method of least squares with damping (Levenberg and Marquardt) on place, rotation vector
 * and phi, on the exact Jacobian; a coordinate at its limit does not move beyond it. At most 200
 * steps, none longer than 0.5 rad or m.
 *
 * D. Marquardt, SIAM J. Appl. Math. 11 (1963), 431-441. */
int
gsnit (const gs_scene *g, double t, int nq, int nu, int nlam, int npt, int k, int job,
       const double *p, const double *r, double *q, const double *qlo, const double *qhi,
       const int *iv, int ns, const int *iset, const double *cst, double wt, double *w, double *wp,
       double *f, double *dst)
{
  const int nr = 3 + 3 * job + nlam;
  double *res = w, *resn = res + nr, *j = resn + nr, *s = j + nr * nu, *qn = s + nu;
  double *a = qn + nq, *u = a + nu * nu, fn, mu = 1e-3, err = 0.0;
  for (int i = 0; i < nq; i++)
    q[i] = within (q[i], qlo[i], qhi[i]);
  gsnrm (ns, iset, q, &err);
  for (int i = 0; i < nu; i++)
    u[i] = 0.0;
  int info = gsnir (g, t, nu, nlam, npt, k, job, p, r, q, u, cst, wt, res, nr, wp, f, dst);
  for (int n = 0; info >= 0 && n < 200 && ! (*f <= 1e-15) && mu <= 1e8; n++)
    {
      info = gsnij (g, t, q, nu, nlam, npt, k, job, u, cst, wt, j, nr, wp);
      for (int better = 0; info >= 0 && ! better && mu <= 1e8;)
        {
          gsnis (g, t, nq, nu, nr, j, res, mu, q, qlo, qhi, iv, u, cst, a, s, qn, wp);
          gsnrm (ns, iset, qn, &err);
          info = gsnir (g, t, nu, nlam, npt, k, job, p, r, qn, u, cst, wt, resn, nr, wp, &fn,
                        dst);
          better = info >= 0 && fn < *f;
          mu = better ? gs_max (0.1 * mu, 1e-14) : 8.0 * mu;
          if (! better)
            continue;
          memcpy (q, qn, nq * sizeof (double));
          memcpy (res, resn, nr * sizeof (double));
          *f = fn;
        }
    }
  return info;
}

/* Newton's method of least squares (gsnit). Where it ends without the pose, as on a position
 * between two ways to it (a closed chain stretched out), it begins again from five positions beside
 * the best one, 0.03 to 0.5 rad or m away. What is not reached then is approached with phi counting
 * a thousand times, so that dst is the distance with the loops closed, to 1e-6 of itself. */
int
gsnik (const gs_scene *g, double t, int nq, int nu, int nlam, int npt, int k, int job,
       const double *p, const double *r, double *q, const double *qlo, const double *qhi,
       const int *iv, int ns, const int *iset, const double *cst, double *w, double *dst)
{
  const int nr = 3 + 3 * job + nlam;
  double *s = w + (2 + nu) * nr, *u = s + nu + nq + nu * nu, *best = u + nu, *wp = best + nq;
  double f, fb = 0.0, far = 0.03;
  for (int n = 0; n < 6; n++)
    {
      if (n > 0)
        {
          for (int i = 0; i < nu; i++)
            s[i] = far * sin (1.0 * (2 * (i + 1) + 3 * n * (i + 1) + n));
          g->kin (t, best, s, cst, q);
          for (int i = 0; i < nq; i++)
            q[i] = best[i] + q[i];
          far = 2.0 * far;
        }
      int info = gsnit (g, t, nq, nu, nlam, npt, k, job, p, r, q, qlo, qhi, iv, ns, iset, cst, 1.0,
                        w, wp, &f, dst);
      if (info < 0)
        return info;
      if (n == 0 || f < 0.999 * fb)
        {
          fb = f;
          memcpy (best, q, nq * sizeof (double));
        }
      if (fb <= 1e-9)
        break;
    }
  memcpy (q, best, nq * sizeof (double));
  int info = fb > 1e-9 && nlam > 0 ? gsnit (g, t, nq, nu, nlam, npt, k, job, p, r, q, qlo, qhi, iv,
                                            ns, iset, cst, 1e3, w, wp, &f, dst)
                                   : 0;
  memset (u, 0, nu * sizeof (double));
  if (info >= 0)
    info = gsnir (g, t, nu, nlam, npt, k, job, p, r, q, u, cst, 1.0, w, nr, wp, &f, dst);
  return info < 0 ? info : ! (f <= 1e-9);
}

int
gsnir (const gs_scene *g, double t, int nu, int nlam, int npt, int k, int job,
       const double *p, const double *r, const double *q, const double *u, const double *cst,
       double wt, double *res, int nr, double *w, double *f, double *dst)
{
  int info = 0;
  g->pnt (t, q, cst, w, w + 3 * npt);
  for (int i = 0; i < 3; i++)
    res[i] = p[i] - w[3 * (k - 1) + i];
  dst[0] = sqrt (res[0] * res[0] + res[1] * res[1] + res[2] * res[2]);
  dst[1] = 0.0;
  if (job == 1)
    {
      gsniv (r, w + 3 * npt + 9 * (k - 1), res + 3);
      dst[1] = sqrt (res[3] * res[3] + res[4] * res[4] + res[5] * res[5]);
    }
  if (nlam > 0)
    {
      double *phit = w + 12 * npt, *h = phit + nlam;
      info = g->con (t, q, u, cst, res + 3 + 3 * job, phit, h, nlam, h + nlam * nu);
      for (int i = 3 + 3 * job; i < nr; i++)
        res[i] = -wt * res[i];
    }
  *f = sqrt (gs_dot (nr, 0.0, res, res));
  return info;
}

/* close to half a turn, of the angle th with the cosine co: the axis from the symmetric part of e;
 * v: its skew part, on exit the rotation vector */
static void
half_turn (const double *e, double co, double th, double *v)
{
  double a[3], d = 0.0, si = 0.0;
  int l = e[4] > e[0] ? 1 : 0;
  if (e[8] > e[4 * l])
    l = 2;
  for (int i = 0; i < 3; i++)
    {
      a[i] = 0.5 * (e[i + 3 * l] + e[l + 3 * i]);
      if (i == l)
        a[i] = a[i] - co;
      d = d + a[i] * a[i];
      si = si + a[i] * v[i];
    }
  d = copysign (sqrt (d), si);
  for (int i = 0; i < 3; i++)
    v[i] = a[i] * (th / d);
}

/* axis and sine from the skew part of R S', close to half a turn the axis from the symmetric
 * part */
void
gsniv (const double *r, const double *s, double *v)
{
  double e[9];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      e[i + 3 * j] = r[i] * s[j] + r[i + 3] * s[j + 3] + r[i + 6] * s[j + 6];
  v[0] = 0.5 * (e[5] - e[7]);
  v[1] = 0.5 * (e[6] - e[2]);
  v[2] = 0.5 * (e[1] - e[3]);
  double si = sqrt (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  double co = 0.5 * (e[0] + e[4] + e[8] - 1.0), th = atan2 (si, co);
  if (! (si > 1e-3 || co > 0.0))
    half_turn (e, co, th, v);
  else if (si > 0.0)
    for (int i = 0; i < 3; i++)
      v[i] = v[i] * (th / si);
}

int
gsnij (const gs_scene *g, double t, const double *q, int nu, int nlam, int npt, int k, int job,
       const double *u, const double *cst, double wt, double *j, int nr, double *w)
{
  const int n = 3 + 3 * job;
  g->jpt (t, q, u, cst, w, w + 6 * npt * nu);
  for (int i = 0; i < nu; i++)
    memcpy (j + nr * i, w + 6 * ((k - 1) * nu + i), n * sizeof (double));
  if (nlam == 0)
    return 0;
  double *phi = w + 6 * npt * (nu + 1), *h = phi + 2 * nlam;
  int info = g->con (t, q, u, cst, phi, phi + nlam, h, nlam, h + nlam * nu);
  for (int i = 0; i < nu; i++)
    for (int l = 0; l < nlam; l++)
      j[n + nr * i + l] = wt * h[nlam * i + l];
  return info;
}

/* (j'j + mu) s = j'res without the speeds that u holds */
static void
solve (int nu, int nr, const double *j, const double *res, double mu, const double *u, double *a,
       double *s)
{
  for (int k = 0; k < nu; k++)
    {
      for (int i = 0; i <= k; i++)
        {
          double d = gs_dot (nr, 0.0, j + nr * i, j + nr * k);
          a[i + nu * k] = a[k + nu * i] = gs_max (u[i], u[k]) > 0.5 ? 0.0 : d;
        }
      a[k + nu * k] = a[k + nu * k] + mu;
      s[k] = u[k] > 0.5 ? 0.0 : gs_dot (nr, 0.0, j + nr * k, res);
    }
  (void)gsspd (nu, 1, a, nu, s, nu);
}

/* speeds of coordinates at a limit that s would pass become held: u = 1; 1 if there are any */
static int
held (int nq, const double *q, const double *qlo, const double *qhi, const int *iv,
      const double *s, double *u)
{
  int more = 0;
  for (int i = 0; i < nq; i++)
    {
      int k = iv[i] - 1;
      if (k >= 0 && u[k] < 0.5
          && ((q[i] <= qlo[i] && s[k] < 0.0) || (q[i] >= qhi[i] && s[k] > 0.0)))
        {
          u[k] = 1.0;
          more = 1;
        }
    }
  return more;
}

void
gsnis (const gs_scene *g, double t, int nq, int nu, int nr, const double *j, const double *res,
       double mu, const double *q, const double *qlo, const double *qhi, const int *iv, double *u,
       const double *cst, double *a, double *s, double *qn, double *qdot)
{
  double big = 0.0;
  for (int i = 0; i < nu; i++)
    u[i] = 0.0;
  for (int try = 0; try <= nu; try++)
    {
      solve (nu, nr, j, res, mu, u, a, s);
      if (! held (nq, q, qlo, qhi, iv, s, u))
        break;
    }
  for (int i = 0; i < nu; i++)
    big = gs_max (big, fabs (s[i]));
  for (int i = 0; i < nu; i++)
    {
      if (big > 0.5)
        s[i] = s[i] * (0.5 / big);
      u[i] = 0.0;
    }
  g->kin (t, q, s, cst, qdot);
  for (int i = 0; i < nq; i++)
    qn[i] = within (q[i] + qdot[i], qlo[i], qhi[i]);
}

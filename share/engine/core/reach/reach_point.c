#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

/* x within its limits */
static gs_real
within (gs_real x, gs_real low, gs_real high)
{
  return gs_min (gs_max (x, low), high);
}

/* Newton's method of least squares with damping (Levenberg and Marquardt) on place, rotation vector
 * and phi, on the exact Jacobian; a coordinate at its limit does not move beyond it. At most 200
 * steps, none longer than 0.5 rad or m.
 *
 * D. Marquardt, SIAM J. Appl. Math. 11 (1963), 431-441. */
int
gs_reach_point_near (const gs_scene *g, gs_real t, int nq, int nu, int nlam, int npt, int k,
                     int job, const gs_real *p, const gs_real *r, gs_real *q, const gs_real *qlo,
                     const gs_real *qhi, const int *iv, int ns, const int *iset, const gs_real *cst,
                     gs_real wt, gs_real *w, gs_real *wp, gs_real *f, gs_real *dst)
{
  const int nr = 3 + 3 * job + nlam;
  gs_real *res = w, *resn = res + nr, *j = resn + nr, *s = j + nr * nu, *qn = s + nu;
  gs_real *a = qn + nq, *u = a + nu * nu, fn, mu = GS_R (1e-3), err = 0;
  for (int i = 0; i < nq; i++)
    q[i] = within (q[i], qlo[i], qhi[i]);
  gs_normalize_sets (ns, iset, q, &err);
  for (int i = 0; i < nu; i++)
    u[i] = 0;
  int info
      = gs_reach_missed (g, t, nu, nlam, npt, k, job, p, r, q, u, cst, wt, res, nr, wp, f, dst);
  for (int n = 0; info >= 0 && n < 200 && ! (*f <= GS_R (1e-15)) && mu <= GS_R (1e8); n++)
    {
      info = gs_reach_jacobian (g, t, q, nu, nlam, npt, k, job, u, cst, wt, j, nr, wp);
      for (int better = 0; info >= 0 && ! better && mu <= GS_R (1e8);)
        {
          gs_reach_step (g, t, nq, nu, nr, j, res, mu, q, qlo, qhi, iv, u, cst, a, s, qn, wp);
          gs_normalize_sets (ns, iset, qn, &err);
          info = gs_reach_missed (g, t, nu, nlam, npt, k, job, p, r, qn, u, cst, wt, resn, nr, wp,
                                  &fn, dst);
          better = info >= 0 && fn < *f;
          mu = better ? gs_max (GS_R (0.1) * mu, GS_R (1e-14)) : 8 * mu;
          if (! better)
            continue;
          gs_copy (nq, qn, q);
          gs_copy (nr, resn, res);
          *f = fn;
        }
    }
  return info;
}

/* Newton's method of least squares (gs_reach_point_near). Where it ends without the pose, as on a
 * position between two ways to it (a closed chain stretched out), it begins again from five
 * positions beside the best one, 0.03 to 0.5 rad or m away. What is not reached then is approached
 * with phi counting a thousand times, so that dst is the distance with the loops closed, to 1e-6 of
 * itself. */
int
gs_reach_point (const gs_scene *g, gs_real t, int nq, int nu, int nlam, int npt, int k, int job,
                const gs_real *p, const gs_real *r, gs_real *q, const gs_real *qlo,
                const gs_real *qhi, const int *iv, int ns, const int *iset, const gs_real *cst,
                gs_real *w, gs_real *dst)
{
  const int nr = 3 + 3 * job + nlam;
  gs_real *s = w + (2 + nu) * nr, *u = s + nu + nq + nu * nu, *best = u + nu, *wp = best + nq;
  gs_real f, fb = 0, far = GS_R (0.03);
  for (int n = 0; n < 6; n++)
    {
      if (n > 0)
        {
          for (int i = 0; i < nu; i++)
            s[i] = far * gs_sin ((gs_real)(2 * (i + 1) + 3 * n * (i + 1) + n));
          g->kin (t, best, s, cst, q);
          for (int i = 0; i < nq; i++)
            q[i] = best[i] + q[i];
          far = 2 * far;
        }
      int info = gs_reach_point_near (g, t, nq, nu, nlam, npt, k, job, p, r, q, qlo, qhi, iv, ns,
                                      iset, cst, 1, w, wp, &f, dst);
      if (info < 0)
        return info;
      if (n == 0 || f < GS_R (0.999) * fb)
        {
          fb = f;
          gs_copy (nq, q, best);
        }
      if (fb <= GS_R (1e-9))
        break;
    }
  gs_copy (nq, best, q);
  int info = 0;
  if (fb > GS_R (1e-9) && nlam > 0)
    info = gs_reach_point_near (g, t, nq, nu, nlam, npt, k, job, p, r, q, qlo, qhi, iv, ns, iset,
                                cst, GS_R (1e3), w, wp, &f, dst);
  gs_zero (nu, u);
  if (info >= 0)
    info = gs_reach_missed (g, t, nu, nlam, npt, k, job, p, r, q, u, cst, 1, w, nr, wp, &f, dst);
  return info < 0 ? info : ! (f <= GS_R (1e-9));
}

int
gs_reach_missed (const gs_scene *g, gs_real t, int nu, int nlam, int npt, int k, int job,
                 const gs_real *p, const gs_real *r, const gs_real *q, const gs_real *u,
                 const gs_real *cst, gs_real wt, gs_real *res, int nr, gs_real *w, gs_real *f,
                 gs_real *dst)
{
  int info = 0;
  g->pnt (t, q, cst, w, w + 3 * npt);
  for (int i = 0; i < 3; i++)
    res[i] = p[i] - w[3 * (k - 1) + i];
  dst[0] = gs_sqrt (res[0] * res[0] + res[1] * res[1] + res[2] * res[2]);
  dst[1] = 0;
  if (job == 1)
    {
      gs_rotation_vector (r, w + 3 * npt + 9 * (k - 1), res + 3);
      dst[1] = gs_sqrt (res[3] * res[3] + res[4] * res[4] + res[5] * res[5]);
    }
  if (nlam > 0)
    {
      gs_real *phit = w + 12 * npt, *h = phit + nlam;
      info = g->con (t, q, u, cst, res + 3 + 3 * job, phit, h, nlam, h + nlam * nu);
      for (int i = 3 + 3 * job; i < nr; i++)
        res[i] = -wt * res[i];
    }
  *f = gs_sqrt (gs_dot (nr, 0, res, res));
  return info;
}

/* close to half a turn, of the angle th with the cosine co: the axis from the symmetric part of e;
 * v: its skew part, on exit the rotation vector */
static void
half_turn (const gs_real *e, gs_real co, gs_real th, gs_real *v)
{
  gs_real a[3], d = 0, si = 0;
  int l = e[4] > e[0] ? 1 : 0;
  if (e[8] > e[4 * l])
    l = 2;
  for (int i = 0; i < 3; i++)
    {
      a[i] = GS_R (0.5) * (e[i + 3 * l] + e[l + 3 * i]);
      if (i == l)
        a[i] = a[i] - co;
      d = d + a[i] * a[i];
      si = si + a[i] * v[i];
    }
  d = gs_copysign (gs_sqrt (d), si);
  for (int i = 0; i < 3; i++)
    v[i] = a[i] * (th / d);
}

/* axis and sine from the skew part of R S', close to half a turn the axis from the symmetric
 * part */
void
gs_rotation_vector (const gs_real *r, const gs_real *s, gs_real *v)
{
  gs_real e[9];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      e[i + 3 * j] = r[i] * s[j] + r[i + 3] * s[j + 3] + r[i + 6] * s[j + 6];
  v[0] = GS_R (0.5) * (e[5] - e[7]);
  v[1] = GS_R (0.5) * (e[6] - e[2]);
  v[2] = GS_R (0.5) * (e[1] - e[3]);
  gs_real si = gs_sqrt (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  gs_real co = GS_R (0.5) * (e[0] + e[4] + e[8] - 1), th = gs_atan2 (si, co);
  if (! (si > GS_R (1e-3) || co > 0))
    half_turn (e, co, th, v);
  else if (si > 0)
    for (int i = 0; i < 3; i++)
      v[i] = v[i] * (th / si);
}

int
gs_reach_jacobian (const gs_scene *g, gs_real t, const gs_real *q, int nu, int nlam, int npt, int k,
                   int job, const gs_real *u, const gs_real *cst, gs_real wt, gs_real *j, int nr,
                   gs_real *w)
{
  const int n = 3 + 3 * job;
  g->jpt (t, q, u, cst, w, w + 6 * npt * nu);
  for (int i = 0; i < nu; i++)
    gs_copy (n, w + 6 * ((k - 1) * nu + i), j + nr * i);
  if (nlam == 0)
    return 0;
  gs_real *phi = w + 6 * npt * (nu + 1), *h = phi + 2 * nlam;
  int info = g->con (t, q, u, cst, phi, phi + nlam, h, nlam, h + nlam * nu);
  for (int i = 0; i < nu; i++)
    for (int l = 0; l < nlam; l++)
      j[n + nr * i + l] = wt * h[nlam * i + l];
  return info;
}

/* (j'j + mu) s = j'res without the speeds that u holds */
static void
solve (int nu, int nr, const gs_real *j, const gs_real *res, gs_real mu, const gs_real *u,
       gs_real *a, gs_real *s)
{
  for (int k = 0; k < nu; k++)
    {
      for (int i = 0; i <= k; i++)
        {
          gs_real d = gs_dot (nr, 0, j + nr * i, j + nr * k);
          a[i + nu * k] = a[k + nu * i] = gs_max (u[i], u[k]) > GS_R (0.5) ? 0 : d;
        }
      a[k + nu * k] = a[k + nu * k] + mu;
      s[k] = u[k] > GS_R (0.5) ? 0 : gs_dot (nr, 0, j + nr * k, res);
    }
  (void)gs_solve_spd (nu, 1, a, nu, s, nu);
}

/* speeds of coordinates at a limit that s would pass become held: u = 1; 1 if there are any */
static int
held (int nq, const gs_real *q, const gs_real *qlo, const gs_real *qhi, const int *iv,
      const gs_real *s, gs_real *u)
{
  int more = 0;
  for (int i = 0; i < nq; i++)
    {
      int k = iv[i] - 1;
      if (k >= 0 && u[k] < GS_R (0.5)
          && ((q[i] <= qlo[i] && s[k] < 0) || (q[i] >= qhi[i] && s[k] > 0)))
        {
          u[k] = 1;
          more = 1;
        }
    }
  return more;
}

void
gs_reach_step (const gs_scene *g, gs_real t, int nq, int nu, int nr, const gs_real *j,
               const gs_real *res, gs_real mu, const gs_real *q, const gs_real *qlo,
               const gs_real *qhi, const int *iv, gs_real *u, const gs_real *cst, gs_real *a,
               gs_real *s, gs_real *qn, gs_real *qdot)
{
  gs_real big = 0;
  for (int i = 0; i < nu; i++)
    u[i] = 0;
  for (int try = 0; try <= nu; try++)
    {
      solve (nu, nr, j, res, mu, u, a, s);
      if (! held (nq, q, qlo, qhi, iv, s, u))
        break;
    }
  for (int i = 0; i < nu; i++)
    big = gs_max (big, gs_abs (s[i]));
  for (int i = 0; i < nu; i++)
    {
      if (big > GS_R (0.5))
        s[i] = s[i] * (GS_R (0.5) / big);
      u[i] = 0;
    }
  g->kin (t, q, s, cst, qdot);
  for (int i = 0; i < nq; i++)
    qn[i] = within (q[i] + qdot[i], qlo[i], qhi[i]);
}

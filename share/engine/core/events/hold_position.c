/* gs_hold_position: a state is moved to where the ports that are held are held: stops in contact to
 * their ends, the speeds of all of them to 0; gs_hold_after_step: so behind a step of a run.
 *
 * As gs_project does with the loops: the nearest state in the metric of the mass matrix, on the
 * constraints as well, by two steps of Newton for the coordinates (where the speeds are their
 * rates) and one for the speeds. A port that is one of the speeds keeps both by itself where there
 * are no loops: x stays. */

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/solve.h"

/* the ports of a scene, as gs_ports_held has them */
typedef struct
{
  int nh;
  const int *kind, *mode;
  gs_real *row, *s, *sd, *prm;
} ports;

static int
is_held (const ports *p, int i)
{
  return p->kind[i] == 2 ? p->mode[i] != 0 : p->mode[i] == 0;
}

static gs_real
end_of (const ports *p, int i)
{
  return p->prm[4 * i + (p->mode[i] > 0 ? 1 : 0)];
}

/* how far they are from where they are held: off of stops beside the way between their ends, fast
 * of speeds beside the slowest rebound or Stribeck's speed; 0 where no held port has other speeds
 * or loops beside it */
static void
away (int nu, int nlam, const ports *p, gs_real *off, gs_real *fast)
{
  int most = 0;
  *off = *fast = 0;
  for (int i = 0; i < p->nh; i++)
    {
      const gs_real *const prm = p->prm + 4 * i;
      if (! is_held (p, i))
        continue;
      const int stop = p->kind[i] == 2;
      const gs_real gap
          = stop ? gs_abs (end_of (p, i) - p->s[i]) / gs_stop_travel (p->s[i], prm) : 0;
      int n = 0;
      for (int j = 0; j < nu; j++)
        n += gs_abs (p->row[i + p->nh * j]) > 0;
      most = gs_most (most, n);
      *off = gs_max (*off, gap);
      *fast = gs_max (*fast, gs_abs (p->sd[i]) / (stop ? prm[3] : prm[1]));
    }
  if (! (most > 1 || (most > 0 && nlam > 0)))
    *off = *fast = 0;
}

/* one step: the coordinates (job 1) or the speeds (2) */
static int
move (const gs_scene *s, int job, gs_real t, gs_real *x, const gs_real *cst, const ports *p,
      gs_real *a, gs_real *h, gs_real *phit, gs_real *u, gs_real *w)
{
  const int nq = s->nq, nu = s->nu, nlam = s->nlam, nh = p->nh, m = nlam + nh;
  gs_real *const g = w + nq + 2 * nlam, *const f = g + m, *const d = f + nu, *const lam = d + nu,
         *const ww = lam + m;
  int info = gs_impact_matrices (s, t, x, cst, nh, p->row, a, h, phit, u, w), l = nlam;
  if (info != 0)
    return info;
  for (int i = 0; i < nlam; i++)
    {
      g[i] = job == 1 ? -w[nq + i] : -phit[i];
      for (int j = 0; j < nu && job == 2; j++)
        g[i] -= h[i + m * j] * u[j];
    }
  for (int i = 0; i < nh; i++)
    {
      if (! is_held (p, i) || (p->kind[i] == 1 && job == 1))
        continue;
      for (int j = 0; j < nu; j++)
        h[l + m * j] = h[nlam + i + m * j];
      g[l++] = job == 1 ? end_of (p, i) - p->s[i] : -p->sd[i];
    }
  gs_zero (nu, f);
  info = gs_solve_kkt (nu, l, a, nu, h, m, f, g, d, lam, ww);
  if (info != 0 && info != 2)
    return info;
  for (int j = 0; j < nu; j++)
    x[(job == 2 ? nq : 0) + j] += d[j];
  return 0;
}

int
gs_hold_position (const gs_scene *s, gs_real t, gs_real *x, const gs_real *v, const gs_real *cst,
                  int nh, const int *kind, const int *mode, gs_real *row, gs_real *pos, gs_real *sd,
                  gs_real *prm, gs_real *a, gs_real *h, gs_real *phit, gs_real *u, gs_real *w)
{
  const ports p = { nh, kind, mode, row, pos, sd, prm };
  gs_real off, fast;
  s->hld (t, x, v, cst, row, nh, pos, sd, prm);
  away (s->nu, s->nlam, &p, &off, &fast);
  for (int k = 0; k < 2 && s->nq == s->nu && off > GS_R2 (1e-14, 1e-6); k++)
    {
      int info = move (s, 1, t, x, cst, &p, a, h, phit, u, w);
      if (info != 0)
        return info;
      s->hld (t, x, v, cst, row, nh, pos, sd, prm);
      away (s->nu, s->nlam, &p, &off, &fast);
      fast = gs_max (fast, 1);
    }
  return fast > GS_R2 (1e-14, 1e-6) ? move (s, 2, t, x, cst, &p, a, h, phit, u, w) : 0;
}

int
gs_hold_after_step (const gs_scene *s, int method, gs_real t, gs_real *x, int nx, int *ip,
                    gs_real *rp, const gs_real *cst, gs_real *v, gs_real rtol, const gs_real *atol)
{
  const gs_events e = gs_events_of (nx, ip + ip[GS_EVENTS] - 1, rp + ip[GS_EVENTS + 1] - 1);
  int held = 0, moved = 0;
  for (int i = 0; i < e.ne; i++)
    held |= (e.kind[i] == 1 && e.mode[i] == 0) || (e.kind[i] == 2 && e.mode[i] != 0);
  if (! held)
    return 0;
  gs_copy (nx, x, e.z);
  int info = s->rst (t, x, v, e.mode, -5, cst);
  for (int i = 0; i < nx; i++)
    {
      const gs_real by = gs_abs (x[i] - e.z[i]),
                   most = method == 4 ? GS_R (1e-3) * (1 + gs_abs (x[i]))
                                      : GS_R (1e3) * (atol[i] + rtol * gs_abs (x[i]));
      moved |= by > 0;
      if (! (by <= most))
        info = 1;
    }
  if (info == 0)
    return moved;
  gs_copy (nx, e.z, x);
  return 0;
}

/* share/engine/core/events and what of share/engine/core/integrate is called by itself, against
   share/fortran */
#include "bridge.h"
#include "gsmbp/events.h"

void gsevt_ (), gsrst_ (), gsimp_ (), gsstk_ (), gsfre_ (), gsevh_ (), gspth_ (), gsjmp_ (),
  gshld_ (), gsipt_ (), gsipm_ (), gsevg_ (), gshjc_ (), gsipb_ (), gsipc_ ();
gs_real gsevp_ ();

/* a symmetric matrix of order n, positive definite but for some cases */
static void
masses (int n, pair a)
{
  gs_real b[64];
  const int less = pick (8) == 0;
  for (int i = 0; i < n * n; i++)
    b[i] = chance ();
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      {
        gs_real s = less ? 0 : i == j ? 0.3 : 0;
        for (int k = less ? 1 : 0; k < n; k++)
          s += b[i + n * k] * b[j + n * k];
        a.c[i + n * j] = s;
      }
  both (a);
}

/* constraints and ports h (m+k,n): some rows depend on others */
static void
rows (int n, int nr, pair h)
{
  if (pick (3) == 0 && nr > 1)
    for (int j = 0; j < n; j++)
      h.c[nr - 1 + nr * j] = 2 * h.c[nr * j];
  if (pick (6) == 0 && nr > 0)
    for (int j = 0; j < n; j++)
      h.c[nr * j] = 0;
  both (h);
}

typedef struct
{
  int n, m, k, nr, kind[4], mode[4], fmode[4];
  pair a, h, phit, u, s, sd, prm, hold, w, gv;
} ports;

static ports
some_ports (void)
{
  ports p = { .n = 1 + pick (5), .k = 1 + pick (4) };
  p.m = pick (p.n < 3 ? p.n : 3);
  p.nr = p.m + p.k;
  for (int i = 0; i < 4; i++)
    {
      p.kind[i] = 1 + pick (2);
      p.mode[i] = p.fmode[i] = pick (3) - 1;
    }
  p.a = pair_of (p.n * p.n);
  p.h = pair_of (p.nr * p.n);
  p.phit = pair_of (p.m);
  p.u = pair_of (p.n);
  p.s = pair_of (p.k);
  p.sd = pair_of (p.k);
  p.prm = pair_of (4 * p.k);
  p.hold = pair_of (p.k);
  p.gv = pair_of (p.k);
  p.w = pair_of (3000);
  masses (p.n, p.a);
  rows (p.n, p.nr, p.h);
  for (int i = 0; i < p.k; i++)
    {
      gs_real *prm = p.prm.c + 4 * i;
      prm[0] = p.kind[i] == 1 ? gs_abs (prm[0]) : -gs_abs (prm[0]) - 0.01;
      prm[1] = gs_abs (prm[1]) + 0.01;
      prm[2] = gs_abs (prm[2]);
      prm[3] = pick (2) ? 0.9 : 1e-3;
      if (pick (4) == 0)
        p.s.c[i] = prm[pick (2)];
      if (pick (5) == 0)
        p.sd.c[i] = 0;
    }
  both (p.prm);
  both (p.s);
  both (p.sd);
  return p;
}

static void
drop_ports (ports p)
{
  const pair all[] = { p.a, p.h, p.phit, p.u, p.s, p.sd, p.prm, p.hold, p.w, p.gv };
  for (int i = 0; i < 10; i++)
    drop (all[i]);
}

static void
what_happens (void)
{
  begin ("gs_port_functions, gs_port_reset, gs_port_impulse");
  for (int i = 0; i < 4000; i++)
    {
      ports p = some_ports ();
      int l = pick (p.k + 2) - 1, info = 0;
      gs_port_functions (p.k, p.kind, p.mode, p.s.c, p.sd.c, p.prm.c, p.hold.c, p.gv.c);
      gsevt_ (&p.k, p.kind, p.mode, p.s.f, p.sd.f, p.prm.f, p.hold.f, p.gv.f);
      same (p.gv);
      gsrst_ (&p.n, &p.m, &p.k, &l, p.kind, p.fmode, p.s.f, p.sd.f, p.prm.f, p.hold.f, p.a.f, &p.n,
              p.h.f, &p.nr, p.phit.f, p.u.f, p.w.f, &info);
      same_int (gs_port_reset (p.n, p.m, p.k, l, p.kind, p.mode, p.s.c, p.sd.c, p.prm.c, p.hold.c,
                               p.a.c, p.n, p.h.c, p.nr, p.phit.c, p.u.c, p.w.c),
                info);
      same (p.u);
      l = pick (p.k + 1);
      gsimp_ (&p.n, &p.m, &p.k, &l, D (0.3), p.kind, p.fmode, p.a.f, &p.n, p.h.f, &p.nr, p.phit.f,
              p.u.f, p.w.f, &info);
      int found = gs_port_impulse (p.n, p.m, p.k, l, 0.3, p.kind, p.mode, p.a.c, p.n, p.h.c, p.nr,
                                   p.phit.c, p.u.c, p.w.c);
      if (found || info)
        same_int (found, info);
      same (p.u);
      for (int j = 0; j < p.k; j++)
        same_int (p.mode[j], p.fmode[j]);
      drop_ports (p);
    }
  finish ();
}

static void
held_ports (void)
{
  begin ("gs_port_holding, gs_port_is_free");
  for (int i = 0; i < 4000; i++)
    {
      ports p = some_ports ();
      pair f = pair_of (p.n), g = pair_of (p.nr), ud = pair_of (p.n), lam = pair_of (p.m);
      int act[4], info = 0, freec, freef;
      for (int j = 0; j < 4; j++)
        act[j] = pick (2);
      gsstk_ (&p.n, &p.m, &p.k, p.a.f, &p.n, p.h.f, &p.nr, f.f, g.f, act, ud.f, lam.f, p.hold.f,
              p.w.f, &info);
      same_int (gs_port_holding (p.n, p.m, p.k, p.a.c, p.n, p.h.c, p.nr, f.c, g.c, act, ud.c, lam.c,
                                 p.hold.c, p.w.c),
                info);
      same (ud);
      same (lam);
      same (p.hold);
      same (p.h);
      same (g);
      for (int row = 1; row <= p.nr; row++)
        {
          gsfre_ (&p.n, &p.m, p.a.f, &p.n, p.h.f, &p.nr, &row, p.w.f, &freef);
          gs_port_is_free (p.n, p.m, p.a.c, p.n, p.h.c, p.nr, row, p.w.c, &freec);
          same_int (freec, freef);
        }
      drop (f);
      drop (g);
      drop (ud);
      drop (lam);
      drop_ports (p);
    }
  finish ();
}

static void
within_steps (void)
{
  begin ("gs_event_cubic, gs_event_point, gs_passage_path, gs_largest_move");
  for (int i = 0; i < 300; i++)
    {
      int n = pick (6), ns = 8 + 4 * pick (2);
      const gs_real h = chance (), b = pick (4) ? 0.5 * (chance () + 1) : 1;
      pair x = pair_of (n), xd = pair_of (n), xn = pair_of (n), z = pair_of (n), q = pair_of (12),
           f = pair_of (13 * n), jump = pair_of (2);
      gs_event_cubic (n, h, b, x.c, xd.c, xn.c, f.c, z.c);
      gsevh_ (&n, &h, &b, x.f, xd.f, xn.f, f.f, z.f);
      same (z);
      gs_passage_path (n, ns, n, x.c, h, q.c, f.c, z.c);
      gspth_ (&n, &ns, &n, x.f, &h, q.f, f.f, z.f);
      same (z);
      gs_largest_move (n / 2, n - n / 2, x.c, xn.c, 1e-3, q.c, jump.c);
      gsjmp_ (I (n / 2), I (n - n / 2), x.f, xn.f, D (1e-3), q.f, jump.f);
      same (jump);
      same_numbers (1, D (gs_event_point (i, 300)), D (gsevp_ (&i, I (300))));
      drop (x);
      drop (xd);
      drop (xn);
      drop (z);
      drop (q);
      drop (f);
      drop (jump);
    }
  finish ();
}

/* ------------------------------------------------------------ ports of a scene */

static const ports *here;

static int
stk (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *ud, gs_real *lam,
     gs_real *hold)
{
  (void)cst;
  for (int i = 0; i < here->n; i++)
    ud[i] = t * x[i];
  for (int i = 0; i < here->m; i++)
    lam[i] = x[i];
  for (int i = 0; i < here->k; i++)
    hold[i] = here->hold.f[i] + v[i];
  return 0;
}

static void
stk_ (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *ud,
      gs_real *lam, gs_real *hold, int *info)
{
  *info = stk (*t, x, v, cst, ud, lam, hold);
}

static void
hld (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *row, int ldr,
     gs_real *s, gs_real *sd, gs_real *prm)
{
  (void)t, (void)x, (void)cst;
  for (int i = 0; i < here->k; i++)
    {
      for (int j = 0; j < here->n; j++)
        row[i + ldr * j] = here->h.f[here->m + i + here->nr * j];
      s[i] = here->s.f[i];
      sd[i] = here->sd.f[i] * (2 + v[i]);
      memcpy (prm + 4 * i, here->prm.f + 4 * i, 4 * sizeof (gs_real));
    }
}

static void
hld_ (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *row,
      const int *ldr, gs_real *s, gs_real *sd, gs_real *prm)
{
  hld (*t, x, v, cst, row, *ldr, s, sd, prm);
}

static void
mas (gs_real t, const gs_real *q, const gs_real *cst, gs_real *m, int ldm)
{
  (void)t, (void)q, (void)cst;
  for (int j = 0; j < here->n; j++)
    memcpy (m + ldm * j, here->a.f + here->n * j, here->n * sizeof (gs_real));
}

static void
mas_ (const gs_real *t, const gs_real *q, const gs_real *cst, gs_real *m, const int *ldm)
{
  mas (*t, q, cst, m, *ldm);
}

static int
con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi, gs_real *phit,
     gs_real *hc, int ldh, gs_real *gam)
{
  (void)q, (void)u, (void)cst;
  for (int i = 0; i < here->m; i++)
    {
      phi[i] = gam[i] = 0;
      phit[i] = here->phit.f[i];
      for (int j = 0; j < here->n; j++)
        hc[i + ldh * j] = here->h.f[i + here->nr * j];
    }
  return t > 0.9 ? 4 : 0;
}

static void
con_ (const gs_real *t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
      gs_real *phit, gs_real *hc, const int *ldh, gs_real *gam, int *info)
{
  *info = con (*t, q, u, cst, phi, phit, hc, *ldh, gam);
}

static void
ports_of_a_scene (void)
{
  int jumps = 0, wrong = 0;
  begin ("gs_ports_held, gs_impact, gs_impact_matrices, gs_release_port, gs_correct_modes, "
         "gs_hold_position");
  for (int i = 0; i < 2000; i++)
    {
      ports p = some_ports ();
      const int n = p.n, nv = p.k + 1, l = pick (4) == 0 ? -3 - pick (3) : pick (p.k + 2) - 1;
      const int ipl[4] = { 2, 1, 3, 4 };
      gs_scene s = { .nq = n, .nu = n, .nx = 2 * n, .nv = nv, .nlam = p.m, .mas = mas, .con = con,
                     .stk = stk, .hld = hld };
      const gs_real t = chance ();
      pair x = pair_of (2 * n), v = pair_of (nv);
      pair w = pair_of (3 * n * n + 3 * n * p.nr + p.k * n + p.nr * p.nr + nv + n + 6 * n
                        + 14 * p.nr + 10 * p.k + 4);
      int info = 0;
      here = &p;
      const gs_real before = x.c[n];
      const ports was = p;
      int made = gs_impact (&s, t, x.c, v.c, p.mode, l, 0, p.k, p.kind, ipl, w.c);
      gsipt_ (stk_, hld_, mas_, con_, &t, x.f, v.f, p.fmode, &l, (gs_real *)0, &n, &n, &nv, &p.m,
              &p.k, p.kind, ipl, w.f, &info);
      same_int (made, info);
      same (x);
      same (v);
      for (int j = 0; j < p.k; j++)
        {
          same_int (p.mode[j], p.fmode[j]);
          wrong += l == -4 && p.mode[j] != was.mode[j];
        }
      jumps += x.c[n] != before;
      drop (x);
      drop (v);
      drop (w);
      drop_ports (p);
    }
  finish ();
  holds (jumps > 100, "... speeds that jump");
  holds (wrong > 100, "... modes that contradict the state");
}

static void
derivatives_of_functions (void)
{
  begin ("gs_port_gradient");
  for (int i = 0; i < 1000; i++)
    {
      const int n = pick (5), nh = 1 + pick (4), nc = 1 + pick (4), k = 1 + pick (nh);
      int kind[4], mode[4];
      pair s = pair_of (nh), prm = pair_of (4 * nh), hold = pair_of (nh), d = pair_of (6 * nh * nc);
      pair z = pair_of ((n + nh) * nc), g = pair_of (nc);
      for (int j = 0; j < nh; j++)
        {
          kind[j] = 1 + pick (2);
          mode[j] = pick (3) - 1;
        }
      gs_port_gradient (n, nh, nc, k, kind, mode, s.c, prm.c, hold.c, d.c, z.c, g.c);
      gsevg_ (&n, &nh, &nc, &k, kind, mode, s.f, prm.f, hold.f, d.f, z.f, g.f);
      same (g);
      pair all[] = { s, prm, hold, d, z, g };
      for (int j = 0; j < 6; j++)
        drop (all[j]);
    }
  finish ();
}

static void
derivatives_of_what_happens (void)
{
  int hits[3] = { 0 };
  begin ("gs_impact_gradient, gs_impact_columns");
  for (int i = 0; i < 2000; i++)
    {
      ports p = some_ports ();
      const int nu = p.n, nq = nu + pick (2), more = pick (3), np = pick (3), n = nu + p.nr,
                nc = nq + nu + np + 1, nxv = nq + nu + more, l = pick (p.k + 2) - 1;
      int after[4], ic[20], jf[20], hit, fhit, info = 0;
      pair x = pair_of (nq + nu), ua = pair_of (nu), row = pair_of (p.k * nu);
      pair h = pair_of (p.m * nu);
      pair c = pair_of (n * n), q = pair_of (n), ud = pair_of (nu), r = pair_of (nu * nc);
      pair d = pair_of (6 * p.k * (nxv + np + 1)), e = pair_of (n * (nq + np + 1));
      pair b = pair_of (n * nc);
      for (int j = 0; j < p.k; j++)
        after[j] = pick (3) - 1;
      int made = gs_impact_gradient (nq, nu, p.m, p.k, nc, l, p.kind, p.mode, after, p.s.c, p.sd.c,
                                     p.prm.c, x.c, ua.c, row.c, p.a.c, h.c, p.phit.c, c.c, q.c,
                                     ud.c, ic, r.c, &hit);
      gsipb_ (&nq, &nu, &p.m, &p.k, &nc, &l, p.kind, p.mode, after, p.s.f, p.sd.f, p.prm.f, x.f,
              ua.f, row.f, p.a.f, h.f, p.phit.f, c.f, q.f, ud.f, jf, r.f, &fhit, &info);
      same_int (made, info);
      same_int (hit, fhit);
      same (r);
      if (hit >= 0 && made == 0)
        {
          same_numbers (p.nr, q.c, q.f);
          same (ud);
          made = gs_impact_columns (nq, nu, p.m, nxv, p.k, np, hit, l, p.kind, after, p.sd.c,
                                    p.prm.c, row.c, p.a.c, h.c, d.c, e.c, c.c, b.c, ic, r.c);
          gsipc_ (&nq, &nu, &p.m, &nxv, &p.k, &np, &hit, &l, p.kind, after, p.sd.f, p.prm.f, row.f,
                  p.a.f, h.f, d.f, e.f, c.f, b.f, jf, r.f, &info);
          same_int (made, info);
          if (made == 0)
            same (r);
        }
      hits[hit < 0 ? 0 : hit > 0 ? 1 : 2]++;
      pair all[] = { x, ua, row, h, c, q, ud, r, d, e, b };
      for (int j = 0; j < 11; j++)
        drop (all[j]);
      drop_ports (p);
    }
  finish ();
  holds (hits[0] > 100 && hits[1] > 50 && hits[2] > 100, "... no jump, a hit, a jump");
}

/* rows that say the same twice, ports that are free, constraints that depend on one another */
static void
jacobians_of_held_ports (void)
{
  int infos[4] = { 0 };
  begin ("gs_held_jacobian, gs_held_duplicates, gs_held_repack");
  for (int i = 0; i < 1000; i++)
    {
      const int nu = 2 + pick (4), m = pick (nu), nh = 1 + pick (3), nq = nu + pick (2),
                nz = nq + nu + pick (3), n = nu + m + nh;
      pair lm = pair_of (nu * nu), lb = pair_of (nu * nu), lc = pair_of (nu * nq);
      pair k = pair_of (n * n), z = pair_of (n * nz);
      int c[20], f[20], held[3], fheld[3], info = 0;
      for (int j = 0; j < nh; j++)
        held[j] = fheld[j] = pick (3) > 0;
      for (int j = 0; j < n * n; j++)
        if (j % n >= nu && j / n >= nu)
          k.c[j] = 0;
      for (int l = nu; l < n; l++)
        for (int j = 0; j < nu; j++)
          {
            if (i % 4 == 0 && l == n - 1 && m > 0)
              k.c[l + n * j] = 3 * k.c[nu + n * j];
            if (i % 9 == 0 && l == nu + 1 && m > 1)
              k.c[l + n * j] = k.c[nu + n * j];
            k.c[j + n * l] = k.c[l + n * j];
          }
      for (int l = 0; l < nu; l++)
        for (int j = 0; j < nu; j++)
          k.c[l + n * j] = l == j ? 4 : 0.5 / (l + j);
      both (k);
      const int made = gs_held_jacobian (nu, m, nh, nq, nz, held, lm.c, lb.c, lc.c, k.c, z.c, c);
      gshjc_ (&nu, &m, &nh, &nq, &nz, fheld, lm.f, lb.f, lc.f, k.f, z.f, f, &info);
      same_int (made, info);
      for (int j = 0; j < nh; j++)
        same_int (held[j], fheld[j]);
      same (z);
      infos[made]++;
      pair all[] = { lm, lb, lc, k, z };
      for (int j = 0; j < 5; j++)
        drop (all[j]);
    }
  finish ();
  holds (infos[0] > 100 && infos[2] > 20 && infos[3] > 50,
         "... unique, dependent constraints, dependent ports");
}

int
main (void)
{
  what_happens ();
  derivatives_of_functions ();
  derivatives_of_what_happens ();
  jacobians_of_held_ports ();
  held_ports ();
  within_steps ();
  ports_of_a_scene ();
  return 0;
}

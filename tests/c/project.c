/* The routines of share/engine/core/loops that emitted subroutines call: projection, motions of
 * closed chains, Jacobians; on the scenes of chains.h and on numbers by chance */
#include "chains.h"
#include "gsmbp/loops.h"

void gsprj_ (), gspjq_ (), gspju_ (), gsnrm_ (), gsnrq_ (), gsclo_ (), gsclq_ (), gscld_ (),
  gsclm_ (), gsjac_ (), gsjdf_ (), gsjrw_ (), gsjth_ ();

/* ------------------------------------------------------------ what the scenes lack */

static int mass_is_singular;

/* a positive definite matrix that depends on the position */
static void
mas (gs_real t, const gs_real *q, const gs_real *cst, gs_real *m, int ldm)
{
  (void)t;
  (void)cst;
  for (int j = 0; j < scene->nu; j++)
    for (int i = 0; i < scene->nu; i++)
      m[i + ldm * j] = mass_is_singular ? 0.0 : i == j ? 2.0 + 0.3 * i : 0.2 * gs_cos (q[i] - q[j]);
}

static void
mas_ (const gs_real *t, const gs_real *q, const gs_real *cst, gs_real *m, const int *ldm)
{
  mas (*t, q, cst, m, *ldm);
}

static void
gad (gs_real t, const gs_real *qj, const gs_real *cst, gs_real *g)
{
  for (int i = 0; i < scene->nlam; i++)
    g[i] = cst[0] * qj[scene->nu + i] * qj[2 * scene->nu + i] - t;
}

static void
gad_ (const gs_real *t, const gs_real *qj, const gs_real *cst, gs_real *g)
{
  gad (*t, qj, cst, g);
}

/* scene k of chains.h, with its routines; cst as there */
static void
choose (gs_scene *s, int k, gs_real *cst)
{
  *s = scene_of (k);
  s->mas = mas;
  s->gad = gad;
  scene = s;
  phi_of = list[k].phi;
  cst[0] = list[k].length;
  cst[1] = cst[2] = cst[3] = 1e9;
}

/* ------------------------------------------------------------ */

static const int sets[8] = { 1, 2, 3, 4, 4, 2, 1, 3 };

static void
norms (void)
{
  begin ("gs_normalize_sets, gs_normalize_set");
  for (int k = 0; k < 100; k++)
    {
      const int ns = pick (3);
      pair q = pair_of (5), err = pair_of (1);
      gs_normalize_sets (ns, sets, q.c, err.c);
      gsnrm_ (&ns, sets, q.f, err.f);
      same (q);
      same (err);
      gs_normalize_set (q.c + 1, err.c);
      gsnrq_ (q.f + 1, err.f);
      same (q);
      same (err);
      drop (q);
      drop (err);
    }
  finish ();
}

static void
projections (void)
{
  int seen[6] = { 0 };
  begin ("gs_project, gs_project_position, gs_project_speeds");
  for (int k = 0; k < 600; k++)
    {
      gs_scene s;
      gs_real cst[4];
      const int one = k % 5;
      choose (&s, one, cst);
      const int nq = s.nq, nu = s.nu, m = s.nlam, quasi = nq > nu, ns = quasi;
      const gs_real size = gs_pow (10.0, -pick (7)), t = k % 13 ? 0.1 : 1.0;
      pair x = pair_of (s.nx), res = pair_of (1);
      pair w = pair_of (2 * nu * nu + 2 * nu * m + m * m + 5 * nu + 10 * m + 2 * nq);
      for (int i = 0; i < s.nx; i++)
        x.c[i] = list[one].x[i] + size * x.c[i] * (k % 9 ? 1 : 20);
      both (x);
      if (k % 23 == 0)
        cst[0] *= 4; /* four bars that do not close */
      mass_is_singular = k % 50 == 49;
      cst[1] = k % 17 ? 1e9 : 0.05;
      int info = 0, made = gs_project (&s, t, x.c, quasi, ns, sets, cst, res.c, w.c);
      gsprj_ (con_, mas_, kin_, &t, x.f, &nq, &nu, &m, &quasi, &ns, sets, cst, res.f, w.f, &info);
      same_int (made, info);
      same (x);
      same (res);
      seen[made]++;
      drop (x);
      drop (res);
      drop (w);
    }
  mass_is_singular = 0;
  finish ();
  holds (seen[0] > 200 && seen[1] > 5 && seen[3] > 3, "... done, singular and not found");
}

/* two rows that cannot hold together, q1 = 0 and q1 = a gap: beyond 1e-9 there is no such
 * position */
static gs_real gap;
static void
two_rows (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi, gs_real *phit, gs_real *dq)
{
  (void)t;
  (void)cst;
  phi[0] = q[0];
  phi[1] = q[0] - gap;
  phit[0] = phit[1] = dq[2] = dq[3] = 0.0;
  dq[0] = dq[1] = 1.0;
}

static void
impossible (void)
{
  const int nq = 2, m = 2, none = 0;
  const gs_real t = 0.0, cst[4] = { 1.0, 1e9, 1e9, 1e9 };
  gs_scene s = { .nq = 2, .nu = 2, .nx = 4, .nlam = 2, .con = con, .kin = kin, .mas = mas };
  begin ("gs_project");
  scene = &s;
  phi_of = two_rows;
  int right = 0;
  for (int k = 0; k <= 12; k++)
    {
      pair x = pair_of (4), res = pair_of (1), w = pair_of (100);
      gap = 3.0 * gs_pow (0.1, k);
      int info = 0, made = gs_project (&s, t, x.c, 0, 0, sets, cst, res.c, w.c);
      gsprj_ (con_, mas_, kin_, &t, x.f, &nq, &nq, &m, &none, &none, sets, cst, res.f, w.f, &info);
      same_int (made, info);
      same (x);
      right += made == (k <= 9 ? 3 : 0);
      drop (x);
      drop (res);
      drop (w);
    }
  finish ();
  holds (right == 13, "... rows that cannot hold together are told");
}

static void
motions (void)
{
  int seen[3] = { 0 };
  static const int id[][4] = { { 2 }, { 2, 3 }, { 3, 1 }, { 2, 4, 3 } };
  static const int ia[][4] = { { 1 }, { 1 }, { 2 }, { 1 } };
  begin ("gs_close_motion, gs_close_positions, gs_close_derivatives, gs_close_matrix");
  for (int k = 0; k < 400; k++)
    {
      gs_scene s;
      gs_real cst[4];
      const int one = k % 4, r = pick (4);
      choose (&s, one, cst);
      const int nu = s.nu, m = s.nlam;
      const gs_real t = 0.3 * chance ();
      pair qj = pair_of (nu * (r + 2)), res = pair_of (1);
      pair w = pair_of (m * m + m * nu + 4 * m);
      int ic[MOST], jf[MOST], info = 0;
      for (int i = 0; i < nu; i++)
        qj.c[i] = list[one].x[i] + (k % 7 ? 0.1 : 2.0) * qj.c[i];
      both (qj);
      res.c[0] = res.f[0] = 0.0;
      cst[1] = k % 17 ? 1e9 : -1e9;
      int made = gs_close_motion (&s, t, qj.c, r, id[one], ia[one], cst, res.c, w.c, ic);
      gsclo_ (con_, gad_, &t, qj.f, &nu, &m, &r, id[one], ia[one], cst, res.f, w.f, jf, &info);
      same_int (made, info);
      same (qj);
      same (res);
      seen[made]++;
      drop (qj);
      drop (res);
      drop (w);
    }
  finish ();
  holds (seen[0] > 100 && seen[1] > 20 && seen[2] > 3, "... done, singular and not closed");
}

/* a positive definite matrix of order n in the first columns of a */
static void
definite (int n, pair a)
{
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      a.c[i + n * j] = i == j ? 3.0 + 0.1 * i : 0.3 / (1 + i + j);
  both (a);
}

static void
jacobians (void)
{
  int seen = 0;
  begin ("gs_loop_jacobian, gs_loop_jacobian_deficient");
  for (int k = 0; k < 400; k++)
    {
      const int nu = 1 + pick (5), m = pick (nu + 1), nq = nu + pick (2);
      const int nz = nq + nu + pick (3), n = nu + m, lost = k % 3 == 0 ? 2 : 0;
      pair lm = pair_of (nu * nu), lb = pair_of (nu * nu), lc = pair_of (nu * nq);
      pair kk = pair_of (n * n), z = pair_of (n * nz), h = pair_of (m * nu), phi = pair_of (m);
      pair hc = pair_of (m * nu), ud = pair_of (nu), lam = pair_of (m);
      pair w = pair_of (2 * nu * nu + nu * m + m * m + 4 * nu + 8 * m);
      int ic[20], jf[20], grp[MOST], info = lost;
      for (int i = 0; i < m; i++)
        {
          phi.c[i] = phi.f[i] = 1e-9 * chance ();
          grp[i] = k % 2 ? 0 : 1;
        }
      for (int j = 0; j < nu && m > 1 && k % 4 == 0; j++)
        h.c[m - 1 + m * j] = h.f[m - 1 + m * j] = 2.0 * h.c[m * j];
      if (k % 11)
        definite (nu, lm);
      for (int i = 0; i < n * n && k % 7 == 0; i++)
        kk.c[i] = kk.f[i] = 0.0;
      int made = gs_loop_jacobian (nu, m, nq, nz, lm.c, lb.c, lc.c, kk.c, z.c, ic, info);
      gsjac_ (&nu, &m, &nq, &nz, lm.f, lb.f, lc.f, kk.f, z.f, jf, &info);
      same_int (made, info);
      same (z);
      same (kk);
      if (made > 0)
        {
          made = gs_loop_jacobian_deficient (nu, m, nz, lm.c, h.c, phi.c, grp, z.c, hc.c, ud.c,
                                             lam.c, w.c);
          gsjdf_ (&nu, &m, &nz, lm.f, h.f, phi.f, grp, z.f, hc.f, ud.f, lam.f, w.f, &info);
          same_int (made, info);
          same (z);
          seen += made == 0;
        }
      pair all[] = { lm, lb, lc, kk, z, h, phi, hc, ud, lam, w };
      for (int i = 0; i < 11; i++)
        drop (all[i]);
    }
  finish ();
  holds (seen > 50, "... column by column");
}

static void
rows (void)
{
  begin ("gs_rate_rows, gs_rate_rows_through");
  for (int k = 0; k < 200; k++)
    {
      const int nu = 1 + pick (5), quasi = pick (2), nq = nu + quasi, nv = pick (3);
      const int nx = 2 * nu + pick (3), nz = nx + nv;
      const int ldz = nu + pick (3), lda = nq + nu + pick (2), nr = 1 + pick (lda), ldb = nr + 1;
      pair z = pair_of (ldz * nz), a = pair_of (lda * nz), by = pair_of (ldb * nu);
      pair b = pair_of (lda * nv);
      gs_rate_rows (nu, nq, nx, nv, quasi, z.c, ldz, a.c, lda, b.c, lda);
      gsjrw_ (&nu, &nq, &nx, &nv, &quasi, z.f, &ldz, a.f, &lda, b.f, &lda);
      same (a);
      same (b);
      gs_rate_rows_through (nr, nu, nz, by.c, ldb, z.c, ldz, a.c, lda);
      gsjth_ (&nr, &nu, &nz, by.f, &ldb, z.f, &ldz, a.f, &lda);
      same (a);
      drop (z);
      drop (a);
      drop (b);
      drop (by);
    }
  finish ();
}

int
main (void)
{
  norms ();
  projections ();
  impossible ();
  motions ();
  jacobians ();
  rows ();
  return 0;
}

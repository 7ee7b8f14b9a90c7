/* The routines of share/engine/core for derivatives by parameters against those of share/fortran:
 * rates of columns, their way onto the constraints, steps backwards; on numbers by chance and
 * chains.h */
#include "chains.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

void gssen_ (), gsspj_ (), gsspl_ (), gsadt_ (), gsad8_ ();

enum { PARAMETERS = 4, COLUMNS = 9 };

static int parameters, fault, calls, failing; /* the call `failing` returns fault */

static int
what_is_said (void)
{
  return ++calls == failing ? fault : 0;
}

/* n rows and m columns of any numbers that depend on a state */
static void
any_matrix (gs_real t, const gs_real *x, int n, int m, gs_real phase, gs_real *a, int lda)
{
  for (int j = 0; j < m; j++)
    for (int i = 0; i < n; i++)
      a[i + lda * j] = gs_sin (phase + t + 1.7 * i - 2.3 * j + x[(i + j) % scene->nx]);
}

/* ------------------------------------------------------------ what the scenes lack */

static int
rhp (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p, int ldp,
     gs_real *a, int lda, gs_real *b, int ldb, gs_real *xd)
{
  const int nx = scene->nx, nv = scene->nv;
  any_matrix (t, x, nx, parameters, cst[0], p, ldp);
  any_matrix (t, x, nx, nx, 1 + cst[0], a, lda);
  any_matrix (t, x, nx, nv, 2 + cst[0], b, ldb);
  any_matrix (t, x, nx, 1, nv > 0 ? v[nv - 1] : 3.0, xd, nx);
  return what_is_said ();
}

static void
rhp_ (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p,
      const int *ldp, gs_real *a, const int *lda, gs_real *b, const int *ldb, gs_real *xd,
      int *info)
{
  *info = rhp (*t, x, v, cst, p, *ldp, a, *lda, b, *ldb, xd);
}

static int
adj (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, const gs_real *l,
     gs_real *xb, gs_real *vb, gs_real *pb)
{
  const int nx = scene->nx, nv = scene->nv;
  any_matrix (t, l, nx, 1, cst[0] + x[0] + (nv > 0 ? v[nv - 1] : 0.0), xb, nx);
  any_matrix (t, x, nv, 1, l[0], vb, nv);
  any_matrix (t, l, parameters, 1, x[nx - 1], pb, parameters);
  return what_is_said ();
}

static void
adj_ (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, const gs_real *l,
      gs_real *xb, gs_real *vb, gs_real *pb, int *info)
{
  *info = adj (*t, x, v, cst, l, xb, vb, pb);
}

static void
tangents (gs_real t, const gs_real *x, const gs_real *cst, gs_real *dp, int ldp, gs_real *dv,
          int ldv)
{
  const int m = scene->nlam;
  gs_real phi[MOST], phit[MOST], dq[MOST * MOST];
  phi_of (t, x, cst, phi, phit, dq);
  for (int j = 0; j < scene->nq; j++)
    for (int i = 0; i < m; i++)
      dp[i + ldp * j] = dq[i + m * j];
  any_matrix (t, x, m, scene->nq, 0.4, dv, ldv);
}

static void
tan_ (const gs_real *t, const gs_real *x, const gs_real *cst, gs_real *dp, const int *ldp,
      gs_real *dv, const int *ldv)
{
  tangents (*t, x, cst, dp, *ldp, dv, *ldv);
}

static void
by_parameters (gs_real t, const gs_real *x, const gs_real *cst, gs_real *pp, int ldpp, gs_real *pv,
               int ldpv)
{
  any_matrix (t, x, scene->nlam, parameters, cst[0], pp, ldpp);
  any_matrix (t, x, scene->nlam, parameters, 1 + cst[0], pv, ldpv);
}

static void
cop_ (const gs_real *t, const gs_real *x, const gs_real *cst, gs_real *pp, const int *ldpp,
      gs_real *pv, const int *ldpv)
{
  by_parameters (*t, x, cst, pp, *ldpp, pv, *ldpv);
}

/* ------------------------------------------------------------ */

/* some columns: their number; col says of which parameter each is */
static int
columns (int *col)
{
  const int nc = pick (COLUMNS + 1);
  parameters = 1 + pick (PARAMETERS);
  for (int k = 0; k < nc; k++)
    col[k] = pick (parameters + 1);
  return nc;
}

static void
rates (void)
{
  int good = 0, lost = 0, other = 0;
  begin ("gs_rates_with_columns, gs_columns_times_four, gs_columns_times_one");
  for (int k = 0; k < 500; k++)
    {
      const int nx = 1 + pick (8), nv = pick (3), ntop = pick (2) * (nx / 2);
      const gs_real t = chance (), cst[1] = { chance () };
      const gs_scene s = { .nx = nx, .nv = nv, .rhp = rhp };
      int col[COLUMNS], info = 0;
      const int nc = columns (col), np = parameters;
      pair x = pair_of (nx * (1 + nc)), xd = pair_of (nx * (1 + nc)), v = pair_of (nv);
      pair w = pair_of (nx * (nx + np + nv + 1));
      scene = &s;
      fault = (int[]){ 1, 2, -6 }[pick (3)];
      failing = k % 5 == 0;
      calls = 0;
      const int made = gs_rates_with_columns (&s, t, ntop, np, nc, col, x.c, v.c, cst, w.c, xd.c);
      calls = 0;
      gssen_ (rhp_, &t, &ntop, &nx, &nv, &np, &nc, col, x.f, v.f, cst, w.f, xd.f, &info);
      same_int (made, info);
      same (xd);
      same (w);
      good += made == 0;
      lost += made == 9;
      other += made == 1 || made == -6;
      pair all[] = { x, xd, v, w };
      for (int i = 0; i < 4; i++)
        drop (all[i]);
    }
  finish ();
  holds (good > 300 && lost > 10 && other > 10, "... rates, lost rank and what else rhp says");
}

static void
projections (void)
{
  static const int sets[4] = { 1, 2, 3, 4 };
  int seen[10] = { 0 };
  begin ("gs_project_columns");
  for (int k = 0; k < 600; k++)
    {
      const int one = k % (SCENES - 1);
      gs_scene s = scene_of (one);
      s.tan = tangents;
      s.cop = by_parameters;
      scene = &s;
      phi_of = list[one].phi;
      const int nx = s.nx, nq = s.nq, nu = s.nu, m = s.nlam, ns = nq > nu, n = m + ns;
      const gs_real t = 0.1, far = 1e9;
      const gs_real cst[4] = { list[one].length, k % 17 ? far : 0.0, k % 13 ? far : 0.0, far };
      int col[COLUMNS], ic[MOST + 1], jf[MOST + 1], info = 0;
      const int nc = columns (col), np = parameters;
      pair x = pair_of (nx * (1 + nc));
      pair w = pair_of (n * (nq + n + nc) + m * (nq + nu + 2 * np + 3));
      for (int i = 0; i < nx; i++)
        x.c[i] = list[one].x[i] + 0.1 * x.c[i];
      both (x);
      const int made = gs_project_columns (&s, t, ns, sets, np, nc, col, x.c, cst, w.c, ic);
      gsspj_ (con_, tan_, cop_, &t, &nx, &nq, &nu, &m, &ns, sets, &np, &nc, col, x.f, cst, w.f, jf,
              &info);
      same_int (made, info);
      same (x);
      seen[made]++;
      drop (x);
      drop (w);
    }
  finish ();
  holds (seen[0] > 300 && seen[1] > 10 && seen[9] > 50, "... done, con fails, lost rank");
}

/* what D*S + R misses, 0 for rows of zeros */
static gs_real
missed (int m, int n, int nc, const gs_real *d, const gs_real *y, const gs_real *r)
{
  gs_real most = 0.0;
  for (int i = 0; i < m; i++)
    for (int k = 0; k < nc; k++)
      {
        gs_real e = r[i + m * k], size = 0.0;
        for (int j = 0; j < n; j++)
          {
            e += d[i + m * j] * y[j + n * k];
            size += gs_abs (d[i + m * j]);
          }
        most = size > 0.0 && gs_abs (e) > most ? gs_abs (e) : most;
      }
  return most;
}

static void
least_squares (void)
{
  int done = 0, dependent = 0;
  gs_real most = 0.0;
  begin ("gs_columns_onto");
  for (int k = 0; k < 300; k++)
    {
      const int n = 1 + pick (6), m = 1 + pick (n), nc = pick (5);
      pair d = pair_of (m * n), y = pair_of (n * nc), r = pair_of (m * nc), g = pair_of (m * m);
      gs_real given[6 * 5];
      int ic[6], jf[6], info = 0;
      for (int i = 0; i < m; i++)
        d.c[i + m * i] += 3.0;
      for (int j = 0; j < n; j++)
        if (k % 4 == 0)
          d.c[m - 1 + m * j] = 0.0;
        else if (k % 4 == 1 && m > 1)
          d.c[m - 1 + m * j] = d.c[m * j];
      both (d);
      memcpy (given, r.c, m * nc * sizeof (gs_real));
      const int made = gs_columns_onto (m, n, nc, d.c, m, y.c, n, r.c, m, g.c, ic);
      gsspl_ (&m, &n, &nc, d.f, &m, y.f, &n, r.f, &m, g.f, jf, &info);
      same_int (made, info);
      same (y);
      same (r);
      same (g);
      if (made == 0)
        most = gs_fmax (most, missed (m, n, nc, d.c, y.c, given));
      done += made == 0;
      dependent += made == 9;
      pair all[] = { d, y, r, g };
      for (int i = 0; i < 4; i++)
        drop (all[i]);
    }
  finish ();
  holds (done > 150 && dependent > 30, "... done, and rows that depend on each other");
  holds (most <= 1e-12, "... onto the equations");
}

static void
coefficients (void)
{
  pair a = pair_of (144), b = pair_of (12), c = pair_of (12), all[] = { a, b, c };
  gs_real off = 0.0, whole = 0.0;
  begin ("gs_dp853_table");
  for (int i = 0; i < 144; i++)
    a.c[i] = 0.0;
  for (int i = 0; i < 12; i++)
    b.c[i] = c.c[i] = i == 11;
  for (int i = 0; i < 3; i++)
    both (all[i]);
  gs_dp853_table (a.c, b.c, c.c);
  gsadt_ (a.f, b.f, c.f);
  for (int i = 0; i < 3; i++)
    same (all[i]);
  finish ();
  for (int i = 0; i < 12; i++)
    {
      gs_real row = 0.0;
      for (int j = 0; j < 12; j++)
        row += a.c[i + 12 * j];
      off = gs_fmax (off, gs_abs (row - c.c[i]));
      whole += b.c[i];
    }
  holds (off <= 1e-14 && gs_abs (whole - 1.0) <= 1e-14, "... rows of a add up to c, b to 1");
  for (int i = 0; i < 3; i++)
    drop (all[i]);
}

/* inputs that are kept, or a table with a break at 0.5; without pieces it fails */
static void
table (int kind, int nv, int *ip, gs_real *rp)
{
  memset (ip, 0, 40 * sizeof (int));
  ip[GS_V0] = kind > 0;
  ip[GS_TABLE] = kind == 2 ? 0 : 2;
  ip[GS_TABLE + 1] = 1;
  ip[GS_TABLE + 2] = 1;
  ip[GS_TABLE + 3] = 4;
  for (int i = 0; i < 3 + 2 * nv; i++)
    rp[i] = i < 3 ? 0.5 * i : chance ();
}

static void
steps (void)
{
  int good = 0, failed = 0, refused = 0;
  begin ("gs_step_back_dp853");
  for (int k = 0; k < 400; k++)
    {
      const int nx = 1 + pick (8), nv = 1 + pick (2), np = 1 + pick (PARAMETERS), nu = 1;
      const int kind = k % 20 == 7 ? 2 : pick (2), side = pick (2) ? 1 : -1;
      const gs_real tn = pick (2) ? 0.5 : 0.6, h = 0.3, t = tn - h, cst[1] = { chance () };
      const gs_scene s = { .nu = nu, .nx = nx, .nv = nv, .adj = adj };
      int ip[40], info = 0;
      gs_real rp[10];
      pair x = pair_of (nx), kk = pair_of (12 * nx), v = pair_of (nv), lx = pair_of (nx);
      pair pb = pair_of (np), w = pair_of (15 * nx + nv + np);
      pair wi = pair_of (2 * nu + 5 * nx + nv * nx + 20);
      scene = &s;
      parameters = np;
      table (kind, nv, ip, rp);
      fault = (int[]){ 1, 3, -4 }[pick (3)];
      failing = k % 3 == 0 ? 1 + pick (12) : 0;
      calls = 0;
      const int made = gs_step_back_dp853 (&s, t, tn, side, h, x.c, kk.c, np, ip, rp, cst, v.c,
                                           lx.c, pb.c, w.c, wi.c);
      calls = 0;
      gsad8_ (adj_, &t, &tn, &side, &h, x.f, kk.f, &nu, &nx, &nv, &np, ip, rp, cst, v.f, lx.f,
              pb.f, w.f, wi.f, &info);
      same_int (made, info);
      pair all[] = { v, lx, pb, w, x, kk, wi };
      for (int i = 0; i < 4; i++)
        same (all[i]);
      for (int i = 0; i < 7; i++)
        drop (all[i]);
      good += made == 0;
      failed += made == 1 || made == -4;
      refused += made < 0 && kind == 2;
    }
  finish ();
  holds (good > 200 && failed > 30 && refused > 10, "... done, adj fails, inputs fail");
}

int
main (void)
{
  rates ();
  projections ();
  least_squares ();
  coefficients ();
  steps ();
  return 0;
}

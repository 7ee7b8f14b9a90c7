/* share/engine/core/solve against share/fortran/solve/plain */
#include "compare.h"
#include "gsmbp/solve.h"

void gsacc_ (), gsacr_ (), gsnul_ (), gszev_ (), gskds_ (), gsmul_ (), gsred_ (), gsrow_ (),
  gslam_ (), gskkt_ (), gskkr_ (), gsaug_ (), gslnm_ (), gsleq_ (), gsspd_ (), gstrs_ (), gschp_ (),
  gschf_ (), gslup_ (), gsluf_ (), gsqrp_ (), gsqrg_ (), gsqrc_ (), gsgrp_ (), gshrf_ (), gsqmv_ (),
  gssvd_ (), gsrot_ (), gsrtl_ ();

static const int sizes[] = { 0, 1, 2, 3, 4, 5, 8, 13, 20 };
enum { SIZES = sizeof sizes / sizeof *sizes, KINDS = 8 };

static int
leading (int n)
{
  return (n > 1 ? n : 1) + pick (3);
}

/* which indicators came up: a test without a failure tests no failure */
static int seen[4];

static void
outcome (int c, int f)
{
  same_int (c, f);
  seen[c < 0 ? 3 : c > 2 ? 2 : c]++;
}

/* a general matrix (m,n): of kind 1 with dependent rows, 2 with a row of zeros, 3 with
 * a number that is none, 4 with rows of very different sizes, 5 of whole numbers, 6 with nearly
 * dependent rows */
static pair
general (int m, int n, int ld, int kind)
{
  pair a = pair_of (ld * n);
  int row = m ? pick (m) : 0, other = m ? pick (m) : 0;
  gs_real scale = 2 * chance ();
  for (int j = 0; m > 0 && j < n; j++)
    {
      gs_real *col = a.c + ld * j;
      for (int i = 0; i < m && kind == 4; i++)
        col[i] *= gs_pow (10.0, 4 * i % 13 - 6);
      for (int i = 0; i < m && kind == 5; i++)
        col[i] = gs_floor (4 * col[i]);
      if (kind == 1)
        col[row] = row == other ? col[row] : scale * col[other];
      if (kind == 2)
        col[row] = 0.0;
      if (kind == 3 && j == n / 2)
        col[row] = row % 2 || QUAD ? NOT_A_NUMBER : INFINITY;
      if (kind == 6 && row != other)
        col[row] = col[other] + 1e-10 * col[row];
    }
  both (a);
  return a;
}

/* a symmetric matrix, positive definite; of kind 1 semidefinite of rank n - 2, 2 indefinite, 3 with
 * what is no number, 4 of very different sizes, 6 with a zero row, 7 zero; its upper triangle is
 * filled with what must not be used; 5 nearly semidefinite */
static pair
symmetric (int n, int ld, int kind)
{
  pair a = pair_of (ld * n), b = pair_of (n * n);
  int rank = kind == 1 || kind == 5 ? n - 2 : n;
  for (int j = 0; j < n; j++)
    for (int i = j; i < n; i++)
      {
        gs_real s = 0.0;
        for (int k = 0; k < rank; k++)
          s += b.c[i + n * k] * b.c[j + n * k];
        s += i != j || kind == 1 ? 0.0 : kind == 5 ? 1e-13 : 0.1;
        if (kind == 2 && i == j && i == n / 2)
          s -= 4.0;
        if (kind == 4)
          s *= gs_pow (10.0, (3 * i + 3 * j) % 9 - 4);
        if ((kind == 6 && (i == n / 2 || j == n / 2)) || kind == 7)
          s = 0.0;
        if (kind == 3 && j == n / 2 && i == j)
          s = NOT_A_NUMBER;
        a.c[i + ld * j] = s;
      }
  both (a);
  drop (b);
  return a;
}

/* groups of rows, each named by its first one, or none */
static void
groups (int m, int *grp)
{
  grp[0] = 0;
  if (pick (2))
    return;
  for (int i = 0; i < m; i++)
    grp[i] = i > 0 && pick (2) ? grp[i - 1] : i + 1;
}

static void
report (int low, int high)
{
  finish ();
  for (int i = low; i <= high; i++)
    if (seen[i] == 0 && ! QUAD)   /* which cases are singular depends on rounding */
      printf ("not ok %s: no case with info %d\n", record.what, i);
  memset (seen, 0, sizeof seen);
}

/* ------------------------------------------------------------
 * square systems, factors */

typedef int square_c (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw);

static int
spd (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw)
{
  (void)iw;
  return gs_solve_spd (n, nrhs, a, lda, b, ldb);
}

static void
spd_ (int *n, int *nrhs, gs_real *a, int *lda, gs_real *b, int *ldb, int *iw, int *info)
{
  (void)iw;
  gsspd_ (n, nrhs, a, lda, b, ldb, info);
}

static void
squares (const char *what, square_c *c, void (*f) (), int definite)
{
  begin (what);
  for (int k = 0; k < 40 * SIZES; k++)
    {
      int n = sizes[k % SIZES], nrhs = pick (8), lda = leading (n), ldb = leading (n), info;
      int kind = k / SIZES % KINDS, iw[20];
      pair a = definite ? symmetric (n, lda, kind) : general (n, n, lda, kind);
      pair b = pair_of (ldb * nrhs);
      int made = c (n, nrhs, a.c, lda, b.c, ldb, iw);
      f (&n, &nrhs, a.f, &lda, b.f, &ldb, iw, &info);
      outcome (made, info);
      same (b);
      same (a);
      drop (a);
      drop (b);
    }
  for (int k = 0; k < 16; k++) /* arguments out of range */
    {
      int n = k & 1 ? -1 : 2, nrhs = k & 2 ? -1 : 1, lda = k & 4 ? 1 : 2, ldb = k & 8 ? 1 : 2;
      int iw[2] = { 0 }, info;
      pair a = symmetric (2, 2, 0), b = pair_of (2);
      int made = c (n, nrhs, a.c, lda, b.c, ldb, iw);
      f (&n, &nrhs, a.f, &lda, b.f, &ldb, iw, &info);
      outcome (made, info);
      same (b);
      drop (a);
      drop (b);
    }
  report (0, 3);
}

/* rows that differ by large powers of two */
static void
scales (void)
{
  begin ("gs_solve_general, rows of any size");
  for (int k = 0; k < 200; k++)
    {
      int n = 1 + pick (6), iw[6], info;
      pair a = pair_of (n * n), b = pair_of (n);
      for (int i = 0; i < n; i++)
        {
          int power = (int)(1010 * chance ());
          for (int j = 0; j < n; j++)
            a.c[i + n * j] = gs_ldexp (a.c[i + n * j], power);
        }
      both (a);
      same_int (gs_solve_general (n, 1, a.c, n, b.c, n, iw),
                (gsleq_ (&n, I (1), a.f, &n, b.f, &n, iw, &info), info));
      same (b);
      drop (a);
      drop (b);
    }
  finish ();
}

static void
cholesky (const char *what, int (*c) (int, gs_real *, int), void (*f) ())
{
  begin (what);
  for (int k = 0; k < 30 * SIZES; k++)
    {
      int n = sizes[k % SIZES], lda = leading (n), info;
      pair a = symmetric (n, lda, k / SIZES % KINDS);
      int made = c (n, a.c, lda);
      f (&n, a.f, &lda, &info);
      outcome (made, info);
      same (a);
      drop (a);
    }
  report (0, 2);
}

static void
lu (const char *what, int (*c) (int, gs_real *, int, int *), void (*f) ())
{
  begin (what);
  for (int k = 0; k < 30 * SIZES; k++)
    {
      int n = sizes[k % SIZES], lda = leading (n), info, ic[20] = { 0 }, jf[20] = { 0 };
      pair a = general (n, n, lda, k / SIZES % KINDS);
      int made = c (n, a.c, lda, ic);
      f (&n, a.f, &lda, jf, &info);
      outcome (made, info);
      same (a);
      for (int i = 0; i < 20; i++)
        same_int (ic[i], jf[i]);
      drop (a);
    }
  report (0, 2);
}

static void
triangles (void)
{
  begin ("gs_solve_triangular");
  for (int k = 0; k < 20 * SIZES; k++)
    {
      int n = sizes[k % SIZES], m = pick (5), ldl = leading (n), ldb = leading (n), trans = k % 2;
      pair l = general (n, n, ldl, 0), b = pair_of (ldb * m);
      for (int i = 0; i < n; i++)
        l.c[i + ldl * i] += 3.0;
      both (l);
      gs_solve_triangular (n, m, l.c, ldl, b.c, ldb, trans);
      gstrs_ (&n, &m, l.f, &ldl, b.f, &ldb, &trans);
      same (b);
      drop (l);
      drop (b);
    }
  finish ();
}

static void
products (void)
{
  begin ("gs_symmetric_times");
  for (int k = 0; k < 10 * SIZES; k++)
    {
      int n = sizes[k % SIZES], lda = leading (n);
      pair a = symmetric (n, lda, 0), x = pair_of (n), y = pair_of (n);
      gs_symmetric_times (n, a.c, lda, x.c, y.c);
      gsmul_ (&n, a.f, &lda, x.f, y.f);
      same (y);
      drop (a);
      drop (x);
      drop (y);
    }
  finish ();

  begin ("gs_rotate_plane");
  for (int n = 0; n < 20; n++)
    {
      pair x = pair_of (n), y = pair_of (n);
      gs_real c = chance (), s = chance ();
      gs_rotate_plane (n, x.c, y.c, c, s);
      gsrot_ (&n, x.f, y.f, &c, &s);
      same (x);
      same (y);
      drop (x);
      drop (y);
    }
  finish ();

  begin ("gs_solve_reduced");
  for (int k = 0; k < 20 * SIZES; k++)
    {
      int n = sizes[k % SIZES], r = n ? pick (n + 1) : 0, lda = leading (n), info;
      pair a = symmetric (n, lda, k % 2 ? 0 : 7), b = symmetric (n, n, k / SIZES % KINDS);
      pair z = pair_of (n);
      int made = gs_solve_reduced (n, r, a.c, lda, b.c, z.c);
      gsred_ (&n, &r, a.f, &lda, b.f, z.f, &info);
      outcome (made, info);
      same (z);
      drop (a);
      drop (b);
      drop (z);
    }
  report (0, 1);
}

/* ------------------------------------------------------------
 * orthogonal factors */

typedef void qr_c (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv,
                   gs_real *beta, gs_real *siz, int *rank);

static void
qrp (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv, gs_real *beta,
     gs_real *siz, int *rank)
{
  (void)grp;
  gs_qr_pivoted (n, m, y, ldy, tol, piv, beta, siz, rank);
}

static void
qrc (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv, gs_real *beta,
     gs_real *siz, int *rank)
{
  (void)grp;
  gs_qr_columns (n, m, y, ldy, tol, piv, beta, siz, rank);
}

static void
qrp_ (int *n, int *m, gs_real *y, int *ldy, gs_real *tol, int *grp, gs_real *piv, gs_real *beta,
      gs_real *siz, int *rank)
{
  (void)grp;
  gsqrp_ (n, m, y, ldy, tol, piv, beta, siz, rank);
}

static void
qrc_ (int *n, int *m, gs_real *y, int *ldy, gs_real *tol, int *grp, gs_real *piv, gs_real *beta,
      gs_real *siz, int *rank)
{
  (void)grp;
  gsqrc_ (n, m, y, ldy, tol, piv, beta, siz, rank);
}

static gs_real
tolerance (void)
{
  static const gs_real t[] = { 0.0, 1e-11, 1e-7, 1e-3 };
  return t[pick (4)];
}

static void
reflections (const char *what, qr_c *c, void (*f) ())
{
  int full = 0, less = 0;
  begin (what);
  for (int k = 0; k < 60 * SIZES; k++)
    {
      int n = sizes[k % SIZES], m = sizes[pick (SIZES)], ldy = leading (n), rank, found;
      int most = n < m ? n : m, grp[20];
      gs_real tol = tolerance ();
      pair h = general (m, n, m, k / SIZES % KINDS), y = pair_of (ldy * m), piv = pair_of (m);
      pair beta = pair_of (most), siz = pair_of (m), b = pair_of (n);
      for (int i = 0; i < n; i++) /* general's dependent rows as columns */
        for (int j = 0; j < m; j++)
          y.c[i + ldy * j] = h.c[j + m * i];
      both (y);
      groups (m, grp);
      c (n, m, y.c, ldy, tol, grp, piv.c, beta.c, siz.c, &rank);
      f (&n, &m, y.f, &ldy, &tol, grp, piv.f, beta.f, siz.f, &found);
      same_int (rank, found);
      same (y);
      same (piv);
      same_numbers (rank, beta.c, beta.f);
      same (siz);
      full += rank == most;
      less += rank < most;
      gs_qr_times (n, rank, y.c, ldy, beta.c, b.c, k % 2);
      gsqmv_ (&n, &rank, y.f, &ldy, beta.f, b.f, I (k % 2));
      same (b);
      drop (h);
      drop (y);
      drop (piv);
      drop (beta);
      drop (siz);
      drop (b);
    }
  finish ();
  holds (full > 20 && less > 20, "... of full and of lower rank");
}

static void
one_reflection (void)
{
  begin ("gs_reflection");
  for (int k = 0; k < 200; k++)
    {
      int n = 1 + pick (8), m = 1 + pick (8), col = pick (n < m ? n : m), ldy = leading (n);
      pair y = pair_of (ldy * m), beta = pair_of (1);
      gs_real d = 0.0;
      for (int i = col; i < n; i++)
        d += y.c[i + ldy * col] * y.c[i + ldy * col];
      gs_reflection (n, m, col, y.c, ldy, d, beta.c);
      gshrf_ (&n, &m, I (col + 1), y.f, &ldy, &d, beta.f);
      same (y);
      same (beta);
      drop (y);
      drop (beta);
    }
  finish ();
}

static void
singular_values (void)
{
  begin ("gs_singular_values");
  for (int k = 0; k < 20 * SIZES; k++)
    {
      int m = sizes[k % SIZES], n = sizes[pick (SIZES)], ldb = leading (m), ldv = leading (n);
      int rank, found;
      pair b = general (m, n, ldb, k / SIZES % KINDS == 3 ? 0 : k / SIZES % KINDS);
      pair v = pair_of (ldv * n), s = pair_of (n);
      gs_singular_values (m, n, b.c, ldb, v.c, ldv, s.c, 1e-11, &rank);
      gssvd_ (&m, &n, b.f, &ldb, v.f, &ldv, s.f, D (1e-11), &found);
      same_int (rank, found);
      same (b);
      same (v);
      same (s);
      drop (b);
      drop (v);
      drop (s);
    }
  finish ();
}

static void
rows (void)
{
  begin ("gs_group_sizes");
  for (int k = 0; k < 100; k++)
    {
      int m = 1 + pick (12), grp[12];
      pair siz = pair_of (m);
      groups (m, grp);
      for (int i = 0; i < m; i++)
        siz.c[i] = gs_abs (siz.c[i]) * gs_pow (10.0, -pick (8));
      both (siz);
      gs_group_sizes (m, grp, 1e-3, siz.c);
      gsgrp_ (&m, grp, D (1e-3), siz.f);
      same (siz);
      drop (siz);
    }
  finish ();

  begin ("gs_scaled_rows");
  for (int k = 0; k < 20 * SIZES; k++)
    {
      int m = 1 + pick (8), n = sizes[k % SIZES], ldh = leading (m), grp[8];
      pair h = general (m, n, ldh, k / SIZES % KINDS), y = pair_of (m * n), d = pair_of (m);
      groups (m, grp);
      gs_scaled_rows (n, m, h.c, ldh, grp, y.c, d.c);
      gsrow_ (&n, &m, h.f, &ldh, grp, y.f, d.f);
      same (y);
      same (d);
      drop (h);
      drop (y);
      drop (d);
    }
  finish ();

  begin ("gs_rank_tolerance");
  for (int k = 0; k < 20 * SIZES; k++)
    {
      int m = 1 + pick (8), n = sizes[k % SIZES], ldh = leading (m), grp[8];
      pair h = general (m, n, ldh, k / SIZES % KINDS), phi = pair_of (m), w = pair_of (m);
      pair tol = pair_of (1);
      groups (m, grp);
      for (int i = 0; i < m; i++)
        phi.c[i] *= gs_pow (10.0, -(k % 25));
      gs_rank_tolerance (n, m, h.c, ldh, phi.c, grp, tol.c, w.c);
      gsrtl_ (&n, &m, h.f, &ldh, phi.c, grp, tol.f, w.f);
      same (tol);
      drop (h);
      drop (phi);
      drop (w);
      drop (tol);
    }
  finish ();
}

/* ------------------------------------------------------------
 * systems with constraints */

typedef struct
{
  int n, m, lda, ldh, grp[20];
  gs_real tol;
  pair a, h, f, g, ud, lam, w;
} chain;

/* kinds of A and of H together; m is at most n in half of the cases */
static chain
chain_of (int k, int smallest)
{
  chain s;
  s.n = sizes[k % SIZES] > smallest ? sizes[k % SIZES] : smallest;
  s.m = k % 2 ? sizes[pick (SIZES)] : s.n ? pick (s.n + 1) : 0;
  s.m = s.m > smallest ? s.m : smallest;
  s.lda = leading (s.n);
  s.ldh = leading (s.m);
  s.tol = tolerance ();
  groups (s.m, s.grp);
  int kind = k / SIZES % (KINDS * KINDS);
  s.a = symmetric (s.n, s.lda, kind % KINDS);
  s.h = general (s.m, s.n, s.ldh, kind / KINDS);
  s.f = pair_of (s.n);
  s.g = pair_of (s.m);
  s.ud = pair_of (s.n);
  s.lam = pair_of (s.m);
  s.w = pair_of (2 * s.n * s.n + s.n * s.m + s.m * s.m + 4 * s.n + 8 * s.m);
  return s;
}

static void
drop_chain (chain s)
{
  pair all[] = { s.a, s.h, s.f, s.g, s.ud, s.lam, s.w };
  for (int i = 0; i < 7; i++)
    drop (all[i]);
}

/* workspace of a routine that takes less */
static void
shorter (chain *s)
{
  drop (s->w);
  s->w = pair_of (s->n * s->n + s->n * s->m + s->m * s->m + 2 * s->n + 6 * s->m);
}

static void
same_chain (const chain *s, int made, int info)
{
  outcome (made, info);
  same (s->ud);
  same (s->lam);
}

enum { CASES = SIZES * KINDS * KINDS };

static void
simple_tolerances (void)
{
  int info;
  begin ("gs_solve_kkt");
  for (int k = 0; k < CASES; k++)
    {
      chain s = chain_of (k, 0);
      shorter (&s);
      int made = gs_solve_kkt (s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.f.c, s.g.c, s.ud.c, s.lam.c,
                               s.w.c);
      gskkt_ (&s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.f.f, s.g.f, s.ud.f, s.lam.f, s.w.f,
              &info);
      same_chain (&s, made, info);
      drop_chain (s);
    }
  report (0, 2);

  begin ("gs_solve_accelerations");
  for (int k = 0; k < 2 * CASES; k++)
    {
      chain s = chain_of (k / 2, 0);
      int way = pick (6); /* 0 and 5 are out of range */
      int made = gs_solve_accelerations (way, s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.f.c, s.g.c,
                                         s.ud.c, s.lam.c, s.w.c);
      gsacc_ (&way, &s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.f.f, s.g.f, s.ud.f, s.lam.f,
              s.w.f, &info);
      same_chain (&s, made, info);
      drop_chain (s);
    }
  report (0, 3);
}

typedef int way_c (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                   const gs_real *f, const gs_real *g, gs_real tol, const int *grp, gs_real *ud,
                   gs_real *lam, gs_real *w);

static void
way (const char *what, way_c *c, void (*f) (), int smallest)
{
  begin (what);
  for (int k = 0; k < CASES; k++)
    {
      chain s = chain_of (k, smallest);
      int info;
      if (c == gs_solve_kkt_groups)
        shorter (&s);
      int made = c (s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.f.c, s.g.c, s.tol, s.grp, s.ud.c,
                    s.lam.c, s.w.c);
      f (&s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.f.f, s.g.f, &s.tol, s.grp, s.ud.f, s.lam.f,
         s.w.f, &info);
      same_chain (&s, made, info);
      drop_chain (s);
    }
  report (0, 2);
}

static void
four_ways (void)
{
  begin ("gs_solve_accelerations_groups");
  for (int k = 0; k < 2 * CASES; k++)
    {
      chain s = chain_of (k / 2, 0);
      int way = 1 + pick (4), info;
      int made = gs_solve_accelerations_groups (way, s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.f.c,
                                                s.g.c, s.tol, s.grp, s.ud.c, s.lam.c, s.w.c);
      gsacr_ (&way, &s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.f.f, s.g.f, &s.tol, s.grp, s.ud.f,
              s.lam.f, s.w.f, &info);
      same_chain (&s, made, info);
      drop_chain (s);
    }
  report (0, 2);

  begin ("gs_solve_accelerations_groups, gs_solve_kkt_groups: arguments out of range");
  for (int k = 0; k < 32; k++)
    {
      int way = k & 1 ? 7 : 2, n = k & 2 ? -1 : 2, m = k & 4 ? -1 : 2, lda = k & 8 ? 1 : 2;
      int ldh = k & 16 ? 1 : 2, grp[1] = { 0 }, info;
      pair w = pair_of (60);
      gs_real *x = w.c + 40;
      if (k)
        {
          int made = gs_solve_accelerations_groups (way, n, m, x, lda, x, ldh, x, x, 1e-9, grp, x,
                                                    x, w.c);
          gsacr_ (&way, &n, &m, x, &lda, x, &ldh, x, x, D (1e-9), grp, x, x, w.f, &info);
          same_int (made, info);
        }
      if (k & 30)
        {
          int made = gs_solve_kkt_groups (n, m, x, lda, x, ldh, x, x, 1e-9, grp, x, x, w.c);
          gskkr_ (&n, &m, x, &lda, x, &ldh, x, x, D (1e-9), grp, x, x, w.f, &info);
          same_int (made, info);
        }
      drop (w);
    }
  finish ();
}

/* the parts of gs_solve_kkt_groups */
static void
parts (void)
{
  begin ("gs_least_multipliers");
  for (int k = 0; k < CASES; k++)
    {
      chain s = chain_of (k, 1);
      gs_least_multipliers (s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.f.c, s.tol, s.grp, s.ud.c,
                            s.lam.c, s.w.c);
      gslam_ (&s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.f.f, &s.tol, s.grp, s.ud.f, s.lam.f,
              s.w.f);
      same (s.lam);
      drop_chain (s);
    }
  finish ();

  begin ("gs_kkt_augmented");
  for (int k = 0; k < CASES; k++)
    {
      chain s = chain_of (k, 1);
      int ldl = leading (s.n), info, begun;
      pair l = pair_of (ldl * s.n), z = pair_of (2 * s.n), y = pair_of (s.m * s.n);
      pair d = pair_of (s.m);
      for (int j = 0; j < s.n; j++)
        memcpy (l.c + ldl * j, s.a.c + s.lda * j, sizeof (gs_real) * s.n);
      begun = gs_cholesky_factor (s.n, l.c, ldl);
      both (l);
      info = begun;
      int made = gs_kkt_augmented (s.n, s.m, s.a.c, s.lda, s.h.c, s.ldh, s.g.c, s.grp, l.c, ldl,
                                   z.c, y.c, d.c, begun);
      gsaug_ (&s.n, &s.m, s.a.f, &s.lda, s.h.f, &s.ldh, s.g.f, s.grp, l.f, &ldl, z.f, y.f, d.f,
              &info);
      outcome (made, info);
      same (l);
      same (z);
      drop (l);
      drop (z);
      drop (y);
      drop (d);
      drop_chain (s);
    }
  report (0, 1);

  begin ("gs_least_norm");
  for (int k = 0; k < 200; k++)
    {
      int m = 1 + pick (8), r = pick (m + 1), ldy = leading (m), rank;
      pair y = pair_of (ldy * m), piv = pair_of (m), c = pair_of (r), lam = pair_of (m);
      pair t = pair_of (m * m), q = pair_of (m), beta = pair_of (m), s = pair_of (m);
      gs_qr_pivoted (m, m, y.c, ldy, 0.0, piv.c, beta.c, s.c, &rank);
      both (y);
      both (piv);
      gs_least_norm (m, r, y.c, ldy, piv.c, c.c, lam.c, t.c, q.c, beta.c, s.c);
      gslnm_ (&m, &r, y.f, &ldy, piv.f, c.f, lam.f, t.f, q.f, beta.f, s.f);
      same (lam);
      pair all[] = { y, piv, c, lam, t, q, beta, s };
      for (int i = 0; i < 8; i++)
        drop (all[i]);
    }
  finish ();
}

int
main (void)
{
  squares ("gs_solve_general, gs_lu_scaled, gs_lu_solution, gs_lu_three_rows, gs_lu_one_column, "
           "gs_lu_four_columns",
           gs_solve_general, gsleq_, 0);
  scales ();
  squares ("gs_solve_spd", spd, spd_, 1);
  cholesky ("gs_cholesky", gs_cholesky, gschp_);
  cholesky ("gs_cholesky_factor", gs_cholesky_factor, gschf_);
  lu ("gs_lu_pivoted", gs_lu_pivoted, gslup_);
  lu ("gs_lu_factor", gs_lu_factor, gsluf_);
  triangles ();
  products ();
  reflections ("gs_qr_groups, gs_qr_times", gs_qr_groups, gsqrg_);
  reflections ("gs_qr_pivoted", qrp, qrp_);
  reflections ("gs_qr_columns", qrc, qrc_);
  one_reflection ();
  singular_values ();
  rows ();
  simple_tolerances ();
  way ("gs_solve_kkt_groups", gs_solve_kkt_groups, gskkr_, 0);
  way ("gs_solve_null_space", gs_solve_null_space, gsnul_, 1);
  way ("gs_solve_zero_eigenvectors", gs_solve_zero_eigenvectors, gszev_, 1);
  way ("gs_solve_dependent_speeds", gs_solve_dependent_speeds, gskds_, 1);
  four_ways ();
  parts ();
  return 0;
}

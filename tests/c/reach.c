/* share/engine/core/reach and its eigenvalues against share/fortran/reach and
   share/fortran/solve/plain */
#include "compare.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

void gseig_ (), gshes_ (), gshqr_ (), gshqs_ (), gsiks_ (), gsikz_ (), gsiko_ (), gsikp_ (),
  gsikd_ (), gsiku_ (), gsiky_ (), gscir_ (), gscif_ (), gsciq_ (), gscie_ (), gsnik_ (), gsnir_ (),
  gsniv_ (), gsnij_ (), gsnis_ (), gsikg_ (), gsikb_ (), gsik1_ (), gsikt_ (), gsikw_ (), gsikf_ (),
  gsikl_ (), gsikr_ (), gsike_ (), gsikh_ (), gsikc_ (), gsikm_ (), gsikv_ (), gsikx_ (), gsikn_ (),
  gsikj_ (), gsika_ (), gsiki_ (), gsipz_ (), gsigd_ (), gsigs_ ();
int gsikq_ ();
gs_real gsikk_ ();

static int seen[3];

static void
outcome (int c, int f)
{
  same_int (c, f);
  seen[c < 0 ? 0 : c > 2 ? 2 : c]++;
}

static void
whole (int n, const int *c, const int *f)
{
  for (int i = 0; i < n; i++)
    same_int (c[i], f[i]);
}

/* ------------------------------------------------------------ eigenvalues */

/* kind 1: whole numbers, 2: a column of zeros, 3: rotations, 4: rows of different sizes */
static void
eigenvalues (void)
{
  begin ("gs_eigenvalues, gs_hessenberg, gs_hessenberg_eigenvalues, gs_hessenberg_step");
  for (int k = 0; k < 300; k++)
    {
      int n = k % 25, lda = n + 1 + pick (2), kind = k / 25 % 5, info;
      pair a = pair_of (lda * n), wr = pair_of (n), wi = pair_of (n), w = pair_of (4 * n);
      for (int i = 0; i < lda * n; i++)
        {
          int row = i % lda, col = i / lda;
          if (kind == 1)
            a.c[i] = gs_floor (3 * a.c[i]);
          if (kind == 2 && col == n / 2)
            a.c[i] = 0.0;
          if (kind == 3)
            a.c[i] = row == (col + 1) % n;
          if (kind == 4)
            a.c[i] *= gs_pow (10.0, row % 7 - 3);
        }
      both (a), both (wr), both (wi), both (w);
      int made = gs_eigenvalues (n, a.c, lda, wr.c, wi.c, w.c);
      gseig_ (&n, a.f, &lda, wr.f, wi.f, w.f, &info);
      same_int (made, info);
      same (a), same (wr), same (wi), same (w);
      drop (a), drop (wr), drop (wi), drop (w);
    }
  finish ();
}

/* ------------------------------------------------------------ conics */

static void
conics (void)
{
  int real = 0;
  begin ("gs_circle_angles, gs_circle_sum, gs_circle_quartic, gs_quartic_roots");
  for (int k = 0; k < 500; k++)
    {
      pair co = pair_of (5), sc = pair_of (8), rad = pair_of (4);
      if (k % 7 == 1)
        co.c[0] = co.c[1] = 0.0;
      if (k % 7 == 2)
        co.c[4] = -co.c[0] - co.c[2], co.c[1] = co.c[3] = 0.0;
      for (int i = 0; i < 5; i++)
        co.c[i] = k % 50 == 3 ? 0.0 : k % 50 == 4 ? NOT_A_NUMBER : co.c[i];
      both (co);
      gs_circle_angles (co.c, sc.c, rad.c);
      gscir_ (co.f, sc.f, rad.f);
      same (sc), same (rad);
      for (int i = 0; i < 4; i++)
        real += rad.c[i] >= 0.0;
      drop (co), drop (sc), drop (rad);
    }
  finish ();
  holds (real > 100, "gs_circle_angles finds roots");
}

/* ------------------------------------------------------------ branches */

static void
branches (void)
{
  begin ("gs_reach_branches, gs_reach_which");
  memset (seen, 0, sizeof seen);
  for (int k = 0; k < 600; k++)
    {
      int n = 1 + pick (6), nb = 1 + pick (8), nm = 1 + pick (4);
      int ldq = n + pick (3) - (k % 50 == 0);
      int nc, nf, nearc, nearf, bc[8] = { 0 }, bf[8] = { 0 }, info;
      pair qc = pair_of (n * nb), rad = pair_of (nm * nb), lim = pair_of (nm);
      pair res = pair_of (2 * nb), qs = pair_of (8 * nb), dst = pair_of (2);
      for (int i = 0; i < nm * nb; i++)
        rad.c[i] = pick (20) ? gs_abs (rad.c[i]) : pick (2) ? 1e-15 : -gs_abs (rad.c[i]);
      for (int i = 0; i < nm; i++)
        lim.c[i] = pick (2) ? 1e-14 : 1e-24;
      for (int i = 0; i < 2 * nb; i++)
        res.c[i] = gs_abs (res.c[i]) * (k % 3 ? 1e-12 : 1e-9);
      for (int i = n; i < n * nb && k % 2; i++)
        qc.c[i] = pick (4) ? qc.c[i - n] : qc.c[i];
      both (qc), both (rad), both (lim), both (res), both (qs);
      int made = gs_reach_branches (n, nb, nm, qc.c, rad.c, lim.c, res.c, qs.c, ldq, &nc, bc, dst.c,
                                    &nearc);
      gsiks_ (&n, &nb, &nm, qc.f, rad.f, lim.f, res.f, qs.f, &ldq, &nf, bf, dst.f, &nearf, &info);
      outcome (made, info);
      same_int (nc, nf), same_int (nearc, nearf), whole (8, bc, bf);
      same (qs), same (dst);
      drop (qc), drop (rad), drop (lim), drop (res), drop (qs), drop (dst);
    }
  finish ();
  holds (seen[0] && seen[1] && seen[2], "gs_reach_branches ends in each way");
}

/* ------------------------------------------------------------ six joints */

typedef struct
{
  int kind[6];
  gs_real ka[18], pa[18], r[9], p[3], q[6]; /* q makes the displacement r, p */
} arm;

/* an arm by chance of n joints and a pose that it reaches; way 1: slides too, 2: axes of a wrist
 * meet, 3: the pose is out of reach, 4: four of six axes almost parallel */
static arm
arm_of (int n, int way)
{
  arm a;
  gs_real e[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, x[3] = { 0 };
  for (int i = 0; i < 18; i++)
    a.ka[i] = chance (), a.pa[i] = chance ();
  for (int j = 0; j < 6; j++)
    {
      gs_real *k = a.ka + 3 * j, d = gs_sqrt (k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
      for (int i = 0; i < 3; i++)
        k[i] /= d;
      a.kind[j] = way == 1 ? pick (2) : 1;
      a.q[j] = 3 * chance ();
      if (way == 2 && j > 3)
        memcpy (a.pa + 3 * j, a.pa + 9, 3 * sizeof (gs_real));
      if (j >= n)
        a.kind[j] = 0, a.q[j] = 0.0, memset (k, 0, 3 * sizeof (gs_real));
    }
  for (int j = 0; j < 6 && way == 4; j++)
    for (int i = 0; i < 3; i++)
      a.ka[3 * j + i] = i == (j == 0 || j == 4 ? 2 : 1);
  if (way == 4)
    a.q[4] = 3e-8 * a.q[4];
  for (int j = 5; j >= 0; j--)
    {
      gs_real s = gs_sin (a.q[j]), c = gs_cos (a.q[j]), *k = a.ka + 3 * j, zero[3];
      for (int l = 0; l < 3; l++)
        {
          memset (zero, 0, sizeof zero);
          if (a.kind[j])
            gs_turn_line (k, zero, s, c, zero, e + 3 * l);
          if (! a.kind[j])
            x[l] += a.q[j] * k[l];
        }
      gs_real none[3] = { 1, 0, 0 };
      if (a.kind[j])
        gs_turn_line (k, a.pa + 3 * j, s, c, x, none);
    }
  memcpy (a.r, e, sizeof e);
  for (int i = 0; i < 3; i++)
    a.p[i] = way == 3 ? x[i] + 100.0 : x[i];
  return a;
}

static void
newtons (void)
{
  int good = 0;
  begin ("gs_arm_refine, gs_arm_refine_step, gs_arm_missed, gs_turn_line, gs_reach_least_move, "
         "gs_reach_difference");
  for (int k = 0; k < 200; k++)
    {
      int n = k % 3 ? 6 : 2 + k / 3 % 4;
      arm a = arm_of (n, k % 4);
      pair q = pair_of (6), w = pair_of (42), z = pair_of (6), s = pair_of (1);
      int iw[6], gc, gf;
      for (int i = 0; i < 6; i++)
        q.c[i] = i < n ? a.q[i] + 0.1 * q.c[i] : 0.0;
      both (q), both (w);
      gs_arm_refine (n, a.kind, a.ka, a.pa, a.r, a.p, q.c, w.c, iw, &gc);
      gsikn_ (&n, a.kind, a.ka, a.pa, a.r, a.p, q.f, w.f, iw, &gf);
      same_int (gc, gf);
      good += gc;
      gs_reach_least_move (n, a.kind, a.ka, a.pa, a.r, a.p, q.c, z.c, s.c);
      gsiko_ (&n, a.kind, a.ka, a.pa, a.r, a.p, q.f, z.f, s.f);
      z.c[0] += gs_reach_difference (n, a.kind, q.c, a.q), z.f[0] += gsikk_ (&n, a.kind, q.f, a.q);
      same (q), same (w), same (z), same (s);
      drop (q), drop (w), drop (z), drop (s);
    }
  finish ();
  holds (good > 100, "gs_arm_refine finds positions");
}

static void
distances (void)
{
  begin ("gs_reach_closest, gs_reach_closest_near");
  for (int k = 0; k < 24; k++)
    {
      arm a = arm_of (6, k % 4);
      int nb = k % 3;
      pair x0 = pair_of (3), qc = pair_of (12), dst = pair_of (2);
      both (x0), both (qc);
      gs_reach_closest (a.kind, a.ka, a.pa, a.r, a.p, x0.c, nb, qc.c, dst.c);
      gsiku_ (a.kind, a.ka, a.pa, a.r, a.p, x0.f, &nb, qc.f, dst.f);
      same (dst);
      drop (x0), drop (qc), drop (dst);
    }
  finish ();
}

/* solutions, the first one twice: how many become one? */
static int
twice (const arm *a, const gs_real *solutions, int n)
{
  pair q = pair_of (96);
  int nc = n + 1, nf = n + 1, info, again = 0;
  memcpy (q.c, solutions, 6 * n * sizeof (gs_real));
  for (int i = 0; i < 6; i++)
    q.c[i + 6 * n] = q.c[i] + 1e-15;
  both (q);
  same_int (gs_arm_doubles (a->ka, a->pa, a->r, a->p, q.c, &nc),
            (gsigd_ (a->ka, a->pa, a->r, a->p, q.f, &nf, &info), info));
  same_int (nc, nf);
  same (q);
  same_int (gs_arm_singular (6, a->kind, a->ka, a->pa, a->r, a->p, q.c, nc, 0),
            (gsigs_ (I (6), a->kind, a->ka, a->pa, a->r, a->p, q.f, &nf, &again), again));
  drop (q);
  return n + 1 - nc;
}

/* all angles of arms, those of the last one parallel; then one solution is refined and others
 * looked for */
static void
generals (void)
{
  int found = 0, more = 0, ones = 0;
  begin ("gs_arm_angles and its parts, gs_reach_refine, gs_reach_put, gs_arm_doubles, "
         "gs_arm_singular");
  for (int k = 0; k < 24; k++)
    {
      arm a = arm_of (6, k % 3 == 1 ? 0 : k % 4);
      for (int i = 3; i < 18 && k == 23; i++)
        a.ka[i] = a.ka[i - 3];
      pair qc = pair_of (96), w = pair_of (1200);
      int iw[24], nc, nf, bc[16] = { 0 }, bf[16] = { 0 }, info = 1;
      both (qc), both (w);
      same_int (gs_arm_angles (a.ka, a.pa, a.r, a.p, qc.c, &nc, w.c, iw),
                (gsikg_ (a.ka, a.pa, a.r, a.p, qc.f, &nf, w.f, iw, &info), info));
      info = 1;
      same_int (nc, nf);
      found += nc;
      same_numbers (6 * nc, qc.c, qc.f);
      if (nc > 0 && nc < 16)
        ones += twice (&a, qc.c, nc);
      pair guess = pair_of (12), rad = pair_of (4), lim = pair_of (2), qs = pair_of (12);
      for (int i = 0; i < 12; i++)
        guess.c[i] = a.q[i % 6] + 1e-4 * guess.c[i];
      for (int i = 0; i < 4; i++)
        rad.c[i] = 1e-9 * rad.c[i];
      lim.c[0] = 1e-14, lim.c[1] = k % 2 ? 1e-14 : 1e-24;
      nc = nf = k % 2, bc[0] = bf[0] = 1;
      memcpy (qs.c, guess.c, 6 * sizeof (gs_real));
      both (guess), both (rad), both (lim), both (qs);
      int made = gs_reach_refine (6, a.kind, a.ka, a.pa, a.r, a.p, 2, 2, guess.c, rad.c, lim.c,
                                  qs.c, &nc, bc, 1);
      gsikz_ (I (6), a.kind, a.ka, a.pa, a.r, a.p, I (2), I (2), guess.f, rad.f, lim.f, qs.f, &nf,
              bf, &info);
      same_int (made, info), same_int (nc, nf), whole (16, bc, bf);
      more += nc > k % 2;
      same (qs);
      drop (qc), drop (w), drop (guess), drop (rad), drop (lim), drop (qs);
    }
  finish ();
  holds (found > 30 && more > 0, "gs_arm_angles and gs_reach_refine find positions");
  holds (ones > 5, "gs_arm_doubles makes double solutions one");
}

/* close to singular positions: solutions along the curve on which the tool hardly moves, from a
 * guess that is wrong on it and from one that is off it */
static void
singulars (void)
{
  int found = 0;
  begin ("gs_reach_refine, gs_reach_size, gs_reach_curve, gs_reach_onto_curve, "
         "gs_reach_beside_singular, gs_reach_refine_all, gs_reach_same, gs_reach_distance, "
         "gs_reach_between");
  for (int k = 0; k < 20; k++)
    {
      arm a = arm_of (6, 4);
      int nc = k % 2, nf = nc, bc[4] = { 1 }, bf[4] = { 1 }, info = 1, near = 0;
      pair guess = pair_of (24), qs = pair_of (24);
      gs_real rad[] = { 1e-9, 1e-9, k % 3 ? 1e-9 : -1e-4, 1e-9 }, lim[] = { 1e-14 };
      for (int i = 0; i < 24; i++)
        guess.c[i] = a.q[i % 6] + 1e-6 * guess.c[i];
      for (int j = 0; j < 4; j++)
        guess.c[6 * j + 5] += 0.3 * j, guess.c[6 * j + 3] -= 0.3 * j;
      memcpy (qs.c, guess.c, 6 * sizeof (gs_real));
      both (guess), both (qs);
      int made = gs_reach_refine (6, a.kind, a.ka, a.pa, a.r, a.p, 4, 1, guess.c, rad, lim, qs.c,
                                  &nc, bc, 1);
      gsikz_ (I (6), a.kind, a.ka, a.pa, a.r, a.p, I (4), I (1), guess.f, rad, lim, qs.f, &nf, bf,
              &info);
      same_int (made, info), same_int (nc, nf), whole (4, bc, bf);
      same (qs);
      for (int j = 0; j < nc; j++)
        near |= gs_reach_difference (6, a.kind, qs.c + 6 * j, a.q) < 1e-6;
      found += near;
      drop (guess), drop (qs);
    }
  finish ();
  holds (found > 17, "gs_reach_refine finds positions close to singular ones");
}

/* three joints that bring a point to a place: one solution refined, others looked for beside it */
static void
places (void)
{
  int good = 0;
  begin ("gs_reach_refine_place");
  for (int k = 0; k < 40; k++)
    {
      int nc = 1, nf = 1, bc[2] = { 1, 0 }, bf[2] = { 1, 0 }, info = 0;
      arm a = arm_of (3, k % 2);
      pair qc = pair_of (6), qs = pair_of (6), x0 = pair_of (3);
      gs_real rad[] = { 1e-9, 1e-9 }, lim[] = { 1e-14 }, miss = 0.0;
      for (int i = 0; i < 6; i++)
        qc.c[i] = a.q[i % 3] + 1e-3 * qc.c[i], qs.c[i] = qc.c[i];
      both (qc), both (qs), both (x0);
      int made = gs_reach_refine_place (a.kind, a.ka, a.pa, a.r, a.p, x0.c, 2, 1, qc.c, rad, lim,
                                        qs.c, &nc, bc, 0);
      gsipz_ (a.kind, a.ka, a.pa, a.r, a.p, x0.f, I (2), I (1), qc.f, rad, lim, qs.f, &nf, bf,
              &info);
      same_int (made, info), same_int (nc, nf), whole (2, bc, bf);
      same (qs);
      for (int i = 0; i < 3; i++)
        miss = gs_fmax (miss, gs_abs (gs_sin (0.5 * (qs.c[i] - a.q[i]))));
      good += miss < 1e-11;
      drop (qc), drop (qs), drop (x0);
    }
  finish ();
  holds (good > 30, "gs_reach_refine_place refines solutions");
}

/* arms of two to five joints: one solution refined, others looked for beside it */
static void
fewer (void)
{
  int good = 0;
  begin ("gs_reach_refine, gs_reach_put, fewer joints");
  for (int k = 0; k < 40; k++)
    {
      int n = 2 + k % 4, nc = 1, nf = 1, bc[2] = { 1, 0 }, bf[2] = { 1, 0 }, info = 0;
      arm a = arm_of (n, k % 2);
      pair qc = pair_of (2 * n), qs = pair_of (2 * n);
      gs_real rad[] = { 1e-9, 1e-9 }, lim[] = { 1e-14 }, miss = 0.0;
      for (int i = 0; i < 2 * n; i++)
        qc.c[i] = a.q[i % n] + 1e-3 * qc.c[i], qs.c[i] = qc.c[i];
      both (qc), both (qs);
      int made = gs_reach_refine (n, a.kind, a.ka, a.pa, a.r, a.p, 2, 1, qc.c, rad, lim, qs.c, &nc,
                                  bc, 0);
      gsikz_ (&n, a.kind, a.ka, a.pa, a.r, a.p, I (2), I (1), qc.f, rad, lim, qs.f, &nf, bf, &info);
      same_int (made, info), same_int (nc, nf), whole (2, bc, bf);
      same (qs);
      for (int i = 0; i < n; i++)
        miss = gs_fmax (miss, gs_abs (gs_sin (0.5 * (qs.c[i] - a.q[i]))));
      good += miss < 1e-12;
      drop (qc), drop (qs);
    }
  finish ();
  holds (good > 30, "gs_reach_refine refines solutions of fewer joints");
}

/* ------------------------------------------------------------ three joints, guesses */

static void
centre (const gs_real *p, const gs_real *r, const gs_real *qg, const gs_real *cst,
        const gs_real *qa, gs_real *miss, gs_real *jc)
{
  (void)r, (void)qg, (void)cst;
  for (int i = 0; i < 3; i++)
    {
      miss[i] = p[i] - gs_sin (qa[0] + i) - gs_cos (qa[1] * (i + 1)) - 0.5 * gs_sin (qa[2] - i);
      jc[i] = gs_cos (qa[0] + i);
      jc[i + 3] = -(i + 1) * gs_sin (qa[1] * (i + 1));
      jc[i + 6] = 0.5 * gs_cos (qa[2] - i);
    }
}

static void
centres (void)
{
  begin ("gs_reach_beyond");
  for (int k = 0; k < 60; k++)
    {
      int nb = 1 + pick (3), at = pick (3), nc = 3 + at;
      pair p = pair_of (3), qc = pair_of (nc * nb), dst = pair_of (1);
      p.c[0] *= k % 2 ? 1 : 10;
      both (p), both (qc);
      gs_reach_beyond (centre, 3, nc, nb, at, p.c, p.c, p.c, p.c, qc.c, dst.c);
      gsikd_ (centre, I (3), &nc, &nb, &at, p.f, p.f, p.f, p.f, qc.f, dst.f);
      same (dst);
      drop (p), drop (qc), drop (dst);
    }
  finish ();
}

static void
pnt (gs_real t, const gs_real *q, const gs_real *cst, gs_real *place, gs_real *axes)
{
  gs_real s = gs_sin (q[1]), c = gs_cos (q[1]);
  (void)t, (void)cst;
  memcpy (place, (gs_real[]){ q[0] + c, s + q[2], q[3] }, 3 * sizeof (gs_real));
  memcpy (axes, (gs_real[]){ c, s, 0, -s, c, 0, 0, 0, 1 }, 9 * sizeof (gs_real));
}

static void
jpt (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *jac, gs_real *gam)
{
  (void)t, (void)u, (void)cst, (void)gam;
  memset (jac, 0, 24 * sizeof (gs_real));
  jac[0] = 1, jac[6] = -gs_sin (q[1]), jac[7] = gs_cos (q[1]);
  jac[11] = 1, jac[13] = 1, jac[20] = 1;
}

static void
kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  (void)t, (void)q, (void)cst;
  memcpy (qdot, u, 4 * sizeof (gs_real));
}

static int
con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi, gs_real *phit,
     gs_real *hc, int ldh, gs_real *gam)
{
  (void)t, (void)u, (void)cst, (void)phit, (void)gam;
  phi[0] = q[0] + q[2] - 0.3 * q[3];
  hc[0] = hc[2 * ldh] = 1, hc[ldh] = 0, hc[3 * ldh] = -0.3;
  return gs_abs (q[0]) > 50.0 ? -3 : 0;
}

static void
pnt_ (gs_real *t, gs_real *q, gs_real *cst, gs_real *place, gs_real *axes)
{
  pnt (*t, q, cst, place, axes);
}

static void
jpt_ (gs_real *t, gs_real *q, gs_real *u, gs_real *cst, gs_real *jac, gs_real *gam)
{
  jpt (*t, q, u, cst, jac, gam);
}

static void
kin_ (gs_real *t, gs_real *q, gs_real *u, gs_real *cst, gs_real *qdot)
{
  kin (*t, q, u, cst, qdot);
}

static void
con_ (gs_real *t, gs_real *q, gs_real *u, gs_real *cst, gs_real *phi, gs_real *phit, gs_real *hc,
      int *ldh, gs_real *gam, int *info)
{
  *info = con (*t, q, u, cst, phi, phit, hc, *ldh, gam);
}

static void
poses (void)
{
  const gs_scene scene = { .nq = 4, .nu = 4, .nlam = 1, .con = con, .kin = kin, .pnt = pnt,
                           .jpt = jpt };
  begin ("gs_reach_point and its parts");
  memset (seen, 0, sizeof seen);
  for (int k = 0; k < 120; k++)
    {
      int job = k % 2, nlam = k / 2 % 2, iv[] = { 1, 2, 3, 0 }, info;
      pair p = pair_of (3), r = pair_of (9), q = pair_of (4), lo = pair_of (4), hi = pair_of (4);
      pair w = pair_of (200), dst = pair_of (2), aim = pair_of (4);
      pnt (0.0, aim.c, NULL, p.c, r.c);
      for (int i = 0; i < 9 && k % 10 == 5; i++)
        r.c[i] = i % 4 ? 0.0 : i == 4 ? 1.0 : -1.0;
      for (int i = 0; i < 4; i++)
        {
          lo.c[i] = k % 3 ? -10.0 : -0.5;
          hi.c[i] = k % 3 ? 10.0 : 0.5;
        }
      if (k % 20 == 7)
        lo.c[0] = hi.c[0] = 60.0;
      both (p), both (r), both (q), both (lo), both (hi), both (w);
      int made = gs_reach_point (&scene, 0.0, 4, 4, nlam, 1, 1, job, p.c, r.c, q.c, lo.c, hi.c, iv,
                                 0, iv, NULL, w.c, dst.c);
      gsnik_ (pnt_, jpt_, kin_, con_, D (0.0), I (4), I (4), &nlam, I (1), I (1), &job, p.f, r.f,
              q.f, lo.f, hi.f, iv, I (0), iv, NULL, w.f, dst.f, &info);
      outcome (made, info);
      if (made >= 0)
        same (dst);
      same (q);
      drop (p), drop (r), drop (q), drop (lo), drop (hi), drop (w), drop (dst), drop (aim);
    }
  finish ();
  holds (seen[0] && seen[1], "gs_reach_point reaches poses, and does not");
}

int
main (void)
{
  eigenvalues ();
  conics ();
  branches ();
  newtons ();
  distances ();
  generals ();
  centres ();
  poses ();
  singulars ();
  places ();
  fewer ();
  return 0;
}

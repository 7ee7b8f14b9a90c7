/* round_trips.c: compiled with -include NAME.h (scenes.py) and linked with the emitted Fortran of
   an arm. round_trips COUNT SEED: that many poses by chance; is the position among the solutions,
   do all solutions have the pose? round_trips beside COUNT SEED: positions beside singular ones.
   The last line begins with "ok" or "not ok"; "lost" lines tell the poses that were lost. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 64                                   /* branches */
#define ROWS (WHOLE ? 6 : 3)
#define NS (NQ - (GIVEN > 0))                     /* coordinates of a solution */

void NAME(par_)(double *), NAME(pre_)(double *, double *, int *);
void NAME(pnt_)(double *, double *, double *, double *, double *);
void NAME(jpt_)(double *, double *, double *, double *, double *, double *);
#if GIVEN
void NAME(ikn_)(double *, double *, double *, double *, double *, int *, int *, double *, int *);
#define IKN(P, R, QG, QS, N, BR, D, I) NAME(ikn_)(P, R, QG, cst, QS, N, BR, D, I)
#else
void NAME(ikn_)(double *, double *, double *, double *, int *, int *, double *, int *);
#define IKN(P, R, QG, QS, N, BR, D, I) NAME(ikn_)(P, R, cst, QS, N, BR, D, I)
#endif

static double cst[1000];
static uint64_t chance_state;

static double chance(void)                        /* 0 to 1, splitmix64 */
{
  uint64_t z = (chance_state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30))*0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27))*0x94D049BB133111EBu;
  return (double) ((z ^ (z >> 31)) >> 11)/9007199254740992.0;
}

static void position_by_chance(double *q)
{
  for (int i = 0; i < NQ; i++)
    q[i] = turns[i] ? 2*M_PI*(chance() - 0.5) : chance() - 0.5;
}

/* ------------------------------------------------------------------------------- the arm itself */

/* place in q of coordinate i of a solution */
static int full(int i) { return i + (GIVEN > 0 && i >= GIVEN - 1); }

static void place(double *q, double *p, double *r)
{
  double t = 0;
  NAME(pnt_)(&t, q, cst, p, r);
}

static void jacobian(double *q, double j[6][NS])
{
  double t = 0, u[NQ] = {0}, jp[6*NQ], rate[6];
  NAME(jpt_)(&t, q, u, cst, jp, rate);
  for (int i = 0; i < NS; i++)
    for (int k = 0; k < 6; k++)
      j[k][i] = k < ROWS ? jp[6*full(i) + k] : 0;
}

/* singular values s, falling, of the Jacobian and right vectors v, by rotations of columns */
static void singular(double *q, double *s, double v[NS][NS])
{
  double a[6][NS];
  jacobian(q, a);
  for (int i = 0; i < NS; i++)
    for (int k = 0; k < NS; k++) v[i][k] = i == k;
  for (int sweep = 0; sweep < 30; sweep++)
    for (int i = 0; i < NS; i++)
      for (int k = i + 1; k < NS; k++) {
        double x = 0, y = 0, z = 0;
        for (int l = 0; l < 6; l++) {
          x += a[l][i]*a[l][i];
          y += a[l][k]*a[l][k];
          z += a[l][i]*a[l][k];
        }
        if (fabs(z) <= 1e-18*sqrt(x*y) + 1e-300 && x >= y) continue;
        double th = 0.5*atan2(2*z, x - y), c = cos(th), e = sin(th);
        for (int l = 0; l < 6 + NS; l++) {
          double *f = l < 6 ? &a[l][i] : &v[l - 6][i], *g = l < 6 ? &a[l][k] : &v[l - 6][k];
          double h = c**f + e**g;
          *g = c**g - e**f;
          *f = h;
        }
      }
  for (int i = 0; i < NS; i++) {
    s[i] = 0;
    for (int l = 0; l < 6; l++) s[i] += a[l][i]*a[l][i];
    s[i] = sqrt(s[i]);
  }
}

static double least_singular(double *q)
{
  double s[NS], v[NS][NS];
  singular(q, s, v);
  return s[NS - 1];
}
static double condition(double *q)
{
  double s[NS], v[NS][NS];
  singular(q, s, v);
  return s[0]/fmax(s[NS - 1], 1e-300);
}

/* ----------------------------------------------------------------------------- solutions */

struct answer {
  double qs[NS*MOST], dst[2], nearest, miss;
  int n, br[MOST], info, at;
};

static double apart(const double *q, const double *solution)
{
  double d = 0;
  for (int i = 0; i < NS; i++) {
    double e = q[full(i)] - solution[i];
    if (turns[full(i)]) e -= 2*M_PI*round(e/(2*M_PI));
    d = fmax(d, fabs(e));
  }
  return d;
}

static void whole_position(const double *q, const double *solution, double *all)
{
  memcpy(all, q, NQ*sizeof *q);
  for (int i = 0; i < NS; i++) all[full(i)] = solution[i];
}

/* all solutions of the pose of q: the distance of the nearest from q, the largest part of the pose
   that one misses where it is not singular (least singular value above 1e-3) */
static void ask(double *q, struct answer *a)
{
  double p[3], r[9], p1[3], r1[9], all[NQ];
  place(q, p, r);
  IKN(p, r, &q[GIVEN > 0 ? GIVEN - 1 : 0], a->qs, &a->n, a->br, a->dst, &a->info);
  a->nearest = 1e9;
  a->miss = 0;
  for (int k = 0; k < a->n; k++) {
    double d = apart(q, a->qs + NS*k), e = 0;
    if (d < a->nearest) a->nearest = d;
    whole_position(q, a->qs + NS*k, all);
    place(all, p1, r1);
    for (int i = 0; i < 3; i++) e = fmax(e, fabs(p1[i] - p[i]));
    for (int i = 0; WHOLE && i < 9; i++) e = fmax(e, fabs(r1[i] - r[i]));
    if (e > a->miss && (e <= 1e-12 || !(least_singular(all) < 1e-3))) a->miss = e;
  }
}

static void tell(const char *word, double *q, const struct answer *a)
{
  printf("%s q =", word);
  for (int i = 0; i < NQ; i++) printf(" %.17g", q[i]);
  printf("; condition %.1e, %d solutions, INFO %d, nearest %.1e\n", condition(q), a->n, a->info,
         a->nearest);
}

/* A position counts as found to 1e-6 and 4e-15 times the condition of its Jacobian: of a pose in
   double precision nobody knows more. */
static int by_chance(long count)
{
  long lost = 0, number = 0;
  double far = 0, miss = 0, worst = 0;
  struct answer a;
  for (long k = 0; k < count; k++) {
    double q[NQ];
    position_by_chance(q);
    ask(q, &a);
    number += a.n;
    if (a.miss > miss) miss = a.miss;
    double c = a.nearest <= 1e-6 ? 0 : condition(q);
    if (a.nearest <= 1e-6 + 4e-15*c) far = fmax(far, a.nearest);
    else {
      if (lost++ < 20) tell("lost", q, &a);
      if (worst == 0 || c < worst) worst = c;
    }
  }
  printf("%s %ld poses, %.3f solutions each, %ld lost",
    lost == 0 && miss <= 1e-12 ? "ok" : "not ok",
         count, (double) number/(double) count, lost);
  if (lost > 0) printf(" (least condition %.1e)", worst);
  printf("; nearest within %.1e, pose missed by %.1e\n", far, miss);
  return lost > 0 || miss > 1e-12;
}

/* ------------------------------------------------------------- beside singular positions */

/* the determinant, of as many coordinates as rows */
static double determinant(double *q)
{
  double j[6][NS], d = 1;
  jacobian(q, j);
  for (int k = 0; k < NS; k++) {
    int p = k;
    for (int i = k; i < NS; i++) if (fabs(j[i][k]) > fabs(j[p][k])) p = i;
    if (j[p][k] == 0) return 0;
    if (p != k) {
      d = -d;
      for (int l = 0; l < NS; l++) { double t = j[p][l]; j[p][l] = j[k][l]; j[k][l] = t; }
    }
    d *= j[k][k];
    for (int i = k + 1; i < NS; i++) {
      double f = j[i][k]/j[k][k];
      for (int l = k; l < NS; l++) j[i][l] -= f*j[k][l];
    }
  }
  return d;
}

/* a singular position on the way from q along z; 0 where the determinant keeps its sign */
static int singular_on_the_way(double *q, const double *z)
{
  double a[NQ], b[NQ], da = determinant(q), db = da;
  memcpy(a, q, sizeof a);
  for (int k = 1; k <= 100 && db*da > 0; k++) {
    memcpy(a, k == 1 ? q : b, sizeof a);
    for (int i = 0; i < NQ; i++) b[i] = q[i] + 0.03*k*z[i];
    db = determinant(b);
  }
  if (!(db*da <= 0)) return 0;
  for (int k = 0; k < 60; k++) {
    double m[NQ];
    for (int i = 0; i < NQ; i++) m[i] = 0.5*(a[i] + b[i]);
    if (determinant(m)*da > 0) memcpy(a, m, sizeof a); else memcpy(b, m, sizeof b);
  }
  memcpy(q, b, sizeof b);
  return 1;
}

/* the largest change of the pose from q to q1 */
static double moved(double *q, double *q1)
{
  double p[3], r[9], p1[3], r1[9], e = 0;
  place(q, p, r);
  place(q1, p1, r1);
  for (int i = 0; i < 3; i++) e = fmax(e, fabs(p1[i] - p[i]));
  for (int i = 0; WHOLE && i < 9; i++) e = fmax(e, fabs(r1[i] - r[i]));
  return e;
}

/* how many of the solutions of the pose of x are still there when the pose moves by e: those beside
   x, and those whose least singular value s is so large that they reach a double root behind more
   than s^2/4 only, the bend of no fold being above 2 */
static int lasting(const double *x, const struct answer *a, double e)
{
  int n = 0;
  double all[NQ];
  for (int k = 0; k < a->n; k++) {
    double s;
    whole_position(x, a->qs + NS*k, all);
    s = least_singular(all);
    n += apart(x, a->qs + NS*k) < 0.1 || s*s > 4*e;
  }
  return n;
}

/* d beside the singular position q along n. An error e of the pose moves a solution by e over the
   least singular value, but a double root by no more than sqrt(2 e/bend), where bend is the slope
   of that value along n (0: the position moves freely, no double root). Answers how many solutions
   there must still be at d/10. */
struct tally { long n, lost, fewer; double miss; };
static int beside(double *q, const double *n, double d, double bend, int before, struct tally *t)
{
  struct answer a;
  double x[NQ], next[NQ], tol;
  memcpy(x, q, sizeof x);
  memcpy(next, q, sizeof next);
  for (int i = 0; i < NS; i++) {
    x[full(i)] += d*n[i];
    next[full(i)] += 0.1*d*n[i];
  }
  tol = 4e-15/least_singular(x);
  if (bend > 0) tol = fmin(tol, 2*sqrt(1e-15/bend));
  tol += 1e-7;
  ask(x, &a);
  t->n++;
  t->miss = fmax(t->miss, a.miss);
  if (a.nearest > tol) {
    t->lost++;
    printf("%g beside, bend %.1e: ", d, bend);
    tell("lost", x, &a);
  }
  if (d >= 9e-8 && tol < d && a.n < before) {
    t->fewer++;
    printf("%g beside, bend %.1e, %d before: ", d, bend, before);
    tell("fewer", x, &a);
  }
  return lasting(x, &a, moved(x, next));
}

static int beside_singular(long count)
{
  struct tally t[7] = {{0}};
  int bad = 0;
  if (NS != ROWS) return puts("ok: left out, fewer coordinates than the pose has rows"), 0;
  for (long k = 0, tries = 0; k < count && tries < 100*count; tries++) {
    double q[NQ], z[NQ], s[NS], v[NS][NS], n[NS], c[NQ], length = 0;
    position_by_chance(q);
    position_by_chance(z);
    for (int i = 0; i < NQ; i++) length += z[i]*z[i];
    for (int i = 0; i < NQ; i++) z[i] = i == GIVEN - 1 ? 0 : z[i]/sqrt(length);
    if (!singular_on_the_way(q, z)) continue;
    k++;
    singular(q, s, v);
    for (int i = 0; i < NS; i++) n[i] = v[i][NS - 1];
    memcpy(c, q, sizeof c);
    for (int i = 0; i < NS; i++) c[full(i)] += 1e-3*n[i];
    double bend = 1e3*least_singular(c);
    if (bend < 1e-2) {                    /* a motion of itself,
      or almost: go where the rank comes back */
      for (int i = 0; i < NS; i++) n[i] = z[full(i)];
      bend = 0;
    }
    int before = 0;
    for (int e = 0; e < 7; e++)
      before = beside(q, n, pow(10, -3 - e), bend, before, &t[e]);
  }
  for (int e = 0; e < 7; e++) {
    printf("1e-%d beside: %ld poses, %ld lost, %ld with fewer solutions, pose missed by %.1e\n",
      3 + e,
           t[e].n, t[e].lost, t[e].fewer, t[e].miss);
    bad |= t[e].lost > 0 || t[e].fewer > 0;
  }
  puts(bad ? "not ok" : t[0].n > 0 ? "ok" : "ok (no singular position found)");
  return bad;
}

int main(int argc, char **argv)
{
  double par[1000];
  int info, by_side = argc > 1 && strcmp(argv[1], "beside") == 0;
  if (argc < 3 + by_side) return fputs("usage: round_trips [beside] COUNT SEED\n", stderr), 2;
  NAME(par_)(par);
  NAME(pre_)(par, cst, &info);
  chance_state = strtoull(argv[2 + by_side], 0, 10)*1000003u + 17;
  long count = strtol(argv[1 + by_side], 0, 10);
  return by_side ? beside_singular(count) : by_chance(count);
}

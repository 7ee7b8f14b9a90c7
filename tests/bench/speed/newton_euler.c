/* newton_euler.c: what the quad build is checked against: the recursive Newton-Euler equations of a
   chain or tree, in quad precision and link axes, from the numbers of model.txt (rivals/model.hpp)
   alone; accelerations from columns of M by the same recursion and Gauss. Results as in ours.c. */
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>
typedef __float128 real;
enum { MOST = 64 };
struct link { int parent, sliding; real R[9], p[3], m, c[3], J[6]; };
static struct link links[MOST];
static int n;
static real gravity[3];

static void numbers(FILE *file, real *x, int k) {
  char word[100];
  while (k-- > 0 && fscanf(file, "%99s", word) == 1) *x++ = strtoflt128(word, NULL);
}

void init(const char *path) {
  FILE *file = fopen(path, "r");
  char type[8];
  if (!file || fscanf(file, "%d", &n) != 1 || n > MOST) {
    fprintf(stderr, "newton_euler: cannot read %s\n", path);
    exit(1);
  }
  numbers(file, gravity, 3);
  for (struct link *l = links; l < links + n; l++) {
    if (fscanf(file, "%d %7s", &l->parent, type) != 2) exit(1);
    l->sliding = *type == 'P';
    numbers(file, l->R, 9);
    numbers(file, l->p, 3);
    numbers(file, &l->m, 1);
    numbers(file, l->c, 3);
    numbers(file, l->J, 6);
  }
  fclose(file);
}

/* o += a x b */
static void cross(const real *a, const real *b, real *o) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    o[i] += a[j] * b[k] - a[k] * b[j];
  }
}

/* o = R' a;  o += R a */
static void into(const real R[9], const real *a, real *o) {
  for (int i = 0; i < 3; i++) o[i] = R[i] * a[0] + R[3 + i] * a[1] + R[6 + i] * a[2];
}
static void back(const real R[9], const real *a, real *o) {
  for (int i = 0; i < 3; i++) o[i] += R[3 * i] * a[0] + R[3 * i + 1] * a[1] + R[3 * i + 2] * a[2];
}

static void inertia(const real J[6], const real *w, real *o) {
  o[0] = J[0] * w[0] + J[3] * w[1] + J[5] * w[2];
  o[1] = J[3] * w[0] + J[1] * w[1] + J[4] * w[2];
  o[2] = J[5] * w[0] + J[4] * w[1] + J[2] * w[2];
}

/* tau of q, v, a; without gravity where g = 0 */
static void recursion(const real *q, const real *v, const real *a, int g, real *tau) {
  static real R[MOST][9], p[MOST][3], w[MOST][3], dw[MOST][3], acc[MOST][3], f[MOST][3], m[MOST][3];
  for (int i = 0; i < n; i++) {
    struct link *l = links + i;
    int b = l->parent;
    real zero[3] = {0}, up[3], c = l->sliding ? 1 : cosq(q[i]), s = l->sliding ? 0 : sinq(q[i]);
    for (int k = 0; k < 3; k++) {
      real x = l->R[3 * k], y = l->R[3 * k + 1];
      R[i][3 * k] = c * x + s * y;
      R[i][3 * k + 1] = c * y - s * x;
      R[i][3 * k + 2] = l->R[3 * k + 2];
      p[i][k] = l->p[k] + (l->sliding ? q[i] * l->R[3 * k + 2] : 0);
      up[k] = g ? -gravity[k] : 0;
    }
    const real *wb = b < 0 ? zero : w[b], *db = b < 0 ? zero : dw[b];
    real at[3], wp[3] = {0}, z[3] = {0, 0, v[i]};
    for (int k = 0; k < 3; k++) at[k] = b < 0 ? up[k] : acc[b][k];
    cross(db, p[i], at); cross(wb, p[i], wp); cross(wb, wp, at);
    into(R[i], wb, w[i]); into(R[i], db, dw[i]); into(R[i], at, acc[i]);
    if (l->sliding) { cross(w[i], z, acc[i]); cross(w[i], z, acc[i]); acc[i][2] += a[i]; }
    else { cross(w[i], z, dw[i]); w[i][2] += v[i]; dw[i][2] += a[i]; }
    real mid[3] = {acc[i][0], acc[i][1], acc[i][2]}, wc[3] = {0}, Jw[3];
    cross(dw[i], l->c, mid); cross(w[i], l->c, wc); cross(w[i], wc, mid);
    inertia(l->J, w[i], Jw); inertia(l->J, dw[i], m[i]); cross(w[i], Jw, m[i]);
    for (int k = 0; k < 3; k++) f[i][k] = l->m * mid[k];
    cross(l->c, f[i], m[i]);
  }
  for (int i = n - 1; i >= 0; i--) {
    int b = links[i].parent;
    tau[i] = links[i].sliding ? f[i][2] : m[i][2];
    if (b < 0) continue;
    real force[3] = {0};
    back(R[i], f[i], force); back(R[i], m[i], m[b]); cross(p[i], force, m[b]);
    for (int k = 0; k < 3; k++) f[b][k] += force[k];
  }
}

static void quads(const double *x, real *y) { for (int i = 0; i < n; i++) y[i] = x[i]; }
static void give(const real *y, double *o) {
  for (int i = 0; i < n; i++) {
    o[i] = y[i];
    o[n + i] = y[i] - o[i];
  }
}

void id(const double *q, const double *v, const double *a, double *o) {
  real Q[MOST], V[MOST], A[MOST], tau[MOST];
  quads(q, Q); quads(v, V); quads(a, A);
  recursion(Q, V, A, 1, tau);
  give(tau, o);
}

void fd(const double *q, const double *v, const double *tau, double *o) {
  static real M[MOST][MOST];
  real Q[MOST], V[MOST], x[MOST], zero[MOST] = {0}, bias[MOST], unit[MOST] = {0}, column[MOST];
  quads(q, Q); quads(v, V); quads(tau, x);
  recursion(Q, V, zero, 1, bias);
  for (int j = 0; j < n; j++) {
    x[j] -= bias[j];
    unit[j] = 1; recursion(Q, zero, unit, 0, column); unit[j] = 0;
    for (int i = 0; i < n; i++) M[i][j] = column[i];
  }
  for (int k = 0; k < n; k++)              /* M is positive definite: no pivots */
    for (int i = k + 1; i < n; i++) {
      real r = M[i][k] / M[k][k];
      for (int j = k; j < n; j++) M[i][j] -= r * M[k][j];
      x[i] -= r * x[k];
    }
  for (int i = n - 1; i >= 0; i--) {
    for (int j = i + 1; j < n; j++) x[i] -= M[i][j] * x[j];
    x[i] /= M[i][i];
  }
  give(x, o);
}

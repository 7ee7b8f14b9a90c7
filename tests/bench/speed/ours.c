/* ours.c: the emitted subroutines of a scene behind the interface of driver.c. -DNAME=puma3 -DN=3
   -DNCST=48 -DNPAR=18, and -DQUAD where the Fortran was built in quad precision: then every result
   is two numbers, the double nearest to it and what is left. -DLOOP: fd is of the closed chain, its
   first torque the input. -DBATCH: of the forms for many states; -DLIN: of the linear model alone;
   -DJAC: jac, of the state equations without torques, and least, what that takes at least. */
#define GLUE(name, word) name##_##word##_
#define PASTE(name, word) GLUE(name, word)
#define F(word) PASTE(NAME, word)
#ifdef QUAD
typedef __float128 real;
#else
typedef double real;
#endif
void F(par)(real *), F(pre)(const real *, real *, int *),
    F(inv)(const real *, const real *, const real *, const real *, const real *, const real *,
           real *),
    F(mas)(const real *, const real *, const real *, real *, const int *),
    F(fwd)(const real *, const real *, const real *, const real *, const real *, const real *,
           real *, int *),
    F(acc)(const real *, const real *, const real *, const real *, real *, real *, int *),
    F(inv_v)(const real *, const real *, const real *, const real *, const real *, const real *,
             real *, const int *, const int *),
    F(mas_v)(const real *, const real *, const real *, real *, const int *, const int *),
    F(fwd_v)(const real *, const real *, const real *, const real *, const real *, const real *,
             real *, int *, const int *, const int *),
    F(lin)(const real *, const real *, const real *, const real *, const real *, const real *,
           real *, real *, real *, const int *);
void F(rhs)(const real *, const real *, const real *, const real *, real *, int *),
    F(jac)(const real *, const real *, const real *, const real *, real *, const int *, real *,
           const int *, real *, const int *, real *, const int *, int *),
    gsspd_(const int *, const int *, real *, const int *, real *, const int *, int *);
static const real t = 0, none[8];
static const int n = N;
static real cst[NCST + 1];

void init(const char *unused) {
  real par[NPAR + 1];
  int info;
  F(par)(par);
  F(pre)(par, cst, &info);
}

#ifdef BATCH
static const real zeros[4096];
static int infos[4096];
void id_v(int k, const real *q, const real *v, const real *a, real *o) {
  F(inv_v)(zeros, q, v, a, none, cst, o, &k, &k);
}
void fd_v(int k, const real *q, const real *v, const real *tau, real *o) {
  F(fwd_v)(zeros, q, v, none, tau, cst, o, infos, &k, &k);
}
void mm_v(int k, const real *q, const real *v, const real *a, real *o) {
  F(mas_v)(zeros, q, cst, o, &k, &k);
}
#elif defined JAC
static const int nx = 2 * N, one = 1;
static real x[2 * N];
static void jacobian(const double *q, const double *v, real *a) {
  real b, c, d;
  int info;
  for (int i = 0; i < N; i++) { x[i] = q[i]; x[N + i] = v[i]; }
  F(jac)(&t, x, none, cst, a, &nx, &b, &nx, &c, &one, &d, &one, &info);
}
#ifdef QUAD
void jac(const double *q, const double *v, const double *unused, double *o) {
  static real a[4 * N * N];
  jacobian(q, v, a);
  for (int i = 0; i < 4 * N * N; i++) { o[i] = a[i]; o[4 * N * N + i] = a[i] - o[i]; }
}
#else
static double xd[2 * N], lm[N * N], lb[N * N];
void jac(const double *q, const double *v, const double *unused, double *o) { jacobian(q, v, o); }
void least(const double *q, const double *v, const double *unused, double *o) {
  int info;
  for (int i = 0; i < N; i++) { x[i] = q[i]; x[N + i] = v[i]; }
  F(rhs)(&t, x, none, cst, xd, &info);
  F(lin)(&t, q, v, xd + N, none, cst, lm, o + N * N, o, &n);
  gsspd_(&n, &nx, lm, &n, o, &n, &info);
}
#endif
#elif defined LIN
void lin(const double *q, const double *v, const double *a, double *o) {
  F(lin)(&t, q, v, a, none, cst, o, o + N * N, o + 2 * N * N, &n);
}
#else
static void forward(const real *q, const real *v, const real *tau, real *a) {
  int info;
#ifdef LOOP
  real x[2 * N], lambda[N];
  for (int i = 0; i < N; i++) { x[i] = q[i]; x[N + i] = v[i]; }
  F(acc)(&t, x, tau, cst, a, lambda, &info);
#else
  F(fwd)(&t, q, v, none, tau, cst, a, &info);
#endif
}

#ifdef QUAD
static real x[3 * N], y[N];
static void take(const double *q, const double *v, const double *a) {
  for (int i = 0; i < N; i++) {
    x[i] = q[i];
    x[N + i] = v[i];
    x[2 * N + i] = a[i];
  }
}
static void give(double *o) { for (int i = 0; i < N; i++) { o[i] = y[i]; o[N + i] = y[i] - o[i]; } }
void id(const double *q, const double *v, const double *a, double *o) {
  take(q, v, a);
  F(inv)(&t, x, x + N, x + 2 * N, none, cst, y);
  give(o);
}
void fd(const double *q, const double *v, const double *tau, double *o) {
  take(q, v, tau);
  forward(x, x + N, x + 2 * N, y);
  give(o);
}
#else
void id(const double *q, const double *v, const double *a, double *o) {
  F(inv)(&t, q, v, a, none, cst, o);
}
void fd(const double *q, const double *v, const double *tau, double *o) { forward(q, v, tau, o); }
void mm(const double *q, const double *v, const double *a, double *o) { F(mas)(&t, q, cst, o, &n); }
#endif
#endif

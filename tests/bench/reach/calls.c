/* calls.c: loops over the emitted Fortran of the PUMA for times.py: poses of COUNT positions, all
   their solutions, inverse dynamics, axes of the joints where all angles are zero; `times` are
   nanoseconds a call. Arrays run state by state, matrices column by column. */
#define _GNU_SOURCE
#include <time.h>

void puma6_par_(double *), puma6_pre_(double *, double *, int *),
    puma6_pnt_(double *, double *, double *, double *, double *),
    puma6_jpt_(double *, double *, double *, double *, double *, double *),
    puma6_ikn_(double *, double *, double *, double *, int *, int *, double *, int *),
    puma6_inv_(double *, double *, double *, double *, double *, double *, double *);

static double cst[1000], t = 0, none[1];

void start(void) {
  double par[1000];
  int info;
  puma6_par_(par);
  puma6_pre_(par, cst, &info);
}

void poses(int count, double *q, double *p, double *r) {
  for (int k = 0; k < count; k++) puma6_pnt_(&t, q + 6 * k, cst, p + 3 * k, r + 9 * k);
}

void jacobian(double *q, double *j) {
  double u[6] = {0}, rate[6];
  puma6_jpt_(&t, q, u, cst, j, rate);
}

void solutions(int count, double *p, double *r, double *qs, int *ns) {
  int br[8], info;
  double dst[2];
  for (int k = 0; k < count; k++)
    puma6_ikn_(p + 3 * k, r + 9 * k, cst, qs + 48 * k, ns + k, br, dst, &info);
}

static double now(void) {
  struct timespec s;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &s);
  return 1e9 * (double)s.tv_sec + (double)s.tv_nsec;
}

double solutions_time(int count, double *p, double *r, double *qs, int *ns) {
  double begin = now();
  solutions(count, p, r, qs, ns);
  return (now() - begin) / count;
}

double inverse_time(int count, double *q, double *u, double *ud, double *tau) {
  double begin = now();
  for (int k = 0; k < count; k++)
    puma6_inv_(&t, q + 6 * k, u + 6 * k, ud + 6 * k, none, cst, tau + 6 * k);
  return (now() - begin) / count;
}

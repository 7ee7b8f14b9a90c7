/* andrews_ida FORM RTOL TEND REPEATS Q U: Andrews' squeezer by SUNDIALS IDA (BDF), to compare with
   GSMBP's own integration.

   M u' + b comes from the emitted Fortran (INV, its exact derivatives from LIN); the three plane
   loops are written here by hand, as complex numbers, with all derivatives that a Jacobian needs;
   they are compared with the emitted CON before anything is timed. FORM is

   ode      x' = f(x), x = [q, u]: f is the emitted RHS, its Jacobian the emitted JAC; Baumgarte's
   constants are zero index1   q' = u, M u' + b = H' lam, H u' = gamma                      y = [q,
   u, lam] index2   q' = u, M u' + b = H' lam, H u = 0                           y = [q, u, lam] ggl
   q' = u - H' mu, M u' + b = H' lam, H u = 0, phi = 0          y = [q, u, lam, mu]

   with exact Jacobians, compared with central differences before anything is timed. A letter s
   behind FORM (ggls) leaves the multipliers out of the error test; a number (ggl4) is the largest
   order of BDF. Q, U: the state at t = 0. Written on one line: seconds of processor time (the best
   of REPEATS runs, from IDAReInit to the end), steps, residuals, Jacobians, failures of the error
   test, failures of Newton's method, then q and u at TEND.

   Tolerances: relative RTOL; absolute RTOL rad, 1e3*RTOL rad/s, 1e3*RTOL N. mu is zero but for what
   Newton's method leaves, divided by the step: weighed 1e9*RTOL it does not stop the run. The first
   step is 1e-6 s; IDA's own, much smaller, loses the digits of phi/h and then fails.       */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

enum { N = 7, L = 3, M = 2 * L, ARMS = 7, MOST = 2 * N + 2 * M };
enum form { ODE, INDEX1, INDEX2, GGL };

void andrews_par_ (double *);
void andrews_pre_ (const double *, double *, int *);
void andrews_inv_(const double *, const double *, const double *, const double *, const double *,
                  const double *, double *);
void andrews_lin_(const double *, const double *, const double *, const double *, const double *,
                  const double *, double *, double *, double *, const int *);
void andrews_con_(const double *, const double *, const double *, const double *, double *,
                  double *, double *, const int *, double *, int *);
void andrews_acc_(const double *, const double *, const double *, const double *, double *,
                  double *, int *);
void andrews_rhs_ (const double *, const double *, const double *, const double *, double *, int *);
void andrews_jac_(const double *, const double *, const double *, const double *, double *,
                  const int *, double *, const int *, double *, const int *, double *, const int *,
                  int *);

static double cst[NCST], start[2 * N];
static const double none[1] = { 0 };
static const int n7 = N, n14 = 2 * N, m6 = M, ny = NY + 1;

/* ------------------------------------------------------------
 * the loops */

/* Arms of the loops as drawn at q = 0 [m], and which of q = [be, th, ga, de, ph, ep, om] turn them.
 */
static const double complex drawn[ARMS] = {0.007,     -0.028,    -0.035 * I, 0.04,
                                           -0.02 * I, -0.04 * I, 0.02};
static const int turned_by[ARMS][2] = {{0, -1}, {0, 1}, {2, -1}, {3, -1}, {3, 4}, {5, -1}, {5, 6}};
/* phi of a loop: base + arms - (crank arm + link arm) */
static const double complex base[L] = {-0.03635 + 0.03273 * I, -0.06934 - 0.00227 * I,
                                       -0.06934 - 0.00227 * I};
static const int arms[L][2] = { { 2, -1 }, { 3, 4 }, { 5, 6 } };

/* sum of v over the coordinates that turn an arm */
static double along (int arm, const double *v)
{
  return v[turned_by[arm][0]] + (turned_by[arm][1] < 0 ? 0 : v[turned_by[arm][1]]);
}

static void arms_at (const double *q, double complex *z)
{
  for (int k = 0; k < ARMS; k++)
    {
      double a = along (k, q);
      z[k] = drawn[k] * (cos (a) + I * sin (a));
    }
}

/* sum over the arms of loop l, signs included, of c */
static double complex closed (int l, const double complex *c)
{
  double complex s = c[arms[l][0]] - c[0] - c[1];
  return arms[l][1] < 0 ? s : s + c[arms[l][1]];
}

/* Adds to the rows ROW + 2l, ROW + 2l + 1 of A, from column COL on, the derivatives of the arms'
 * sums: c[k] for a unit turn of arm k. */
static void add_columns(double *A, int ld, int row, int col, const double complex *c,
                        double factor) {
  for (int l = 0; l < L; l++)
    for (int i = 0; i < 4; i++)
      {
        int k = i < 2 ? i : arms[l][i - 2];
        double complex d = k < 0 ? 0 : (i < 2 ? -factor : factor) * c[k];
        for (int j = 0; k >= 0 && j < 2; j++)
          if (turned_by[k][j] >= 0)
            {
              double *place = A + row + 2 * l + (size_t) ld * (col + turned_by[k][j]);
              place[0] += creal (d);
              place[1] += cimag (d);
            }
      }
}

/* r += factor * H' lam */
static void add_pull (double *r, const double complex *z, const double *lam, double factor)
{
  for (int l = 0; l < L; l++)
    for (int i = 0; i < 4; i++)
      {
        int k = i < 2 ? i : arms[l][i - 2];
        if (k < 0)
          continue;
        double d =
            (i < 2 ? -factor : factor) * (creal(z[k]) * lam[2 * l + 1] - cimag(z[k]) * lam[2 * l]);
        for (int j = 0; j < 2; j++)
          if (turned_by[k][j] >= 0)
            r[turned_by[k][j]] += d;
      }
}

/* A(ROW.., COL..) += factor * H' and factor * d(H' lam)/dq */
static void add_transposed(double *A, int ld, int row, int col, const double complex *z,
                           double factor) {
  double H[M * N] = { 0 };
  double complex c[ARMS];
  for (int k = 0; k < ARMS; k++)
    c[k] = I * z[k];
  add_columns (H, M, 0, 0, c, factor);
  for (int i = 0; i < M; i++)
    for (int j = 0; j < N; j++)
      A[row + j + (size_t) ld * (col + i)] += H[i + M * j];
}

static void add_pull_derivative(double *A, int ld, int row, int col, const double complex *z,
                                const double *lam, double factor) {
  for (int l = 0; l < L; l++)
    for (int i = 0; i < 4; i++)
      {
        int k = i < 2 ? i : arms[l][i - 2];
        if (k < 0)
          continue;
        double d =
            (i < 2 ? factor : -factor) * (creal(z[k]) * lam[2 * l] + cimag(z[k]) * lam[2 * l + 1]);
        for (int j = 0; j < 4; j++)
          if (turned_by[k][j / 2] >= 0 && turned_by[k][j % 2] >= 0)
            A[row + turned_by[k][j / 2] + (size_t) ld * (col + turned_by[k][j % 2])] += d;
      }
}

/* The loops of this file against the emitted ones, at a state far from closed: the sign of phi, or
 * 0 where they differ. */
static int emitted_sign (void)
{
  double q[N], u[N], phi[M], phit[M], H[M * N], mine[M * N] = { 0 }, gam[M], t = 0, s = 0, miss = 0;
  double complex z[ARMS], c[ARMS], a[ARMS];
  int info;
  for (int i = 0; i < N; i++)
    {
      q[i] = sin (3.7 * i + 1);
      u[i] = cos (2.3 * i);
    }
  andrews_con_ (&t, q, u, cst, phi, phit, H, &m6, gam, &info);
  arms_at (q, z);
  for (int k = 0; k < ARMS; k++)
    {
      double w = along (k, u);
      c[k] = I * z[k];
      a[k] = w * w * z[k];
    }
  s = phi[0] * creal (base[0] + closed (0, z)) > 0 ? 1 : -1;
  add_columns (mine, M, 0, 0, c, 1);
  for (int l = 0; l < L; l++)
    {
      double complex p = base[l] + closed (l, z), g = closed (l, a);
      miss = fmax (miss, fabs (phi[2 * l] - s * creal (p)) + fabs (phi[2 * l + 1] - s * cimag (p)));
      miss = fmax (miss, fabs (gam[2 * l] - s * creal (g)) + fabs (gam[2 * l + 1] - s * cimag (g)));
    }
  for (int i = 0; i < M * N; i++)
    miss = fmax (miss, fabs (H[i] - s * mine[i]));
  return miss < 1e-14 ? (int) s : 0;
}

/* ------------------------------------------------------------
 * residual and Jacobian */

static int residual (realtype t, N_Vector yy, N_Vector yp, N_Vector rr, void *data)
{
  enum form form = *(enum form *) data;
  const double *y = N_VGetArrayPointer(yy), *d = N_VGetArrayPointer(yp), *lam = y + 2 * N,
               *mu = lam + M;
  double *r = N_VGetArrayPointer (rr);
  double complex z[ARMS], c[ARMS];
  int info;
  if (form == ODE)
    {
      andrews_rhs_ (&t, y, none, cst, r, &info);
      for (int i = 0; i < 2 * N; i++)
        r[i] = d[i] - r[i];
      return info > 0;
    }
  arms_at (y, z);
  for (int i = 0; i < N; i++)
    r[i] = d[i] - y[N + i];
  andrews_inv_ (&t, y, y + N, d + N, none, cst, r + N);
  add_pull (r + N, z, lam, -1);
  if (form == GGL)
    {
      add_pull (r, z, mu, 1);
      for (int l = 0; l < L; l++)
        {
          double complex p = base[l] + closed (l, z);
          r[2 * N + M + 2 * l] = creal (p);
          r[2 * N + M + 2 * l + 1] = cimag (p);
        }
    }
  for (int k = 0; k < ARMS; k++)
    {
      double w = along (k, y + N);
      c[k] = form == INDEX1 ? I * along (k, d + N) * z[k] - w * w * z[k] : I * w * z[k];
    }
  for (int l = 0; l < L; l++)
    {
      double complex p = closed (l, c);
      r[2 * N + 2 * l] = creal (p);
      r[2 * N + 2 * l + 1] = cimag (p);
    }
  return 0;
}

/* dF/dy + cj dF/dy' */
static int jacobian(realtype t, realtype cj, N_Vector yy, N_Vector yp, N_Vector rr, SUNMatrix JJ,
                    void *data, N_Vector t1, N_Vector t2, N_Vector t3) {
  enum form form = *(enum form *) data;
  const double *y = N_VGetArrayPointer(yy), *d = N_VGetArrayPointer(yp), *lam = y + 2 * N,
               *mu = lam + M;
  double *J = SUNDenseMatrix_Data (JJ), W[N * N], B[N * N], C[N * N], Y[2 * N * (NY + 1)];
  double complex z[ARMS], c[ARMS], e[ARMS];
  int n = (int) SUNDenseMatrix_Rows (JJ), info;
  if (form == ODE)
    {
      andrews_jac_ (&t, y, none, cst, J, &n14, B, &n14, Y, &ny, W, &ny, &info);
      for (int i = 0; i < 4 * N * N; i++)
        J[i] = -J[i];
      for (int i = 0; i < 2 * N; i++)
        J[i + n * i] += cj;
      return info > 0;
    }
  memset (J, 0, sizeof (double) * n * n);
  arms_at (y, z);
  andrews_lin_ (&t, y, y + N, d + N, none, cst, W, B, C, &n7);
  for (int j = 0; j < N; j++)
    {
      J[j + n * j] = cj;
      J[j + n * (N + j)] = -1;
      for (int i = 0; i < N; i++)
        {
          J[N + i + n * j] = C[i + N * j];
          J[N + i + n * (N + j)] = B[i + N * j] + cj * W[i + N * j];
        }
    }
  add_pull_derivative (J, n, N, 0, z, lam, -1);
  add_transposed (J, n, N, 2 * N, z, -1);
  for (int k = 0; k < ARMS; k++)
    {
      double w = along (k, y + N), a = along (k, d + N);
      c[k] = form == INDEX1 ? -(a + I * w * w) * z[k] : -w * z[k];
      e[k] = form == INDEX1 ? (cj * I - 2 * w) * z[k] : I * z[k];
    }
  add_columns (J, n, 2 * N, 0, c, 1);
  add_columns (J, n, 2 * N, N, e, 1);
  if (form == GGL)
    {
      for (int k = 0; k < ARMS; k++)
        c[k] = I * z[k];
      add_columns (J, n, 2 * N + M, 0, c, 1);
      add_pull_derivative (J, n, 0, 0, z, mu, 1);
      add_transposed (J, n, 0, 2 * N + M, z, 1);
    }
  return 0;
}

/* the largest entry of the Jacobian that differs from a central difference, relative to the largest
 * of its column */
static double wrong_jacobian(enum form form, int n, N_Vector y, N_Vector d, N_Vector r,
                             SUNMatrix J) {
  double worst = 0, cj = 1e3, *py = N_VGetArrayPointer(y), *pd = N_VGetArrayPointer(d), plus[MOST];
  jacobian (0, cj, y, d, r, J, &form, NULL, NULL, NULL);
  for (int j = 0; j < n; j++)
    {
      double h = 1e-5 * fmax (1, fabs (py[j])), old = py[j], oldd = pd[j], top = 0, miss = 0;
      py[j] = old + h;
      pd[j] = oldd + cj * h;
      residual (0, y, d, r, &form);
      memcpy (plus, N_VGetArrayPointer (r), sizeof (double) * n);
      py[j] = old - h;
      pd[j] = oldd - cj * h;
      residual (0, y, d, r, &form);
      py[j] = old;
      pd[j] = oldd;
      for (int i = 0; i < n; i++)
        {
          double exact = SUNDenseMatrix_Column (J, j)[i];
          top = fmax (top, fabs (exact));
          miss = fmax (miss, fabs (exact - (plus[i] - N_VGetArrayPointer (r)[i]) / (2 * h)));
        }
      worst = fmax (worst, miss / top);
    }
  return worst;
}

/* ------------------------------------------------------------
 * a run */

/* consistent start: u' and lam from the emitted ACC, mu = 0 */
static void begin (enum form form, int sign, double *y, double *d)
{
  double t = 0, ud[N], lam[M];
  int info;
  andrews_acc_ (&t, start, none, cst, ud, lam, &info);
  for (int i = 0; i < N; i++)
    {
      y[i] = start[i];
      y[N + i] = start[N + i];
      d[i] = start[N + i];
      d[N + i] = ud[i];
    }
  if (form == ODE)
    return;
  for (int i = 0; i < M; i++)
    y[2 * N + i] = sign * lam[i];
}

static double processor (void)
{
  struct timespec t;
  clock_gettime (CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void ok (int flag, const char *what)
{
  if (flag < 0)
    {
      fprintf (stderr, "andrews_ida: %s: %d\n", what, flag);
      exit (1);
    }
}

int main (int argc, char **argv)
{
  static const char *names[] = { "ode", "index1", "index2", "ggl" };
  enum form form = ODE;
  double par[NPAR], rtol, tend, best = HUGE_VAL;
  int info, sign, repeats, order = 5, quiet, n;
  if (argc != 5 + 2 * N)
    return fprintf (stderr, "usage: andrews_ida FORM RTOL TEND REPEATS Q U\n"), 2;
  while (form < GGL && strncmp (argv[1], names[form], strlen (names[form])))
    form++;
  sscanf (argv[1] + strlen (names[form]), "%d", &order);
  quiet = argv[1][strlen (argv[1]) - 1] == 's';
  rtol = atof (argv[2]);
  tend = atof (argv[3]);
  repeats = atoi (argv[4]);
  for (int i = 0; i < 2 * N; i++)
    start[i] = atof (argv[5 + i]);
  andrews_par_ (par);
  if (BAUMGARTE >= 0)
    par[BAUMGARTE] = par[BAUMGARTE + 1] = 0;
  andrews_pre_ (par, cst, &info);
  ok (-info, "PRE");
  sign = emitted_sign ();
  ok (sign ? 0 : -1, "the loops of this program are not the emitted ones");
  n = form == ODE ? 2 * N : form == GGL ? 2 * N + 2 * M : 2 * N + M;

  SUNContext context;
  SUNContext_Create (NULL, &context);
  N_Vector y = N_VNew_Serial(n, context), d = N_VClone(y), r = N_VClone(y), atol = N_VClone(y),
           id = N_VClone(y);
  SUNMatrix J = SUNDenseMatrix (n, n, context);
  SUNLinearSolver solver = SUNLinSol_Dense (y, J, context);
  void *ida = IDACreate (context);
  for (int i = 0; i < n; i++)
    {
      N_VGetArrayPointer (atol)[i] = rtol * (i < N ? 1 : i < 2 * N + M ? 1e3 : 1e9);
      N_VGetArrayPointer (id)[i] = i < 2 * N;
    }
  N_VConst (0.1, y);
  N_VConst (0.2, d);
  for (int i = 0; i < 2 * N; i++)
    N_VGetArrayPointer (y)[i] = i < N ? start[i] + 0.01 * sin (i + 1) : cos (i);
  double wrong = wrong_jacobian (form, n, y, d, r, J);
  ok (wrong < 1e-6 ? 0 : -1, "the Jacobian is wrong");
  N_VConst (0, y);
  N_VConst (0, d);
  begin (form, sign, N_VGetArrayPointer (y), N_VGetArrayPointer (d));
  residual (0, y, d, r, &form);
  ok (N_VMaxNorm (r) < 1e-9 ? 0 : -1, "the start is not consistent");
  ok (IDAInit (ida, residual, 0, y, d), "IDAInit");
  ok (IDASVtolerances (ida, rtol, atol), "IDASVtolerances");
  ok (IDASetLinearSolver (ida, solver, J), "IDASetLinearSolver");
  ok (IDASetJacFn (ida, jacobian), "IDASetJacFn");
  ok (IDASetUserData (ida, &form), "IDASetUserData");
  ok (IDASetMaxNumSteps (ida, 1000000), "IDASetMaxNumSteps");
  ok (IDASetMaxOrd (ida, order), "IDASetMaxOrd");
  if (form != ODE)
    {
      ok (IDASetId (ida, id), "IDASetId");
      ok (IDASetSuppressAlg (ida, quiet), "IDASetSuppressAlg");
    }
  for (int k = 0; k < repeats; k++)
    {
      realtype t;
      N_VConst (0, y);
      N_VConst (0, d);
      begin (form, sign, N_VGetArrayPointer (y), N_VGetArrayPointer (d));
      double from = processor ();
      ok (IDAReInit (ida, 0, y, d), "IDAReInit");
      ok (IDASetInitStep (ida, 1e-6), "IDASetInitStep");
      ok (IDASetStopTime (ida, tend), "IDASetStopTime");
      ok (IDASolve (ida, tend, &t, y, d, IDA_NORMAL), "IDASolve");
      best = fmin (best, processor () - from);
    }
  long steps, residuals, jacobians, setups, fails, newton;
  IDAGetNumSteps (ida, &steps);
  IDAGetNumResEvals (ida, &residuals);
  IDAGetNumJacEvals (ida, &jacobians);
  IDAGetNumLinSolvSetups (ida, &setups);
  IDAGetNumErrTestFails (ida, &fails);
  IDAGetNumNonlinSolvConvFails (ida, &newton);
  printf ("%.9g %ld %ld %ld %ld %ld", best, steps, residuals, jacobians, fails, newton);
  for (int i = 0; i < 2 * N; i++)
    printf (" %.17g", N_VGetArrayPointer (y)[i]);
  puts ("");
  IDAFree (&ida);
  SUNLinSolFree (solver);
  SUNMatDestroy (J);
  return 0;
}

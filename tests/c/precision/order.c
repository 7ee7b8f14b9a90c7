/* What share/engine/core computes in quad precision against closed forms: the sines; a system with
 * a symmetric positive definite matrix; the integrators on y' = y cos t, z' = -2 t z^2, whose
 * orders hold down to errors that only coefficients good to 30 digits give. Prints ok or not ok. */
#include <stdio.h>

#include "gsmbp/integrate.h"
#include "gsmbp/sines.h"
#include "gsmbp/solve.h"

static void
told (const char *what, gs_real error, double most)
{
  printf ("%sok quad precision, C: %s: error %.1e, at most %.0e\n",
          (double)error <= most ? "" : "not ", what, (double)error, most);
}

/* sin 30 deg, cos 30 deg: 1/2, sqrt (3)/2, and far away, where the library reduces the angle */
static void
sines (void)
{
  const gs_real turn = 8 * gs_atan (1);
  gs_real s, c, off = 0;
  for (int k = -3; k <= 3; k++)
    {
      gs_sines (turn / 12 + (gs_real)k * turn, &s, &c);
      off = gs_fmax (off, gs_abs (s - GS_R (0.5)));
      off = gs_fmax (off, gs_abs (c - gs_sqrt (3) / 2));
    }
  told ("sines", off, 1e-31);
}

/* a(i,j) = min (i,j)/7, the solution i^2 + 1 */
static void
system_of_equations (void)
{
  enum { N = 12 };
  gs_real a[N * N], b[N] = { 0 }, off = 0;
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      {
        a[i + N * j] = (gs_real)(i < j ? i + 1 : j + 1) / 7;
        b[i] += a[i + N * j] * (gs_real)(j * j + 1);
      }
  int info = gs_solve_spd (N, 1, a, N, b, N);
  for (int i = 0; i < N; i++)
    off = gs_fmax (off, gs_abs (b[i] - (gs_real)(i * i + 1)));
  told ("gs_solve_spd", info == 0 ? off : 1, 1e-30);
}

static int
rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)v, (void)cst;
  xd[0] = x[0] * gs_cos (t);
  xd[1] = -2 * t * x[1] * x[1];
  return 0;
}

/* the error at t = 1 after n steps */
static gs_real
error_of (int method, int n)
{
  static const gs_scene scene = { .name = "order", .nq = 1, .nu = 1, .nx = 2, .rhs = rhs };
  gs_real atol[2] = { 1, 1 }, ropt[3] = { 0, 1, 0 }, w[2 * 13], wi[100], v[1] = { 0 };
  gs_real p[100] = { 0 };
  gs_real x[2] = { 1, 1 }, xn[2], err, rstat[20] = { 0 }, rp[1] = { 0 };
  int iopt[6] = { 0 }, ip[40] = { 0 }, istat[20] = { 0 }, info = 0;
  const gs_system g = { .s = &scene, .nx = 2, .iopt = iopt, .ropt = ropt, .atol = atol, .ip = ip,
                        .rp = rp, .cst = rp, .v = v, .w = wi, .p = p, .istat = istat,
                        .rstat = rstat };
  const gs_real h = 1 / (gs_real)n;
  for (int i = 0; i < n && info == 0; i++)
    {
      gs_real t = (gs_real)i * h;
      info = rhs (t, x, v, rp, w);
      if (method == 4)
        info = gs_step_rk4 (&g, t, t + h, 1, h, x, xn, w);
      else
        info = gs_step_dp853 (&g, t, t + h, 1, h, x, xn, &err, w);
      x[0] = xn[0];
      x[1] = xn[1];
    }
  return info == 0 ? gs_abs (x[0] - gs_exp (gs_sin (1))) + gs_abs (x[1] - GS_R (0.5)) : 1;
}

static void
order_of (int method)
{
  gs_real coarse = error_of (method, 256), fine = error_of (method, 512);
  gs_real order = gs_log (coarse / fine) / gs_log (2);
  char what[60];
  snprintf (what, sizeof what, "method %d, order %.3f", method, (double)order);
  told (what, gs_abs (order - (gs_real)method), 0.1);
  if (method == 8)
    told ("method 8, 512 steps", fine, 1e-24);
}

int
main (void)
{
  sines ();
  system_of_equations ();
  order_of (4);
  order_of (8);
  return 0;
}

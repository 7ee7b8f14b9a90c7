/* Runs of small scenes by GSSIM in Fortran and in C. */
#include "bridge.h"
#include "gsmbp/events.h"
#include "gsmbp/solve.h"

static test a;

/* what is to go wrong, and from when on */
static struct
{
  const char *what;
  gs_real from;
  int info, nth; /* nth > 0: from the nth call on instead */
} fault;

static int
fails (const char *what, gs_real t)
{
  if (! fault.what || strcmp (fault.what, what) != 0)
    return 0;
  const int now = fault.nth > 0 ? ++calls >= fault.nth : t >= fault.from;
  return now ? fault.info : 0;
}

static void
wrong (const char *what, gs_real from, int info)
{
  fault.what = what;
  fault.from = from;
  fault.info = info;
}

static void
compare_wrong (const char *what, int info, int which, int said)
{
  compare (&a, what, info);
  holds (a.run.istat[GS_FAILED] == which && a.run.istat[GS_FAILED_INFO] == said,
         "... for the reason that was given");
  fault.what = NULL;
}

/* ------------------------------------------------------------ a pendulum with a torque v */

static int
pendulum_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)cst;
  xd[0] = x[1];
  xd[1] = -9.81 * gs_sin (x[0]) - 0.1 * x[1] + v[0];
  if (fails ("nan", t))
    xd[1] = gs_sqrt (-1.0 - t * t);
  if (fails ("huge", t))
    xd[1] = 1e304;
  return fails ("rhs", t) + (x[0] > 0.5 ? 2 : x[0] < -0.5 ? 3 : 0);
}

static int
pendulum_out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  (void)v, (void)cst;
  y[0] = x[0];
  y[1] = x[1] + 0.01 * v[0];
  return fails ("out", t) ? fails ("out", t) : x[0] > 0.2 ? 2 : 0;
}

/* device 1 holds the reference, device 2 reads it, device 3 has a delay */
static void
pendulum_ctl (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  (void)cst;
  if (k == 1)
    v[1] = 0.3 * gs_sin (t);
  else if (k == 2)
    {
      xk[0] += 0.01 * (v[1] - y[0]);
      v[0] = 20 * (v[1] - y[0]) + xk[0] - 3 * y[1];
    }
  else
    {
      xk[1] = 0.5 * xk[1] + y[0];
      v[2] = xk[1] + t;
      v[3] = v[2] - y[1];
    }
}

static int
pendulum_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  const gs_real *amplitude = data;
  for (int i = 0; i < nv; i++)
    v[i] = *amplitude * (t > 1 || (t >= 1 && side >= 0) ? -1 : 1) * gs_cos (3 * t) - x[nx - 1];
  return fails ("vin", t);
}

static int
pendulum_cmd (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v,
              gs_real *xid)
{
  (void)cst;
  v[0] = qj[2] + 9.81 * gs_sin (qj[0]) + 0.1 * qj[1] + 0.01 * xi[0];
  xid[0] = 0;
  return fails ("cmd", t);
}

static gs_real amplitude = 2;
static const gs_scene pendulum = { .name = "pendulum", .nq = 1, .nu = 1, .nx = 2, .nv = 1, .ny = 2,
                                   .rhs = pendulum_rhs, .out = pendulum_out, .ctl = pendulum_ctl,
                                   .vin = pendulum_vin, .cmd = pendulum_cmd, .data = &amplitude };

static void
start_pendulum (gs_real tend, int nt)
{
  make (&a, &pendulum, NULL, tend, nt);
  a.x0[0] = 0.4;
  a.x0[1] = 4.0;
}

static void
tree (void)
{
  start_pendulum (5, 40);
  compare (&a, "pendulum, method 8", 0);
  start_pendulum (5, 40);
  a.rp[0] = 3;
  a.ropt[0] = 0.01;
  a.ropt[2] = 0.05;
  a.tout[0] = 0;
  compare (&a, "pendulum, method 8, a first and a largest step, an output at once", 0);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.ropt[0] = 0.01;
  compare (&a, "pendulum, method 4", 0);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.ropt[0] = 0.5;
  a.ropt[2] = 0.01;
  compare (&a, "pendulum, method 4, a largest step", 0);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 9;
  a.atol[0] = a.atol[1] = 0;
  compare (&a, "pendulum, method 9, no absolute tolerance", 0);
  start_pendulum (5, 40);
  a.atol[0] = a.atol[1] = 0;
  a.x0[0] = a.x0[1] = 0;
  a.rp[0] = 0.1;
  compare (&a, "pendulum, no absolute tolerance where all states are 0", 2);
}

static void
inputs (void)
{
  const gs_real brk[4] = { 0, 1, 2.5, 4 };
  const gs_real table[6] = { 1, -2, 0.5, 3, 0, 1 };
  start_pendulum (5, 40);
  a.ip[GS_V0] = 1;
  polynomial (&a, GS_TABLE, 1, 3, 2, brk, table);
  a.run.nb = 3;
  memcpy (a.tbrk, (gs_real[]){ 1, 2.5, 4 }, 3 * sizeof (gs_real));
  compare (&a, "a table with breaks", 0);

  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.ropt[0] = 0.02;
  a.ip[GS_V0] = 3;
  a.run.nb = 2;
  memcpy (a.tbrk, (gs_real[]){ 0, 1 }, 2 * sizeof (gs_real));
  compare (&a, "inputs of the user with breaks, method 4", 0);

  for (int limits = 0; limits <= 1; limits++)
    {
      const gs_real gain[8] = { 1, 0.1, 0, 2, 5, 1, -0.1, 0.3 }, x0[4] = { 0.1, 0.2, 0, 0.1 };
      const gs_real pieces[3] = { 0, 2, 5 }, whole[2] = { 0, 5 };
      start_pendulum (5, 40);
      a.ip[GS_V0] = 1;
      polynomial (&a, GS_TABLE, 1, 3, 2, brk, table);
      a.ip[GS_FEEDBACK] = 1;
      polynomial (&a, GS_REFERENCE, 2, 1, 2, whole, x0);
      polynomial (&a, GS_GAIN, 2, 2, 2, pieces, gain);
      if (limits)
        {
          a.ip[GS_LIMITS] = a.nrp + 1;
          a.rp[a.nrp++] = -2;
          a.rp[a.nrp++] = 1.5;
        }
      compare (&a, limits ? "feedback within limits" : "feedback", 0);
    }

  const gs_real motion[6] = { 0.05, 0.3, 0.1, 0.5, 0.4, 1.3 };
  start_pendulum (5, 40);
  a.ip[GS_V0] = 2;
  a.ip[GS_DERIVATIVES] = 2;
  a.ip[GS_PLANNED] = 1;
  a.ip[GS_NUMBERS] = 1;
  a.ip[GS_INTERNAL] = 2;
  polynomial (&a, GS_MOTION, 1, 2, 3, (gs_real[]){ 0, 2, 5 }, motion);
  compare (&a, "a planned motion", 0);
}

static void
sampled (void)
{
  static const gs_scene more = { .name = "sampled", .nq = 1, .nu = 1, .nx = 2, .nv = 4, .ny = 2,
                                 .rhs = pendulum_rhs, .out = pendulum_out, .ctl = pendulum_ctl };
  const gs_real period[3] = { 0.1, 0.05, 0.03 }, delay[3] = { 0, 0, 0.07 };
  const int held[3] = { 1, 1, 2 }, anew[3] = { 0, 1, 0 }, input[4] = { 2, 1, 3, 4 };
  for (int method = 4; method <= 8; method += 4)
    for (int np = 4; np >= 2; np -= 2)
      {
        make (&a, &more, NULL, 2, 30);
        a.x0[0] = 0.4;
        a.iopt[GS_METHOD] = method;
        a.ropt[0] = 0.01;
        samples (&a, 3, period, delay, held, anew, input, 2, (gs_real[]){ 0.1, 0.2 }, np, 50);
        if (np == 2)
          compare_wrong ("samples without enough places", 3, 6, -1);
        else
          compare (&a, method == 4 ? "samples, method 4" : "samples, method 8", 0);
      }
  make (&a, &more, NULL, 2, 30);
  samples (&a, 3, period, delay, held, anew, input, 2, (gs_real[]){ 0.1, 0.2 }, 4, 0);
  wrong ("out", 0.75, 7);
  compare_wrong ("samples, out fails", 3, 6, 7);
}

/* ------------------------------------------------------------ what goes wrong */

static int
stiff_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)v, (void)cst;
  xd[0] = -1e3 * (x[0] - gs_cos (t)) + x[1];
  xd[1] = -x[1];
  xd[2] = 700 * x[3];
  xd[3] = -700 * x[2] - 900 * x[3];
  return 0;
}

static void
stability (void)
{
  char what[60];
  static const gs_scene stiff = { .name = "stiff", .nx = 4, .rhs = stiff_rhs };
  for (int method = 4; method <= 9; method += method == 4 ? 4 : 1)
    {
      make (&a, &stiff, NULL, method == 4 ? 0.3 : 10, 2);
      a.iopt[GS_METHOD] = method;
      a.ropt[0] = method == 4 ? 3e-3 : 0;
      a.ropt[1] = 1e-5;
      a.x0[0] = 1;
      a.x0[2] = 1e-3;
      snprintf (what, sizeof what, "steps bound by stability, method %d", method);
      compare (&a, what, method == 9 ? 5 : 0);
      holds (a.run.istat[GS_IS_STIFF] == 1, "... are found");
    }
}

/* no step is good whose end is not finite: the run ends where that begins, in finite numbers */
static void
not_finite (const char *what, gs_real from, const char *said, int info)
{
  start_pendulum (5, 40);
  wrong (what, from, 1);
  compare (&a, said, info);
  const gs_real *last = a.xout + a.run.ldx * a.run.istat[4];
  holds (gs_abs (a.run.rstat[GS_T_REACHED] - from) <= 1e-9 && gs_abs (last[0]) <= 1e3
         && gs_abs (last[1]) <= 1e3, "... where that begins, with the last finite state");
}

static void
faults (void)
{
  start_pendulum (5, 40);
  a.iopt[GS_MOST_STEPS] = 20;
  compare (&a, "too many steps", 1);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.iopt[GS_MOST_STEPS] = 50;
  a.ropt[0] = 0.01;
  compare (&a, "too many steps, method 4", 1);
  not_finite ("nan", 1.23, "no rate from some time on", 8);
  not_finite ("huge", 1.23, "a rate of 1e304 from some time on", 2);
  fault.what = "nan";
  fault.from = 0;
  start_pendulum (5, 40);
  compare (&a, "no rate at the start", 8);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.ropt[0] = 0.1;
  if (! QUAD)
    compare (&a, "no rate, method 4", 4);
  wrong ("huge", 1, 1);
  start_pendulum (5, 40);
  a.iopt[GS_METHOD] = 4;
  a.ropt[0] = 0.1;
  compare (&a, "an infinite state, method 4", 4);
  for (int method = 4; method <= 8; method += 4)
    for (int late = 0; late <= 1; late++)
      {
        start_pendulum (5, 40);
        a.iopt[GS_METHOD] = method;
        a.ropt[0] = 0.1;
        wrong ("rhs", 1.3 * late, 20);
        a.x0[0] = 0;
        compare (&a, "rhs fails", 3);
        start_pendulum (5, 40);
        a.iopt[GS_METHOD] = method;
        a.ropt[0] = 0.1;
        a.ip[GS_V0] = 3;
        wrong ("vin", 1.3 * late, 9);
        compare_wrong ("vin fails", 3, 1, 9);
      }
}

static void
arguments (void)
{
  static const gs_scene bad = { .name = "bad", .nq = -1, .nu = -1, .nx = 2, .nv = -1, .nlam = -1,
                                .rhs = pendulum_rhs };
  enum { T0, TOUT, TBRK, METHOD, WAY, STEP, ATOL };
  static const struct { int info, what; gs_real value; } given[]
    = { { -103, 0, 1 }, { -105, 0, 0 }, { -106, 0, 0 }, { -107, 0, -1 }, { -108, 0, 9 },
        { -13, T0, NAN }, { -14, 0, INFINITY }, { -13, TOUT, NAN }, { -13, TOUT, -1 },
        { -13, TOUT, 7 }, { -13, TBRK, NAN }, { -13, TBRK, 3 }, { -15, METHOD, 7 },
        { -15, WAY, 0 }, { -16, STEP, -1 }, { -16, STEP, 0 }, { -16, STEP, 1e-10 },
        { -16, ATOL, -1 } };
  for (int i = 0; i < (int)(sizeof given / sizeof *given); i++)
    {
      const gs_real value = given[i].value;
      start_pendulum (5, 3);
      a.run.nb = 2;
      a.tbrk[1] = 2;
      switch (given[i].info)
        {
        case -103: a.run.nx = 1; break;
        case -105: a.s = &bad; break;
        case -106: a.run.nt = 0; break;
        case -107: a.run.nb = -1; break;
        case -108: a.run.lw = (int)value; break;
        case -13: *(given[i].what == T0 ? &a.run.t0 : given[i].what == TBRK ? a.tbrk
                    : a.tout + (value > 0)) = value; break;
        case -14: a.x0[1] = value; break;
        case -15: a.iopt[given[i].what == WAY] = (int)value; break;
        default:
          *(given[i].what == ATOL ? a.atol + 1 : a.ropt) = value;
          if (value >= 0)
            a.iopt[GS_METHOD] = 4;
        }
      a.run.lw = a.run.lw ? a.run.lw : 3000;
      compare (&a, "an argument out of range", given[i].info);
    }
  start_pendulum (5, 3); /* what the Fortran does not have */
  a.run.lw = 3000;
  a.run.ldx = 1;
  holds (gs_integrate (a.s, &a.run) == -109, "ldx out of range");
  a.run.ldx = a.run.nx;
  a.run.ldv = 0;
  holds (gs_integrate (a.s, &a.run) == -110, "ldv out of range");
}

/* ------------------------------------------------------------ a point on a circle, in Cartesian
 * coordinates, whose centre moves sideways by cst[1]*sin(3*t); cst[0]: the way of the loops */

static int
point_con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
           gs_real *phit, gs_real *hc, int ldh, gs_real *gam)
{
  const gs_real x = q[0] - cst[1] * gs_sin (3 * t), xt = -3 * cst[1] * gs_cos (3 * t),
               xtt = 9 * cst[1] * gs_sin (3 * t);
  phi[0] = x * x + q[1] * q[1] - 1;
  phit[0] = 2 * x * xt;
  hc[0] = 2 * x;
  hc[ldh] = 2 * q[1];
  gam[0] = -2 * ((u[0] + xt) * (u[0] + xt) + u[1] * u[1] + x * xtt);
  return fails ("con", t);
}

static void
same_rates (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  (void)t, (void)q, (void)cst;
  qdot[0] = u[0];
  qdot[1] = u[1];
}

static int
point_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  const gs_real m[4] = { 2, 0, 0, 2 }, f[2] = { v[0], -2 * 9.81 };
  gs_real phi, phit, h[2], gam, lam, w[200];
  point_con (t, x, x + 2, cst, &phi, &phit, h, 1, &gam);
  if (cst[0] == 1)
    gam -= 20 * (h[0] * x[2] + h[1] * x[3] + phit) + 100 * phi;
  xd[0] = x[2];
  xd[1] = x[3];
  return gs_solve_kkt (2, 1, m, 2, h, 1, f, &gam, xd + 2, &lam, w);
}

static int
point_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  gs_real phi = 0, phit, h[2], gam;
  if (fails ("prj", t))
    return fails ("prj", t);
  for (int k = 0; k < 10; k++)
    {
      point_con (t, x, x + 2, cst, &phi, &phit, h, 1, &gam);
      if (k == 0)
        *res = phi;
      const gs_real s = phi / (h[0] * h[0] + h[1] * h[1]);
      x[0] -= s * h[0];
      x[1] -= s * h[1];
      if (gs_abs (phi) < 1e-14)
        break;
    }
  point_con (t, x, x + 2, cst, &phi, &phit, h, 1, &gam);
  const gs_real s = (h[0] * x[2] + h[1] * x[3] + phit) / (h[0] * h[0] + h[1] * h[1]);
  x[2] -= s * h[0];
  x[3] -= s * h[1];
  return 0;
}

static const gs_scene point = { .name = "point", .nq = 2, .nu = 2, .nx = 4, .nv = 1, .nlam = 1,
                                .rhs = point_rhs, .prj = point_prj, .con = point_con,
                                .kin = same_rates, .vin = pendulum_vin, .data = &amplitude };

static void
start_point (int way, int method, gs_real moves, gs_real tend, int nt)
{
  make (&a, &point, NULL, tend, nt);
  a.iopt[GS_METHOD] = method;
  a.iopt[GS_LOOPS] = way;
  a.ropt[0] = method == 4 ? 0.01 : 0;
  a.cst[0] = way;
  a.cst[1] = moves;
  a.x0[0] = 1;
  a.x0[3] = 0.5;
  a.x0[2] = 3 * moves;
}

static void
loop (void)
{
  char what[80];
  for (int method = 4; method <= 8; method += 4)
    for (int way = 1; way <= 6; way++)
      for (int moves = 0; moves <= 1; moves++)
        {
          start_point (way, method, 0.2 * moves, 3, 25);
          if (moves)
            a.ip[GS_V0] = 3;
          snprintf (what, sizeof what, "a loop, method %d, way %d, the constraint %s", method, way,
                    moves ? "moves" : "rests");
          compare (&a, what, 0);
        }
  start_point (2, 8, 0.2, 3, 25);
  a.iopt[GS_DRIFT] = a.iopt[GS_WATCH] = 0;
  compare (&a, "a loop, drift is not recorded", 0);
  static const struct { const char *what; int way, which; } parts[]
    = { { "prj", 2, 3 }, { "con", 3, 5 }, { "con", 2, 4 }, { "con", 6, 5 } };
  for (int i = 0; i < 4; i++)
    for (int method = 4; method <= 8; method += 4)
      {
        start_point (parts[i].way, method, 0.2, 3, 25);
        wrong (parts[i].what, 1.3, 20);
        compare (&a, "a loop, a routine fails", 3);
        start_point (parts[i].way, method, 0.2, 3, 25);
        fault.from = 0;
        compare (&a, "a loop, a routine fails at the start", 3);
        fault.what = NULL;
      }
}

/* ------------------------------------------------------------ Euler parameters, a sleigh */

static void
body_kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  (void)t, (void)cst;
  qdot[0] = 0.5 * (-q[1] * u[0] - q[2] * u[1] - q[3] * u[2]);
  qdot[1] = 0.5 * (q[0] * u[0] - q[3] * u[1] + q[2] * u[2]);
  qdot[2] = 0.5 * (q[3] * u[0] + q[0] * u[1] - q[1] * u[2]);
  qdot[3] = 0.5 * (-q[2] * u[0] + q[1] * u[1] + q[0] * u[2]);
}

static int
body_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  const gs_real *u = x + 4;
  (void)v;
  body_kin (t, x, u, cst, xd);
  xd[4] = (2 - 3) * u[1] * u[2] / 1.0;
  xd[5] = (3 - 1) * u[2] * u[0] / 2.0;
  xd[6] = (1 - 2) * u[0] * u[1] / 3.0;
  return 0;
}

static int
body_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  const gs_real s = gs_sqrt (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
  (void)t, (void)cst;
  *res = s - 1;
  for (int i = 0; i < 4; i++)
    x[i] /= s;
  return 0;
}

static int
sleigh_con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
            gs_real *phit, gs_real *hc, int ldh, gs_real *gam)
{
  (void)t, (void)cst;
  phi[0] = phit[0] = 0;
  hc[0] = -gs_sin (q[2]);
  hc[ldh] = gs_cos (q[2]);
  hc[2 * ldh] = -0.3;
  gam[0] = (gs_cos (q[2]) * u[0] + gs_sin (q[2]) * u[1]) * u[2];
  return 0;
}

static void
sleigh_kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  (void)t, (void)q, (void)cst;
  memcpy (qdot, u, 3 * sizeof (gs_real));
}

static int
sleigh_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  const gs_real m[9] = { 2, 0, 0, 0, 2, 0, 0, 0, 0.5 }, f[3] = { v[0] * gs_cos (x[2]), 0, 0.2 };
  gs_real phi, phit, h[3], gam, lam, w[300];
  sleigh_con (t, x, x + 3, cst, &phi, &phit, h, 1, &gam);
  memcpy (xd, x + 3, 3 * sizeof (gs_real));
  return gs_solve_kkt (3, 1, m, 3, h, 1, f, &gam, xd + 3, &lam, w);
}

static int
sleigh_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  gs_real phi, phit, h[3], gam;
  sleigh_con (t, x, x + 3, cst, &phi, &phit, h, 1, &gam);
  const gs_real s = (h[0] * x[3] + h[1] * x[4] + h[2] * x[5]) / (1 + 0.09);
  for (int i = 0; i < 3; i++)
    x[3 + i] -= s * h[i];
  *res = 0;
  return 0;
}

static void
other_states (void)
{
  static const gs_scene body = { .name = "body", .nq = 4, .nu = 3, .nx = 7, .rhs = body_rhs,
                                 .prj = body_prj, .kin = body_kin };
  static const gs_scene sleigh = { .name = "sleigh", .nq = 3, .nu = 3, .nx = 6, .nv = 1, .nlam = 1,
                                   .rhs = sleigh_rhs, .prj = sleigh_prj, .con = sleigh_con,
                                   .kin = sleigh_kin };
  for (int method = 4; method <= 8; method += 4)
    {
      make (&a, &body, NULL, 5, 30);
      a.iopt[GS_METHOD] = method;
      a.ropt[0] = 0.01;
      memcpy (a.x0, (gs_real[]){ 1, 0.1, 0, 0, 0.1, 3, 0.2 }, 7 * sizeof (gs_real));
      compare (&a, "a body with Euler parameters", 0);
      for (int way = 1; way <= 6; way++)
        {
          make (&a, &sleigh, NULL, 5, 30);
          a.iopt[GS_METHOD] = method;
          a.iopt[GS_LOOPS] = way;
          a.iopt[GS_ON_SPEEDS] = 1;
          a.iopt[GS_ON_SPEEDS + 1] = 1;
          a.ropt[0] = 0.01;
          a.rp[0] = 1;
          a.x0[5] = 1;
          compare (&a, "a sleigh, its constraint is on speeds alone", 0);
        }
    }
}

/* ------------------------------------------------------------ a parallelogram: angles of crank,
 * coupler and rocker; v a torque at the crank; cst[0]: the way of the loops; [1]: gravity; [2]:
 * how much longer the ground is than the coupler; nlam = 3: the first constraint again */

static const gs_real r = 0.2, d = 0.3;

static int
bars_con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
          gs_real *phit, gs_real *hc, int ldh, gs_real *gam)
{
  for (int k = 0; k < bridged->nlam; k++)
    {
      const int y = k == 1;
      const gs_real f[3] = { y ? gs_sin (q[0]) : gs_cos (q[0]), y ? gs_sin (q[1]) : gs_cos (q[1]),
                            y ? gs_sin (q[2]) : gs_cos (q[2]) };
      const gs_real g[3] = { y ? gs_cos (q[0]) : -gs_sin (q[0]), y ? gs_cos (q[1]) : -gs_sin (q[1]),
                            y ? gs_cos (q[2]) : -gs_sin (q[2]) };
      phi[k] = r * f[0] + d * f[1] - r * f[2] - (y ? 0 : d + cst[2]);
      phit[k] = 0;
      hc[k] = r * g[0];
      hc[k + ldh] = d * g[1];
      hc[k + 2 * ldh] = -r * g[2];
      gam[k] = r * f[0] * u[0] * u[0] + d * f[1] * u[1] * u[1] - r * f[2] * u[2] * u[2];
    }
  return fails ("con", t);
}

static void
bars_matrix (const gs_real *q, gs_real *m)
{
  const gs_real c = 2 * r * d / 2 * gs_cos (q[0] - q[1]);
  memset (m, 0, 9 * sizeof (gs_real));
  m[0] = 0.014 + 2 * r * r;
  m[1] = m[3] = c;
  m[4] = 0.01 + 2 * d * d / 4;
  m[8] = 0.014;
}

static int
bars_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  const gs_real s = 2 * r * d / 2 * gs_sin (x[0] - x[1]), g = cst[1];
  gs_real m[9], phi[3], phit[3], h[9], gam[3], lam[3], f[3], w[600];
  const int nlam = bridged->nlam;
  bars_con (t, x, x + 3, cst, phi, phit, h, nlam, gam);
  bars_matrix (x, m);
  f[0] = -s * x[4] * x[4] - g * 2.5 * r * gs_cos (x[0]) + v[0];
  f[1] = s * x[3] * x[3] - g * d * gs_cos (x[1]);
  f[2] = -g * 0.5 * r * gs_cos (x[2]);
  memcpy (xd, x + 3, 3 * sizeof (gs_real));
  for (int k = 0; k < nlam && cst[0] == 1; k++)
    gam[k] -= 20 * (h[k] * x[3] + h[k + nlam] * x[4] + h[k + 2 * nlam] * x[5]) + 100 * phi[k];
  if (fails ("rhs", t))
    return fails ("rhs", t);
  return gs_solve_accelerations (cst[0] > 3 ? (int)cst[0] - 2 : 1, 3, nlam, m, 3, h, nlam, f, gam,
                                 xd + 3, lam, w);
}

/* the least change of coordinates, then of speeds */
static int
bars_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  const gs_real one[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, zero[3] = { 0 };
  gs_real phi[3], phit[3], h[9], gam[3], lam[3], dx[3], b[3], w[600];
  const int nlam = bridged->nlam;
  *res = 0;
  if (fails ("prj", t))
    return fails ("prj", t);
  for (int k = 0; k < 12; k++)
    {
      gs_real most = 0;
      bars_con (t, x, x + 3, cst, phi, phit, h, nlam, gam);
      for (int i = 0; i < nlam; i++)
        {
          b[i] = -phi[i];
          most = gs_fmax (most, gs_abs (phi[i]));
        }
      if (k == 0)
        *res = most;
      if (gs_solve_kkt (3, nlam, one, 3, h, nlam, zero, b, dx, lam, w) == 1)
        return 1;
      for (int i = 0; i < 3; i++)
        x[i] += dx[i];
      if (most < 1e-15)
        break;
    }
  bars_con (t, x, x + 3, cst, phi, phit, h, nlam, gam);
  for (int k = 0; k < nlam; k++)
    b[k] = -(h[k] * x[3] + h[k + nlam] * x[4] + h[k + 2 * nlam] * x[5]);
  gs_solve_kkt (3, nlam, one, 3, h, nlam, zero, b, dx, lam, w);
  for (int i = 0; i < 3; i++)
    x[3 + i] += dx[i];
  return 0;
}

static int
bars_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  const int behind = t > 1.07 || (t >= 1.07 && side >= 0), info = fails ("vin", t);
  (void)x, (void)nx, (void)nv, (void)data;
  v[0] = behind ? 0.2 : 0.05 * gs_sin (3 * t);
  return info;
}

/* the rocker of a planned crank */
static int
bars_clo (gs_real t, gs_real *qj, const gs_real *cst, gs_real *res)
{
  gs_real x[6] = { qj[0], qj[1], qj[2], 0, 0, 0 };
  (void)t, (void)cst;
  for (int k = 0; k < 30; k++)
    {
      gs_real phi[3], phit[3], h[9], gam[3];
      bars_con (0, x, x + 3, cst, phi, phit, h, 3, gam);
      const gs_real det = h[3] * h[7] - h[4] * h[6];
      x[1] -= (phi[0] * h[7] - phi[1] * h[6]) / det;
      x[2] -= (h[3] * phi[1] - h[4] * phi[0]) / det;
      *res = gs_fmax (gs_abs (phi[0]), gs_abs (phi[1]));
      if (*res < 1e-15)
        {
          qj[1] = x[1];
          qj[2] = x[2];
          qj[4] = -(qj[3] * (h[0] * h[7] - h[1] * h[6])) / det;
          qj[5] = -(qj[3] * (h[3] * h[1] - h[4] * h[0])) / det;
          return 0;
        }
    }
  return 3;
}

static int
bars_cmd (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v,
          gs_real *xid)
{
  (void)t, (void)xi, (void)cst, (void)xid;
  v[0] = 0.1 * qj[3] + 0.05 * gs_cos (qj[1]) + 0.01 * qj[2];
  return 0;
}

#define BARS .nq = 3, .nu = 3, .nx = 6, .nv = 1, .rhs = bars_rhs, .prj = bars_prj, .con = bars_con,\
             .kin = sleigh_kin, .vin = bars_vin, .cmd = bars_cmd, .clo = bars_clo
static const gs_scene bars = { .name = "bars", .nlam = 2, BARS };
static const gs_scene redundant = { .name = "redundant", .nlam = 3, BARS };

static void
start_bars (const gs_scene *s, int way, int method, gs_real angle, gs_real tend, int nt)
{
  bridged = s;
  make (&a, s, NULL, tend, nt);
  a.iopt[GS_METHOD] = method;
  a.iopt[GS_LOOPS] = way;
  a.ropt[0] = method == 4 ? 0.01 : 0;
  a.cst[0] = way;
  a.x0[0] = a.x0[2] = angle;
  a.x0[3] = a.x0[5] = 3;
}

static void
singular (void)
{
  char what[90];
  for (int method = 4; method <= 8; method += 4)
    for (int way = 1; way <= 6; way++)
      for (int kind = 0; kind < 2; kind++)
        {
          start_bars (kind ? &redundant : &bars, way, method, 0.4, 3, 60);
          a.cst[1] = 2.5;
          if (kind)
            a.tout[0] = 0;
          snprintf (what, sizeof what, "a parallelogram%s, method %d, way %d",
                    kind ? " with a constraint twice" : "", method, way);
          compare (&a, what, 0);
          if (method == 8 && way > 1)
            holds (a.run.istat[GS_N_PASSED] > 0, "... passes singular positions");
        }
  for (int way = 2; way <= 3; way++)
    {
      start_bars (&bars, way, 8, 0.4, 3, 60);
      a.ip[GS_V0] = 3;
      a.run.nb = 2;
      a.tbrk[0] = 0.9;
      a.tbrk[1] = 1.07;
      compare (&a, "a parallelogram, breaks close to a singular position", 0);
    }
  for (int way = 2; way <= 6; way++)
    for (int k = 2; k <= 7; k++)
      {
        start_bars (&bars, way, 8, 0.4, 3, 60);
        a.cst[2] = (k % 2 ? -1 : 1) * gs_pow (10, -k);
        a.ropt[1] = way == 4 ? 1e-10 : 1e-8;
        bars_prj (0, a.x0, a.cst, a.xout);
        snprintf (what, sizeof what, "almost a parallelogram, %.0e, way %d", (double)a.cst[2], way);
        compare (&a, what, way == 4 && k >= 6 ? 2 : 0); /* rounding errors above the tolerance */
      }
  start_bars (&bars, 3, 8, 0.4, 3, 60);
  a.cst[2] = 1e-6;
  a.ropt[1] = 1e-12;
  compare (&a, "almost a parallelogram, the step becomes too small", 2);
  start_bars (&bars, 3, 8, 0.4, 3, 60);
  for (int i = 0; i < 6; i++)
    a.atol[i] = 1e-16;
  a.ropt[1] = 1e-14;
  compare (&a, "a parallelogram, a fine tolerance", 0);
  start_bars (&bars, 2, 8, 0.4, 3, 60);
  wrong ("prj", 1, 20);
  compare_wrong ("a parallelogram, prj fails behind a singular position", 3, 3, 20);
}

static void
starts (void)
{
  start_bars (&bars, 2, 8, 0, 2, 30);
  compare (&a, "a start in a singular position", 0);
  start_bars (&bars, 3, 8, 1e-6, 2, 30);
  a.cst[1] = 9.81;
  compare (&a, "a start very close to one", 0);
  start_bars (&bars, 2, 4, 0, 2, 30);
  compare_wrong ("a start in one, method 4", 3, 8, 1);
  start_bars (&bars, 2, 8, 0, 2, 30);
  a.cst[1] = 9.81;
  memset (a.x0 + 3, 0, 3 * sizeof (gs_real));
  compare_wrong ("a start at rest in one", 3, 8, 2);
  start_bars (&bars, 2, 8, 0, 2, 30);
  a.x0[3] = 4;
  a.x0[4] = -0.2;
  a.x0[5] = 3.7;
  compare_wrong ("a start with speeds that do not lead out of one", 3, 8, 3);
}

static void
closed_plan (void)
{
  const gs_real motion[8] = { 0.3, 0.1, 0.2, 0.4, 0.5, 0.7, 0.8, 1.1375 };
  for (int method = 4; method <= 8; method += 4)
    {
      start_bars (&bars, 3, method, 0.8, 1.2, 20);
      a.ip[GS_V0] = 2;
      a.ip[GS_CLOSED] = 1;
      a.ip[GS_DERIVATIVES] = 2;
      a.ip[GS_PLANNED] = 1;
      a.ip[GS_NUMBERS] = 1;
      a.w[1] = 0.1;
      a.w[2] = 0.7;
      polynomial (&a, GS_MOTION, 1, 2, 4, (gs_real[]){ 0, 0.5, 1.2 }, motion);
      a.run.nb = 1;
      a.tbrk[0] = 0.5;
      compare (&a, "a planned motion of a closed chain", 0);
    }
  a.rp[a.ip[GS_MOTION + 3] - 1 + 7] = 2.5; /* a jump */
  compare (&a, "a planned motion that the chain cannot follow", 3);
}

/* ------------------------------------------------------------ two blocks with friction, a spring
 * between them; the first has a stop; the second is shaken. v: three modes */

static const int kind[3] = { 1, 1, 2 };

static void
blocks_ports (gs_real t, const gs_real *x, const int *mode, gs_real *s, gs_real *sd, gs_real *prm,
              gs_real *hold, gs_real *ud)
{
  const gs_real m[4] = { 1, 0, 0, 2 }, fc[2] = { 2, 1.5 };
  const gs_real spring = 30 * (x[1] - x[0] - 1), push = 8 * gs_sin (7 * t) + 3 * gs_sin (2 * t);
  gs_real f[2] = { spring - fc[0] * mode[0], push - spring - fc[1] * mode[1] };
  gs_real lam[1], g[3] = { 0 };
  gs_real h[6] = { 1, 0, 1, 0, 1, 0 }, w[400];
  int act[3] = { mode[0] == 0, mode[1] == 0, mode[2] != 0 };
  s[0] = s[2] = x[0];
  s[1] = x[1];
  sd[0] = sd[2] = x[2];
  sd[1] = x[3];
  memcpy (prm, (gs_real[]){ 2.2, 0.05, 0, 0, 1.5, 0.05, 0, 0, -0.3, 0.25, 0.6, 0.02 },
          12 * sizeof (gs_real));
  gs_port_holding (2, 0, 3, m, 2, h, 3, f, g, act, ud, lam, hold, w);
}

static void
modes_of (const gs_real *v, int *mode)
{
  for (int i = 0; i < 3; i++)
    mode[i] = (int)gs_lround (v[i]);
}

static int
blocks_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  gs_real s[3], sd[3], prm[12], hold[3];
  int mode[3];
  (void)cst;
  modes_of (v, mode);
  xd[0] = x[2];
  xd[1] = x[3];
  blocks_ports (t, x, mode, s, sd, prm, hold, xd + 2);
  return fails ("rhs", t);
}

static void
blocks_evt (gs_real t, const gs_real *x, const gs_real *v, const int *mode, const gs_real *cst,
            gs_real *gv)
{
  gs_real s[3], sd[3], prm[12], hold[3], ud[2];
  (void)v, (void)cst;
  blocks_ports (t, x, mode, s, sd, prm, hold, ud);
  gs_port_functions (3, kind, mode, s, sd, prm, hold, gv);
  if (fails ("evt", t))
    gv[0] = -1;
}

static int
blocks_rst (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst)
{
  const gs_real m[4] = { 1, 0, 0, 2 }, h[6] = { 1, 0, 1, 0, 1, 0 };
  gs_real s[3], sd[3], prm[12], hold[3], ud[2], w[400];
  (void)cst;
  if (k == -3)
    return fails ("rst", t);
  blocks_ports (t, x, mode, s, sd, prm, hold, ud);
  int info = gs_port_reset (2, 0, 3, k, kind, mode, s, sd, prm, hold, m, 2, h, 3, NULL, x + 2, w);
  if (fails ("evt", t))
    mode[0] = 0;
  for (int i = 0; i < 3; i++)
    v[i] = mode[i];
  return info ? info : fails ("rst", t);
}

/* the modes stand in its place; it may fail where steps of 0.01 look for events, but no stage is */
static int
blocks_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  const gs_real past = gs_fmod (t, 0.01);
  (void)side, (void)x, (void)nx, (void)data;
  memset (v, 0, nv * sizeof (gs_real));
  return fault.nth > 0 || (past > 6e-4 && past < 8e-4) ? fails ("vin", t) : 0;
}

static const gs_scene blocks = { .name = "blocks", .nq = 2, .nu = 2, .nx = 4, .nv = 3,
                                 .rhs = blocks_rhs, .evt = blocks_evt, .rst = blocks_rst,
                                 .vin = blocks_vin };

static void
start_blocks (int method)
{
  make (&a, &blocks, NULL, 8, 80);
  a.iopt[GS_METHOD] = method;
  a.ropt[0] = method == 4 ? 0.01 : 0;
  a.x0[1] = 1.2;
  a.x0[2] = 0.5;
  events (&a, 3, kind, (int[]){ 1, 2, 3 }, 300);
}

static void
friction_and_stops (void)
{
  for (int method = 4; method <= 8; method += 4)
    {
      start_blocks (method);
      compare (&a, method == 4 ? "events, method 4" : "events, method 8", 0);
      holds (a.ip[a.ip[GS_EVENTS] + 1] > 20, "... more than 20");
      start_blocks (method);
      a.ip[a.ip[GS_EVENTS]] = 5;
      compare (&a, "events, five are recorded", 0);
      start_blocks (method);
      a.ip[a.ip[GS_EVENTS] + 3] = 1;
      memcpy (a.ip + a.ip[GS_EVENTS] + 9, (int[]){ 1, 0, 0 }, 3 * sizeof (int));
      compare (&a, "events, modes given at the start", 0);
      start_blocks (method);
      wrong ("rst", 1.2, 8);
      compare_wrong ("events, rst fails", 3, 7, 8);
      start_blocks (method);
      wrong ("rhs", 1.2, 8);
      compare_wrong ("events, rhs fails", 3, 2, 8);
      start_blocks (method);
      wrong ("vin", 1.2, 9);
      a.ip[GS_V0] = 3;
      compare_wrong ("events, vin fails", 3, 1, 9);
      start_blocks (method);
      wrong ("evt", 1.2, 1);
      compare_wrong ("events without end at one instant", 3, 7, 9);
    }
}

/* ------------------------------------------------------------ every call may be the first that
 * fails */

static void
start_kind (int k)
{
  if (k < 2)
    start_blocks (k == 0 ? 4 : 8);
  else if (k < 4)
    start_bars (&bars, k, 8, 0.4, 1.5, 15);
  else if (k == 4)
    start_bars (&bars, 2, 8, 0, 1, 5);
  else
    start_pendulum (1, 5);
  a.ip[GS_V0] = 3;
  if (k >= 2 && k < 5)
    {
      a.run.nb = 1;
      a.tbrk[0] = 0.95;
    }
}

static void
every_call (void)
{
  static const char *const routine[] = { "vin", "rhs", "con", "prj", "rst" };
  for (int r = 0; r < 5; r++)
    {
      char what[60];
      snprintf (what, sizeof what, "%s fails from any call on", routine[r]);
      begin (what);
      for (int k = 0; k < 6; k++)
        for (int n = 1; n < 3000; n += 1 + n / 30)
          {
            start_kind (k);
            a.run.nt = a.run.nt > 15 ? 15 : a.run.nt;
            fault.what = routine[r];
            fault.nth = n;
            fault.info = 9;
            compare_silently (&a);
            if (a.info != 3 && a.info != 2)
              break;
          }
      finish ();
    }
  memset (&fault, 0, sizeof fault);
}

int
main (void)
{
  tree ();
  inputs ();
  sampled ();
  stability ();
  faults ();
  arguments ();
  loop ();
  other_states ();
  singular ();
  starts ();
  closed_plan ();
  friction_and_stops ();
  every_call ();
  return 0;
}

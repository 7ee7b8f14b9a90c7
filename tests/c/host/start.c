/* start.c: share/engine/host/start.h on a particle on a circle: coordinates x, y, their rates u, w,
 * a filter f that follows x, a stop and a margin on y, sampled devices. All values are closed
 * forms. A line for each check; cst[0] = 1: PRJ moves along the circle, too; 2: and its INFO is
 * 3. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/start.h"

#define RADIUS 2

static void
check (const char *what, int true_)
{
  printf ("%sok %s\n", true_ ? "" : "not ", what);
}

static void
says (const char *what, const char *found, const char *wanted)
{
  const int same = strcmp (found, wanted) == 0;
  printf ("%sok %s%s%s\n", same ? "" : "not ", what, same ? "" : ": found ", same ? "" : found);
}

static int
rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  (void)t, (void)v, (void)cst;
  xd[0] = x[2];
  xd[1] = x[3];
  xd[2] = xd[3] = 0;
  xd[4] = 10 * (x[0] - x[4]);
  return 0;
}

static int
con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi, gs_real *phit,
     gs_real *hc, int ldh, gs_real *gam)
{
  (void)t, (void)cst;
  phi[0] = (q[0] * q[0] + q[1] * q[1] - RADIUS * RADIUS) / 2;
  phit[0] = 0;
  hc[0] = q[0];
  hc[ldh] = q[1];
  gam[0] = -u[0] * u[0] - u[1] * u[1];
  return 0;
}

static int
prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  (void)t;
  const gs_real r = gs_sqrt (x[0] * x[0] + x[1] * x[1]), turn = cst[0] / 100;
  const gs_real c = x[0] / r, s = x[1] / r, along = c * x[3] - s * x[2];
  *res = 0;
  if (r < GS_R (0.1))
    return 1;
  x[0] = RADIUS * (c * gs_cos (turn) - s * gs_sin (turn));
  x[1] = RADIUS * (s * gs_cos (turn) + c * gs_sin (turn));
  x[2] = -x[1] / RADIUS * along;
  x[3] = x[0] / RADIUS * along;
  return cst[0] > 1 ? 3 : 0;
}

static void
mar (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *g, gs_real *size)
{
  (void)t, (void)v, (void)cst;
  g[0] = GS_R (1.5) - x[1];
  size[0] = GS_R (1.5);
}

static void
hld (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *row, int ldr,
     gs_real *s, gs_real *sd, gs_real *prm)
{
  (void)t, (void)v, (void)cst;
  row[0] = 0;
  row[ldr] = 1;
  s[0] = x[1];
  sd[0] = x[3];
  prm[0] = -(prm[1] = GS_R (1.9));
  prm[2] = prm[3] = 0;
}

static const char *
meaning (const char *routine, int info)
{
  return strcmp (routine, "prj") == 0 && info == 1 ? "too near to the centre" : 0;
}

static const int kinds[] = { 2 }, settled[] = { 4 }, angles[] = { 0, 1 },
                 margin_values[] = { 1, 1, 1, 0 };
static const double nominal[] = { 1, 1, 1, 1, 1 };
static const char *const states[] = { "x", "y", "u", "w", "f" }, *const names[] = { "C" },
                  *const walls[] = { "wall" }, *const high[] = { "too high" },
                  *const limits[] = { "limit" };
static const gs_scene scene = { .name = "circle", .nq = 2, .nu = 2, .nx = 5, .nlam = 1, .rhs = rhs,
                                .prj = prj, .con = con, .hld = hld, .nev = 1,
                                .event_kinds = kinds };
static const gs_description circle = {
  .scene = &scene, .mar = mar, .nmargins = 1, .nominal = nominal, .nsettled = 1, .settled = settled,
  .angles = angles, .states = states, .constraints = names, .events = walls, .margins = high,
  .parameters = limits, .margin_values = margin_values, .meaning = meaning
};

/* the verdict on a start from there */
static int
from (int checks, double x, double y, double u, double turn, const int *modes, gs_real *z,
      gs_start *s)
{
  static gs_real cst[1];
  static const double par[] = { 1.5 };
  const gs_start_given g = { .t = 3, .cst = cst, .par = par, .check = checks, .modes = modes };
  const gs_real start[] = { (gs_real)x, (gs_real)y, (gs_real)u, 0, 7 };
  cst[0] = (gs_real)turn;
  memcpy (z, start, sizeof start);
  return gs_take_start (&circle, &g, z, s);
}

static void
constraints (void)
{
  gs_start s;
  gs_real z[5];
  check ("off", from (1, 2.2, 0, 1, 0, 0, z, &s) == GS_START_OFF && z[0] > GS_R (2.1));
  says ("its rows, the worst first", s.text, "expected a state on the constraints at t = 3 s, "
        "found rate of C = 2.2, C = 0.42");
  check ("relative to the nominal magnitudes", fabs (s.residual - 1) < 1e-15);
  check ("moved", from (0, 2.2, 0, 1, 0, 0, z, &s) == GS_START_TAKEN && z[0] == 2 && z[2] == 0);
  check ("by how much", s.moved == 1 && s.state == 2);
  check ("a small gap is closed", from (1, 2 + 1e-8, 0, 0, 0, 0, z, &s) == GS_START_TAKEN
         && z[0] == 2 && fabs (s.moved - 1e-8) < 1e-15);
  check ("rounding stays", from (0, 2 + 1e-15, 0, 0, 1, 0, z, &s) == GS_START_TAKEN && z[1] == 0);
  check ("closed, but the next state is far", from (1, 2 + 1e-8, 0, 0, 1, 0, z, &s) == GS_START_FAR
         && z[1] == 0 && strstr (s.text, "must be moved by 0.02 in y (close to a singular"));
  check ("none near", from (0, 0.01, 0, 0, 0, 0, z, &s) == GS_START_NONE && z[0] > 0);
  check ("and why", strstr (s.text, "t = 3 s (PRJ: INFO = 1: too near to the centre); found C = ")
         != NULL);
  check ("closed, but INFO", from (0, 2.2, 0, 0, 2, 0, z, &s) == GS_START_NONE
         && strstr (s.text, "t = 3 s (PRJ: INFO = 3); found ") && z[0] > GS_R (2.1));
  check ("no number", from (1, NAN, 0, 0, 0, 0, z, &s) == GS_START_OFF
         && strstr (s.text, "= NaN (no number: "));
  check ("none by PRJ", from (0, NAN, 0, 0, 0, 0, z, &s) == GS_START_NONE
         && strstr (s.text, "found a state that is not finite"));
  check ("no angle", from (0, 2, 1e16, 0, 0, 0, z, &s) == GS_START_ANGLE && s.state == 1);
}

static void
orientations (void)
{
  static const int sets[] = { 0, 1, 2, 3 };
  const gs_start_given g = { .t = 0 };
  const gs_real x[] = { GS_R (0.6), 0, GS_R (0.8), 0, 0 };
  gs_scene free_ = scene;
  gs_description d = circle;
  gs_real z[] = { 0, 0, 0, 0, 1 };
  double scaled[1], found[1];
  gs_start s;
  free_.nq = 4;
  free_.nlam = 0;
  d.scene = &free_;
  d.angles = 0;
  d.sets = sets;
  d.nsets = 1;
  check ("no orientation", gs_close_start (&d, &g, z, &s) == GS_START_ORIENTATION);
  says ("which", s.text, "expected Euler parameters of length 1, found (x, y, u, w) = [0 0 0 0], "
        "which is no orientation");
  gs_residuals (&d, 0, x, 0, scaled, found);
  check ("one of length 1", gs_residual_rows (&d) == 1 && fabs (scaled[0]) < 1e-15);
}

static void
devices (void)
{
  gs_start s;
  gs_real z[5];
  const int held[] = { 1 }, below[] = { -1 };
  char text[200];
  check ("a margin", from (1, sqrt (4 - 2.56), 1.6, 0, 0, 0, z, &s) == GS_START_DEVICE);
  says ("its value", s.text,
        "a device cannot be there: too high: expected above 0, found -0.1 (y = 1.6, limit = 1.5)");
  check ("as it is", from (0, sqrt (4 - 2.56), 1.6, 0, 0, 0, z, &s) == GS_START_TAKEN);
  const double near = 1.5 + 1e-7;
  check ("at it", from (1, sqrt (4 - near * near), near, 0, 0, 0, z, &s) == GS_START_TAKEN);
  const double far = sqrt (4 - 1.95 * 1.95);
  check ("a stop", from (0, far, 1.95, 0, 0, 0, z, &s) == GS_START_STOP);
  says ("its ends", s.text, "the start is beyond an end of the stop wall: expected -1.9 to 1.9, "
        "found 1.95 (m or rad)");
  check ("in contact", from (0, far, 1.95, 0, 0, held, z, &s) == GS_START_TAKEN);
  from (0, 2, 0, 0, 0, 0, z, &s);
  gs_wrong_mode (&circle, &(gs_start_given){ .modes = below }, z, 0, text, sizeof text);
  says ("a wrong mode", text,
        "expected 0 of wall, which is at 0 between -1.9 and 1.9 (m or rad); found -1");
}

static void
runs (void)
{
  const double y[] = { 0, 1.6, 1.8, 1.55 };
  gs_real t[4], x[4 * 6] = { 0 }, v[1] = { 0 };
  gs_passed_margin list[1];
  for (int k = 0; k < 4; k++)
    {
      t[k] = k;
      x[6 * k + 1] = (gs_real)y[k];
    }
  check ("a margin in a run", gs_margins_of_run (&circle, 4, t, x, 6, v, 0, 0, list) == 1
         && list[0].k == 0 && list[0].first == 1 && list[0].at == 2
         && fabs (list[0].least + 0.3) < 1e-15);
  check ("none of one column", gs_margins_of_run (&circle, 1, t, x, 6, v, 0, 0, list) == 0);
}

static void
states_that_settle (void)
{
  const gs_real cst[] = { 0 };
  const int fixed[] = { 0, 0, 0, 0, 1 };
  gs_real x[] = { GS_R (2.2), 0, 0, 0, 7 };
  gs_settle_states (&circle, 0, cst, fixed, x);
  check ("a fixed state stays", x[4] == 7);
  gs_settle_states (&circle, 0, cst, 0, x);
  check ("a filter is where its rate vanishes, on the constraints",
         gs_abs (x[4] - 2) < GS_R (1e-14) && x[0] > GS_R (2.1));
}

static void
samples (void)
{
  const double period[] = { 0.125, 0.25, 0 }, delay[] = { 0.375, 0, 1 };
  check ("pending outputs", gs_pending (3, period, delay) == 5);
  check ("instants", gs_instants (3, period, delay, 1) == 2 * (8 + 2) + 4 + 2);
}

int
main (void)
{
  constraints ();
  orientations ();
  devices ();
  runs ();
  states_that_settle ();
  samples ();
  return 0;
}

/* MuJoCo behind the common interface: init(model.txt) (see model.hpp); id, fd with everything that
   it does in a step, constraints switched off; id_lean, fd_lean only what the result needs. A link
   without mass (turning about a fixed axis) gives its inertia to the joint's armature. */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <string.h>
static mjModel *m;
static mjData *d;
static int n;
static char text[200000];
static double x[22];

static void numbers(FILE *file, int count) {
  for (int k = 0; k < count; k++)
    if (fscanf(file, "%lf", x + k) != 1) fprintf(stderr, "mujoco: model.txt is too short\n");
}

void init(const char *path) {
  FILE *file = fopen(path, "r");
  char *t = text, type[8], error[500];
  int parent;
  if (fscanf(file, "%d", &n) != 1) return;
  numbers(file, 3);
  t +=
      sprintf(t,
              "<mujoco><compiler angle='radian' autolimits='false' balanceinertia='false' "
              "inertiafromgeom='false'/><option gravity='%.17g %.17g %.17g'>"
              "<flag constraint='disable' contact='disable' limit='disable' frictionloss='disable' "
              "equality='disable' sensor='disable' warmstart='disable'/></option><worldbody>",
              x[0], x[1], x[2]);
  for (int i = 0; i < n; i++) {
    if (fscanf(file, "%d %7s", &parent, type) != 2) return;
    numbers(file, 22);
    double *J = x + 16, armature = 0;
    if (x[12] == 0) { armature = J[2]; x[12] = J[0] = J[1] = J[2] = 1e-14; }
    t += sprintf(t,
                 "<body pos='%.17g %.17g %.17g' xyaxes='%.17g %.17g %.17g %.17g %.17g %.17g'>"
                 "<joint type='%s' axis='0 0 1' armature='%.17g'/>"
                 "<inertial pos='%.17g %.17g %.17g' mass='%.17g' fullinertia='%.17g %.17g %.17g "
                 "%.17g %.17g %.17g'/>",
                 x[9], x[10], x[11], x[0], x[3], x[6], x[1], x[4], x[7],
                 *type == 'R' ? "hinge" : "slide", armature, x[13], x[14], x[15], x[12], J[0], J[1],
                 J[2], J[3], J[5], J[4]);
  }
  for (int i = 0; i < n; i++) t += sprintf(t, "</body>");
  sprintf(t, "</worldbody></mujoco>");
  fclose(file);
  mjSpec *spec = mj_parseXMLString(text, NULL, error, sizeof error);
  m = spec ? mj_compile(spec, NULL) : NULL;
  if (!m) { fprintf(stderr, "mujoco: %s\n", spec ? mjs_getError(spec) : error); return; }
  d = mj_makeData(m);
}

static void state(const double *q, const double *v) {
  memcpy(d->qpos, q, n * 8);
  memcpy(d->qvel, v, n * 8);
}

void id(const double *q, const double *v, const double *a, double *o) {
  state(q, v); memcpy(d->qacc, a, n * 8);
  mj_inverse(m, d); memcpy(o, d->qfrc_inverse, n * 8);
}

void fd(const double *q, const double *v, const double *tau, double *o) {
  state(q, v); memcpy(d->qfrc_applied, tau, n * 8);
  mj_forward(m, d); memcpy(o, d->qacc, n * 8);
}

void id_lean(const double *q, const double *v, const double *a, double *o) {
  state(q, v); memcpy(d->qacc, a, n * 8);
  mj_kinematics(m, d); mj_comPos(m, d); mj_comVel(m, d); mj_rne(m, d, 1, o);
  for (int i = 0; i < n; i++) o[i] += m->dof_armature[i] * a[i];
}

void fd_lean(const double *q, const double *v, const double *tau, double *o) {
  state(q, v);
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_makeM(m, d);
  mj_factorM(m, d);
  mj_comVel(m, d);
  mj_rne(m, d, 0, d->qfrc_bias);
  for (int i = 0; i < n; i++) o[i] = tau[i] - d->qfrc_bias[i];
  mj_solveM(m, d, o, o, 1);
}

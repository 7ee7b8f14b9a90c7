// Pinocchio behind the common interface: init(model.txt); id, mm; fd by articulated bodies in world
// axes, in link axes, by mass matrix and Cholesky; jac, the derivatives of that without torques.
#include "model.hpp"
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/cholesky.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>
using namespace pinocchio;
typedef Eigen::Map<const Eigen::VectorXd> In;
typedef Eigen::Map<Eigen::VectorXd> Out;
static Model model;
static Data *data;
static int n;

extern "C" {
void init(const char *path) {
  model = read_model<double>(path, n, [](double x) { return x; });
  data = new Data(model);
}

void id(const double *q, const double *v, const double *a, double *o) {
  Out(o, n) = rnea(model, *data, In(q, n), In(v, n), In(a, n));
}

void fd(const double *q, const double *v, const double *tau, double *o) {
  Out(o, n) = aba(model, *data, In(q, n), In(v, n), In(tau, n), Convention::WORLD);
}

void fd_local(const double *q, const double *v, const double *tau, double *o) {
  Out(o, n) = aba(model, *data, In(q, n), In(v, n), In(tau, n), Convention::LOCAL);
}

void fd_mass(const double *q, const double *v, const double *tau, double *o) {
  Out x(o, n);
  crba(model, *data, In(q, n), Convention::WORLD);
  cholesky::decompose(model, *data);
  x = In(tau, n) - nonLinearEffects(model, *data, In(q, n), In(v, n));
  cholesky::solve(model, *data, x);
}

void jac(const double *q, const double *v, const double *, double *o) {
  computeABADerivatives(model, *data, In(q, n), In(v, n), Eigen::VectorXd::Zero(n));
  for (int k = 0; k < n * n; k++) {
    o[k] = data->ddq_dq.data()[k];
    o[n * n + k] = data->ddq_dv.data()[k];
  }
}

void mm(const double *q, const double *, const double *, double *o) {
  crba(model, *data, In(q, n), Convention::WORLD);
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j++) o[i * n + j] = o[j * n + i] = data->M(i, j);
}
}

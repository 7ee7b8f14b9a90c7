// J and (dJ/dt) u of the arm of arm.mac by Pinocchio and by the emitted Fortran: the largest
// differences, then nanoseconds a call: Pinocchio by the Jacobian and its time variation, by the
// Jacobian and the classical acceleration, GSMBP.
#include <chrono>
#include <cstdio>
#include <vector>
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
using namespace pinocchio;
typedef Eigen::VectorXd Vector;
typedef Eigen::Matrix<double, 6, 6> Six;

extern "C" {
void arm_par_(double *);
void arm_pre_(double *, double *, int *);
void arm_jpt_(double *, double *, double *, double *, double *, double *);
}

// the joints turn about z or, their frames turned, about -y
static Model arm(FrameIndex &tcp) {
  const double d1 = .67183, a2 = .4318, a3 = .0203, d3 = .15005, d4 = .4318, h = .1;
  const bool across[6] = {0, 1, 1, 0, 1, 0};
  const Eigen::Vector3d at[6] = {{0, 0, 0}, {0, 0, d1}, {a2, 0, 0}, {a3, -d3, 0}, {0, 0, d4},
                                 {0, 0, 0}};
  Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), turned, before = one;
  turned << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  Model m;
  JointIndex p = 0;
  for (int i = 0; i < 6; i++) {
    Eigen::Matrix3d own = across[i] ? turned : one;
    p = m.addJoint(p, JointModelRZ(), SE3(before.transpose() * own, before.transpose() * at[i]),
                   "j" + std::to_string(i));
    m.appendBodyToJoint(p, Inertia::Random(), SE3::Identity());
    before = own;
  }
  tcp = m.addFrame(Frame("tcp", p, 0, SE3(one, Eigen::Vector3d(0, 0, h)), OP_FRAME));
  return m;
}

// the least time of a call over all states, of sixty tries
template <class F> static double nanoseconds(int n, F f) {
  double best = 1e99;
  for (int k = 0; k < 60; k++) {
    auto start = std::chrono::steady_clock::now();
    for (int j = 0; j < 8; j++)
      for (int i = 0; i < n; i++) f(i);
    std::chrono::duration<double> s = std::chrono::steady_clock::now() - start;
    best = std::min(best, s.count() / (8 * n) * 1e9);
  }
  return best;
}

int main() {
  const int n = 1024;
  FrameIndex tcp;
  Model m = arm(tcp);
  Data d(m);
  std::vector<Vector> q, u;
  for (int i = 0; i < n; i++) {
    q.push_back(Vector::Random(6) * 3);
    u.push_back(Vector::Random(6));
  }
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 6), dJ(6, 6);
  Eigen::Matrix<double, 6, 1> b, own_b;
  Six own;
  Vector zero = Vector::Zero(6);
  double par[16], cst[64], t = 0, sum = 0;
  int info;
  arm_par_(par);
  arm_pre_(par, cst, &info);
  auto variation = [&](int i) {
    computeJointJacobiansTimeVariation(m, d, q[i], u[i]);
    updateFramePlacement(m, d, tcp);
    J.setZero();
    dJ.setZero();
    getFrameJacobian(m, d, tcp, LOCAL_WORLD_ALIGNED, J);
    getFrameJacobianTimeVariation(m, d, tcp, LOCAL_WORLD_ALIGNED, dJ);
    b.noalias() = dJ * u[i];
    sum += b[0] + J(0, 1);
  };
  auto acceleration = [&](int i) {
    forwardKinematics(m, d, q[i], u[i], zero);
    computeJointJacobians(m, d);
    J.setZero();
    updateFramePlacement(m, d, tcp);
    getFrameJacobian(m, d, tcp, LOCAL_WORLD_ALIGNED, J);
    b = getFrameClassicalAcceleration(m, d, tcp, LOCAL_WORLD_ALIGNED).toVector();
    sum += b[0] + J(0, 1);
  };
  auto ours = [&](int i) {
    arm_jpt_(&t, q[i].data(), u[i].data(), cst, own.data(), own_b.data());
    sum += own_b[0] + own(0, 1);
  };
  double off = 0, off_b = 0;
  for (int i = 0; i < n; i++) {
    ours(i);
    acceleration(i);
    off = std::max(off, (J - own).cwiseAbs().maxCoeff());
    off_b = std::max(off_b, (b - own_b).cwiseAbs().maxCoeff());
  }
  double a = nanoseconds(n, variation), c = nanoseconds(n, acceleration), o = nanoseconds(n, ours);
  printf("%.1e %.1e %.0f %.0f %.0f\n", off, off_b, a, c, o);
  return sum == 0;
}

// The chain of a file model.txt as a model of Pinocchio, whatever its scalar is.
//
// model.txt: n, gravity(3); for each link: parent (-1: ground), type of its joint, R or P about z;
// rotation (9, by rows) and place (3) of the joint in the parent; mass, mass centre (3), inertia
// about it xx yy zz xy yz xz; SI units.
#include <pinocchio/multibody.hpp>
#include <fstream>
#include <string>
#include <vector>

// parameter(x) makes the scalar that stands for the number x
template <class Scalar, class Parameter>
pinocchio::ModelTpl<Scalar> read_model(const char *path, int &n, Parameter parameter) {
  using namespace pinocchio;
  typedef Eigen::Matrix<Scalar, 3, 1> Vector;
  std::ifstream file(path);
  auto number = [&]() { double x; file >> x; return x; };
  auto vector = [&]() {
    Vector v;
    for (int k = 0; k < 3; k++) v(k) = parameter(number());
    return v;
  };
  ModelTpl<Scalar> model;
  file >> n;
  for (int k = 0; k < 3; k++) model.gravity.linear()(k) = Scalar(number());
  std::vector<JointIndex> joint(n);
  for (int i = 0; i < n; i++) {
    int parent; std::string type; file >> parent >> type;
    Eigen::Matrix<Scalar, 3, 3> R;
    for (int k = 0; k < 9; k++) R(k / 3, k % 3) = Scalar(number());
    Vector place = vector();
    Scalar mass = parameter(number());
    Vector centre = vector();
    Scalar J[6];
    for (Scalar &x : J) x = parameter(number());
    SE3Tpl<Scalar> at(R, place);
    JointIndex before = parent < 0 ? 0 : joint[parent];
    std::string name = "joint" + std::to_string(i + 1);
    joint[i] = type == "R"
      ? model.addJoint(before, JointModelRevoluteTpl<Scalar, 0, 2>(), at, name)
      : model.addJoint(before, JointModelPrismaticTpl<Scalar, 0, 2>(), at, name);
    Symmetric3Tpl<Scalar> inertia(J[0], J[3], J[1], J[5], J[4], J[2]);
    model.inertias[joint[i]] = InertiaTpl<Scalar>(mass, centre, inertia);
  }
  return model;
}

// CasADi: Pinocchio's algorithms traced with CasADi's symbols (as pinocchio.casadi does), its
// common subexpressions, its C code.
//
// casadi MODEL.txt lit|num FOLDER: writes FOLDER/id.c, fd.c, mm.c, jac.c, each with f_<word>, and par.c,
// the parameters' values (lit: numbers that are not 0 are parameters). Prints a line for each:
// word, CPU seconds of graph, cse and C code, mul, add, div, sqrt, trig.
#include <pinocchio/autodiff/casadi.hpp>
#include "model.hpp"
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <casadi/casadi.hpp>
#include <ctime>
#include <iostream>
using namespace pinocchio;
typedef ::casadi::SX S;
typedef Eigen::Matrix<S, Eigen::Dynamic, 1> Vector;

static double cpu() { return double(clock()) / CLOCKS_PER_SEC; }

static S column(const Vector &v) {
  return S::vertcat(std::vector<S>(v.data(), v.data() + v.size()));
}

// the entries of a column of symbols
static Vector entries(const S &s, int n) {
  Vector v(n);
  for (int i = 0; i < n; i++) v(i) = s(i);
  return v;
}

static void count(const ::casadi::Function &f, int c[5]) {
  for (int k = 0; k < f.n_instructions(); k++) switch (f.instruction_id(k)) {
    case ::casadi::OP_MUL: case ::casadi::OP_SQ: case ::casadi::OP_TWICE: c[0]++; break;
    case ::casadi::OP_ADD: case ::casadi::OP_SUB: c[1]++; break;
    case ::casadi::OP_DIV: case ::casadi::OP_INV: c[2]++; break;
    case ::casadi::OP_SQRT: c[3]++; break;
    case ::casadi::OP_SIN: case ::casadi::OP_COS: c[4]++; break;
  }
}

// of the accelerations without torques, by q and v: those of the inverse dynamics at them, and the
// mass matrix by L*D*L'
static S derivatives(const ModelTpl<S> &model, const S &q, const S &v, int n) {
  DataTpl<S> data(model);
  const Vector Q = entries(q, n), V = entries(v, n);
  const S a = S::sym("ddq", n);
  aba(model, data, Q, V, Vector(Vector::Zero(n)), Convention::LOCAL);
  const S ddq = column(data.ddq);
  rnea(model, data, Q, V, entries(a, n));
  const S tau = column(data.tau);
  crba(model, data, Q, Convention::LOCAL);
  S M(n, n), D, LT;
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j++) M(i, j) = M(j, i) = data.M(i, j);
  std::vector<casadi_int> p;
  S right = substitute(jacobian(tau, vertcat(q, v)), a, ddq);
  ldl(densify(M), D, LT, p, false);
  return vec(densify(-ldl_solve(right, D, LT, p)));
}

int main(int, char **argv) {
  const bool literal = std::string(argv[2]) == "lit";
  const std::string folder = argv[3];
  std::vector<S> symbols;
  std::vector<double> values;
  int n;
  double start = cpu();
  ModelTpl<S> model = read_model<S>(argv[1], n, [&](double x) {
    if (!literal || x == 0) return S(x);
    symbols.push_back(S::sym("p" + std::to_string(values.size())));
    values.push_back(x);
    return symbols.back();
  });
  const S q = S::sym("q", n), v = S::sym("v", n), a = S::sym("a", n), p = S::vertcat(symbols);
  const Vector Q = entries(q, n), V = entries(v, n), A = entries(a, n);
  const double reading = cpu() - start;
  for (std::string word : {"id", "fd", "mm", "jac"}) {
    start = cpu();
    DataTpl<S> data(model);
    S out;
    if (word == "id") { rnea(model, data, Q, V, A); out = column(data.tau); }
    else if (word == "fd") { aba(model, data, Q, V, A, Convention::LOCAL); out = column(data.ddq); }
    else if (word == "jac") out = derivatives(model, q, v, n);
    else {
      crba(model, data, Q, Convention::LOCAL);
      out = S(n * n, 1);
      for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++) out(i * n + j) = out(j * n + i) = data.M(i, j);
    }
    out = cse(densify(out));
    ::casadi::Function f("f_" + word, {q, v, a, p}, {out});
    ::casadi::CodeGenerator code("f_" + word + ".c");
    code.add(f);
    std::ofstream(folder + "/" + word + ".c") << code.dump() << "extern double p[];\nvoid " << word
      << "(const double *q, const double *v, const double *a, double *o) { "
      << "const double *in[4] = {q, v, a, p}; double *out[1] = {o}; f_" << word
      << "(in, out, 0, 0, 0); }\n";
    const double seconds = reading + cpu() - start;
    int c[5] = {0};
    count(f, c);
    std::cout << word << " " << seconds;
    for (int k : c) std::cout << " " << k;
    std::cout << std::endl;
  }
  std::ofstream par(folder + "/par.c");
  par.precision(17);
  par << "double p[" << values.size() + 1 << "] = {";
  for (double x : values) par << x << ", ";
  par << "0};\n";
}

// casadi MODEL.txt FOLDER JOINT: C from Pinocchio's own templates on CasADi's symbols, one file a function.
//
// Of the graph with and without CasADi's elimination of common subexpressions the one with fewer operations is written;
// of the mass matrix and of its inverse, which are derivatives by accelerations and forces too, the upper triangle, as Pinocchio
// computes it; the Jacobian is that of the link that JOINT moves. Prints the operations of each.
#include <pinocchio/autodiff/casadi.hpp>
#include <pinocchio/multibody.hpp>

namespace pinocchio {
// The kinds of joints that occur, where Pinocchio has 25 (an eighth of the time to compile): what is written is the same.
template <typename Scalar, int Options> struct FewJoints {
  typedef JointModelRevoluteTpl<Scalar, Options, 0> JointModelRX;
  typedef JointModelRevoluteTpl<Scalar, Options, 1> JointModelRY;
  typedef JointModelRevoluteTpl<Scalar, Options, 2> JointModelRZ;
  typedef JointModelRevoluteUnalignedTpl<Scalar, Options> JointModelRevoluteUnaligned;
  typedef JointModelFreeFlyerTpl<Scalar, Options> JointModelFreeFlyer;
  typedef boost::variant<JointModelRX, JointModelRY, JointModelRZ, JointModelRevoluteUnaligned, JointModelFreeFlyer>
      JointModelVariant;
  typedef boost::variant<JointDataRevoluteTpl<Scalar, Options, 0>, JointDataRevoluteTpl<Scalar, Options, 1>,
                         JointDataRevoluteTpl<Scalar, Options, 2>, JointDataRevoluteUnalignedTpl<Scalar, Options>,
                         JointDataFreeFlyerTpl<Scalar, Options>>
      JointDataVariant;
};
} // namespace pinocchio
#define JOINTS pin::FewJoints
#include "model.hpp"
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <algorithm>
#include <iostream>

using casadi::SX;

// Multiplications, additions, divisions, signs and trigonometric functions.
static casadi_int operations(const casadi::Function &f) {
  casadi_int n = 0;
  for (casadi_int k = 0; k < f.n_instructions(); ++k) {
    const auto id = f.instruction_id(k);
    n += id != casadi::OP_INPUT && id != casadi::OP_OUTPUT && id != casadi::OP_CONST;
  }
  return n;
}

static SX symbols(const char *name, int n, Eigen::Matrix<SX, Eigen::Dynamic, 1> &v) {
  const SX s = SX::sym(name, n);
  v.resize(n);
  for (int i = 0; i < n; ++i) v[i] = s(i);
  return s;
}

// What is zero is left out.
template <typename Derived> static SX sparse(const Eigen::MatrixBase<Derived> &m, bool upper = false) {
  SX out(m.rows(), m.cols());
  for (int j = 0; j < m.cols(); ++j)
    for (int i = 0; i < (upper ? j + 1 : m.rows()); ++i)
      if (!m(i, j).is_zero()) out(i, j) = m(i, j);
  return out;
}

// Of the graphs of all these outputs, which are equal, the one with the fewest operations.
static void write(const std::string &folder, const std::string &name, const std::vector<SX> &in, const std::vector<SX> &outs) {
  std::vector<casadi::Function> graphs;
  for (const auto &out : outs)
    for (const bool shared : {false, true}) graphs.emplace_back(name, in, std::vector<SX>{out}, casadi::Dict{{"cse", shared}});
  const auto fewer = [](const auto &a, const auto &b) { return operations(a) < operations(b); };
  const auto &chosen = *std::min_element(graphs.begin(), graphs.end(), fewer);
  casadi::CodeGenerator code(name + ".c");
  code.add(chosen);
  code.generate(folder + "/");
  std::cout << name << " " << operations(chosen) << std::endl;
}

// In the two ways of Pinocchio: all joints', then that of one; or along its path alone.
static std::vector<SX> jacobians(const ModelOf<SX> &model, pin::JointIndex tip, const std::string &joint, const Eigen::Matrix<SX, Eigen::Dynamic, 1> &q) {
  DataOf<SX> all(model), path(model);
  DataOf<SX>::Matrix6x one = DataOf<SX>::Matrix6x::Zero(6, model.nv), other = one;
  pin::computeJointJacobians(model, all, q);
  pin::getJointJacobian(model, all, tip, pin::LOCAL_WORLD_ALIGNED, one);
  pin::computeFrameJacobian(model, path, q, model.getFrameId(joint), pin::LOCAL_WORLD_ALIGNED, other);
  return {sparse(one), sparse(other)};
}

int main(int argc, char **argv) {
  if (argc != 4) return std::cerr << "usage: casadi MODEL.txt FOLDER JOINT\n", 2;
  const auto numbers = read_model(argv[1]);
  const auto model = numbers.cast<SX>();
  const std::string folder = argv[2], joint = argv[3];
  Eigen::Matrix<SX, Eigen::Dynamic, 1> q, v, a, tau;
  const SX sq = symbols("q", model.nq, q), sv = symbols("v", model.nv, v), sa = symbols("a", model.nv, a),
           st = symbols("tau", model.nv, tau);
  DataOf<SX> inverse(model), matrix(model), forward(model), coriolis(model), inverted(model), regressor(model), by(model), forward_by(model);
  write(folder, "inverse_dynamics", {sq, sv, sa}, {sparse(pin::rnea(model, inverse, q, v, a))});
  write(folder, "mass_matrix", {sq}, {sparse(pin::crba(model, matrix, q), true)});
  write(folder, "forward_dynamics", {sq, sv, st}, {sparse(pin::aba(model, forward, q, v, tau))});
  write(folder, "jacobian", {sq}, jacobians(model, tip_of(numbers, joint), joint, q));
  write(folder, "coriolis_matrix", {sq, sv}, {sparse(pin::computeCoriolisMatrix(model, coriolis, q, v))});
  write(folder, "mass_matrix_inverse", {sq}, {sparse(pin::computeMinverse(model, inverted, q), true)});
  write(folder, "regressor", {sq, sv, sa}, {sparse(pin::computeJointTorqueRegressor(model, regressor, q, v, a))});
  pin::computeRNEADerivatives(model, by, q, v, a);
  write(folder, "d_inverse_dynamics_d_q_u_u_dot", {sq, sv, sa}, {vertcat(sparse(by.dtau_dq), sparse(by.dtau_dv), sparse(by.M, true))});
  pin::computeABADerivatives(model, forward_by, q, v, tau);
  write(folder, "d_forward_dynamics_d_q_u_tau", {sq, sv, st},
        {vertcat(sparse(forward_by.ddq_dq), sparse(forward_by.ddq_dv), sparse(forward_by.Minv, true))});
}

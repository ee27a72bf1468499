// States, one candidate's coordinates from Pinocchio's, and what Pinocchio's results are to be.
#pragma once
#include "rivals.hpp"

#include <random>

struct State {
  Vector q, u, x;
};

inline std::vector<State> random_states(const Robot &robot, Function f, int count) {
  std::mt19937_64 source(1);
  auto uniform = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(source); };
  std::vector<State> states(count);
  for (auto &s : states) {
    s.q = Vector::NullaryExpr(robot.model.nq, [&] { return uniform(3); });
    if (robot.floating) s.q.segment<4>(3).normalize();
    s.u = Vector::NullaryExpr(robot.model.nv, [&] { return uniform(1.5); });
    s.x = Vector::NullaryExpr(robot.model.nv, [&] { return uniform(is_forward(f) ? 10 : 3); });
  }
  return states;
}

// `u = T v`, `u_dot = T a + c`, and because T is orthogonal `tau = T tau_P`; `rate` is T' T_dot.
struct Conversion {
  Matrix t, rate;
  Vector c, q;
};

inline Conversion convert(const Candidate &to, const Robot &robot, const Vector &q, const Vector &v) {
  const int n = robot.model.nv, base = robot.floating ? 6 : 0;
  Conversion made{Matrix::Zero(n, n), Matrix::Zero(n, n), Vector::Zero(n), q};
  for (int i = base; i < n; ++i) {
    const int place = base + (to.places.empty() ? i - base : to.places[i - base]);
    made.t(place, i) = 1;
    made.q[place + (robot.floating ? 1 : 0)] = q[i + (robot.floating ? 1 : 0)];
  }
  if (!robot.floating) return made;
  const auto &in = to.convention;
  const Eigen::Quaterniond turn(q[6], q[3], q[4], q[5]);
  const Eigen::Matrix3d r = turn.toRotationMatrix(), one = Eigen::Matrix3d::Identity(), spin = pin::skew(v.segment<3>(3));
  const int linear = in.angular_first ? 3 : 0, angular = 3 - linear, position = in.quaternion_first ? 4 : 0;
  made.t.block<3, 3>(linear, 0) = in.inertial_linear ? r : one;
  made.t.block<3, 3>(angular, 3) = in.inertial_angular ? r : one;
  if (in.inertial_linear) made.rate.block<3, 3>(0, 0) = spin;
  if (in.inertial_angular) made.rate.block<3, 3>(3, 3) = spin;
  made.c = made.t * (made.rate * v);
  made.q.segment<3>(position) = q.head<3>();
  auto e = made.q.segment<4>(in.quaternion_first ? 0 : 3);
  if (in.scalar_first) e << q[6], q[3], q[4], q[5];
  else e << q[3], q[4], q[5], q[6];
  return made;
}

// What Pinocchio computes.
inline Matrix expected(const Robot &robot, Data &data, Function f, const State &s) {
  const Model &model = robot.model;
  switch (f) {
  case INVERSE_DYNAMICS: return pin::rnea(model, data, s.q, s.u, s.x);
  case MASS_MATRIX: data.M.setZero(); return symmetric(pin::crba(model, data, s.q));
  case FORWARD_DYNAMICS: return pin::aba(model, data, s.q, s.u, s.x);
  case JACOBIAN: {
    pin::Data::Matrix6x j = pin::Data::Matrix6x::Zero(6, model.nv);
    pin::computeJointJacobians(model, data, s.q);
    pin::getJointJacobian(model, data, robot.tip(), pin::LOCAL_WORLD_ALIGNED, j);
    return j;
  }
  case CORIOLIS_MATRIX: return pin::computeCoriolisMatrix(model, data, s.q, s.u);
  case MASS_MATRIX_INVERSE: return symmetric(pin::computeMinverse(model, data, s.q));
  case REGRESSOR: return pin::computeJointTorqueRegressor(model, data, s.q, s.u, s.x);
  case INVERSE_DYNAMICS_DERIVATIVES:
    pin::computeRNEADerivatives(model, data, s.q, s.u, s.x);
    return derivatives(data.dtau_dq, data.dtau_dv, data.M);
  case FORWARD_DYNAMICS_DERIVATIVES:
    pin::computeABADerivatives(model, data, s.q, s.u, s.x);
    return derivatives(data.ddq_dq, data.ddq_dv, data.Minv);
  }
  return {};
}

// A matrix of the size of M with this where forces of the base's origin meet its turning.
inline Matrix by_turning(int n, const Eigen::Vector3d &turned) {
  Matrix m = Matrix::Zero(n, n);
  m.block<3, 3>(0, 3) = pin::skew(turned);
  return m;
}

// Derivatives of a candidate, in Pinocchio's displacements and speeds. Where it has the velocity of a floating base's origin along
// inertial axes, the angular velocity is in the base's. As the base turns by e in its axes, a vector that is given along
// inertial axes changes there by its product with e, and a result that is wanted along inertial axes by the opposite.
inline Matrix derivatives_to_pinocchio(const Robot &robot, Data &data, Function f, const State &s, const Conversion &own, const Matrix &result) {
  const int n = robot.model.nv;
  const auto local = [&](int block) -> Matrix { return own.t.transpose() * result.middleRows(block * n, n) * own.t; };
  Matrix by_q = local(0), by_u = local(1), by_x = local(2);
  if (own.rate.isZero(0)) return derivatives(by_q, by_u, by_x); // nothing along inertial axes
  const Vector found = expected(robot, data, is_forward(f) ? FORWARD_DYNAMICS : INVERSE_DYNAMICS, s);
  const Vector &a = is_forward(f) ? found : s.x, &tau = is_forward(f) ? s.x : found;
  // u_dot = T (a + w x v): how v, T' u_dot and T' tau change with turns, and a with v, where `rate` is w x.
  const Matrix v_by_q = by_turning(n, s.u.head<3>()), whole_by_q = by_turning(n, (a + own.rate * s.u).head<3>()),
               tau_by_q = by_turning(n, tau.head<3>()), a_by_v = v_by_q - own.rate;
  if (is_forward(f)) {
    by_q += whole_by_q - by_u * v_by_q - by_x * tau_by_q;
    by_u += a_by_v;
  } else {
    by_q += tau_by_q - by_u * v_by_q - by_x * whole_by_q;
    by_u -= by_x * a_by_v;
  }
  return derivatives(by_q, by_u, by_x);
}

// A candidate's result in Pinocchio's speeds.
inline Matrix to_pinocchio(const Robot &robot, Data &data, Function f, const State &s, const Conversion &own, const Matrix &result) {
  const Matrix &t = own.t;
  switch (f) {
  case INVERSE_DYNAMICS:
  case REGRESSOR: return t.transpose() * result;
  case FORWARD_DYNAMICS: return t.transpose() * (result - own.c);
  case JACOBIAN: return result * t;
  case MASS_MATRIX:
  case MASS_MATRIX_INVERSE: return t.transpose() * result * t;
  case INVERSE_DYNAMICS_DERIVATIVES:
  case FORWARD_DYNAMICS_DERIVATIVES: return derivatives_to_pinocchio(robot, data, f, s, own, result);
  // C' = T' (C T + M T_dot), M = T M' T'.
  case CORIOLIS_MATRIX: return t.transpose() * result * t + expected(robot, data, MASS_MATRIX, s) * own.rate;
  }
  return {};
}

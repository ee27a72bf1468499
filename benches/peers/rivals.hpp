// Every candidate behind the interface of candidate.hpp.
#pragma once
#include "candidate.hpp"
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>

// Of the last matrix the upper triangle counts.
inline Matrix derivatives(const Matrix &by_q, const Matrix &by_u, const Matrix &by_x) {
  Matrix all(3 * by_q.rows(), by_q.cols());
  all << by_q, by_u, by_x;
  return symmetric_below(all);
}

// Pinocchio's functions in one of its two conventions; they leave their results in `data` or, the Jacobian, in `jacobian`, of
// which one number is copied. Of the Jacobian there are two ways too: all joints', then that of one; or along its path alone.
template <pin::Convention convention> struct Pinocchio {
  const Model &model;
  Data data;
  int row, column;
  pin::JointIndex tip;
  pin::FrameIndex frame;
  Data::Matrix6x jacobian;
  typedef Eigen::Map<const Vector, Eigen::Aligned64> In;

  static void inverse_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::rnea(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv));
    out[0] = o.data.tau[o.row];
  }
  static void mass_matrix(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::crba(o.model, o.data, In(q, o.model.nq), convention);
    out[0] = o.data.M(o.row, o.column);
  }
  static void forward_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::aba(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv), convention);
    out[0] = o.data.ddq[o.row];
  }
  static void frame_jacobian(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    if (convention == pin::Convention::LOCAL) {
      pin::computeJointJacobians(o.model, o.data, In(q, o.model.nq));
      pin::getJointJacobian(o.model, o.data, o.tip, pin::LOCAL_WORLD_ALIGNED, o.jacobian);
    } else pin::computeFrameJacobian(o.model, o.data, In(q, o.model.nq), o.frame, pin::LOCAL_WORLD_ALIGNED, o.jacobian);
    out[0] = o.jacobian(o.row, o.column);
  }
  static void coriolis_matrix(void *object, const double *q, const double *u, const double *, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::computeCoriolisMatrix(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv));
    out[0] = o.data.C(o.row, o.column);
  }
  static void mass_matrix_inverse(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::computeMinverse(o.model, o.data, In(q, o.model.nq));
    out[0] = o.data.Minv(o.row, o.column);
  }
  static void regressor(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::computeJointTorqueRegressor(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv));
    out[0] = o.data.jointTorqueRegressor(o.row, o.column);
  }
  static void inverse_dynamics_derivatives(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::computeRNEADerivatives(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv));
    out[0] = o.data.dtau_dv(o.row - o.model.nv, o.column);
  }
  static void forward_dynamics_derivatives(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::computeABADerivatives(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv));
    out[0] = o.data.ddq_dv(o.row - o.model.nv, o.column);
  }
  static Candidate candidate(const Robot &robot, Function f) {
    const auto [row, column] = robot.entry(f, 3);
    const auto tip = robot.tip();
    auto *o = new Pinocchio{robot.model, Data(robot.model), row, column, tip, robot.model.getFrameId(robot.joint), Data::Matrix6x::Zero(6, robot.model.nv)};
    const Call calls[] = {inverse_dynamics,    mass_matrix, forward_dynamics,             frame_jacobian, coriolis_matrix,
                          mass_matrix_inverse, regressor,   inverse_dynamics_derivatives, forward_dynamics_derivatives};
    return {"Pinocchio", PINOCCHIO, calls[f], o, [o, f](const double *) { return o->result(f); }, 0};
  }
  Matrix result(Function f) const {
    switch (f) {
    case INVERSE_DYNAMICS: return data.tau;
    case MASS_MATRIX: return symmetric(data.M);
    case FORWARD_DYNAMICS: return data.ddq;
    case JACOBIAN: return jacobian;
    case CORIOLIS_MATRIX: return data.C;
    case MASS_MATRIX_INVERSE: return symmetric(data.Minv);
    case REGRESSOR: return data.jointTorqueRegressor;
    case INVERSE_DYNAMICS_DERIVATIVES: return derivatives(data.dtau_dq, data.dtau_dv, data.M);
    case FORWARD_DYNAMICS_DERIVATIVES: return derivatives(data.ddq_dq, data.ddq_dv, data.Minv);
    }
    return {};
  }
};

template <typename Symbol> Symbol symbol(const std::string &library, const std::string &name) {
  void *handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void *found = handle ? dlsym(handle, name.c_str()) : nullptr;
  if (!found) throw std::runtime_error(dlerror());
  return reinterpret_cast<Symbol>(found);
}

// C that CasADi generated: dense or sparse by columns.
struct CasADi {
  int (*function)(const double **, double **, long long *, double *, int);
  std::vector<const double *> arguments;
  std::vector<double *> results;
  std::vector<long long> integers;
  std::vector<double> work;

  static void call(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<CasADi *>(object);
    o.arguments[0] = q, o.arguments[1] = u, o.arguments[2] = x, o.results[0] = out;
    o.function(o.arguments.data(), o.results.data(), o.integers.data(), o.work.data(), 0);
  }
  static Candidate candidate(const Robot &robot, Function f) {
    const std::string name = NAMES[f], library = robot.folder + "/" + name + ".so";
    auto *o = new CasADi{symbol<decltype(function)>(library, name)};
    long long sizes[4] = {};
    symbol<int (*)(long long *, long long *, long long *, long long *)>(library, name + "_work")(sizes, sizes + 1, sizes + 2, sizes + 3);
    o->arguments.resize(std::max(sizes[0], 3LL));
    o->results.resize(std::max(sizes[1], 1LL));
    o->integers.resize(sizes[2]), o->work.resize(sizes[3]);
    // Rows, columns, then 1 for dense or where each column begins and the rows of its entries.
    const long long *pattern = symbol<const long long *(*)(long long)>(library, name + "_sparsity_out")(0);
    const bool dense = pattern[2] == 1;
    const long long *begins = pattern + 2, *rows = begins + pattern[1] + 1;
    auto expand = [=](const double *out) -> Matrix {
      if (dense) return Eigen::Map<const Matrix>(out, pattern[0], pattern[1]);
      Matrix m = Matrix::Zero(pattern[0], pattern[1]);
      for (long long j = 0; j < pattern[1]; ++j)
        for (long long k = begins[j]; k < begins[j + 1]; ++k) m(rows[k], j) = out[k];
      return is_symmetric(f) ? symmetric(m) : is_derivative(f) ? symmetric_below(m) : m;
    };
    const auto [row, column] = robot.entry(f, 3);
    long long whole = dense ? column * pattern[0] + row : -1;
    for (long long k = dense ? 0 : begins[column]; !dense && k < begins[column + 1]; ++k)
      if (rows[k] == row) whole = k;
    if (whole < 0) throw std::runtime_error("CasADi's " + name + " of " + robot.name + " leaves out what all the others compute");
    return {"CasADi", PINOCCHIO, call, o, expand, int(whole)};
  }
};

// The shortest sequence of MuJoCo's functions that leads to the result; the mass matrix is its own sparse lower triangle.
struct MuJoCo {
  mjModel *m;
  mjData *d;
  std::vector<double> rest;
  int body;

  void place(const double *q) {
    std::memcpy(d->qpos, q, sizeof(double) * m->nq);
    mj_kinematics(m, d);
    mj_comPos(m, d);
  }
  void move(const double *u) {
    std::memcpy(d->qvel, u, sizeof(double) * m->nv);
    mj_comVel(m, d);
  }
  static void inverse_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<MuJoCo *>(object);
    o.place(q), o.move(u);
    std::memcpy(o.d->qacc, x, sizeof(double) * o.m->nv);
    mj_rne(o.m, o.d, 1, out);
  }
  static void mass_matrix(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<MuJoCo *>(object);
    o.place(q);
    mj_makeM(o.m, o.d);
    std::memcpy(out, o.d->M, sizeof(double) * o.m->nC);
  }
  static void forward_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<MuJoCo *>(object);
    o.place(q);
    mj_makeM(o.m, o.d);
    mj_factorM(o.m, o.d);
    o.move(u);
    double *rest = o.rest.data();
    mj_rne(o.m, o.d, 0, rest);
    for (int i = 0; i < o.m->nv; ++i) rest[i] = x[i] - rest[i];
    mj_solveM(o.m, o.d, out, rest, 1);
  }
  static void jacobian(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<MuJoCo *>(object);
    o.place(q);
    mj_jacBody(o.m, o.d, out, out + 3 * o.m->nv, o.body);
  }
  static Candidate candidate(const Robot &robot, Function f) {
    char error[1000] = "";
    mjModel *m = mj_loadXML((robot.folder + ".xml").c_str(), nullptr, error, sizeof error);
    if (!m) throw std::runtime_error(error);
    auto *o = new MuJoCo{m, mj_makeData(m), std::vector<double>(m->nv), mj_name2id(m, mjOBJ_BODY, robot.joint.c_str())};
    const Call calls[] = {inverse_dynamics, mass_matrix, forward_dynamics, jacobian};
    auto sparse = [m](const double *out) -> Matrix {
      Matrix upper = Matrix::Zero(m->nv, m->nv);
      for (int i = 0; i < m->nv; ++i)
        for (int k = m->M_rowadr[i]; k < m->M_rowadr[i] + m->M_rownnz[i]; ++k) upper(m->M_colind[k], i) = out[k];
      return symmetric(upper);
    };
    if (f != MASS_MATRIX) return {"MuJoCo", MUJOCO, calls[f], o, robot.dense(f), robot.whole(f, 3)};
    // The last entry of a row is that on the diagonal.
    const int row = robot.floating ? 5 : 0;
    return {"MuJoCo", MUJOCO, calls[f], o, sparse, m->M_rowadr[row] + m->M_rownnz[row] - 1};
  }
};

// What the Rust library offers: generated functions, and dynibo.
struct Rust {
  std::string library;
  struct Found {
    Call call;
    void *object;
  };

  Candidate kane(const Robot &robot, Function f) const {
    const auto found = symbol<Found (*)(const char *, unsigned)>(library, "kane_candidate")(robot.name.c_str(), f);
    if (!found.call) throw std::runtime_error("no generated functions of " + robot.name);
    return {"kane", KANE, found.call, found.object, robot.dense(f), robot.whole(f, 0)};
  }
  // What the tree does not make zero, of symmetric matrices of a triangle: as CasADi writes it. None where there is no such function.
  std::vector<Candidate> kane_packed(const Robot &robot, Function f) const {
    const auto found = symbol<Found (*)(const char *, unsigned)>(library, "kane_packed_candidate")(robot.name.c_str(), f);
    if (!found.call) return {};
    const auto unpack = symbol<void (*)(const char *, unsigned, const double *, double *)>(library, "kane_unpack");
    auto expand = [=, name = robot.name, m = robot.rows(f), n = robot.columns(f)](const double *out) -> Matrix {
      Rows whole(m, n);
      unpack(name.c_str(), f, out, whole.data());
      return whole;
    };
    // Where the entry of `Candidate::whole` stands is asked of the places: numbers that say where they stand are unpacked.
    const auto [row, column] = robot.entry(f, 0);
    std::vector<double> numbered(robot.rows(f) * robot.columns(f));
    for (size_t i = 0; i < numbered.size(); ++i) numbered[i] = i;
    const int place = expand(numbered.data())(row, column);
    return {{"kane", KANE, found.call, found.object, expand, place}};
  }
  size_t operations(const Robot &robot, Function f) const {
    return symbol<size_t (*)(const char *, unsigned)>(library, "kane_operations")(robot.name.c_str(), f);
  }
  Candidate dynibo(const Robot &robot, Function f) const {
    const char *urdf = robot.urdf.c_str();
    const auto found = symbol<Found (*)(const char *, bool, unsigned)>(library, "dynibo_candidate")(urdf, robot.floating, f);
    if (!found.call) throw std::runtime_error("dynibo");
    const auto joint = symbol<std::ptrdiff_t (*)(const char *, const char *)>(library, "dynibo_joint");
    std::vector<int> places;
    for (int i = robot.floating ? 2 : 1; i < robot.model.njoints; ++i) {
      const auto place = joint(urdf, robot.model.names[i].c_str());
      if (place < 0) throw std::runtime_error("dynibo has no joint " + robot.model.names[i]);
      places.push_back(place);
    }
    int whole = robot.whole(f, 0);
    if (!robot.floating) whole = f == MASS_MATRIX ? places[0] * (robot.model.nv + 1) : places[0];
    return {"dynibo", DYNIBO, found.call, found.object, robot.dense(f), whole, places, 9.80665};
  }
};

// Ours first. Of the functions after the Jacobian CasADi and Pinocchio have one each, the others none.
inline std::vector<Candidate> candidates_of(const Robot &robot, Function f, const Rust &rust) {
  std::vector<Candidate> all = {rust.kane(robot, f), CasADi::candidate(robot, f), Pinocchio<pin::Convention::LOCAL>::candidate(robot, f)};
  if (f <= JACOBIAN) {
    all.push_back(Pinocchio<pin::Convention::WORLD>::candidate(robot, f));
    all.push_back(MuJoCo::candidate(robot, f));
  }
  if (f <= FORWARD_DYNAMICS) all.push_back(rust.dynibo(robot, f));
  for (const auto &packed : rust.kane_packed(robot, f)) all.push_back(packed);
  return all;
}

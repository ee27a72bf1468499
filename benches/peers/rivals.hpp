// Every candidate behind one interface: a function, the object it works on, and in what its arguments and results are expressed.
#pragma once
#include "model.hpp"
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <functional>
#include <iostream>
#include <memory>
#include <vector>

typedef Eigen::VectorXd Vector;
typedef Eigen::MatrixXd Matrix;

enum Function { INVERSE_DYNAMICS, MASS_MATRIX, FORWARD_DYNAMICS };
static const char *const NAMES[] = {"inverse_dynamics", "mass_matrix", "forward_dynamics"};

// Object, q, u, x, output; x is u_dot for inverse dynamics, tau for forward dynamics. As kane/src/lib.rs has it.
typedef void (*Call)(void *, const double *, const double *, const double *, double *);

// What a floating base's coordinates and speeds are. Pinocchio's come first: the position, a quaternion (x, y, z, w); the
// origin's velocity, then the angular velocity, both in the base's axes.
struct Convention {
  bool scalar_first, quaternion_first, inertial_linear, inertial_angular, angular_first;
};
static const Convention PINOCCHIO = {false, false, false, false, false};
static const Convention KANE = {true, true, true, false, true};
static const Convention MUJOCO = {true, false, true, false, false};
static const Convention DYNIBO = {false, false, true, true, true};

struct Candidate {
  std::string name;
  Convention convention;
  Call call;
  void *object;
  // The output as it stands in memory, as a vector or a whole matrix in the candidate's own speeds.
  std::function<Matrix(const double *)> expand;
  // Where the output holds an entry that depends on all coordinates: the last angular speed of a floating base, else the first.
  int whole = 0;
  // The place of each of Pinocchio's joints after the base, where the order is another.
  std::vector<int> places = {};
  // As in dynibo, where it is a constant, or as in a URDF, which has none.
  double gravity = 9.81;
};

inline Matrix symmetric(Matrix m) {
  m.triangularView<Eigen::StrictlyLower>() = m.transpose();
  return m;
}

struct Robot {
  std::string name, urdf, folder; // of compiled C and of the model as MJCF
  Model model;
  bool floating;

  // The entry of `Candidate::whole` for a dense output whose angular speeds begin at `angular`.
  int whole(Function f, int angular) const {
    const int place = floating ? angular + 2 : 0;
    return f == MASS_MATRIX ? place * (model.nv + 1) : place;
  }
  std::function<Matrix(const double *)> dense(Function f) const {
    const int n = model.nv;
    return [n, f](const double *out) -> Matrix { return Eigen::Map<const Matrix>(out, n, f == MASS_MATRIX ? n : 1); };
  }
};

// Pinocchio's functions in one of its two conventions; they leave their results in `data`, of which one number is copied.
template <pin::Convention convention> struct Pinocchio {
  const Model &model;
  Data data;
  int place;
  typedef Eigen::Map<const Vector, Eigen::Aligned64> In;

  static void inverse_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::rnea(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv));
    out[o.place] = o.data.tau[o.place];
  }
  static void mass_matrix(void *object, const double *q, const double *, const double *, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::crba(o.model, o.data, In(q, o.model.nq), convention);
    out[o.place] = o.data.M.data()[o.place];
  }
  static void forward_dynamics(void *object, const double *q, const double *u, const double *x, double *out) {
    auto &o = *static_cast<Pinocchio *>(object);
    pin::aba(o.model, o.data, In(q, o.model.nq), In(u, o.model.nv), In(x, o.model.nv), convention);
    out[o.place] = o.data.ddq[o.place];
  }
  static Candidate candidate(const Robot &robot, Function f) {
    auto *o = new Pinocchio{robot.model, Data(robot.model), robot.whole(f, 3)};
    const Call calls[] = {inverse_dynamics, mass_matrix, forward_dynamics};
    auto expand = [o, f](const double *) -> Matrix {
      return f == INVERSE_DYNAMICS ? Matrix(o->data.tau) : f == MASS_MATRIX ? symmetric(o->data.M) : Matrix(o->data.ddq);
    };
    return {"Pinocchio", PINOCCHIO, calls[f], o, expand, o->place};
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
      return f == MASS_MATRIX ? symmetric(m) : m;
    };
    // Of an upper triangle, the last entry of a column is that on the diagonal.
    const int place = robot.whole(f, 3);
    const int whole = dense || f != MASS_MATRIX ? place : begins[place / (robot.model.nv + 1) + 1] - 1;
    return {"CasADi", PINOCCHIO, call, o, expand, whole};
  }
};

// The shortest sequence of MuJoCo's functions that leads to the result; the mass matrix is its own sparse lower triangle.
struct MuJoCo {
  mjModel *m;
  mjData *d;
  std::vector<double> rest;

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
  static Candidate candidate(const Robot &robot, Function f) {
    char error[1000] = "";
    mjModel *m = mj_loadXML((robot.folder + ".xml").c_str(), nullptr, error, sizeof error);
    if (!m) throw std::runtime_error(error);
    auto *o = new MuJoCo{m, mj_makeData(m), std::vector<double>(m->nv)};
    const Call calls[] = {inverse_dynamics, mass_matrix, forward_dynamics};
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
  // Of the mass matrix what is not zero of a triangle, as all the others but dynibo write it.
  Candidate kane_packed(const Robot &robot) const {
    const auto found = symbol<Found (*)(const char *)>(library, "kane_packed_candidate")(robot.name.c_str());
    if (!found.call) throw std::runtime_error("no generated functions of " + robot.name);
    const auto unpack = symbol<void (*)(const char *, const double *, double *)>(library, "kane_unpack");
    auto expand = [=, name = robot.name, n = robot.model.nv](const double *out) -> Matrix {
      Matrix m(n, n);
      unpack(name.c_str(), out, m.data());
      return m;
    };
    // Row after row, the last entry of each on the diagonal; the base's rows are whole.
    return {"kane", KANE, found.call, found.object, expand, robot.floating ? 5 : 0};
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

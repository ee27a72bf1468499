// What is compared, on what, and the one interface of all that compute it: a function, the object it works on, and in what its
// arguments and results are expressed.
#pragma once
#include "model.hpp"

#include <functional>
#include <vector>

typedef Eigen::VectorXd Vector;
typedef Eigen::MatrixXd Matrix;
typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;

// As kane/src/lib.rs numbers them.
enum Function {
  INVERSE_DYNAMICS,
  MASS_MATRIX,
  FORWARD_DYNAMICS,
  JACOBIAN,
  CORIOLIS_MATRIX,
  MASS_MATRIX_INVERSE,
  REGRESSOR,
  INVERSE_DYNAMICS_DERIVATIVES,
  FORWARD_DYNAMICS_DERIVATIVES
};
static const Function FUNCTIONS[] = {INVERSE_DYNAMICS,    MASS_MATRIX, FORWARD_DYNAMICS,             JACOBIAN,                    CORIOLIS_MATRIX,
                                     MASS_MATRIX_INVERSE, REGRESSOR,   INVERSE_DYNAMICS_DERIVATIVES, FORWARD_DYNAMICS_DERIVATIVES};
static const char *const NAMES[] = {"inverse_dynamics",    "mass_matrix", "forward_dynamics",             "jacobian",                    "coriolis_matrix",
                                    "mass_matrix_inverse", "regressor",   "d_inverse_dynamics_d_q_u_u_dot", "d_forward_dynamics_d_q_u_tau"};

inline bool reads_u(Function f) { return f != MASS_MATRIX && f != JACOBIAN && f != MASS_MATRIX_INVERSE; }
inline bool reads_x(Function f) { return reads_u(f) && f != CORIOLIS_MATRIX; }
inline bool is_forward(Function f) { return f == FORWARD_DYNAMICS || f == FORWARD_DYNAMICS_DERIVATIVES; }
// Three matrices, one below the other: by q, by u, and by u_dot or tau, which is symmetric.
inline bool is_derivative(Function f) { return f >= INVERSE_DYNAMICS_DERIVATIVES; }
inline bool is_symmetric(Function f) { return f == MASS_MATRIX || f == MASS_MATRIX_INVERSE; }

// Object, q, u, x, output; x is tau for forward dynamics and its derivatives, else u_dot. As kane/src/lib.rs has it.
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
  // Where the output holds an entry that depends on all coordinates, or on all that move the frame or the body in question.
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

// The same of the last of three matrices, of which a triangle is there.
inline Matrix symmetric_below(Matrix m) {
  const auto n = m.cols();
  m.bottomRows(n) = symmetric(m.bottomRows(n));
  return m;
}

struct Robot {
  std::string name, urdf, folder; // of compiled C and of the model as MJCF
  Model model;
  bool floating;
  std::string joint; // that moves the link whose Jacobian is compared
  pin::JointIndex tip() const { return tip_of(model, joint); }

  int rows(Function f) const { return f == JACOBIAN ? 6 : is_derivative(f) ? 3 * model.nv : model.nv; }
  int columns(Function f) const { return f == REGRESSOR ? 10 * (model.njoints - 1) : f == INVERSE_DYNAMICS || f == FORWARD_DYNAMICS ? 1 : model.nv; }

  // The row and column of the entry of `Candidate::whole`, where angular speeds of a floating base begin at `angular`: that of
  // the last of these, else of the first speed; of derivatives that by speeds; of the regressor the column of a moment of mass of the link's body.
  std::pair<int, int> entry(Function f, int angular) const {
    const int place = floating ? angular + 2 : 0;
    if (f == JACOBIAN) return {0, place};
    if (is_derivative(f)) return {model.nv + place, place};
    if (f == REGRESSOR) return {place, 10 * (int(tip()) - 1) + 1};
    return {place, columns(f) == 1 ? 0 : place};
  }
  // Where that stands in an output that is written whole, row by row.
  int whole(Function f, int angular) const {
    const auto [row, column] = entry(f, angular);
    return row * columns(f) + column;
  }
  std::function<Matrix(const double *)> dense(Function f) const {
    const int m = rows(f), n = columns(f);
    return [m, n](const double *out) -> Matrix { return Eigen::Map<const Rows>(out, m, n); };
  }
};

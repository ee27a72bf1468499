// bench FOLDER LIBRARY SECONDS URDF:fixed|free...: times every candidate on the same states in one process and prints ratios.
// Exits with 1 where our results are not those of Pinocchio.
//
// All start from the same states of Pinocchio, converted to a candidate's own coordinates before, and compared with Pinocchio's
// results after, the timed part. Rounds are interleaved: in each, every candidate is called often enough to take some
// microseconds, first on one state after the other, then on states that depend on its own last result. Ratios are those of
// two times of one round, and their median is printed, since the machine's speed changes from round to round.
#include "rivals.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <random>

static const int STATES = 256, ROUND_NS = 20000, LEAST_ROUNDS = 32;
static const double AGREE = 1e-6;
static const int PAGE = 512, LINE = 8; // of memory and of the cache, in numbers

struct State {
  Vector q, u, x;
};

// `u = T v`, `u_dot = T a + c`, and because T is orthogonal `tau = T tau_P`.
struct Conversion {
  Matrix t;
  Vector c, q;
};

static Conversion convert(const Candidate &to, const Robot &robot, const Vector &q, const Vector &v) {
  const int n = robot.model.nv, base = robot.floating ? 6 : 0;
  Conversion made{Matrix::Zero(n, n), Vector::Zero(n), q};
  for (int i = base; i < n; ++i) {
    const int place = base + (to.places.empty() ? i - base : to.places[i - base]);
    made.t(place, i) = 1;
    made.q[place + (robot.floating ? 1 : 0)] = q[i + (robot.floating ? 1 : 0)];
  }
  if (!robot.floating) return made;
  const auto &in = to.convention;
  const Eigen::Quaterniond turn(q[6], q[3], q[4], q[5]);
  const Eigen::Matrix3d r = turn.toRotationMatrix(), one = Eigen::Matrix3d::Identity();
  const int linear = in.angular_first ? 3 : 0, angular = 3 - linear, position = in.quaternion_first ? 4 : 0;
  made.t.block<3, 3>(linear, 0) = in.inertial_linear ? r : one;
  made.t.block<3, 3>(angular, 3) = in.inertial_angular ? r : one;
  if (in.inertial_linear) made.c.segment<3>(linear) = r * v.segment<3>(3).cross(v.head<3>());
  made.q.segment<3>(position) = q.head<3>();
  auto e = made.q.segment<4>(in.quaternion_first ? 0 : 3);
  if (in.scalar_first) e << q[6], q[3], q[4], q[5];
  else e << q[3], q[4], q[5], q[6];
  return made;
}

static std::vector<State> random_states(const Robot &robot, Function f) {
  std::mt19937_64 source(1);
  auto uniform = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(source); };
  std::vector<State> states(STATES);
  for (auto &s : states) {
    s.q = Vector::NullaryExpr(robot.model.nq, [&] { return uniform(3); });
    if (robot.floating) s.q.segment<4>(3).normalize();
    s.u = Vector::NullaryExpr(robot.model.nv, [&] { return uniform(1.5); });
    s.x = Vector::NullaryExpr(robot.model.nv, [&] { return uniform(f == FORWARD_DYNAMICS ? 10 : 3); });
  }
  return states;
}

// One array after the other, each beginning at a cache line.
struct Memory {
  int stride;
  Eigen::Matrix<double, Eigen::Dynamic, 1> all;
  double *begin;
  Memory(int length, int count) : stride((length + 7) / 8 * 8), all(Vector::Zero(stride * count + 8)) {
    begin = reinterpret_cast<double *>((reinterpret_cast<std::uintptr_t>(all.data()) + 63) / 64 * 64);
  }
  double *at(int i) { return begin + i * stride; }
};

struct Runner {
  Candidate candidate;
  int nq, nv, calls = 1;
  Memory q, u, x, out;
  double *written; // somewhere in `out`
  double difference = 0;
  std::vector<double> independent, chained; // ns, one for each round

  Runner(const Candidate &made, const Robot &robot)
      : candidate(made), nq(robot.model.nq), nv(robot.model.nv), q(nq, STATES + 1), u(nv, STATES + 1), x(nv, STATES + 1), out(nv * nv + PAGE, 1), written(out.begin) {}

  void call(int state) { candidate.call(candidate.object, q.at(state), u.at(state), x.at(state), written); }

  // Sets the states, and compares with Pinocchio.
  void check(Robot &robot, Function f, const std::vector<State> &states) {
    robot.model.gravity.linear() = Eigen::Vector3d(0, 0, -candidate.gravity);
    Data data(robot.model);
    for (int i = 0; i < STATES; ++i) {
      const State &s = states[i];
      const auto own = convert(candidate, robot, s.q, s.u);
      Vector rest = f == INVERSE_DYNAMICS ? own.c : Vector::Zero(nv);
      Eigen::Map<Vector>(q.at(i), nq) = own.q;
      Eigen::Map<Vector>(u.at(i), nv) = own.t * s.u;
      Eigen::Map<Vector>(x.at(i), nv) = own.t * s.x + rest;
      call(i);
      Matrix result = candidate.expand(written), expected;
      if (f == MASS_MATRIX) {
        data.M.setZero();
        expected = symmetric(pin::crba(robot.model, data, s.q));
        result = (own.t.transpose() * result * own.t).eval();
      } else {
        expected = f == INVERSE_DYNAMICS ? pin::rnea(robot.model, data, s.q, s.u, s.x) : pin::aba(robot.model, data, s.q, s.u, s.x);
        if (f == FORWARD_DYNAMICS) result -= own.c;
        result = (own.t.transpose() * result).eval();
      }
      const double off = (result - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
      difference = off <= difference ? difference : off; // not a number counts
    }
    robot.model.gravity.linear() = Eigen::Vector3d(0, 0, -9.81);
  }

  __attribute__((noinline)) double time_independent(int first) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) call((first + i) % STATES);
    return nanoseconds_since(begin) / calls;
  }

  // The result's share is far below rounding, so the values are the same as above; the processor cannot know.
  __attribute__((noinline)) double time_chained(int first, Function f) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) {
      const int from = (first + i) % STATES;
      const double share = 1e-30 * written[candidate.whole];
      add(q, from, nq, share);
      if (f != MASS_MATRIX) add(u, from, nv, share), add(x, from, nv, share);
      call(STATES);
    }
    return nanoseconds_since(begin) / calls;
  }

  static void add(Memory &to, int from, int n, double share) {
    for (int k = 0; k < n; ++k) to.at(STATES)[k] = to.at(from)[k] + share;
  }
  static double nanoseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
  }
};

static double quantile(std::vector<double> of, double part) {
  std::sort(of.begin(), of.end());
  return of[std::min<size_t>(of.size() * part, of.size() - 1)];
}

static double median_ratio(const std::vector<double> &a, const std::vector<double> &b) {
  std::vector<double> ratios(a.size());
  for (size_t i = 0; i < a.size(); ++i) ratios[i] = a[i] / b[i];
  return quantile(ratios, 0.5);
}

static const std::vector<std::string> RIVALS = {"CasADi", "Pinocchio", "MuJoCo", "dynibo"};

// One line of the table, of the runner `own`. Of Pinocchio's two conventions the faster counts.
static void print(const Robot &robot, const std::string &function, const char *how, const Runner &own, const std::vector<Runner> &runners,
                  std::vector<double> Runner::*times) {
  const auto &ours = own.*times;
  std::printf("| %s | %s | %s | %.0f |", robot.name.c_str(), function.c_str(), how, quantile(ours, 0.5));
  for (const auto &rival : RIVALS) {
    double ratio = 0;
    for (const auto &runner : runners)
      if (runner.candidate.name == rival) ratio = std::max(ratio, median_ratio(ours, runner.*times));
    std::printf(" %.2f |", ratio);
  }
  std::printf(" %.2f |\n", quantile(ours, 0.9) / quantile(ours, 0.1));
}

// False where our results are not those of Pinocchio.
static bool compare(Robot &robot, Function f, const Rust &rust, double seconds) {
  const auto states = random_states(robot, f);
  std::vector<Candidate> candidates = {rust.kane(robot, f),
                                       CasADi::candidate(robot, f),
                                       Pinocchio<pin::Convention::LOCAL>::candidate(robot, f),
                                       Pinocchio<pin::Convention::WORLD>::candidate(robot, f),
                                       MuJoCo::candidate(robot, f),
                                       rust.dynibo(robot, f)};
  if (f == MASS_MATRIX) candidates.push_back(rust.kane_packed(robot));
  std::vector<Runner> runners;
  for (const auto &candidate : candidates) runners.emplace_back(candidate, robot);
  for (auto &runner : runners) {
    runner.check(robot, f, states);
    // MuJoCo moves inertias that no body can have.
    if (!(runner.difference < AGREE))
      std::fprintf(stderr, "%s %s: %s differs from Pinocchio by %.1e\n", robot.name.c_str(), NAMES[f], runner.candidate.name.c_str(), runner.difference);
    runner.calls = STATES;
    runner.calls = std::clamp(int(ROUND_NS / runner.time_independent(0)), 8, STATES);
  }
  const auto begin = std::chrono::steady_clock::now();
  for (int round = 0; round < LEAST_ROUNDS || Runner::nanoseconds_since(begin) < seconds * 1e9; ++round)
    for (auto &runner : runners) {
      const int first = round * 37 % STATES;
      // Loads wait for stores to addresses that end alike: no candidate is to be lucky in where its results lie.
      runner.written = runner.out.begin + round * 5 * LINE % PAGE;
      runner.call(first); // what others left in the caches is not its own
      runner.independent.push_back(runner.time_independent(first));
      runner.chained.push_back(runner.time_chained(first, f));
    }
  bool agree = true;
  for (const auto &own : runners) {
    if (own.candidate.name != "kane") continue;
    const std::string function = std::string(NAMES[f]) + (&own == &runners[0] ? "" : "_packed");
    print(robot, function, "independent", own, runners, &Runner::independent);
    print(robot, function, "chained", own, runners, &Runner::chained);
    agree &= own.difference < AGREE;
  }
  for (const auto &runner : runners) std::fprintf(stderr, " %s %.0e", runner.candidate.name.c_str(), runner.difference);
  std::fprintf(stderr, "  largest relative differences of %s %s\n", robot.name.c_str(), NAMES[f]);
  return agree;
}

int main(int argc, char **argv) {
  if (argc < 5) return std::cerr << "usage: bench FOLDER LIBRARY SECONDS URDF:fixed|free...\n", 2;
  const std::string folder = argv[1];
  const Rust rust{argv[2]};
  std::printf("| robot | function | calls | kane, ns |");
  for (const auto &rival : RIVALS) std::printf(" / %s |", rival.c_str());
  std::printf(" spread |\n|---|---|---|---|---|---|---|---|---|\n");
  bool agree = true;
  for (int i = 4; i < argc; ++i) {
    const std::string given = argv[i], urdf = given.substr(0, given.rfind(':'));
    const std::string name = urdf.substr(urdf.rfind('/') + 1, urdf.rfind('.') - urdf.rfind('/') - 1);
    Robot robot{name, urdf, folder + "/" + name, read_model(folder + "/" + name + ".txt"), given.substr(given.rfind(':') + 1) == "free"};
    for (const auto f : {INVERSE_DYNAMICS, MASS_MATRIX, FORWARD_DYNAMICS}) agree &= compare(robot, f, rust, std::atof(argv[3]));
  }
  return agree ? 0 : 1;
}

// bench FOLDER LIBRARY SECONDS FUNCTIONS URDF:fixed|free:JOINT...: times every candidate on the same states in one process, prints
// ratios, and operations. FUNCTIONS are names with spaces between, none for all; JOINT moves the link of the Jacobian. Exits
// with 1 where our results are not those of Pinocchio.
//
// All start from the same states of Pinocchio, converted to a candidate's own coordinates before, and compared with Pinocchio's
// results after, the timed part. Rounds are interleaved: in each, every candidate is called often enough to take some
// microseconds, first on one state after the other, then on states that depend on its own last result. Ratios are those of
// two times of one round, and their median is printed, since the machine's speed changes from round to round.
#include "conversion.hpp"

#include <chrono>
#include <cstdio>
#include <sstream>

static const int STATES = 256, ROUND_NS = 20000, LEAST_ROUNDS = 32;
static const double AGREE = 1e-6;
static const int PAGE = 512, LINE = 8; // of memory and of the cache, in numbers

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

  Runner(const Candidate &made, const Robot &robot, Function f)
      : candidate(made), nq(robot.model.nq), nv(robot.model.nv), q(nq, STATES + 1), u(nv, STATES + 1), x(nv, STATES + 1), out(robot.rows(f) * robot.columns(f) + PAGE, 1), written(out.begin) {}

  void call(int state) { candidate.call(candidate.object, q.at(state), u.at(state), x.at(state), written); }

  // Sets the states, and compares with Pinocchio.
  void check(Robot &robot, Function f, const std::vector<State> &states) {
    robot.model.gravity.linear() = Eigen::Vector3d(0, 0, -candidate.gravity);
    Data data(robot.model);
    for (int i = 0; i < STATES; ++i) {
      const State &s = states[i];
      const auto own = convert(candidate, robot, s.q, s.u);
      Eigen::Map<Vector>(q.at(i), nq) = own.q;
      Eigen::Map<Vector>(u.at(i), nv) = own.t * s.u;
      Eigen::Map<Vector>(x.at(i), nv) = own.t * s.x;
      if (!is_forward(f)) Eigen::Map<Vector>(x.at(i), nv) += own.c; // they are accelerations
      call(i);
      const Matrix result = to_pinocchio(robot, data, f, s, own, candidate.expand(written)), wanted = expected(robot, data, f, s);
      const double off = (result - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff();
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
      if (reads_u(f)) add(u, from, nv, share);
      if (reads_x(f)) add(x, from, nv, share);
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

// One line of the table, of the runner `own`; an empty cell where there is no rival. Of Pinocchio's two conventions the faster
// counts.
static void print(const Robot &robot, const std::string &function, const char *how, const Runner &own, const std::vector<Runner> &runners,
                  std::vector<double> Runner::*times) {
  const auto &ours = own.*times;
  std::printf("| %s | %s | %s | %.0f |", robot.name.c_str(), function.c_str(), how, quantile(ours, 0.5));
  for (const auto &rival : RIVALS) {
    double ratio = 0;
    for (const auto &runner : runners)
      if (runner.candidate.name == rival) ratio = std::max(ratio, median_ratio(ours, runner.*times));
    std::printf(ratio > 0 ? " %.2f |" : " |", ratio);
  }
  std::printf(" %.2f |\n", quantile(ours, 0.9) / quantile(ours, 0.1));
}

// False where our results are not those of Pinocchio.
static bool compare(Robot &robot, Function f, const Rust &rust, double seconds) {
  const auto states = random_states(robot, f, STATES);
  std::vector<Runner> runners;
  for (const auto &candidate : candidates_of(robot, f, rust)) runners.emplace_back(candidate, robot, f);
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

// Of our functions, and of the C that CasADi wrote.
static void print_operations(const std::vector<Robot> &robots, const std::vector<Function> &functions, const Rust &rust) {
  std::printf("\n| robot | function | operations: kane | CasADi |\n|---|---|---|---|\n");
  for (const auto &robot : robots)
    for (const auto f : functions) {
      std::ifstream in(robot.folder + "/operations");
      std::string name, counted = "";
      for (std::string count; in >> name >> count;)
        if (name == NAMES[f]) counted = count;
      std::printf("| %s | %s | %zu | %s |\n", robot.name.c_str(), NAMES[f], rust.operations(robot, f), counted.c_str());
    }
}

// Throws where a name is none of a function.
static std::vector<Function> functions_of(const std::string &names) {
  std::vector<Function> found;
  std::istringstream in(names);
  for (std::string name; in >> name;) {
    const auto has = [&](Function f) { return name == NAMES[f]; };
    const auto f = std::find_if(std::begin(FUNCTIONS), std::end(FUNCTIONS), has);
    if (f == std::end(FUNCTIONS)) throw std::runtime_error("no function " + name);
    found.push_back(*f);
  }
  if (found.empty()) found.assign(std::begin(FUNCTIONS), std::end(FUNCTIONS));
  return found;
}

int main(int argc, char **argv) {
  if (argc < 6) return std::cerr << "usage: bench FOLDER LIBRARY SECONDS FUNCTIONS URDF:fixed|free:JOINT...\n", 2;
  const std::string folder = argv[1];
  const Rust rust{argv[2]};
  const auto functions = functions_of(argv[4]);
  std::vector<Robot> robots;
  for (int i = 5; i < argc; ++i) {
    const std::string given = argv[i];
    const auto joint = given.rfind(':'), base = given.rfind(':', joint - 1);
    const std::string urdf = given.substr(0, base), file = urdf.substr(urdf.rfind('/') + 1), name = file.substr(0, file.rfind('.'));
    const bool free = given.substr(base + 1, joint - base - 1) == "free";
    robots.push_back({name, urdf, folder + "/" + name, read_model(folder + "/" + name + ".txt"), free, given.substr(joint + 1)});
  }
  std::printf("| robot | function | calls | kane, ns |");
  for (const auto &rival : RIVALS) std::printf(" / %s |", rival.c_str());
  std::printf(" spread |\n|---|---|---|---|---|---|---|---|---|\n");
  bool agree = true;
  for (auto &robot : robots)
    for (const auto f : functions) agree &= compare(robot, f, rust, std::atof(argv[3]));
  print_operations(robots, functions, rust);
  return agree ? 0 : 1;
}

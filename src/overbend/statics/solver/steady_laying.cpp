#include "statics/solver/steady_laying.h"

#include <fmt/core.h>

#include <cmath>

#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

constexpr double kToleranceLength = 10.0;  ///< Remaining displacement of the line over the force tolerance [m].
constexpr double kNoise = 1e-6;            ///< Displacement below which a step need not reduce the miss [m].
constexpr double kNoSide = 1e-7;           ///< Miss of a pipe without side load [m].
constexpr int kMaxStepFailures = 8;        ///< Maximum number of steps without equilibrium or with a larger miss, each
                                           ///< followed by half of it.

/// Counts the effort of the search for the line separately from that of the equilibrium, so that it does not exhaust
/// it.
class SeparateWork {
 public:
  explicit SeparateWork(EquilibriumProblem& problem) : at_(problem), before_(problem.work) { at_.work = 0.0; }
  ~SeparateWork() { at_.work = before_; }
  SeparateWork(const SeparateWork&) = delete;
  SeparateWork& operator=(const SeparateWork&) = delete;
  bool is_exhausted() const { return at_.work > kShare * at_.max_work(); }

 private:
  static constexpr double kShare = 0.25;
  EquilibriumProblem& at_;
  double before_;
};

/// Moves the line by `step` [m]: first-order prediction of the state, then equilibrium.
bool move_line_by(EquilibriumProblem& problem, const StaticSystem::LineChange& change, double step) {
  LineState moved = problem.state;
  advance(moved, problem.state, change.q, step);
  moved.far_force += step * change.far_force;
  if (moved.far_force <= 0.0) return false;
  problem.state = std::move(moved);
  return solve_from_warm_start(problem, "steady laying");
}

}  // namespace

LayRoute laid_route(const Model& model, const StaticSolution& solution) {
  constexpr double kRounding = 1e-9;  // [m], as in statics
  LayRoute route = lay_route(model);
  if (!lays_steadily(model)) return route;
  const double aside = route.offset(Eigen::Map<const Vec3>(solution.state.q.data()));
  return std::abs(aside) > kRounding ? route.parallel_route(aside) : route;
}

bool solve_steady_laying(EquilibriumProblem& problem) {
  if (!problem.system.lays_steadily() || !problem.system.plane().route.straight()) return true;
  std::optional<double> miss = problem.system.landing_miss(problem.state);
  if (!miss || std::abs(*miss) < kNoSide) return true;
  const double tolerance = kToleranceLength * problem.model.description.statics.tolerance;
  double share = 1.0;
  bool factored = false;
  StaticSystem::LineChange change;
  int failures = 0;
  SeparateWork work(problem);
  while (failures < kMaxStepFailures && !work.is_exhausted()) {
    if (!factored) {
      problem.system.evaluate(problem.state, true);
      problem.system.hold(true);
      if (!problem.system.factor(problem.state, problem.target) || problem.system.line_change() == nullptr) {
        return false;
      }
      problem.work += problem.size();
      change = *problem.system.line_change();
      factored = true;
    }
    const double step = -share * *miss / change.miss;
    if (std::abs(step) < tolerance) return true;
    const LineState before = problem.state;
    const std::optional<double> new_miss =
        move_line_by(problem, change, step) ? problem.system.landing_miss(problem.state) : std::nullopt;
    if (new_miss && std::abs(*new_miss) < std::abs(*miss)) {
      miss = new_miss;
      share = std::min(1.0, 2.0 * share);
      factored = false;
    } else {
      problem.state = before;
      share *= 0.5;
      ++failures;
      if (std::abs(step) < kNoise) return true;  // the tolerance of the forces hides the rest
    }
  }
  return false;
}

double laid_offset_in_bend(const Model& model) {
  if (!lays_steadily(model) || !model.description.route.given()) return 0.0;
  Model straight = model;
  straight.description.route = {};
  const StaticOutcome outcome = solve_statics(straight);
  return outcome.solution ? laid_route(straight, *outcome.solution).shift() : 0.0;
}

bool move_line(EquilibriumProblem& problem, double to_port) {
  const LineMesh& mesh = problem.system.mesh();
  const LayRoute& route = problem.system.plane().route;
  const auto present_offset = [&] { return route.offset(Eigen::Map<const Vec3>(problem.state.q.data())); };
  double step = to_port - present_offset();
  SeparateWork work(problem);
  for (int failures = 0; failures < kMaxStepFailures && !work.is_exhausted();) {
    const double left = to_port - present_offset();
    if (std::abs(left) < kNoise) return true;
    step = std::abs(step) < std::abs(left) ? std::copysign(step, left) : left;
    const LineState before = problem.state;
    for (std::size_t node = 0; node < mesh.s.size(); ++node) {
      Eigen::Map<Vec3> r(problem.state.q.data() + 6 * node);
      r += (1.0 - mesh.s[node] / mesh.total_length()) * step * route.port(route.distance(r));
    }
    if (solve_from_warm_start(problem, "line moved aside")) continue;
    problem.state = before;
    step *= 0.5;
    ++failures;
  }
  return false;
}

}  // namespace overbend

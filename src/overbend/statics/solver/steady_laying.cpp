#include "statics/solver/steady_laying.h"

#include <fmt/core.h>

#include <cmath>

#include "statics/solver/static_start.h"

namespace overbend {
namespace {

constexpr double kThere = 10.0;   ///< Way of the line that is left, over the tolerance of forces [m].
constexpr double kNoise = 1e-6;   ///< A way as short that does not lessen the miss [m].
constexpr double kNoSide = 1e-7;  ///< Miss of a pipe that nothing pushes aside [m].
constexpr int kMostFailures = 8;  ///< Ways that find no equilibrium, or miss by more, each followed by half of it.

/// What looking for the line may cost, apart from what the equilibrium did: a case must not be given up for it.
class OwnWork {
 public:
  explicit OwnWork(StaticCase& at) : at_(at), before_(at.work) { at_.work = 0.0; }
  ~OwnWork() { at_.work = before_; }
  OwnWork(const OwnWork&) = delete;
  OwnWork& operator=(const OwnWork&) = delete;
  bool spent() const { return at_.work > kShare * at_.most_work(); }

 private:
  static constexpr double kShare = 0.25;
  StaticCase& at_;
  double before_;
};

/// A step of the line by `way` [m]: the state goes along to first order, then into balance.
bool take(StaticCase& at, const StaticSystem::LineChange& change, double way) {
  LineState moved = at.state;
  advance(moved, at.state, change.q, way);
  moved.far_force += way * change.far_force;
  if (moved.far_force <= 0.0) return false;
  at.state = std::move(moved);
  return follow(at, "steady laying");
}

}  // namespace

LayRoute laid_route(const Model& model, const StaticSolution& solution) {
  constexpr double kRounding = 1e-9;  // [m], as in statics
  LayRoute route = lay_route(model);
  if (!lays_steadily(model)) return route;
  const double aside = route.offset(Eigen::Map<const Vec3>(solution.state.q.data()));
  return std::abs(aside) > kRounding ? route.beside(aside) : route;
}

bool settle_steadily(StaticCase& at) {
  if (!at.system.lays_steadily() || !at.system.plane().route.straight()) return true;
  std::optional<double> miss = at.system.landing_miss(at.state);
  if (!miss || std::abs(*miss) < kNoSide) return true;
  const double there = kThere * at.model.description.statics.tolerance;
  double share = 1.0;
  bool factored = false;
  StaticSystem::LineChange change;
  int failures = 0;
  OwnWork work(at);
  while (failures < kMostFailures && !work.spent()) {
    if (!factored) {
      at.system.evaluate(at.state, true);
      at.system.hold(true);
      if (!at.system.factor(at.state, at.target) || at.system.line_change() == nullptr) return false;
      at.work += at.size();
      change = *at.system.line_change();
      factored = true;
    }
    const double way = -share * *miss / change.miss;
    if (std::abs(way) < there) return true;
    const LineState before = at.state;
    const std::optional<double> now = take(at, change, way) ? at.system.landing_miss(at.state) : std::nullopt;
    if (now && std::abs(*now) < std::abs(*miss)) {
      miss = now;
      share = std::min(1.0, 2.0 * share);
      factored = false;
    } else {
      at.state = before;
      share *= 0.5;
      ++failures;
      if (std::abs(way) < kNoise) return true;  // the forces' own tolerance hides the rest
    }
  }
  return false;
}

double laid_beside(const Model& model) {
  if (!lays_steadily(model) || !model.description.route.given()) return 0.0;
  Model straight = model;
  straight.description.route = {};
  const StaticOutcome outcome = solve_statics(straight);
  return outcome.solution ? laid_route(straight, *outcome.solution).shift() : 0.0;
}

bool move_line(StaticCase& at, double to_port) {
  const LineMesh& mesh = at.system.mesh();
  const LayRoute& route = at.system.plane().route;
  const auto now = [&] { return route.offset(Eigen::Map<const Vec3>(at.state.q.data())); };
  double step = to_port - now();
  OwnWork work(at);
  for (int failures = 0; failures < kMostFailures && !work.spent();) {
    const double left = to_port - now();
    if (std::abs(left) < kNoise) return true;
    step = std::abs(step) < std::abs(left) ? std::copysign(step, left) : left;
    const LineState before = at.state;
    for (std::size_t node = 0; node < mesh.s.size(); ++node) {
      Eigen::Map<Vec3> r(at.state.q.data() + 6 * node);
      r += (1.0 - mesh.s[node] / mesh.total_length()) * step * route.port(route.distance(r));
    }
    if (follow(at, "line moved aside")) continue;
    at.state = before;
    step *= 0.5;
    ++failures;
  }
  return false;
}

}  // namespace overbend

#include "statics/solver/dragged_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/dragged_shape.h"
#include "statics/solver/warm_start.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

constexpr double kAtWinch = 1e-6;  ///< [m]
constexpr int kMaxChanges = 20;    ///< Changes of the length.

/// Number of elements of the cable, counted from the far end.
std::size_t cable_elements(const LineMesh& mesh) {
  const auto other_section =
      ranges::find_if(mesh.section, [&](int section) { return section != mesh.section.front(); });
  return static_cast<std::size_t>(other_section - mesh.section.begin());
}

/// Scales the elements of the cable in the mesh by `factor`.
LineMesh with_cable(LineMesh mesh, double factor) {
  const std::size_t cable = cable_elements(mesh);
  const double longer = (factor - 1.0) * mesh.s[cable];
  for (std::size_t i = 0; i < mesh.s.size(); ++i) mesh.s[i] = i < cable ? factor * mesh.s[i] : mesh.s[i] + longer;
  for (std::size_t e = 0; e < cable; ++e) mesh.length[e] = mesh.s[e + 1] - mesh.s[e];
  return mesh;
}

/// State on such a mesh: chords of the cable are scaled by the same factor, so that its strain stays constant.
LineState with_cable(const LineMesh& mesh, const LineState& state, double factor) {
  LineState moved;
  moved.far_force = state.far_force;
  moved.q = state.q;
  for (std::size_t node = cable_elements(mesh); node-- > 0;) {
    const Eigen::Map<const Vec3> old(state.q.data() + 6 * node), old_next(state.q.data() + 6 * node + 6);
    Eigen::Map<Vec3>(moved.q.data() + 6 * node) =
        Vec3(Eigen::Map<const Vec3>(moved.q.data() + 6 * node + 6)) + factor * (old - old_next);
  }
  return moved;
}

/// Horizontal distance from the cable's end to the winch [m].
double remaining_to_winch(const EquilibriumProblem& problem) {
  const LayPlane& plane = problem.system.plane();
  return (winch_place(problem.model, plane) - Eigen::Map<const Vec3>(problem.state.q.data())).dot(plane.astern_W);
}

bool change_length(EquilibriumProblem& problem, const LoadHistory& past, double longer) {
  const LineMesh& mesh = problem.system.mesh();
  const double length = mesh.s[cable_elements(mesh)];
  const double factor = 1.0 + std::clamp(longer / length, -0.5, 0.5);
  problem.state = with_cable(mesh, problem.state, factor);
  problem.system = system_with_history(problem.model, with_cable(mesh, factor), past);
  pin_far_end(problem.system, problem.state);
  return solve_from_warm_start(problem, "cable to its winch");
}

/// Effective tension at a node, and the distance of the node from the top.
struct NodeTension {
  double tension = 0.0, from_top = 0.0;
};

NodeTension min_tension_in_line(EquilibriumProblem& problem) {
  problem.system.evaluate(problem.state, false);
  const LineMesh& mesh = problem.system.mesh();
  NodeTension min_tension{1e300, 0.0};
  for (std::size_t node = 0; node < mesh.s.size(); ++node) {
    const Vec3 tangent = Eigen::Map<const Vec3>(problem.state.q.data() + 6 * node + 3).normalized();
    const double tension = cut_at_node(problem.system.cuts(), problem.state.q, node).force.dot(tangent);
    if (tension < min_tension.tension) min_tension = {tension, mesh.total_length() - mesh.s[node]};
  }
  return min_tension;
}

StaticFailure compressed(const EquilibriumProblem& problem, const NodeTension& min_tension) {
  const bool away = dragging_direction(problem.model.description) > 0.0;
  return {"the line is in compression",
          shown(min_tension.from_top, "m", 1) + " from the tensioner",
          fmt::format("with {} at the tensioner the tension there is {}: {}; increase the tension at the tensioner, or "
                      "pay out less pipe",
                      shown(problem.target.value, "N", 1), shown(min_tension.tension, "N", 1),
                      away ? "the pipe would slide down the seabed, or its suspended weight exceeds the tension"
                           : "seabed friction exceeds the pull"),
          false,
          {},
          FailureKind::tension_too_low};
}

}  // namespace

std::optional<StaticFailure> check_dragged(EquilibriumProblem& problem) {
  constexpr double kNone = 1e-6;  // relative to the tension at the tensioner
  if (!is_dragged(problem.model.description)) return std::nullopt;
  const NodeTension min_tension = min_tension_in_line(problem);
  if (min_tension.tension < -kNone * problem.target.value) return compressed(problem, min_tension);
  const double out = problem.system.mesh().s[cable_elements(problem.system.mesh())];
  const std::optional<double>& available = problem.model.description.operation.lay.cable->length;
  if (!available || out <= *available) return std::nullopt;
  return StaticFailure{"the cable does not reach", "from the head to the winch",
                       fmt::format("it needs {} of cable, the winch has {} (operation.cable.length)",
                                   shown(out, "m", 1), shown(*available, "m", 1))};
}

bool fit_cable_to_winch(EquilibriumProblem& problem, const LoadHistory& past) {
  if (!is_dragged(problem.model.description)) return true;
  double reach_by_length = 1.0;  // displacement of the end per metre of cable, from the last two lengths
  double missing = remaining_to_winch(problem);
  for (int i = 0; i < kMaxChanges && std::abs(missing) > kAtWinch; ++i) {
    const double longer = missing / reach_by_length;
    if (!change_length(problem, past, longer)) return false;
    const double before = std::exchange(missing, remaining_to_winch(problem));
    reach_by_length = std::clamp((before - missing) / longer, 0.3, 3.0);
  }
  return std::abs(missing) <= kAtWinch;
}

}  // namespace overbend

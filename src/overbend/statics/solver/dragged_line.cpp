#include "statics/solver/dragged_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/dragged_shape.h"
#include "statics/solver/carried_start.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

constexpr double kAtWinch = 1e-6;  ///< [m]
constexpr int kMaxChanges = 20;    ///< Of the length.

/// Elements of the cable, counted from the far end.
std::size_t cable_elements(const LineMesh& mesh) {
  const auto other = std::ranges::find_if(mesh.section, [&](int section) { return section != mesh.section.front(); });
  return static_cast<std::size_t>(other - mesh.section.begin());
}

/// The mesh with elements of the cable that are `factor` times as long.
LineMesh with_cable(LineMesh mesh, double factor) {
  const std::size_t cable = cable_elements(mesh);
  const double longer = (factor - 1.0) * mesh.s[cable];
  for (std::size_t i = 0; i < mesh.s.size(); ++i) mesh.s[i] = i < cable ? factor * mesh.s[i] : mesh.s[i] + longer;
  for (std::size_t e = 0; e < cable; ++e) mesh.length[e] = mesh.s[e + 1] - mesh.s[e];
  return mesh;
}

/// The state on such a mesh: chords of the cable are longer by the same factor, so that its strain stays.
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

/// Horizontal distance of the cable's end short of the winch [m].
double short_of_winch(const StaticCase& at) {
  const LayPlane& plane = at.system.plane();
  return (winch_place(at.model, plane) - Eigen::Map<const Vec3>(at.state.q.data())).dot(plane.astern_W);
}

bool change_length(StaticCase& at, const LinePast& past, double longer) {
  const LineMesh& mesh = at.system.mesh();
  const double length = mesh.s[cable_elements(mesh)];
  const double factor = 1.0 + std::clamp(longer / length, -0.5, 0.5);
  at.state = with_cable(mesh, at.state, factor);
  at.system = system_with_past(at.model, with_cable(mesh, factor), past);
  pin_far_end(at.system, at.state);
  return follow(at, "cable to its winch");
}

/// Effective tension at a node and its place.
struct NodeTension {
  double tension = 0.0, from_top = 0.0;
};

NodeTension smallest_tension(StaticCase& at) {
  at.system.evaluate(at.state, false);
  const LineMesh& mesh = at.system.mesh();
  NodeTension least{1e300, 0.0};
  for (std::size_t node = 0; node < mesh.s.size(); ++node) {
    const Vec3 tangent = Eigen::Map<const Vec3>(at.state.q.data() + 6 * node + 3).normalized();
    const double tension = cut_at_node(at.system.cuts(), at.state.q, node).force.dot(tangent);
    if (tension < least.tension) least = {tension, mesh.total_length() - mesh.s[node]};
  }
  return least;
}

StaticFailure compressed(const StaticCase& at, const NodeTension& least) {
  const bool away = dragging_direction(at.model.description) > 0.0;
  return {
      "the line is in compression",
      shown(least.from_top, "m", 1) + " from the tensioner",
      fmt::format("{} at the tensioner leave a tension of {} there: {}; hold more tension at the tensioner, or less "
                  "pipe out",
                  shown(at.target.value, "N", 1), shown(least.tension, "N", 1),
                  away ? "the pipe slides down the seabed by itself, or hangs heavier than it is held"
                       : "friction of the seabed takes more than is pulled"),
      false,
      {},
      FailureKind::tension_too_low};
}

}  // namespace

std::optional<StaticFailure> check_dragged(StaticCase& at) {
  constexpr double kNone = 1e-6;  // of the tension at the tensioner
  if (!is_dragged(at.model.description)) return std::nullopt;
  const NodeTension least = smallest_tension(at);
  if (least.tension < -kNone * at.target.value) return compressed(at, least);
  const double out = at.system.mesh().s[cable_elements(at.system.mesh())];
  const std::optional<double>& given = at.model.description.operation.lay.cable->length;
  if (!given || out <= *given) return std::nullopt;
  return StaticFailure{"the cable does not reach", "from the head to the winch",
                       fmt::format("it takes {} of cable, the winch has {} (operation.cable.length)",
                                   shown(out, "m", 1), shown(*given, "m", 1))};
}

bool reach_winch(StaticCase& at, const LinePast& past) {
  if (!is_dragged(at.model.description)) return true;
  double reach_by_length = 1.0;  // metres that the end goes on per metre of cable, from the last two lengths
  double missing = short_of_winch(at);
  for (int i = 0; i < kMaxChanges && std::abs(missing) > kAtWinch; ++i) {
    const double longer = missing / reach_by_length;
    if (!change_length(at, past, longer)) return false;
    const double before = std::exchange(missing, short_of_winch(at));
    reach_by_length = std::clamp((before - missing) / longer, 0.3, 3.0);
  }
  return std::abs(missing) <= kAtWinch;
}

}  // namespace overbend

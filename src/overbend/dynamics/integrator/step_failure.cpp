#include "dynamics/integrator/step_failure.h"

#include <fmt/format.h>

#include "base/shown_unit.h"

namespace overbend {
namespace {

/// Label of a free body, by its number among the free bodies.
std::string body_label(const System& system, int number) {
  const int body = free_bodies(system)[static_cast<std::size_t>(number)];
  const bool hinged = system.bodies[static_cast<std::size_t>(body)].free->hinge.has_value();
  return hinged ? "the moments about the stinger's hinge" : "the forces on the hull";
}

std::string node_label(const System& system, std::size_t line, int node) {
  const std::vector<double>& s = system.lines[line].mesh.s;
  const double arc_length = s[static_cast<std::size_t>(node)];
  if (system.lines[line].role == LineRole::pipe) return fmt::format("{} from the anchor", shown(arc_length, "m", 3));
  return fmt::format("line '{}', {} from its first end", system.lines[line].name,
                     shown(arc_length - s.front(), "m", 3));
}

}  // namespace

StaticFailure step_failure(const StepReport& report, const System& system, double time) {
  const auto [line, node] = report.worst_place;
  const std::string place =
      line == kBodyPlace ? body_label(system, node) : node_label(system, static_cast<std::size_t>(line), node);
  return {"the time step cannot be solved", fmt::format("at t = {:.6f} s, {}", time, place),
          report.end == StepStatus::singular ? "the equations have no solution there"
                                             : "the forces do not balance even with the minimum step"};
}

}  // namespace overbend

#include "statics/recovery/recovery_target.h"

#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"
#include "statics/solver/anchored_lay.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

constexpr double kWorthSaying = 1e-3;  ///< Relative to the target; with suitable meshes results miss it by 1e-6.

}  // namespace

void warn_of_missed_target(StaticResults& results, const Model& model) {
  const Description& d = model.description;
  if (d.tensioner.tension) {
    const double wanted = *d.tensioner.tension;
    if (std::abs(results.top_tension - wanted) > kWorthSaying * wanted) {
      results.findings.push_back(Finding{
          FindingCode::tension_target_missed,
          fmt::format("the tension at the tensioner is {}, {} was specified: the elements are too long for such a "
                      "sharp bend; look for a box off the line of the pipe, or reduce analysis.mesh.overbend_element",
                      shown(results.top_tension, "N", 2), shown(wanted, "N", 2))}
                                     .on("tensioner")
                                     .with("tension", results.top_tension, "N"));
    }
  } else if (d.pipe.anchor) {
    const double wanted = *d.pipe.anchor, reached = results.stations.front().astern;
    if (std::abs(reached - wanted) > kWorthSaying * std::abs(wanted)) {
      results.findings.push_back(Finding{FindingCode::anchor_target_missed,
                                         fmt::format("the anchor is {} astern of the stern shoe, {} was specified",
                                                     shown(reached, "m", 2), shown(wanted, "m", 2))}
                                     .with("distance", reached, "m"));
    }
  }
}

std::optional<double> tension_per_anchor_distance(const Model& model, const StaticSolution& solution) {
  StaticSystem system = system_with_history(model, solution.mesh, solution.past);
  system.evaluate(solution.state, true);
  system.hold(true);
  if (!system.factor(solution.state, find_target(model.description))) return std::nullopt;
  std::vector<double> change(solution.state.q.size(), 0.0);
  double far_force = 1.0;  // on entry: the required change of the distance
  system.solve(change, far_force);
  const std::size_t top = change.size() - 3;
  const Vec3 tangent(Eigen::Map<const Vec3>(solution.state.q.data() + top));
  const Vec3 turned(Eigen::Map<const Vec3>(change.data() + top));
  return system.elements().EA[static_cast<std::size_t>(system.mesh().elements() - 1)] *
         tangent.normalized().dot(turned);
}

void note_sensitive_tension(StaticResults& results, const Model& model, const StaticSolution& solution) {
  constexpr double kLength = 0.01;  // [m]
  if (!is_anchored(model)) return;
  const std::optional<double> slope = tension_per_anchor_distance(model, solution);
  if (!slope) return;
  const double change = std::abs(*slope) * kLength;
  results.assumptions.push_back(
      {AssumptionRank::other, fmt::format("the tension follows from pipe.length and pipe.anchor, which are taken as "
                                          "exact: an error of {} in either changes the tension by {} ({:.2g} %)",
                                          shown_digits(kLength, section_length(), 3), shown_digits(change, "N", 3),
                                          100.0 * change / results.top_tension)});
}

}  // namespace overbend

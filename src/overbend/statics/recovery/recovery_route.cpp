#include "statics/recovery/recovery_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "statics/solver/steady_laying.h"

namespace overbend {
namespace {

constexpr double kNoSideLoad = 1e-6;  ///< Relative to the line's weight: rounding, or negligible.

/// Finds offsets and slip of the pipe on the bed.
void find_offsets(RouteResults& route, const StaticResults& results, const StaticSystem& system,
                  const LineState& state) {
  const LineMesh& mesh = system.mesh();
  const LineEnvironment& env = system.environment();
  const Vec3 astern = system.plane().astern_W;
  for (int e = 0; e < mesh.elements(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    for (int point = 0; point < kGaussPoints; ++point) {
      const Vec3 r = centreline(q, kGaussXi[point], mesh.length[i]).r;
      const GroundPoint ground = ground_at(env, r);
      const double normal = env.bed_stiffness * (system.elements().radius[i] - ground.clearance);
      if (normal <= 0.0) continue;
      // beyond the elastic displacement under its own weight: at light contact the smallest side load moves it
      const double weight = system.elements().weight[i] - system.elements().buoyancy[i];
      const double limit = env.bed_friction_lateral * std::max(normal, weight);
      if (env.bed_stick * std::abs(ground.off_route) > limit * (1.0 + 1e-9)) {
        route.slid_length += kGaussWeight[point] * mesh.length[i];
      }
      const double offset = system.plane().route.offset(r);
      if (std::abs(offset) > std::abs(route.max_offset)) {
        route.max_offset = offset;
        route.offset_x = (r - results.stern_shoe_W).dot(astern);
      }
    }
  }
}

void warn(StaticResults& results, const Model& model, const LayRoute& drawn) {
  constexpr double kMiss = 0.01;  // [m]
  const RouteResults& route = *results.route;
  const double far_offset = drawn.offset(results.anchor_W);
  if (drawn.straight() && lays_steadily(model) && std::abs(route.laid_offset - far_offset) > kMiss) {
    results.findings.push_back(
        Finding{FindingCode::steady_laying_not_found,
                fmt::format("steady laying: no laid line was found; the pipe touches down {} from the line on which it "
                            "lies, as if it was pulled across after laying",
                            shown(std::abs(route.laid_offset - far_offset), "m", 2))}
            .with("offset", std::abs(route.laid_offset - far_offset), "m"));
  }
  if (!route.holds) {
    results.findings.push_back(Finding{
        FindingCode::route_not_held,
        fmt::format("the route does not hold: its bend has a radius of {}, bottom tension and lateral friction hold "
                    "{}; the pipe has slid sideways over {} of its length and lies up to {} off the route",
                    shown(route.radius, "m", 0),
                    route.min_stable_radius > 0.0 ? shown(route.min_stable_radius, "m", 0) : "none",
                    shown(route.slid_length, "m", 0), shown(std::abs(route.max_offset), "m", 2))}
                                   .with("radius", route.radius, "m")
                                   .with("slid_length", route.slid_length, "m"));
  }
}

}  // namespace

void recover_route(StaticResults& results, const StaticSystem& system, const LineState& state) {
  const Model& model = system.model();
  const LayRoute& drawn = system.plane().route;
  const Vec3 port = system.plane().port_W;
  RouteResults route;
  route.side_load_bed = -(results.sum_seabed + results.anchor_reaction).dot(port);
  route.side_load_supports = -(results.sum_rollers + results.top_reaction).dot(port);
  const double side = std::max(std::abs(route.side_load_bed), std::abs(route.side_load_supports));
  if (drawn.straight() && side < kNoSideLoad * results.total_weight) return;
  const double touchdown = drawn.distance(results.touchdown.p_W);
  const double sharpest = drawn.max_curvature_beyond(touchdown);
  route.radius = sharpest > 0.0 ? 1.0 / sharpest : 0.0;
  const double hold = model.seabed.friction_lateral * model.pipe_section().weight_submerged;
  if (hold > 0.0) route.min_stable_radius = std::max(0.0, results.bottom_tension) / hold;
  route.holds = sharpest == 0.0 || (hold > 0.0 && route.radius >= route.min_stable_radius);
  route.laid_offset = drawn.offset(results.touchdown.p_W);
  find_offsets(route, results, system, state);
  results.route = route;
  warn(results, model, drawn);
}

}  // namespace overbend

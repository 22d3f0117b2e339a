#include "dynamics/setup/initial_jump.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"
#include "model/bodies.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

namespace {

Vec3 stern_shoe_position(const VesselDescription& vessel) {
  return {vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z};
}

/// The stern shoe at t = 0 of a prescribed motion without build-up; empty otherwise.
std::optional<PointMotion> initial_shoe_motion(const Model& model) {
  const Description& d = model.description;
  if (d.dynamics->build_up > 0.0 || d.vessel.motion == VesselMotion::coupled) return std::nullopt;
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, dynamic_options(model).seed);
  return point_motion(vessel_motion(make_vessel_motion(model, sea), 0.0, BuildUp{}), stern_shoe_position(d.vessel));
}

}  // namespace

double initial_shoe_jump(const Model& model) {
  const std::optional<PointMotion> shoe = initial_shoe_motion(model);
  if (!shoe) return 0.0;
  const VesselPose& mean = model.mean_pose;
  return (shoe->place - (mean.p_WV + mean.R_WV * stern_shoe_position(model.description.vessel))).norm();
}

double initial_shoe_speed(const Model& model) {
  const std::optional<PointMotion> shoe = initial_shoe_motion(model);
  return shoe ? shoe->velocity.norm() : 0.0;
}

double initial_line_end_jump(const Model& model, const DynamicOptions& options) {
  const Description& d = model.description;
  if (options.build_up > 0.0 || d.lines.empty()) return 0.0;
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, options.seed);
  std::vector<RigidMotion> bodies(1);
  if (d.vessel.motion != VesselMotion::coupled) {
    bodies.front() = vessel_motion(make_vessel_motion(model, sea), 0.0, BuildUp{});
  }
  for (const BodyDescription& body : d.bodies) {
    bodies.push_back(vessel_motion(make_body_motion(body.hull, body_pose(body), sea), 0.0, BuildUp{}));
  }
  double max_jump = 0.0;
  for (const FreeLineDescription& line : d.lines) {
    for (const LineEndDescription* end : {&line.first, &line.second}) {
      if (d.vessel.motion == VesselMotion::coupled && is_on_vessel(*end)) continue;  // moves with the hull
      const double leap =
          end->kind == LineEndKind::body
              ? (point_motion(bodies[body_index(d, end->body)], end->at).place - end_place(model, *end)).norm()
              : std::abs(std::sin(end->phase)) * (end->period > 0.0 ? end->amplitude.norm() : 0.0);
      max_jump = std::max(max_jump, leap);
    }
  }
  return max_jump;
}

}  // namespace overbend

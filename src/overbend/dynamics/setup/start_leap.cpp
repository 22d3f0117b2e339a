#include "dynamics/setup/start_leap.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"
#include "model/bodies.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

namespace {

Vec3 shoe_of(const VesselDescription& vessel) {
  return {vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z};
}

/// The stern shoe at t = 0 of a told motion without build-up; none where there is no such.
std::optional<PointMotion> shoe_at_start(const Model& model) {
  const Description& d = model.description;
  if (d.dynamics->build_up > 0.0 || d.vessel.motion == VesselMotion::coupled) return std::nullopt;
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, dynamic_options(model).seed);
  return point_motion(vessel_motion(make_vessel_motion(model, sea), 0.0, BuildUp{}), shoe_of(d.vessel));
}

}  // namespace

double leap_at_start(const Model& model) {
  const std::optional<PointMotion> shoe = shoe_at_start(model);
  if (!shoe) return 0.0;
  const VesselPose& mean = model.mean_pose;
  return (shoe->place - (mean.p_WV + mean.R_WV * shoe_of(model.description.vessel))).norm();
}

double speed_at_start(const Model& model) {
  const std::optional<PointMotion> shoe = shoe_at_start(model);
  return shoe ? shoe->velocity.norm() : 0.0;
}

double line_leap_at_start(const Model& model, const DynamicOptions& options) {
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
  double largest = 0.0;
  for (const FreeLineDescription& line : d.lines) {
    for (const LineEndDescription* end : {&line.first, &line.second}) {
      if (d.vessel.motion == VesselMotion::coupled && is_on_vessel(*end)) continue;  // it goes with the hull
      const double leap =
          end->kind == LineEndKind::body
              ? (point_motion(bodies[body_index(d, end->body)], end->at).place - end_place(model, *end)).norm()
              : std::abs(std::sin(end->phase)) * (end->period > 0.0 ? end->amplitude.norm() : 0.0);
      largest = std::max(largest, leap);
    }
  }
  return largest;
}

}  // namespace overbend

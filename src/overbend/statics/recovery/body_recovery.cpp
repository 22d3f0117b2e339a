#include "statics/recovery/body_recovery.h"

#include <cmath>
#include <numbers>

#include "hull/pose_shift.h"
#include "model/bodies.h"
#include "system/body_forces.h"

namespace overbend {
namespace {

/// Azimuth of the bow, 0 to 2 pi [rad].
double compute_heading(const VesselPose& pose) {
  const double azimuth = std::atan2(pose.R_WV(0, 0), pose.R_WV(1, 0));
  return azimuth < 0.0 ? azimuth + 2.0 * std::numbers::pi : azimuth;
}

BodyResult recover_body(const std::string& name, const VesselPose& drawn, std::size_t index, const Assembly& assembly,
                        const SystemState& state) {
  const VesselPose& pose = assembly.surroundings().bodies[index].pose;
  const auto shift = shift_between(drawn, pose);
  const ForceAndMoment lines = force_on_body(assembly, state, static_cast<int>(index));
  BodyResult body;
  body.name = name;
  body.floats = assembly.system().bodies[index].free.has_value();
  body.place = pose.p_WV;
  body.heading = compute_heading(pose);
  body.surge = shift[0];
  body.sway = shift[1];
  body.heave = shift[2];
  body.roll = shift[3];
  body.pitch = shift[4];
  body.yaw = shift[5];
  body.force = lines.force;
  body.moment = lines.moment;
  return body;
}

}  // namespace

std::vector<BodyResult> recover_bodies(const Model& model, const Assembly& assembly, const SystemState& state) {
  std::vector<BodyResult> bodies;
  if (assembly.system().bodies[kVessel].free) {
    bodies.push_back(recover_body(kVesselName, model.nominal_pose, kVessel, assembly, state));
  }
  for (std::size_t i = 0; i < model.description.bodies.size(); ++i) {
    const BodyDescription& body = model.description.bodies[i];
    bodies.push_back(recover_body(body.name, body_pose(body), i + 1, assembly, state));
  }
  return bodies;
}

}  // namespace overbend

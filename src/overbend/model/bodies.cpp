#include "model/bodies.h"

#include <algorithm>

#include "base/ranges.h"
#include "base/require.h"

namespace overbend {

std::size_t body_index(const Description& description, const std::string& name) {
  if (name == kVesselName) return 0;
  const auto found = ranges::find(description.bodies, name, &BodyDescription::name);
  require(found != description.bodies.end(), "a body that an end of a line names is one of the model's");
  return 1 + static_cast<std::size_t>(found - description.bodies.begin());
}

VesselPose body_pose(const BodyDescription& body) {
  return {body.place, vessel_axes(body.hull.heading, body.hull.trim, body.hull.heel)};
}

std::vector<VesselPose> body_poses(const Model& model) {
  std::vector<VesselPose> poses = {model.mean_pose};
  for (const BodyDescription& body : model.description.bodies) poses.push_back(body_pose(body));
  return poses;
}

}  // namespace overbend

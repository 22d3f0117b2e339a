/// Bodies to which ends of lines are attached, by name: the vessel, then those of the model in file order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

namespace overbend {

/// Returns the index of the body with this name: 0 for the vessel, from 1 for the others. The name must exist.
std::size_t body_index(const Description& description, const std::string& name);

/// Returns the pose of a body as described, world frame W.
VesselPose body_pose(const BodyDescription& body);

/// Returns the mean poses of all bodies, the vessel first, W.
std::vector<VesselPose> body_poses(const Model& model);

}  // namespace overbend

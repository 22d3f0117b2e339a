/// The bodies that ends of lines are on, by their names: the vessel, then those of the model in their order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

namespace overbend {

/// 0 for the vessel, from 1 on for the others. The name is one of them.
std::size_t body_index(const Description& description, const std::string& name);

/// Where a body lies as described.
VesselPose body_pose(const BodyDescription& body);

/// Mean poses of all bodies, the vessel first.
std::vector<VesselPose> body_poses(const Model& model);

}  // namespace overbend

/// Inclination of roller boxes in the frame in which results show their positions.
#pragma once

#include "model/model.h"

namespace overbend {

/// Returns the angle of the box axis from horizontal, positive dipping astern, for a vessel pose that includes trim and
/// heel [rad].
double box_dip(const VesselPose& pose, const SupportBox& box);

}  // namespace overbend

/// Inclination of roller boxes in the frame in which their places are shown.
#pragma once

#include "model/model.h"

namespace overbend {

/// Of the box axis from horizontal, positive dipping astern, on a vessel in this pose with its trim and heel [rad].
double box_dip(const VesselPose& pose, const SupportBox& box);

}  // namespace overbend

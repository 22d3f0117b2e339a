/// How far a body lies from another pose of its.
#pragma once

#include <array>

#include "model/model.h"

namespace overbend {

inline constexpr std::size_t kVesselFreedoms = 6;

/// Surge, sway, heave [m], roll, pitch, yaw [rad] of a pose from another, along the axes of that; see VesselResult.
std::array<double, kVesselFreedoms> shift_between(const VesselPose& from, const VesselPose& to);

}  // namespace overbend

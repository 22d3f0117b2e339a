/// Displacement of a body between two poses.
#pragma once

#include <array>

#include "model/model.h"

namespace overbend {

inline constexpr std::size_t kVesselFreedoms = 6;

/// Returns surge, sway, heave [m], roll, pitch, yaw [rad] from the first pose to the second, along the axes of the
/// first; see VesselResult.
std::array<double, kVesselFreedoms> shift_between(const VesselPose& from, const VesselPose& to);

}  // namespace overbend

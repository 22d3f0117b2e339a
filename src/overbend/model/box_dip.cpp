#include "model/box_dip.h"

#include <algorithm>
#include <cmath>

namespace overbend {

double box_dip(const VesselPose& pose, const SupportBox& box) {
  return -std::asin(std::clamp(direction_from_ramp(pose, box.direction_S).z(), -1.0, 1.0));
}

}  // namespace overbend

#include "hull/pose_shift.h"

#include "hull/body_kinematics.h"

namespace overbend {

std::array<double, kVesselFreedoms> shift_between(const VesselPose& from, const VesselPose& to) {
  const Vec6 u = make_coordinates(from.R_WV.transpose() * Vec3(to.p_WV - from.p_WV), from.R_WV.transpose() * to.R_WV);
  const Vec3 ahead = Vec3(from.R_WV(0, 0), from.R_WV(1, 0), 0.0).normalized();  // level, independent of heel and trim
  const Vec3 shift = to.p_WV - from.p_WV;
  return {shift.dot(ahead), shift.dot(Vec3::UnitZ().cross(ahead)), shift.z(), u(3), u(4), u(5)};
}

}  // namespace overbend

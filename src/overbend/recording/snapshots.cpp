#include "recording/snapshots.h"

#include <algorithm>
#include <cmath>

namespace overbend {

std::int64_t snapshot_stride(const DynamicOptions& options) {
  constexpr double kMaxSnapshots = 2400.0;  // per run
  const double rows = options.duration / options.output_step;
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(rows / kMaxSnapshots)));
}

double* put_pose(const VesselPose& pose, double* out) {
  for (int i = 0; i < 3; ++i) *out++ = pose.p_WV(i);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) *out++ = pose.R_WV(i, j);
  }
  return out;
}

}  // namespace overbend

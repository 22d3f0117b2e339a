/// Layout and interval of the snapshots of a run.
#pragma once

#include <cstdint>

#include "dynamics/integrator/dynamics.h"
#include "model/model.h"

namespace overbend {

inline constexpr std::size_t kPoseNumbers = 12;

/// Returns the number of rows between snapshots.
std::int64_t snapshot_stride(const DynamicOptions& options);

/// Writes p_WV and R_WV by rows to `out`; returns the end.
double* put_pose(const VesselPose& pose, double* out);

}  // namespace overbend

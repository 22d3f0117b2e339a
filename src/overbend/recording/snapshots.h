/// What snapshots of all runs have in common.
#pragma once

#include <cstdint>

#include "dynamics/integrator/dynamics.h"
#include "model/model.h"

namespace overbend {

inline constexpr std::size_t kPoseNumbers = 12;

/// Rows from one snapshot of a run to the next.
std::int64_t snapshot_stride(const DynamicOptions& options);

/// Puts p_WV and R_WV by rows to `out`; returns where they end.
double* put_pose(const VesselPose& pose, double* out);

}  // namespace overbend

/// Limits, line search and damping of Newton steps, shared by the equations of the pipe and those of a single line.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/block_tridiagonal.h"
#include "system/line_mesh.h"

namespace overbend {

inline constexpr double kMaxTangentRotation = 0.35;  ///< Maximum rotation of a node's tangent per step [rad].
inline constexpr double kDampingStep = 4.0;          ///< Factor by which the damping is raised or lowered.
inline constexpr double kMaxDamping = 1e8;           ///< [N/m2]
inline constexpr double kMaxRemainingWork = 0.8;  ///< A step is accepted when the remaining work along it has fallen to
                                                  ///< this share.

/// Maximum displacement of a node per step [m].
inline double max_node_move(const LineMesh& mesh) {
  return 2.0 + 0.02 * mesh.total_length();
}

/// Share of the step that keeps it within the limits.
inline double step_limit(const std::vector<double>& dq, double move) {
  double share = 1.0;
  for (std::size_t i = 0; i < dq.size(); i += 3) {
    const double size = std::sqrt(dq[i] * dq[i] + dq[i + 1] * dq[i + 1] + dq[i + 2] * dq[i + 2]);
    const double limit = i % 6 == 0 ? move : kMaxTangentRotation;
    share = size * share > limit ? limit / size : share;
  }
  return share;
}

/// Adds viscous damping of a step, per length [N/m2].
inline void add_step_damping(const LineMesh& mesh, double damping, BlockTridiagonal& tangent) {
  if (damping <= 0.0) {
    return;
  }
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double h = mesh.length[static_cast<std::size_t>(std::min(node, mesh.elements() - 1))];
    for (int i = 0; i < kNodeDofs; ++i) {
      tangent.diag(node)[i * kRowWidth + i] += damping * h * (i < 3 ? 1.0 : h * h / 12.0);
    }
  }
}

/// Finds a share in (0, limit] at which the work of the unbalanced forces along the step, `work_at(share)`, is close
/// enough to zero; the last call was at that share (Crisfield 1991, section 9.2).
template <class WorkAt>
double search_along(const WorkAt& work_at, double work_start, double limit) {
  double low = 0.0, work_low = work_start;
  double share = limit;
  double work = work_at(share);
  if (std::abs(work) <= kMaxRemainingWork * std::abs(work_start) || work * work_start > 0.0) {
    return share;  // accepted, or still downhill at the end of the step
  }
  double high = share, work_high = work;
  for (int i = 0; i < 8 && std::abs(work) > kMaxRemainingWork * std::abs(work_start); ++i) {
    const double secant = low + (high - low) * work_low / (work_low - work_high);
    share = std::clamp(secant, low + 0.1 * (high - low), low + 0.9 * (high - low));
    work = work_at(share);
    const bool same_side = work * work_start > 0.0;
    (same_side ? low : high) = share;
    (same_side ? work_low : work_high) = work;
  }
  return share;
}

}  // namespace overbend

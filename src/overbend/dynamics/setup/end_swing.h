/// Harmonic motion of line ends about their positions.
#pragma once

#include <vector>

#include "model/description/line_description.h"
#include "system/system.h"

namespace overbend {

/// Motion of one attachment.
struct EndSwing {
  std::size_t attachment = 0;
  Vec3 amplitude = Vec3::Zero();  ///< [m]
  double omega = 0.0;             ///< [rad/s]
  double phase = 0.0;             ///< Phase of the sine at t = 0 [rad].
};

/// Returns the motions of line ends whose attachments begin at `first`, two per line of the system; `of_system` maps
/// each described line to its index in the system.
std::vector<EndSwing> end_swings(const std::vector<FreeLineDescription>& lines, const std::vector<int>& of_system,
                                 std::size_t first);

/// Adds the motions to ends at their mean positions, ramped over `build_up` seconds before t = 0.
void swing_ends(const std::vector<EndSwing>& swings, double time, double build_up, std::vector<EndMotion>& ends);

}  // namespace overbend

/// Ends of lines that swing about their places in a harmonic motion of their own.
#pragma once

#include <vector>

#include "model/description/line_description.h"
#include "system/system.h"

namespace overbend {

/// The motion of one attachment.
struct EndSwing {
  std::size_t attachment = 0;
  Vec3 amplitude = Vec3::Zero();  ///< [m]
  double omega = 0.0;             ///< [rad/s]
  double phase = 0.0;             ///< Of the sine at t = 0 [rad].
};

/// Of the ends of lines whose attachments stand from `first` on, two for every line of the system; `of_system` says
/// which each line is there.
std::vector<EndSwing> end_swings(const std::vector<FreeLineDescription>& lines, const std::vector<int>& of_system,
                                 std::size_t first);

/// Adds the motion to ends that stand in their places, brought in over `build_up` seconds before t = 0.
void swing_ends(const std::vector<EndSwing>& swings, double time, double build_up, std::vector<EndMotion>& ends);

}  // namespace overbend

/// Prescribed motion of a vessel whose mean position moves ahead.
#pragma once

#include <span>

#include "mechanics/move_profile.h"
#include "mechanics/vessel_motion.h"

namespace overbend {

/// Advance of the mean position along the lay route from the described one. Waves are evaluated at the current position
/// of the vessel: the phase of a term decreases by its wave number times the advance, and its frequency shifts with the
/// speed.
struct MoveAhead {
  MoveState at;
  /// Wave numbers in that direction, by term of the motion [1/m]; empty if the terms do not belong to waves.
  std::span<const double> wave_numbers;
};

/// Returns the horizontal unit vector towards the bow of a pose, W: for the nominal pose, ahead along the lay route.
Vec3 level_ahead(const VesselPose& mean);

/// Returns the wave numbers ahead of the terms that RAOs make from a sea [1/m]; empty if terms do not belong to waves.
std::vector<double> wave_numbers_ahead(const VesselMotionModel& motion, const Sea& sea);

/// Returns the motion at time `t` [s] with the vessel moved ahead; else as vessel_motion without a move. Does not
/// allocate.
RigidMotion vessel_motion(const VesselMotionModel& motion, const MoveAhead& move, double t, const BuildUp& b);

}  // namespace overbend

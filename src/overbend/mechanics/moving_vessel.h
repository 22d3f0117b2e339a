/// The told motion of a vessel whose mean place moves ahead.
#pragma once

#include <span>

#include "mechanics/move_profile.h"
#include "mechanics/vessel_motion.h"

namespace overbend {

/// How far the mean place has moved ahead along the lay route since it was as described. Waves are met where the
/// vessel then is: the phase of a term turns back by its wave number times the way, its frequency shifts with the
/// speed.
struct MoveAhead {
  WayPoint at;
  std::span<const double> wave_numbers;  ///< That way, by the terms of the motion [1/m]; none: of no wave.
};

/// Horizontal unit vector towards the bow of a pose, W: of the drawn one, ahead along the lay route.
Vec3 level_ahead(const VesselPose& mean);

/// Wave numbers ahead of the terms that RAOs make of a sea [1/m]; none where terms are not those of waves.
std::vector<double> wave_numbers_ahead(const VesselMotionModel& motion, const Sea& sea);

/// As vessel_motion without a move. Does not allocate.
RigidMotion vessel_motion(const VesselMotionModel& motion, const MoveAhead& move, double t, const BuildUp& b);

}  // namespace overbend

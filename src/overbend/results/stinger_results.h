/// A stinger that turns, at rest. SI; forces in the vertical plane of the barge.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

struct StingerTankResult {
  std::string name;
  double weight = 0.0;     ///< With ballast [N].
  double buoyancy = 0.0;   ///< Of the part under water [N].
  double at_x = 0.0;       ///< Where that acts, astern of the stern shoe [m].
  double at_z = 0.0;       ///< Above the stern shoe there [m].
  double submerged = 0.0;  ///< Fraction of its length under water [-].
  double draught = 0.0;    ///< Of its deeper end below the water [m].
};

/// One section on its hinge.
struct StingerSectionResult {
  std::string name;
  double angle = 0.0;           ///< Positive when the tip goes down from where it is drawn [rad].
  bool floats = false;          ///< The forces on it decide its angle.
  Vec3 hinge_W = Vec3::Zero();  ///< [m]
  double roller_moment =
      0.0;  ///< Of the pipe on its rollers about the hinge, positive when it pushes the tip down [N m].
  double hinge_longitudinal = 0.0;  ///< On the section, level astern [N].
  double hinge_vertical = 0.0;      ///< On the section, up [N].
  double hinge_force = 0.0;         ///< Magnitude [N].
  double stop_moment = 0.0;         ///< On the section, of a stop or of what holds it, tip down positive [N m].
  bool at_stop = false;
  double friction_moment = 0.0;             ///< That the hinge bears at most before the section turns [N m].
  double angle_up = 0.0, angle_down = 0.0;  ///< Between which hinge friction may leave it [rad].
  double stiffness = 0.0;                   ///< Fall of the moment with the angle, pipe included [N m/rad].
  double natural_period = 0.0;              ///< Of small motion about the hinge, 0 where nothing brings it back [s].
  double draught = 0.0;                     ///< Of its deepest tank below the water; 0 without [m].
  Vec3 tip_W = Vec3::Zero();                ///< Top of its last roller [m].
  std::vector<StingerTankResult> tanks;
};

}  // namespace overbend

/// Static results of a stinger on hinges. SI; forces in the vertical plane of the vessel.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

struct StingerTankResult {
  std::string name;
  double weight = 0.0;     ///< With ballast [N].
  double buoyancy = 0.0;   ///< Buoyancy of the submerged part [N].
  double at_x = 0.0;       ///< Centre of buoyancy, astern of the stern shoe [m].
  double at_z = 0.0;       ///< Centre of buoyancy, above the stern shoe [m].
  double submerged = 0.0;  ///< Submerged fraction of the length [-].
  double draught = 0.0;    ///< Depth of its deeper end below the water [m].
};

/// One section on its hinge.
struct StingerSectionResult {
  std::string name;
  double angle = 0.0;               ///< Rotation from the nominal position, positive for tip down [rad].
  bool floats = false;              ///< True if the angle follows from equilibrium.
  Vec3 hinge_W = Vec3::Zero();      ///< [m]
  double roller_moment = 0.0;       ///< Moment of the pipe on its rollers about the hinge, positive for tip down [N m].
  double hinge_longitudinal = 0.0;  ///< On the section, level astern [N].
  double hinge_vertical = 0.0;      ///< On the section, up [N].
  double hinge_force = 0.0;         ///< Magnitude [N].
  double stop_moment = 0.0;         ///< Moment of a stop or a holding device on the section, positive for tip down [N
                                    ///< m].
  bool at_stop = false;
  double friction_moment = 0.0;             ///< Moment capacity of hinge friction [N m].
  double angle_up = 0.0, angle_down = 0.0;  ///< Range of angles due to hinge friction [rad].
  double stiffness = 0.0;                   ///< Restoring moment per angle, including the pipe [N m/rad].
  double natural_period = 0.0;              ///< Natural period of small rotations about the hinge, 0 without restoring
                                            ///< moment [s].
  double draught = 0.0;                     ///< Depth of its deepest tank below the water; 0 without tanks [m].
  Vec3 tip_W = Vec3::Zero();                ///< Top of its last roller [m].
  std::vector<StingerTankResult> tanks;
};

}  // namespace overbend

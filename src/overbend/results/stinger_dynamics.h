/// What a dynamic analysis hands on of a stinger that turns on its hinges: plain data, SI units. Statistics count from
/// t = 0 to the end of the run.
#pragma once

#include <cstdint>
#include <string>

#include "results/spread.h"

namespace overbend {

/// One section over time. Signs as in StingerSectionResult.
struct StingerSectionDynamics {
  std::string name;
  Spread angle;                ///< Positive when the tip goes down from where it is drawn [rad].
  Spread hinge_longitudinal;   ///< On the section, level astern [N].
  Spread hinge_vertical;       ///< On the section, up [N].
  Spread hinge_force;          ///< Magnitude [N].
  Spread stop_moment;          ///< On the section, positive when it pushes the tip down [N m].
  Spread draught;              ///< Of the deepest end of its tanks below the surface there [m].
  double start_angle = 0.0;    ///< At the start of the run [rad].
  double fastest = 0.0;        ///< Largest rate of turning either way [rad/s].
  double time_at_stop = 0.0;   ///< [s]
  std::int64_t stop_hits = 0;  ///< How often it ran into a stop.
};

}  // namespace overbend

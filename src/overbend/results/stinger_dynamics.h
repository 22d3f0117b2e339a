/// Dynamic results of a stinger on hinges: plain data, SI units. Statistics count from t = 0 to the end of the run.
#pragma once

#include <cstdint>
#include <string>

#include "results/summary_statistics.h"

namespace overbend {

/// One section over time. Signs as in StingerSectionResult.
struct StingerSectionDynamics {
  std::string name;
  SummaryStatistics angle;               ///< Rotation from the nominal position, positive for tip down [rad].
  SummaryStatistics hinge_longitudinal;  ///< On the section, level astern [N].
  SummaryStatistics hinge_vertical;      ///< On the section, up [N].
  SummaryStatistics hinge_force;         ///< Magnitude [N].
  SummaryStatistics stop_moment;         ///< On the section, positive for tip down [N m].
  SummaryStatistics draught;             ///< Depth of the deepest end of its tanks below the local water surface [m].
  double start_angle = 0.0;              ///< At the start of the run [rad].
  double fastest = 0.0;                  ///< Maximum rate of rotation in either direction [rad/s].
  double time_at_stop = 0.0;             ///< [s]
  std::int64_t stop_hits = 0;            ///< Number of impacts on a stop.
};

}  // namespace overbend

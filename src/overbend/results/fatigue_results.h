/// Fatigue of girth welds while the pipe is laid: plain data, SI.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"

namespace overbend {

/// A spot of the weld along the line; arrays are by station of the dynamic results.
struct FatigueSpot {
  std::string name, curve;
  double stress_factor = 1.0;  ///< Hot spot over nominal stress.
  std::vector<double> rate;    ///< Largest damage rate of the points round the section, 1/s.
  std::vector<double> cycles;  ///< Rate of cycles, 1/s.
  std::vector<double> range;   ///< Stress range that gives the same damage at that rate of cycles [Pa].
  double path_damage = 0.0;    ///< Of a weld on its way from the tensioner to the bed.
  double worst_rate = 0.0;     ///< Largest along the line [1/s].
  double worst_s = 0.0;        ///< Where, from the anchor [m].
  double standby = 0.0;        ///< Time that the pipe may wait as it lies until the budget is used up [s].
};

struct FatigueResults {
  std::vector<FatigueSpot> spots;
  double budget = 0.0, design_factor = 1.0;
  double lay_rate = 0.0;  ///< Mean, by joint, weld time and move time [m/s].
  Assumptions assumptions;
};

}  // namespace overbend

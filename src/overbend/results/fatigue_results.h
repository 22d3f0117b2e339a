/// Fatigue of girth welds during laying: plain data, SI.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"

namespace overbend {

/// A spot of the weld; arrays are by station of the dynamic results.
struct FatigueSpot {
  std::string name, curve;
  double stress_factor = 1.0;  ///< Hot-spot stress over nominal stress.
  std::vector<double> rate;    ///< Maximum damage rate over the points round the section [1/s].
  std::vector<double> cycles;  ///< Rate of cycles [1/s].
  std::vector<double> range;   ///< Equivalent stress range: same damage at that rate of cycles [Pa].
  double path_damage = 0.0;    ///< Damage of a weld on its way from the tensioner to the seabed.
  double worst_rate = 0.0;     ///< Maximum along the line [1/s].
  double worst_s = 0.0;        ///< Arc length of that maximum from the anchor [m].
  double standby = 0.0;        ///< Time that the pipe may stay in this position until the damage budget is used up [s].
};

struct FatigueResults {
  std::vector<FatigueSpot> spots;
  double budget = 0.0, design_factor = 1.0;
  double lay_rate = 0.0;  ///< Mean lay rate from joint length, weld time and move time [m/s].
  Assumptions assumptions;
};

}  // namespace overbend

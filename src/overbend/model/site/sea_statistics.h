/// Height and periods of a sea state from its spectrum.
#pragma once

#include <string>
#include <vector>

#include "model/description/description.h"

namespace overbend {

struct SeaStatistics {
  double hs = 0.0;  ///< 4 sqrt(m0) [m].
  double tp = 0.0;  ///< Period of the maximum density [s].
  double tz = 0.0;  ///< Zero up-crossing period, 2 pi sqrt(m0 / m2) [s].
};

/// Returns the statistics of densities that are linear between the points; zeros without energy.
SeaStatistics sea_statistics(const std::vector<SpectrumPoint>& points);

/// Returns the statistics of a measured elevation: four standard deviations, and the duration over the number of
/// up-crossings of the mean; `tp` is 0.
SeaStatistics record_statistics(const ElevationRecord& record);

/// Returns a text such as "Hs 2.1 m, Tp 8.3 s, Tz 6.2 s".
std::string sea_statistics_label(const std::vector<SpectrumPoint>& points);

}  // namespace overbend

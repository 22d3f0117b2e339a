/// Height and periods of a sea from its spectrum.
#pragma once

#include <string>
#include <vector>

#include "model/description/description.h"

namespace overbend {

struct SeaStatistics {
  double hs = 0.0;  ///< 4 sqrt(m0) [m].
  double tp = 0.0;  ///< Period of the largest density [s].
  double tz = 0.0;  ///< Zero up-crossing period, 2 pi sqrt(m0 / m2) [s].
};

/// Of densities that are linear between the points; zeros where there is no energy.
SeaStatistics sea_statistics(const std::vector<SpectrumPoint>& points);

/// "Hs 2.1 m, Tp 8.3 s, Tz 6.2 s"
std::string sea_statistics_words(const std::vector<SpectrumPoint>& points);

}  // namespace overbend

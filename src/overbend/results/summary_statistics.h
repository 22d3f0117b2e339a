/// Summary statistics of a quantity over time.
#pragma once

namespace overbend {

/// A quantity over time.
struct SummaryStatistics {
  double min = 0.0, max = 0.0, mean = 0.0, std = 0.0;
};

}  // namespace overbend

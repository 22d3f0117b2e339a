/// A quantity over time, in four numbers.
#pragma once

namespace overbend {

/// A quantity over time.
struct Spread {
  double min = 0.0, max = 0.0, mean = 0.0, std = 0.0;
};

}  // namespace overbend

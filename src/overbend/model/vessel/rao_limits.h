/// Response of a free hull in very long waves, for comparison with RAOs and their stated conventions.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/waves/rao_table.h"

namespace overbend {

/// One degree of freedom at one heading, at the lowest frequency of the table.
struct RaoLimitRow {
  double heading = 0.0;       ///< Direction of travel [rad].
  int freedom = 0;            ///< 0 surge to 4 pitch.
  double ratio = 0.0;         ///< Amplitude relative to the water motion: particle orbit, surface height or slope [-].
  double lag = 0.0;           ///< Lag of the table behind the crest at the wave origin, in (-pi, pi] [rad].
  double expected_lag = 0.0;  ///< Lag in long waves [rad].
  bool agrees = true;         ///< Ratio within 0.5 to 2 and lag within 60 deg.
};

struct RaoLimits {
  double omega = 0.0;        ///< Lowest frequency of the table [rad/s].
  double wave_length = 0.0;  ///< [m]
  /// True if the wave is at least four vessels long, so that the comparison is meaningful.
  bool long_enough = false;
  std::vector<RaoLimitRow> rows;
};

/// Compares the lowest frequency with the water motion: heave with the surface, roll and pitch with its slope, surge
/// and sway with the particle orbit averaged over the draught; headings 0, 90 and 180 deg. All in SI.
RaoLimits long_wave_limits(const RaoTable& raos, double vessel_length, double draught, double depth);

/// Returns a sentence for each degree of freedom that disagrees, with its headings; none if the wave is too short for a
/// comparison.
Findings limit_findings(const RaoLimits& limits);

}  // namespace overbend

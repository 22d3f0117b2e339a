/// Tensioner as given in the model file.
#pragma once

#include <optional>

namespace overbend {

enum class Guide { clamped, pinned };
enum class TensionerMode { controlled, locked, constant };

struct TensionerDescription {
  double x = 0.0;        ///< Frame S, pipe axis [m].
  double z = 0.0;        ///< Frame S, pipe axis [m].
  double incline = 0.0;  ///< Inclination of the pipe at the tensioner, positive when it dips astern [rad].
  Guide guide = Guide::clamped;
  std::optional<double> tension;     ///< Target effective tension [N].
  std::optional<double> range_low;   ///< Operational range [N].
  std::optional<double> range_high;  ///< Operational range [N].
  TensionerMode mode = TensionerMode::locked;
  bool mode_assumed = false;           ///< True if the model gives neither mode nor range.
  double delay = 0.0;                  ///< Response delay [s].
  double velocity = 0.0;               ///< Response velocity [m/s].
  std::optional<double> acceleration;  ///< Response acceleration [m/s2].
  std::optional<double> travel;        ///< Travel limit either way [m].
  double found = 0.0;  ///< Without a target tension: last tension found, see update_moment_curvature(); not a key [N].
};

}  // namespace overbend

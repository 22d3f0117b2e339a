/// All roots of a function of one variable in an interval, told from jumps over zero and from gaps in it.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace overbend {

/// A value where the function has one; nothing where it cannot be evaluated.
using ScannedFunction = std::function<std::optional<double>(double)>;

/// Two arguments close by, between which the function changes its sign.
struct Crossing {
  double low = 0.0, high = 0.0;        ///< low < high.
  double at_low = 0.0, at_high = 0.0;  ///< Values there.
  bool jump = false;                   ///< The values do not close up with the arguments.

  /// The end with the value nearer to zero.
  double nearest() const { return std::abs(at_low) <= std::abs(at_high) ? low : high; }
};

struct ScannedPoint {
  double x = 0.0;
  std::optional<double> value;
};

struct RootScan {
  std::vector<Crossing> crossings;   ///< By increasing argument.
  std::vector<ScannedPoint> points;  ///< All that were evaluated, by increasing argument.
};

struct ScanSettings {
  int points = 13;           ///< Of the grid.
  double resolution = 1e-8;  ///< Width at which a bracket is closed, relative to the interval.
  double negligible = 1e-9;  ///< Value taken as zero, relative to the largest on the grid.
  bool both_ends = false;    ///< Whether a bracket is closed also where one end is zero already: for limits.
};

/// Evaluates a grid from `from` to `to`, looks between its points where the values turn towards zero, at the ends also
/// where they begin to, and closes every change of sign by the method of Brent (1973), chapter 4. Roots of even order
/// between points that do not point to them are missed, as are pairs of roots closer than the grid.
RootScan scan_roots(const ScannedFunction& f, double from, double to, const ScanSettings& settings = {});

/// Whether the values that there are never fall, or never rise, over the interval by more than a thousandth of their
/// range.
bool is_monotone(const RootScan& scan);

}  // namespace overbend

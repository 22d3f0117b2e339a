/// All roots of a function of one variable in an interval, distinguished from jumps across zero and from gaps.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace overbend {

/// Returns the value of the function; nothing if it cannot be evaluated.
using ScannedFunction = std::function<std::optional<double>(double)>;

/// Two close arguments between which the function changes sign.
struct Crossing {
  double low = 0.0, high = 0.0;        ///< low < high.
  double at_low = 0.0, at_high = 0.0;  ///< Values at the two arguments.
  bool jump = false;                   ///< True if the values do not converge with the arguments.

  /// Returns the end with the value nearer to zero.
  double nearest() const { return std::abs(at_low) <= std::abs(at_high) ? low : high; }
};

struct ScannedPoint {
  double x = 0.0;
  std::optional<double> value;
};

struct RootScan {
  std::vector<Crossing> crossings;   ///< By increasing argument.
  std::vector<ScannedPoint> points;  ///< All evaluated points, by increasing argument.
};

struct ScanSettings {
  int points = 13;           ///< Number of points of the grid.
  double resolution = 1e-8;  ///< Width at which a bracket is closed, relative to the interval.
  double negligible = 1e-9;  ///< Value taken as zero, relative to the maximum magnitude on the grid.
  bool both_ends = false;    ///< True to close a bracket also if one end is already zero: for limits.
};

/// Evaluates a grid from `from` to `to`, searches between its points where the values turn towards zero, also in the
/// end intervals, and closes every change of sign by the method of Brent (1973), chapter 4. Roots of even order without
/// such an indication on the grid are missed, as are pairs of roots closer than the grid.
RootScan scan_roots(const ScannedFunction& f, double from, double to, const ScanSettings& settings = {});

/// True if the existing values never decrease, or never increase, over the interval by more than a thousandth of their
/// range.
bool is_monotone(const RootScan& scan);

}  // namespace overbend

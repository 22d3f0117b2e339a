/// Numbers in the data of figures.
#pragma once

#include <cmath>

#include "base/json.h"

namespace overbend {

/// Rounds to seven significant digits: a tenth of a millimetre in a kilometre. Values that are not finite, which JSON
/// cannot represent, become 0.
inline double seven_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return 0.0;
  }
  // Powers of ten with negative exponents are inexact and would add digits to large numbers.
  const double digits = 6.0 - std::floor(std::log10(std::abs(value)));
  const double scale = std::pow(10.0, std::abs(digits));
  const double rounded = digits > 0.0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
  return std::isfinite(rounded) ? rounded : 0.0;  // the scale of a number close to zero overflows
}

/// Returns null for a missing value (NaN).
inline Json json_number(double value) {
  if (std::isnan(value)) return nullptr;
  const double rounded = seven_digits(value);
  return rounded == 0.0 ? Json(0) : Json(rounded);
}

}  // namespace overbend

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
  const double scale = std::pow(10.0, 6.0 - std::floor(std::log10(std::abs(value))));
  const double rounded = std::round(value * scale) / scale;
  return std::isfinite(rounded) ? rounded : 0.0;  // the scale of a number close to zero overflows
}

/// Returns null for a missing value (NaN).
inline Json json_number(double value) {
  if (std::isnan(value)) return nullptr;
  const double rounded = seven_digits(value);
  return rounded == 0.0 ? Json(0) : Json(rounded);
}

}  // namespace overbend

/// Sentinels: numbers that instruments and their software write for missing values.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>

namespace overbend {

/// True for 9.99, 99.9, 999, -9999, 1e20, 32767 and the like, of either sign.
inline bool is_sentinel(double value) {
  constexpr double kWritten[] = {9.99,   9.999,  99.0,   99.9,   99.99,   99.999,  999.0,   999.9,
                                 999.99, 9999.0, 999.25, 9999.9, 99999.0, 32767.0, 32768.0, 65535.0};
  const double size = std::abs(value);
  return size >= 1e15 || std::any_of(std::begin(kWritten), std::end(kWritten),
                                     [&](double written) { return std::abs(size - written) < 1e-9 * written; });
}

inline constexpr const char* kMissingValueText = ", which recorders write for missing values";

}  // namespace overbend

/// Uniform random numbers that are identical on every machine, which the standard's distributions do not guarantee.
#pragma once

#include <random>

namespace overbend {

/// Returns a number in (0, 1).
inline double uniform_draw(std::mt19937_64& generator) {
  return (static_cast<double>(generator() >> 11) + 0.5) * 0x1.0p-53;
}

}  // namespace overbend

/// Severity order of verdicts, for the verdict on several cases.
#pragma once

#include <array>

#include "results/verdict.h"

namespace overbend {

/// Returns true if `a` is less severe: in the order passed, reserved, not judged, exceeded.
constexpr bool less_severe(VerdictKind a, VerdictKind b) {
  constexpr std::array kRank = {0, 1, 3, 2};
  return kRank[static_cast<std::size_t>(a)] < kRank[static_cast<std::size_t>(b)];
}

}  // namespace overbend

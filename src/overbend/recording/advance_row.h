/// Advances a run by one output row.
#pragma once

#include <chrono>
#include <optional>

#include "base/interruption.h"

namespace overbend {

/// Steps to the next output row; `Run`: a Simulation. Returns false if the run is cancelled and the row is not reached
/// soon after: checkpoints are exact at rows only, so that the previous one remains. Stops at a failed step, see
/// failure() of the run.
template <class Run>
bool reach_row(Run& run) {
  using SteadyClock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPatience(400);
  const double row = run.next_row();
  std::optional<SteadyClock::time_point> asked;
  while (run.time() < row && run.step()) {
    if (!interruption_wanted()) continue;
    if (!asked) asked = SteadyClock::now();
    if (SteadyClock::now() - *asked > kPatience && run.time() < row) return false;
  }
  return true;
}

}  // namespace overbend

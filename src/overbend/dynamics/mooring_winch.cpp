#include "dynamics/mooring_winch.h"

#include <algorithm>

namespace overbend {
namespace {

constexpr double kToSpeed = 0.5;        ///< Of a winch that does not say how fast it reaches its speed [s].
constexpr double kRangeOfWanted = 0.1;  ///< Either way, of a winch that keeps a tension and says no range.
constexpr double kResolution = 1e-5;    ///< Of the tension wanted.

TensionerLaw keeper(const WinchDescription& winch) {
  TensionerLaw law;
  law.mode = TensionerMode::controlled;
  law.wanted = winch.tension.value_or(0.0);
  law.low = (1.0 - kRangeOfWanted) * law.wanted;
  law.high = (1.0 + kRangeOfWanted) * law.wanted;
  law.delay = winch.delay;
  law.velocity = winch.speed;
  law.acceleration = winch.speed / kToSpeed;
  law.resolution = kResolution * law.wanted;
  return law;
}

}  // namespace

std::optional<WinchLaw> winch_of(const MooringsDescription& moorings, const MooringLineDescription& line) {
  const auto named = std::find_if(moorings.winches.begin(), moorings.winches.end(),
                                  [&](const WinchDescription& winch) { return winch.name == line.winch; });
  if (named == moorings.winches.end() || (named->mode == WinchMode::hold && !named->brake)) {
    return std::nullopt;
  }
  WinchLaw law;
  law.stall = named->stall.value_or(law.stall);
  law.brake = named->brake.value_or(law.brake);
  if (named->mode == WinchMode::tension) {
    law.tension = keeper(*named);
  }
  return law;
}

}  // namespace overbend

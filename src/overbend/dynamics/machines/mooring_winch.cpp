#include "dynamics/machines/mooring_winch.h"

#include <algorithm>

namespace overbend {
namespace {

/// Default tension band of a constant-tension winch, relative to the target tension.
constexpr double kDefaultTensionBand = 0.1;
constexpr double kResolution = 1e-5;  ///< Relative to the target tension.

/// Speed limits of the winch and, in mode tension, its target tension.
TensionerLaw make_winch_machine(const WinchDescription& winch) {
  TensionerLaw law;
  law.velocity = winch.speed;
  law.acceleration = winch.speed / winch.acceleration_time;
  if (winch.mode != WinchMode::tension) return law;
  law.mode = TensionerMode::controlled;
  law.wanted = winch.tension.value_or(0.0);
  const double band = winch.band.value_or(kDefaultTensionBand * law.wanted);
  law.low = law.wanted - band;
  law.high = law.wanted + band;
  law.delay = winch.delay;
  law.resolution = kResolution * law.wanted;
  return law;
}

LengthTable make_winch_program(const WinchDescription& winch) {
  LengthTable table;
  if (winch.mode == WinchMode::speed) {
    for (const WinchStepDescription& step : winch.program) {
      const double last_length = table.empty() ? 0.0 : table.lengths.back();
      add_move(table, step.time, step.paid_out - last_length, winch.speed, winch.acceleration_time);
    }
    return table;
  }
  std::vector<double> times, lengths;
  if (!winch.program.empty() && winch.program.front().time > 0.0) {
    times.push_back(0.0);
    lengths.push_back(0.0);
  }
  for (const WinchStepDescription& step : winch.program) {
    times.push_back(step.time);
    lengths.push_back(step.paid_out);
  }
  return smooth_table(std::move(times), std::move(lengths));
}

}  // namespace

WinchLaw winch_law(const WinchDescription& winch) {
  WinchLaw law;
  law.stall = winch.stall.value_or(winch.haul.value_or(law.stall));
  law.brake = winch.brake.value_or(law.brake);
  law.tension = make_winch_machine(winch);
  if (winch.mode == WinchMode::speed || winch.mode == WinchMode::length) law.program = make_winch_program(winch);
  return law;
}

const WinchDescription* find_winch(const MooringsDescription& moorings, const MooringLineDescription& line) {
  const auto named = std::find_if(moorings.winches.begin(), moorings.winches.end(),
                                  [&](const WinchDescription& winch) { return winch.name == line.winch; });
  return named == moorings.winches.end() ? nullptr : &*named;
}

std::optional<WinchLaw> find_winch_law(const MooringsDescription& moorings, const MooringLineDescription& line) {
  const WinchDescription* const named = find_winch(moorings, line);
  if (named == nullptr) return std::nullopt;
  // A winch that holds may be commanded by an operation, and then hauls within its limits.
  const bool limited = named->brake || named->stall || named->haul;
  if (named->mode == WinchMode::hold && !limited) return std::nullopt;
  return winch_law(*named);
}

}  // namespace overbend

#include "dynamics/machines/mooring_winch.h"

#include <algorithm>

namespace overbend {
namespace {

constexpr double kBandOfWanted = 0.1;  ///< Of a winch that keeps a tension and does not say how closely.
constexpr double kResolution = 1e-5;   ///< Of the tension wanted.

/// How fast the winch may be, and the tension that it keeps in mode tension.
TensionerLaw machine_of(const WinchDescription& winch) {
  TensionerLaw law;
  law.velocity = winch.speed;
  law.acceleration = winch.speed / winch.acceleration_time;
  if (winch.mode != WinchMode::tension) return law;
  law.mode = TensionerMode::controlled;
  law.wanted = winch.tension.value_or(0.0);
  const double band = winch.band.value_or(kBandOfWanted * law.wanted);
  law.low = law.wanted - band;
  law.high = law.wanted + band;
  law.delay = winch.delay;
  law.resolution = kResolution * law.wanted;
  return law;
}

LengthTable program_of(const WinchDescription& winch) {
  LengthTable table;
  if (winch.mode == WinchMode::speed) {
    for (const WinchStepDescription& step : winch.program) {
      const double there = table.empty() ? 0.0 : table.lengths.back();
      add_move(table, step.time, step.paid_out - there, winch.speed, winch.acceleration_time);
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
  law.tension = machine_of(winch);
  if (winch.mode == WinchMode::speed || winch.mode == WinchMode::length) law.program = program_of(winch);
  return law;
}

const WinchDescription* winch_named_by(const MooringsDescription& moorings, const MooringLineDescription& line) {
  const auto named = std::find_if(moorings.winches.begin(), moorings.winches.end(),
                                  [&](const WinchDescription& winch) { return winch.name == line.winch; });
  return named == moorings.winches.end() ? nullptr : &*named;
}

std::optional<WinchLaw> winch_of(const MooringsDescription& moorings, const MooringLineDescription& line) {
  const WinchDescription* const named = winch_named_by(moorings, line);
  if (named == nullptr) return std::nullopt;
  // One that holds may still be led by an operation, and then hauls no harder than it can.
  const bool limited = named->brake || named->stall || named->haul;
  if (named->mode == WinchMode::hold && !limited) return std::nullopt;
  return winch_law(*named);
}

}  // namespace overbend

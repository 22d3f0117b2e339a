#include "model/step_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace overbend {
namespace {

constexpr double kStepsInPeriod = 50.0;      ///< (w h)^2/12 of a swing is 0.13 %.
constexpr double kErrorsInDiameter = 250.0;  ///< Of pipe.
constexpr double kErrorsInLength = 4e5;      ///< Of a line by itself: 1 mm in 400 m.
constexpr double kImpactsInSag = 40.0;       ///< In the weight of the length over which a pipe bends.

double mean_period(const std::vector<SpectrumPoint>& spectrum) {
  double energy = 0.0, moment = 0.0;
  for (std::size_t i = 1; i < spectrum.size(); ++i) {
    const SpectrumPoint &a = spectrum[i - 1], &b = spectrum[i];
    energy += (b.omega - a.omega) * (a.density + b.density);
    moment += (b.omega - a.omega) * (a.density * a.omega + b.density * b.omega);
  }
  return 2.0 * std::numbers::pi * energy / moment;
}

double wave_period(const WavesDescription& waves) {
  if (waves.type == WaveType::none) return std::numeric_limits<double>::infinity();
  if (!waves.spectrum.empty()) return mean_period(waves.spectrum);
  return waves.tp > 0.0 ? waves.tp : waves.period;
}

/// Of whatever moves by a period that is told [s].
double shortest_period(const Description& d) {
  double period = std::numeric_limits<double>::infinity();
  const auto take = [&](double one) { period = one > 0.0 ? std::min(period, one) : period; };
  take(wave_period(d.environment.waves));
  for (const auto& [freedom, motion] : d.vessel.harmonic) take(motion.period);
  for (const FreeLineDescription& line : d.lines) {
    for (const LineEndDescription* end : {&line.first, &line.second}) {
      if (end->amplitude.norm() > 0.0) take(end->period);
    }
  }
  return period;
}

}  // namespace

StepScales step_scales(const Model& model) {
  const Description& d = model.description;
  StepScales scales;
  scales.time = std::min(scales.time, shortest_period(d) / kStepsInPeriod);
  for (const FreeLineDescription& line : d.lines) {
    const bool wire = is_weightless(line) && !has_pipe_section(line);  // without mass it follows its ends
    if (!wire && unstressed_length(line) > 0.0) {
      scales.length = std::min(scales.length, unstressed_length(line) / kErrorsInLength);
    }
  }
  if (d.has_pipe && !model.sections.empty()) {
    const Section& pipe = model.pipe_section();
    scales.length = std::min(scales.length, pipe.outer_diameter / kErrorsInDiameter);
    const double sag = std::cbrt(pipe.EI / pipe.weight_in_air);
    scales.force = std::min(scales.force, pipe.weight_in_air * sag / kImpactsInSag);
  }
  return scales;
}

}  // namespace overbend

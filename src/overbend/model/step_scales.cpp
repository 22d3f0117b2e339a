#include "model/step_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/site/sea_statistics.h"

namespace overbend {
namespace {

constexpr double kStepsInPeriod = 50.0;       ///< (w h)^2/12 of an oscillation is 0.13 %.
constexpr double kDiameterOverError = 250.0;  ///< Pipe diameter divided by the position error.
constexpr double kLengthOverError = 4e5;      ///< Length of a free line divided by the position error: 1 mm in 400 m.
/// Weight of the length over which a pipe bends, divided by the impact force.
constexpr double kSagWeightOverImpact = 40.0;

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
  if (waves.type == WaveType::elevation) {
    const double tz = record_statistics(waves.record).tz;
    return tz > 0.0 ? tz : std::numeric_limits<double>::infinity();
  }
  if (waves.type == WaveType::ochi_hubble) {
    double period = std::numeric_limits<double>::infinity();
    for (const SpectrumPart& part : waves.parts) period = std::min(period, part.tp);
    return period;
  }
  if (!waves.spectrum.empty()) return mean_period(waves.spectrum);
  return waves.tp > 0.0 ? waves.tp : waves.period;
}

/// Min. period of all prescribed motions and waves [s].
double compute_min_period(const Description& d) {
  double period = std::numeric_limits<double>::infinity();
  const auto take = [&](double value) { period = value > 0.0 ? std::min(period, value) : period; };
  for (const WavesDescription& waves : d.environment.waves) take(wave_period(waves));
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
  scales.time = std::min(scales.time, compute_min_period(d) / kStepsInPeriod);
  for (const FreeLineDescription& line : d.lines) {
    const bool wire = is_weightless(line) && !has_pipe_section(line);  // without mass it follows its ends
    if (!wire && unstressed_length(line) > 0.0) {
      scales.length = std::min(scales.length, unstressed_length(line) / kLengthOverError);
    }
  }
  if (d.has_pipe && !model.sections.empty()) {
    const Section& pipe = model.pipe_section();
    scales.length = std::min(scales.length, pipe.outer_diameter / kDiameterOverError);
    const double sag = std::cbrt(pipe.EI / pipe.weight_in_air);
    scales.force = std::min(scales.force, pipe.weight_in_air * sag / kSagWeightOverImpact);
  }
  return scales;
}

}  // namespace overbend

#include "hull/hull_report.h"

#include <cstdio>

namespace overbend {
namespace {

constexpr double kNoticeable = 0.02;  // share of the sea's variance
constexpr double kSlender = 0.44, kSharp = 1.2;

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

double sideways(HullCurrent current, double coefficient, double psi) {
  current.transverse = coefficient;
  return current_force(current, psi, Vec6::Zero(), StripWater{}).force(1);
}

void tell_current(const Hull& hull, HullReport& out) {
  if (hull.current.form != HullCurrentForm::strips || hull.current.velocity.isZero()) return;
  const double psi = hull.drawn(5);
  out.current_now = sideways(hull.current, hull.current.transverse, psi);
  out.current_least = sideways(hull.current, kSlender, psi);
  out.current_most = sideways(hull.current, kSharp, psi);
}

/// Wave number of the sea's energy on average.
double mean_wave_number(const Sea& sea) {
  double energy = 0.0, moment = 0.0;
  for (const WaveComponent& c : sea.components) {
    energy += c.amplitude * c.amplitude;
    moment += c.amplitude * c.amplitude * c.wave_number;
  }
  return energy > 0.0 ? moment / energy : 0.0;
}

void tell_waves(const Hull& hull, const Sea& sea, HullReport& out) {
  out.below_table = hull.waves.below_table;
  out.above_table = hull.waves.above_table;
  const double outside = out.below_table + out.above_table;
  if (outside > kNoticeable) {
    out.warnings.push_back(percent(outside) + " of the sea's variance lies beyond the frequencies of the wave forces");
  }
  if (sea.calm() || hull.waves.drift != WaveDrift::newman) return;
  out.assumptions.push_back(
      "The slow drift is by Newman's approximation: mean drift coefficients alone, no set-down under wave groups, none "
      "in heave, roll and pitch.");
  if (mean_wave_number(sea) * sea.depth < 1.0) {
    out.warnings.push_back("the water is shallow for these waves: Newman's approximation of the slow drift is too low");
  }
}

}  // namespace

HullReport hull_report(const MadeHull& made, const Model& model, const Sea& sea, const Mat6& station_stiffness) {
  HullReport out;
  out.radiation = made.radiation;
  out.warnings = made.warnings;
  const std::optional<CoupledHullDescription>& given = model.description.vessel.coupled;
  if (!given || !given->data) return out;
  out.damping = horizontal_damping(made.hull, *given->data, station_stiffness);
  for (const ModeDamping& mode : out.damping) {
    if (mode.critical > 0.0 && mode.total() < 0.0) {
      out.warnings.push_back("the slow " + mode.mode + " is fed rather than damped: " + percent(mode.total()) +
                             " of critical damping");
    }
  }
  tell_current(made.hull, out);
  tell_waves(made.hull, sea, out);
  return out;
}

}  // namespace overbend

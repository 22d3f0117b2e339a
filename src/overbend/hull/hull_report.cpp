#include "hull/hull_report.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "hull/radiation_accuracy.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

constexpr double kNoticeable = 0.02;  // share of the sea's variance
constexpr double kSharp = 1.2;        // of a sharp-edged rectangle in two dimensions, as wide as a barge is deep

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

double sideways(HullCurrent current, double coefficient, double psi) {
  current.form = HullCurrentModel::strips;
  current.transverse = coefficient;
  return current_force(current, psi, Vec6::Zero(), StripWater{}).force(1);
}

void add_current_forces(const Hull& hull, const UfcHull& shape, double depth, HullReport& out) {
  if (!by_strips(hull.current) || hull.current.velocity.isZero()) return;
  const double psi = hull.lies(5);
  out.model_current_force = current_force(hull.current, psi, Vec6::Zero(), StripWater{}).force(1);
  out.min_current_force = sideways(hull.current, ufc_transverse_coefficient(shape, depth), psi);
  out.max_current_force = sideways(hull.current, kSharp, psi);
}

/// Warns if a table pushes the hull against the flow, which indicates another sign convention.
void add_table_warning(const CoefficientTable& table, const char* flow, HullReport& out) {
  double along = 0.0, across = 0.0;
  for (const CoefficientRow& row : table.rows) {
    along += row.cx * std::cos(row.angle);
    across += row.cy * std::sin(row.angle);
  }
  if (along < 0.0 || across < 0.0) {
    out.findings.push_back(
        Finding{FindingCode::force_table_sign,
                std::string(along < 0.0 ? "cx" : "cy") + " of the " + flow +
                    " table pushes the hull against the flow: cx is positive forward and cy to port, for any "
                    "definition of the angles"}
            .on(flow));
  }
}

/// Wave number of the sea's peak; for a sea without a peak period, or of several groups of waves, of the frequency
/// below which half of its energy lies.
double peak_wave_number(const WaveGroups& waves, const Sea& sea) {
  if (waves.size() == 1 && waves.front().tp > 0.0) {
    return linear_wave_number(2.0 * std::numbers::pi / waves.front().tp, sea.depth);
  }
  double energy = 0.0, passed = 0.0;
  for (const WaveComponent& c : sea.components) energy += c.amplitude * c.amplitude;
  for (const WaveComponent& c : sea.components) {
    passed += c.amplitude * c.amplitude;
    if (passed >= 0.5 * energy) return c.wave_number;
  }
  return 0.0;
}

void add_wave_findings(const Hull& hull, const CoupledHullDescription& coupled, const WaveGroups& waves, const Sea& sea,
                       HullReport& out) {
  out.below_table = hull.waves.below_table;
  out.above_table = hull.waves.above_table;
  const double outside = out.below_table + out.above_table;
  if (outside > kNoticeable) {
    out.findings.push_back(
        Finding{FindingCode::sea_outside_wave_forces,
                percent(outside) + " of the sea's variance lies beyond the frequencies of the wave forces"}
            .with("fraction", outside, "1"));
  }
  if (hull.waves.above_drift > out.above_table + kNoticeable) {
    out.findings.push_back(
        Finding{FindingCode::sea_above_drift,
                percent(hull.waves.above_drift) +
                    " of the sea's variance lies above the frequencies of the mean drift, which end below those "
                    "of the wave forces: these waves cause no drift"}
            .with("fraction", hull.waves.above_drift, "1"));
  }
  if (!sea.calm() && coupled.wave_drift != WaveDrift::none && hull.waves.drift == WaveDrift::none) {
    out.findings.push_back(
        {FindingCode::no_drift_coefficients,
         "the hydrodynamic files have no drift coefficients: no mean and no slow wave drift acts, regardless of "
         "vessel.motion.coupled.wave_drift"});
  }
  if (sea.calm() || hull.waves.drift != WaveDrift::newman) return;
  out.assumptions.push_back({AssumptionRank::other,
                             "Slow drift uses Newman's approximation: mean drift coefficients only, no set-down under "
                             "wave groups, no slow drift in heave, roll and pitch."});
  const double shallowness = peak_wave_number(waves, sea) * sea.depth;
  if (shallowness < 1.0) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", shallowness);
    out.findings.push_back({FindingCode::newman_in_shallow_water,
                            "the water is shallow for these waves, with a k_p d of " + std::string(text) +
                                ": Newman's approximation underestimates the slow drift"});
  }
}

}  // namespace

HullReport hull_report(const MadeHull& made, const Model& model, const Sea& sea, const Mat6& station_stiffness) {
  HullReport out;
  out.radiation = made.radiation;
  out.findings = made.findings;
  const std::optional<CoupledHullDescription>& coupled = model.description.vessel.coupled;
  if (!coupled || !coupled->data) return out;
  append(out.findings, misfit_findings(radiation_misfits(made.hull.radiation, *coupled->data, sea)));
  out.damping = horizontal_damping(made.hull, *coupled->data, station_stiffness);
  for (const ModeDamping& mode : out.damping) {
    if (mode.loop && mode.loop->damping < 0.0) {
      char period[32];
      std::snprintf(period, sizeof period, "%.0f", mode.loop->period);
      out.findings.push_back(
          Finding{FindingCode::positioning_unstable,
                  "dynamic positioning is unstable in slow " + mode.mode + ", with a period of " + std::string(period) +
                      " s and " + percent(mode.loop->damping) +
                      " of critical damping: the low-frequency filter lags; a shorter "
                      "vessel.motion.coupled.slow_period or a softer spring helps, more damping may not"}
              .on(mode.mode)
              .with("damping", mode.loop->damping, "1"));
    } else if (mode.critical > 0.0 && mode.total() < 0.0) {
      out.findings.push_back(
          Finding{FindingCode::slow_motion_undamped,
                  "slow " + mode.mode + " has negative damping: " + percent(mode.total()) + " of critical"}
              .on(mode.mode)
              .with("damping", mode.total(), "1"));
    }
  }
  add_current_forces(made.hull, ufc_hull(model, *coupled), model.description.environment.water_depth, out);
  add_table_warning(made.hull.current.table, "current", out);
  add_table_warning(made.hull.wind.table, "wind", out);
  add_wave_findings(made.hull, *coupled, model.description.environment.waves, sea, out);
  out.steady = steady_forces(made.hull, made.hull.lies(5));
  out.steady.drift = mean_drift(made.hull.waves, made.hull.lies(5));
  return out;
}

}  // namespace overbend

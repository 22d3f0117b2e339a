#include "study/run/run_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/sea_outside_range.h"
#include "model/site/wave_groups.h"
#include "model/waves/rao_table.h"
#include "numerics/record_part.h"
#include "study/run/non_stationary.h"

namespace overbend {
namespace {

constexpr double kReportedMeanDeviation =
    0.02;                                       ///< Deviation of the mean tension from its target that is reported [-].
constexpr double kDrift = 0.01;                 ///< Drift of the mean tension over the run that is reported [-].
constexpr double kMaxEnergyDrift = 1e-3;        ///< Error of the energy balance beyond which the run is not resolved
                                                ///< [-].
constexpr double kNoMotion = 1e-9;              ///< Standard deviation below which a vessel does not move [m, rad].
constexpr double kLargeAngle = 10.0 * kDegree;  ///< Heel or trim beyond which hydrostatic restoring is not linear
                                                ///< [rad].
constexpr double kReportedUncertainty = 0.1;  ///< Relative standard error of a standard deviation that is reported [-].
constexpr double kTravelRows = 1.0;           ///< Sampling interval of the tensioner's travel [s].
constexpr std::size_t kBlocks = 8;
constexpr double kReportedVarianceOutside = 0.05;  ///< Fraction of the sea's variance outside the frequencies of the
                                                   ///< RAOs that is reported [-].
constexpr double kReportedAutocorrelation =
    0.5;                                 ///< Autocorrelation of the sea's components at a later time that is reported
                                         ///< [-].
constexpr std::size_t kManyWaves = 100;  ///< Number of wave components from which a sea does not repeat itself within a
                                         ///< day.
constexpr double kBeyondChance = 5.0;  ///< Standard errors; with six degrees of freedom 0.2 % of records exceed them by
                                       ///< chance.

const HistorySummary* history(const DynamicResults& results, const std::string& name) {
  for (const HistorySummary& h : results.histories) {
    if (h.name == name) return &h;
  }
  return nullptr;
}

double deviation(const DynamicResults& results, const std::string& name) {
  const HistorySummary* h = history(results, name);
  return h == nullptr ? 0.0 : h->over_time.std;
}

void warn_of_change(DynamicResults& results) {
  if (results.non_stationary.empty()) return;
  results.findings.push_back(
      {FindingCode::record_not_stationary,
       fmt::format("{}: {}; there are no three-hour extremes, and means and standard deviations are of the whole run",
                   kNotStationary, results.non_stationary)});
}

void warn_of_short_run(DynamicResults& results) {
  const auto estimated = [](const ExtremeEstimate& extreme) { return extreme.estimate.has_value(); };
  if (results.duration >= kThreeHours || ranges::none_of(results.extremes, estimated)) return;
  results.findings.push_back(
      Finding{FindingCode::short_record, fmt::format("the three-hour extremes are extrapolated from a run of {0:.3g} "
                                                     "min, and the maxima of the run are those of {0:.3g} min only",
                                                     results.duration / 60.0)}
          .with("duration", results.duration, "s"));
}

void warn_of_fixed_vessel(DynamicResults& results) {
  if (results.station_s.empty() && results.moorings.empty()) return;  // models of lines only have no vessel
  if (deviation(results, "elevation") <= kNoMotion) return;
  for (const char* freedom : {"surge", "sway", "heave", "roll", "pitch", "yaw"}) {
    if (deviation(results, freedom) > kNoMotion) return;
  }
  results.findings.push_back(Finding{
      FindingCode::vessel_fixed_in_sea,
      std::string("the vessel does not move in this sea: vessel.motion is fixed, and only the water acts on the ") +
          (results.station_s.empty() ? "mooring lines" : "pipe")}
                                 .on("vessel"));
}

void warn_of_tension(DynamicResults& results, std::span<const double> tension) {
  const TensionerDynamics& t = results.tensioner;
  if (t.wanted <= 0.0) return;
  const double off = t.tension.mean / t.wanted - 1.0;
  if (std::abs(off) > kReportedMeanDeviation) {
    results.findings.push_back(
        Finding{FindingCode::mean_tension_off_target,
                fmt::format("the mean tension at the tensioner is {}, {:.1f} % {} the set tension of {}",
                            shown(t.tension.mean, "N", 1), 100.0 * std::abs(off), off > 0.0 ? "above" : "below",
                            shown(t.wanted, "N", 1))}
            .on("tensioner")
            .with("tension", t.tension.mean, "N"));
  }
  const double change = trend(tension);
  if (std::abs(change) > kDrift * t.wanted) {
    results.findings.push_back(
        Finding{FindingCode::tension_drifts,
                fmt::format("the mean tension at the tensioner drifts: it {} by {} over the run, {:.1f} % of the set "
                            "tension; the statistics are those of a non-stationary record",
                            change > 0.0 ? "rises" : "falls", shown(std::abs(change), "N", 1),
                            100.0 * std::abs(change) / t.wanted)}
            .on("tensioner")
            .with("change", change, "N"));
  }
}

}  // namespace

void warn_of_energy(double drift, bool fixed_step, DynamicResults& results) {
  if (std::abs(drift) <= kMaxEnergyDrift) return;
  results.findings.push_back(
      Finding{FindingCode::energy_imbalance,
              fmt::format("the energy balance of the run has an error of {:.2g} of the energy exchanged: the motion is "
                          "not resolved; {}",
                          std::abs(drift),
                          fixed_step ? "omit analysis.dynamic.step, or reduce it"
                                     : "reduce analysis.dynamic.max_step and analysis.dynamic.step_error")}
          .with("error", drift, "1"));
}

double trend(std::span<const double> values) {
  const std::size_t block_size = values.size() / kBlocks;
  if (block_size == 0) return 0.0;
  constexpr double n = kBlocks;
  std::array<double, kBlocks> mean{};
  double all = 0.0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const std::span<const double> block = values.subspan(b * block_size, block_size);
    mean[b] = std::accumulate(block.begin(), block.end(), 0.0) / static_cast<double>(block_size);
    all += mean[b] / n;
  }
  double squares = 0.0, product = 0.0, left = 0.0;
  const auto from_middle = [](std::size_t b) { return static_cast<double>(b) - 0.5 * (n - 1.0); };
  for (std::size_t b = 0; b < kBlocks; ++b) {
    squares += from_middle(b) * from_middle(b);
    product += from_middle(b) * (mean[b] - all);
  }
  const double slope = product / squares;
  for (std::size_t b = 0; b < kBlocks; ++b) left += std::pow(mean[b] - all - slope * from_middle(b), 2);
  const double error = std::sqrt(left / (n - 2.0) / squares);
  return std::abs(slope) > kBeyondChance * error ? slope * n : 0.0;
}

void warn_of_tensioner_uncertainty(const Description& description, std::span<const double> travel,
                                   DynamicResults& results) {
  const bool irregular = is_irregular(description.environment.waves);
  if (description.operation.type == OperationType::pull_ahead) return;
  const std::int64_t acted = results.tensioner.pay_out_count + results.tensioner.haul_in_count;
  if (!irregular || acted == 0) return;
  const double error = deviation_error(travel, results.output_step, kTravelRows);
  if (error <= kReportedUncertainty) return;
  results.findings.push_back(Finding{
      FindingCode::tensioner_statistics_uncertain,
      fmt::format(
          "the tensioner acted {} times in {:.3g} min: the standard deviation of its travel, {}, is known to {:.0f} % "
          "(one standard error), as are results that depend on it; use a longer run, or several seeds",
          acted, results.duration / 60.0, shown(results.tensioner.travel.std, "m", 2), 100.0 * error)}
                                 .on("tensioner")
                                 .with("error", error, "1"));
}

void warn_of_large_motion(const VesselDescription& vessel, DynamicResults& results) {
  if (vessel.motion != VesselMotion::coupled) return;
  const auto max_magnitude = [&](const char* name) {
    const HistorySummary* h = history(results, name);
    return h == nullptr ? 0.0 : std::max(std::abs(h->over_time.min), std::abs(h->over_time.max));
  };
  const double heel = max_magnitude("roll"), trim = max_magnitude("pitch"), heave = max_magnitude("heave");
  if (std::max(heel, trim) > kLargeAngle) {
    results.findings.push_back(
        Finding{FindingCode::vessel_angle_nonlinear,
                fmt::format("the vessel heels by up to {:.1f} deg and trims by up to {:.1f} deg: beyond 10 deg the "
                            "hydrostatic restoring is not linear, as the analysis assumes",
                            heel * kToDegrees, trim * kToDegrees)}
            .on("vessel")
            .with("roll", heel, "rad")
            .with("pitch", trim, "rad"));
  }
  const double freeboard = vessel.depth - vessel.draught;
  if (heave > 0.5 * freeboard) {
    results.findings.push_back(
        Finding{FindingCode::vessel_heave_nonlinear,
                fmt::format("the vessel heaves by up to {}, more than half its freeboard of {}: the hydrostatic "
                            "restoring is not linear there, as the analysis assumes",
                            shown(heave, "m", 2), shown(freeboard, "m", 2))}
            .on("vessel")
            .with("heave", heave, "m"));
  }
}

void warn_of_sea(const Description& description, DynamicResults& results) {
  const WaveGroups& waves = description.environment.waves;
  if (is_calm(waves)) return;
  const Sea sea = make_sea(waves, description.environment.water_depth, results.seed);
  const std::size_t count = sea.components.size();
  const bool few = is_random(waves) && count < kManyWaves;
  const double again = few ? recurrence(sea, results.build_up + results.duration) : 0.0;
  if (again > kReportedAutocorrelation) {
    results.findings.push_back(
        Finding{FindingCode::few_wave_components,
                fmt::format("the sea of {} waves repeats itself within the run: its autocorrelation rises to {:.2f} "
                            "again, where 200 waves in three hours reach 0.2; use more (environment.waves.components)",
                            count, again)}
            .with("autocorrelation", again, "1"));
  }
  if (description.vessel.motion != VesselMotion::raos || !description.vessel.raos) return;
  const std::vector<double>& omegas = description.vessel.raos->omegas;
  const SeaOutsideRange outside = sea_outside_range(sea, omegas.front(), omegas.back());
  if (outside.above > kReportedVarianceOutside) {
    results.findings.push_back(Finding{
        FindingCode::sea_outside_raos,
        fmt::format("{:.0f} % of the sea's variance lies above the highest frequency of the RAOs, {:.3g} rad/s: up to "
                    "1.25 times that frequency the vessel motion fades out, and beyond it the vessel does not move",
                    100.0 * outside.above, omegas.back())}
                                   .with("fraction", outside.above, "1"));
  }
  if (outside.below > kReportedVarianceOutside) {
    results.findings.push_back(
        Finding{FindingCode::sea_outside_raos,
                fmt::format("{:.0f} % of the sea's variance lies below the lowest frequency of the RAOs, {:.3g} rad/s, "
                            "where translations are those of that frequency and rotations decrease with the frequency",
                            100.0 * outside.below, omegas.front())}
            .with("fraction", outside.below, "1"));
  }
}

void warn_of_run(const Description& description, DynamicResults& results, std::span<const double> tension) {
  const bool alike = !is_irregular(description.environment.waves);  // regular waves have equal peaks
  if (!alike) warn_of_short_run(results);
  warn_of_change(results);
  warn_of_fixed_vessel(results);
  warn_of_tension(results, tension);
  warn_of_energy(results.energy.drift(), description.dynamics && description.dynamics->step, results);
}

}  // namespace overbend

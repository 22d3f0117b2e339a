#include "recording/fatigue_findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/shown_unit.h"
#include "checks/fatigue_spot.h"

namespace overbend {
namespace {

constexpr double kFewCycles = 100.0;  ///< Below this number of cycles at the worst station the damage rate is
                                      ///< uncertain.

/// Mean damage of a weld during its passage over that with the worst positions of the stops [-].
double mean_over_worst(const DynamicResults& results, const FatigueSpot& spot, const LayPace& pace) {
  const WeldPath path = weld_path(results.station_s, spot.rate, pace);
  return path.worst > 0.0 ? path.mean / path.worst : 1.0;
}

std::size_t worst_station(const FatigueSpot& spot) {
  return static_cast<std::size_t>(std::max_element(spot.rate.begin(), spot.rate.end()) - spot.rate.begin());
}

/// True if steel yields anywhere, with or without a plastic model.
bool yields(const Model& model, const DynamicResults& results) {
  for (std::size_t i = 0; i < results.station_s.size(); ++i) {
    const double from_top = results.station_s.back() - results.station_s[i];
    const Section& section = model.sections[static_cast<std::size_t>(model.section_at(from_top))];
    if (section.yield_stress > 0.0 && results.von_mises.max[i] > section.yield_stress) return true;
  }
  return false;
}

/// True if a spot has an S-N curve that differs between editions.
bool uses_renewed_curve(const FatigueDescription& fatigue) {
  const std::vector<FatigueSpotDescription> spots = fatigue_spots(fatigue);
  return std::any_of(spots.begin(), spots.end(), [](const auto& spot) { return spot.curve <= FatigueCurve::c2; });
}

}  // namespace

LayPace lay_pace(const Description& description) {
  const FatigueDescription& fatigue = *description.fatigue;
  const std::optional<JointDescription>& joint = description.pipe.section.joint;
  return {fatigue.joint.value_or(joint.value_or(JointDescription{}).length), fatigue.weld_time, fatigue.move_time};
}

void add_weld_damage(const Model& model, DynamicResults& results) {
  const FatigueDescription& fatigue = *model.description.fatigue;
  const LayPace pace = lay_pace(model.description);
  FatigueResults& out = *results.fatigue;
  out.budget = fatigue.budget;
  out.design_factor = fatigue.design_factor;
  out.lay_rate = pace.speed();
  for (FatigueSpot& spot : out.spots) {
    spot.path_damage = weld_path(results.station_s, spot.rate, pace).worst;
    spot.worst_s = results.station_s[worst_station(spot)];
    const double left = std::max(0.0, fatigue.budget / fatigue.design_factor - spot.path_damage);
    spot.standby = left < kMaxStandby * spot.worst_rate ? left / spot.worst_rate : kMaxStandby;
  }
}

void assume_of_fatigue(const Model& model, DynamicResults& results) {
  const LayPace pace = lay_pace(model.description);
  FatigueResults& out = *results.fatigue;
  const auto add = [&](AssumptionRank rank, std::string text) {
    out.assumptions.push_back({rank, std::move(text)});
    results.assumptions.push_back(out.assumptions.back());
  };
  double min_ratio = 1.0;
  for (const FatigueSpot& spot : out.spots) min_ratio = std::min(min_ratio, mean_over_worst(results, spot, pace));
  add(AssumptionRank::governing,
      fmt::format("Fatigue: the sea of the run lasts for the whole passage of a weld; its build-up is not counted. A "
                  "weld stops for {:.4g} s at positions {} apart and moves for {:.4g} s between them; its damage is "
                  "that of the worst positions of the stops along the line (the mean over all positions is at least "
                  "{:.2f} of it).",
                  pace.weld_time, shown_digits(pace.joint, "m", 4), pace.move_time, min_ratio));
  add(AssumptionRank::other,
      fmt::format(
          "Fatigue: rainflow cycles (ASTM E1049) of the longitudinal stress at eight points around the section, "
          "ranges below {} left out, with S-N curves of {}; stations are fixed on the pipe during the run, "
          "and the pipe does not turn about its axis. Residual and mean stresses are ignored.",
          shown_digits(0.1e6, "Pa", 2), fatigue_code(model.description.fatigue->edition)));
  if (uses_renewed_curve(*model.description.fatigue)) {
    add(AssumptionRank::other,
        fmt::format("Fatigue: editions of DNV-RP-C203 differ for the S-N curves B1 to C2 (fatigue.edition). For ranges "
                    "above {} to {} in air and {} to {} in protected seawater C, C1 and C2 of 2024 give more damage "
                    "than those of 2016, below less. The values of 2024 are from one public source, and for walls "
                    "of more than {} they are used with the larger thickness exponent of older editions. Evaluate "
                    "both and use the larger damage.",
                    shown_number(100e6, "Pa", 0), shown(125e6, "Pa", 0), shown_number(240e6, "Pa", 0),
                    shown(300e6, "Pa", 0), shown(0.025, section_length(), 0)));
  }
  if (model.description.fatigue->hi_lo > 0.0) {
    add(AssumptionRank::other,
        "Fatigue: the stress factor of misaligned walls is 1 + 3 (e/t) exp(-(D/t)^-0.5) inside and outside "
        "(DNV-RP-C203 2.10), without deduction for the misalignment included in the S-N curves.");
  }
}

void warn_of_fatigue(const Model& model, DynamicResults& results) {
  const FatigueResults& fatigue = *results.fatigue;
  const LayPace pace = lay_pace(model.description);
  for (const FatigueSpot& spot : fatigue.spots) {
    const double cycles = spot.cycles[worst_station(spot)] * results.duration;
    if (cycles < kFewCycles) {
      results.findings.push_back(Finding{
          FindingCode::fatigue_few_cycles,
          fmt::format("fatigue at '{}' is based on {:.0f} stress cycles at the worst station: a run of more than "
                      "{:.0f} cycles is needed for a statistically reliable damage rate",
                      spot.name, cycles, kFewCycles)}
                                     .on(spot.name)
                                     .with("cycles", cycles, "1"));
    }
    if (spot.standby < pace.weld_time + pace.move_time) {
      results.findings.push_back(Finding{
          FindingCode::fatigue_budget,
          fmt::format("the fatigue budget at '{}' leaves {:.0f} s of standby, less than the {:.0f} s of one joint",
                      spot.name, spot.standby, pace.weld_time + pace.move_time)}
                                     .on(spot.name)
                                     .with("standby", spot.standby, "s"));
    }
  }
  if (yields(model, results)) {
    results.findings.push_back({FindingCode::fatigue_with_yield,
                                "the steel yields in the run: fatigue is evaluated with the stress of elastic steel at "
                                "the same curvature or moment, and low-cycle fatigue is not evaluated"});
  }
}

}  // namespace overbend

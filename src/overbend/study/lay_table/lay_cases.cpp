#include "study/lay_table/lay_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/finding.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "base/units.h"
#include "results/findings.h"
#include "study/lay_table/limit_search.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

constexpr double kLayBackMiss = 1e-3;  ///< [m]
constexpr double kLayBackJump = 0.05;  ///< Touchdown jump if a roller loses contact or the mesh is remade [m].
constexpr double kSameTension = 1e-8;  ///< Relative difference of equal tensions [-].
constexpr double kSmallStep = 1.02, kLargeStep = 1.15;  ///< Ratios of successive trial tensions [-].
constexpr int kMaxSteps = 24;                           ///< Maximum number of trial steps: a factor of 20 in both
                                                        ///< directions.
constexpr int kMaxBisections = 40;
constexpr double kMinWeightFraction = 0.5;  // of the weight over the depth: the seabed may rise astern
constexpr double kMinYieldFraction = 1e-3;  // of the yield tension: for a pipe with almost no submerged weight

LayTableValues make_lay_values(const StaticResults& r) {
  LayTableValues v;
  v.top_tension = r.top_tension;
  v.bottom_tension = r.bottom_tension;
  v.lay_back = r.lay_back;
  v.departure_angle = r.departure_angle;
  v.tip_separation = r.stinger_tip_clearance;
  if (const auto& bent = r.overbend ? r.overbend : r.tower) {
    v.overbend_bending_stress = bent->bending_stress.value;
    v.overbend_von_mises = bent->von_mises.value;
    v.overbend_strain = bent->strain.value;
  }
  v.sagbend_bending_stress = r.sagbend.bending_stress.value;
  v.sagbend_von_mises = r.sagbend.von_mises.value;
  v.sagbend_strain = r.sagbend.strain.value;
  v.max_reaction = r.max_reaction;
  v.max_reaction_support = r.max_reaction_support;
  if (const CheckRow* worst = find_governing_check(r.checks)) {
    v.utilisation = worst->utilisation;
    v.find_governing_check = worst->name;
    if (worst->region == CheckRegion::tip) v.tip = "stinger tip " + worst->remark;
  }
  v.verdict = verdict_kind(r.checks, r.findings);
  return v;
}

/// Shifts the whole seabed to the depth at the stern shoe.
void set_depth(EnvironmentDescription& environment, double depth) {
  const double deeper = depth - environment.water_depth;
  environment.water_depth = depth;
  if (deeper == 0.0) return;
  for (ProfilePoint& point : environment.seabed.profile) point.depth += deeper;
  if (!environment.seabed.bathymetry) return;
  for (double& point : environment.seabed.bathymetry->depth) point += deeper;
}

/// Search range of the minimum passing tension [N]: below the first value no pipe has an equilibrium over such a
/// seabed, beyond the second the steel yields without any bending.
std::pair<double, double> find_tension_range(const Model& model) {
  const Section& pipe = model.pipe_section();
  const double yield_tension = pipe.yield_stress * pipe.steel_area;
  const double weight = pipe.weight_submerged * model.description.environment.water_depth;
  return {std::clamp(kMinWeightFraction * weight, kMinYieldFraction * yield_tension, 0.5 * yield_tension),
          yield_tension};
}

/// Reason that a lay does not pass; empty if it passes.
std::string failure_reason(const LayTableValues& v, const Findings& serious) {
  if (v.verdict == VerdictKind::exceeded) return fmt::format("{} is exceeded", v.find_governing_check);
  return v.passed() ? "" : serious_codes(serious);
}

/// Returns the lay nearest to passing, with a message about the searched range and the failures at both ends.
LayCase nearest_to_passing(const std::vector<TriedLay>& tried, const TryLay& try_at) {
  const auto tension_text = [](double tension) { return shown_digits(tension, "N", 5); };
  const std::string none = fmt::format("no tension from {} to {} passes every check", tension_text(tried.front().value),
                                       tension_text(tried.back().value));
  const auto first = ranges::find_if(tried, [](const TriedLay& trial) { return trial.lay.lay.has_value(); });
  if (first == tried.end()) {
    return {tried.back().value, tried.back().lay.depth, {}, none + ": " + tried.back().lay.reason};
  }
  const auto utilisation = [](const TriedLay& trial) {
    return trial.lay.lay ? trial.lay.lay->utilisation.value_or(0.0) : std::numeric_limits<double>::infinity();
  };
  LayCase nearest = try_at(ranges::min_element(tried, {}, utilisation)->value);
  nearest.reason = fmt::format(
      "{}: with {}, the lowest tension with an equilibrium, {}; with {}, {}; the nearest to passing is shown: {}", none,
      tension_text(first->value), first->lay.reason, tension_text(tried.back().value), tried.back().lay.reason,
      nearest.reason);
  return nearest;
}

}  // namespace

LayCases::LayCases(const Description& description) : description_(description) {
  const double depth = description_.environment.water_depth;
  own_ = solve(description_, description_.tensioner.tension.value_or(0.0), depth);
  if (!description_.tensioner.tension && own_.lay) own_.tension = own_.lay->top_tension;
  if (description_.pipe.length && description_.pipe.anchor) {
    description_.pipe.length.reset();  // the tension is known now
  }
  for (Known& known : known_) known.tension = own_.tension;  // the tension that was not given
}

const LayCases::Known* LayCases::nearest_by_lay_back(double lay_back, double depth) const {
  const Known* near = nullptr;
  for (const Known& known : known_) {
    if (known.depth != depth) continue;
    const bool nearer = near == nullptr || std::abs(known.lay_back - lay_back) < std::abs(near->lay_back - lay_back);
    if (nearer) near = &known;
  }
  return near;
}

LayCase LayCases::solve(const Description& description, double tension, double depth) {
  LayCase found{tension, depth, {}, {}};
  Model model = build_model(description);
  // From scratch, although a neighbouring row would be closer: in a current a lay may have several equilibria, which
  // differ in the side rollers that carry load, and rows must not depend on preceding rows.
  const ModelEquilibrium outcome = solve_lay(model);
  ++solves_;
  if (!outcome.solution) {
    found.reason = outcome.failure->what;
    return found;
  }
  StaticResults results = checked_statics(model, outcome);
  add_hull_results(model, results);
  if (assumptions_.empty()) assumptions_ = results.assumptions;
  known_.push_back({tension, depth, results.lay_back});
  return make_lay_case(tension, depth, results);
}

LayCase LayCases::make_lay_case(double tension, double depth, const StaticResults& results) {
  LayCase found{tension, depth, make_lay_values(results), {}};
  found.serious = serious_findings(results.findings);
  found.reason = failure_reason(*found.lay, found.serious);
  return found;
}

Description LayCases::described(double tension, double depth) const {
  Description description = description_;
  description.tensioner.tension = tension;
  set_depth(description.environment, depth);
  return description;
}

LayCase LayCases::at(double tension, double depth) {
  return solve(described(tension, depth), tension, depth);
}

LayCase LayCases::solve_from_last(double tension, double depth, std::shared_ptr<const LayWarmStart>& last) {
  Model model = build_model(described(tension, depth));
  std::shared_ptr<const LayWarmStart> found;
  const StaticRun statics = solve_with_warm_starts(model, {last.get()}, &found);
  ++solves_;
  if (found) last = std::move(found);
  return statics.results ? make_lay_case(tension, depth, *statics.results)
                         : LayCase{tension, depth, {}, statics.failure->what};
}

/// Returns tensions with touchdown on both sides of the lay-back, searched outwards from known lays; without values if
/// no equilibrium is found before.
std::pair<LayCase, LayCase> LayCases::around_lay_back(double lay_back, double depth) {
  const Known* near = nearest_by_lay_back(lay_back, depth);
  LayCase low = at(near != nullptr ? near->tension : own_.tension, depth), high = low;
  double factor = kSmallStep;
  for (int i = 0; i < kMaxSteps && low.lay && low.lay->lay_back > lay_back; ++i) {
    high = low;
    low = at(low.tension / factor, depth);
    factor = std::min(factor * factor, kLargeStep);
  }
  for (int i = 0; i < kMaxSteps && high.lay && high.lay->lay_back < lay_back; ++i) {
    low = high;
    high = at(high.tension * factor, depth);
    factor = std::min(factor * factor, kLargeStep);
  }
  // The equilibria may end before touchdown is near enough: bisect towards the solved side.
  for (int i = 0; i < kMaxBisections && high.lay && !low.lay; ++i) {
    LayCase middle = at(0.5 * (low.tension + high.tension), depth);
    (!middle.lay || middle.lay->lay_back <= lay_back ? low : high) = std::move(middle);
    if (high.tension - low.tension < kSameTension * high.tension) break;
  }
  return {std::move(low), std::move(high)};
}

LayCase LayCases::at_lay_back(double lay_back, double depth) {
  auto [low, high] = around_lay_back(lay_back, depth);
  for (const LayCase* end : {&low, &high}) {
    if (!end->lay) return {end->tension, depth, {}, "no tension has this lay-back: " + end->reason};
  }
  const auto miss = [&](const LayCase& lay) { return lay.lay->lay_back - lay_back; };
  if (miss(low) > kLayBackMiss || miss(high) < -kLayBackMiss) return {0.0, depth, {}, "no tension has this lay-back"};
  // Regula falsi; the weight of the fixed end is halved (Dowell and Jarratt 1971, "Illinois").
  double f_low = miss(low), f_high = miss(high);
  int side = 0;
  for (int i = 0; i < kMaxBisections && high.tension - low.tension > kSameTension * high.tension; ++i) {
    if (std::abs(miss(low)) < kLayBackMiss || std::abs(miss(high)) < kLayBackMiss) break;
    LayCase between = at((low.tension * f_high - high.tension * f_low) / (f_high - f_low), depth);
    if (!between.lay) return between;
    const bool below = miss(between) < 0.0;
    (below ? f_low : f_high) = miss(between);
    const int moved = below ? -1 : 1;
    if (side == moved) (below ? f_high : f_low) *= 0.5;
    side = moved;
    (below ? low : high) = std::move(between);
  }
  LayCase& best = std::abs(miss(low)) < std::abs(miss(high)) ? low : high;
  if (std::abs(miss(best)) > kLayBackJump) return {best.tension, depth, {}, "touchdown jumps across this lay-back"};
  return std::move(best);
}

LayCase LayCases::at_min_tension(double depth) {
  const auto [from, to] = find_tension_range(build_model(described(own_.tension, depth)));
  std::shared_ptr<const LayWarmStart> last;
  const TryLay near = [&](double tension) { return solve_from_last(tension, depth, last); };
  const TryLay alone = [&](double tension) { return at(tension, depth); };
  MinPassingLay search = find_min_passing(from, to, {}, near, alone);
  if (!search.limit) return nearest_to_passing(search.tried, alone);
  LayCase found = std::move(search.limit->passing.lay);
  const LayCase& less = search.limit->beyond.lay;
  if (!less.reason.empty()) found.reason = "with less, " + less.reason;
  return found;
}

}  // namespace overbend

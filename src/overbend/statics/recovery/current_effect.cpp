#include "statics/recovery/current_effect.h"

#include <algorithm>
#include <cmath>

#include "statics/recovery/recovery_parts.h"
#include "statics/solver/planar_start.h"

namespace overbend {
namespace {

bool flows(const CurrentProfile& current) {
  const auto moves = [](double v) { return v != 0.0; };
  return std::any_of(current.vx.begin(), current.vx.end(), moves) ||
         std::any_of(current.vy.begin(), current.vy.end(), moves);
}

/// Values of the lay in still water at a distance from the tensioner.
class StillWaterStations {
 public:
  explicit StillWaterStations(const std::vector<Station>& stations) : stations_(&stations), total_(stations.back().s) {}

  double at(double from_top, double Station::*member) const {
    const double s = total_ - from_top;
    const auto above = std::lower_bound(stations_->begin(), stations_->end(), s,
                                        [](const Station& station, double v) { return station.s < v; });
    if (above == stations_->begin()) return (*above).*member;
    if (above == stations_->end()) return stations_->back().*member;
    const Station &b = *above, &a = *(above - 1);
    return a.*member + (s - a.s) / (b.s - a.s) * (b.*member - a.*member);
  }

 private:
  const std::vector<Station>* stations_;
  double total_;
};

}  // namespace

bool has_current(const Model& model) {
  return flows(model.current);
}

bool needs_still_water_lay(const Model& model) {
  const CheckSettings& checks = model.description.checks;
  return checks.current_load == CurrentLoad::environmental && checks.codes != CheckCodes::api && has_current(model);
}

Model without_current(const Model& model) {
  Model still_water_model = model;
  still_water_model.description.environment.current.clear();
  still_water_model.current = {};
  still_water_model.mean_pose = still_water_model.nominal_pose;
  return still_water_model;
}

StaticOutcome solve_still_water_lay(const Model& still_water_model, const StaticSolution& solution,
                                    const StaticSolution* still_water_solution) {
  if (still_water_solution != nullptr) return solve_statics(still_water_model, still_water_solution, solution.past);
  const StaticSolution flat = flattened_lay(still_water_model, solution);
  return solve_statics(still_water_model, &flat, solution.past);
}

void set_current_effect(const std::vector<Station>& still_water_stations, StaticResults& results) {
  const StillWaterStations lay(still_water_stations);
  for (Station& station : results.stations) {
    const double from_top = results.total_length - station.s;
    station.current_vertical_moment = station.vertical_moment - lay.at(from_top, &Station::vertical_moment);
    station.current_lateral_moment = station.lateral_moment - lay.at(from_top, &Station::lateral_moment);
    station.current_tension = station.effective_tension - lay.at(from_top, &Station::effective_tension);
  }
}

void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results) {
  std::optional<StaticSolution> still_water_solution;
  find_current_effect(model, solution, results, still_water_solution);
}

void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results,
                         std::optional<StaticSolution>& still_water_solution) {
  if (!needs_still_water_lay(model)) return;
  const Model still_water_model = without_current(model);
  StaticOutcome outcome =
      solve_still_water_lay(still_water_model, solution, still_water_solution ? &*still_water_solution : nullptr);
  if (!outcome.solution) {
    results.findings.push_back({FindingCode::current_effect_unknown,
                                "there is no equilibrium without the current: the checks treat the load effects of the "
                                "current as functional"});
    return;
  }
  set_current_effect(recover_stations(still_water_model, *outcome.solution), results);
  still_water_solution = std::move(outcome.solution);
}

}  // namespace overbend

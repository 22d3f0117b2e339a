#include "checks/check_station.h"

#include <algorithm>
#include <cmath>

#include "checks/current_part.h"
#include "results/regions.h"

namespace overbend {
namespace {

/// Arc lengths of a station, of the next one below it and of the top [m].
struct StationPlace {
  double s, below, top;
};

CheckStation make_base_station(const Model& model, const Regions& limits, const StationPlace& place, const Vec3& p_W,
                               std::size_t section) {
  CheckStation station;
  station.s = place.s;
  station.from_top = place.top - place.s;
  station.p_W = p_W;
  station.region = limits.code_check_region(place.s);
  station.leaves = limits.leaves(place.below, place.s);
  station.lands = limits.lands(place.below, place.s);
  station.section = section;
  station.external_pressure = model.water_weight_density * std::max(-p_W.z(), 0.0);
  station.overpressure = station.external_pressure - pressure_on_bore(model.sections[section], p_W.z());
  station.load_pressure = station.bend_pressure = station.overpressure;
  return station;
}

/// Returns the maximum roller force on the stretch nearest to each station; 0 without one.
std::vector<double> roller_forces(const StaticResults& statics) {
  std::vector<double> forces(statics.stations.size(), 0.0);
  for (const SupportResult& box : statics.supports) {
    for (const RowResult& row : box.rows) {
      const auto after = std::lower_bound(statics.stations.begin(), statics.stations.end(), row.s,
                                          [](const Station& station, double s) { return station.s < s; });
      if (row.s < 0.0 || after == statics.stations.end()) continue;
      auto near = static_cast<std::size_t>(after - statics.stations.begin());
      if (near > 0 && row.s - statics.stations[near - 1].s < statics.stations[near].s - row.s) --near;
      for (const RollerResult& roller : row.rollers) forces[near] = std::max(forces[near], roller.reaction);
    }
  }
  return forces;
}

/// Returns the load effects of the static state; everything except the current is functional.
FactoredEffects static_effects(const Station& station, const Section& section, bool current_apart) {
  FactoredEffects e;
  const Vec3 moment(station.vertical_moment, station.lateral_moment, 0.0);
  if (current_apart) {
    e.current = Vec3(station.current_vertical_moment, station.current_lateral_moment, 0.0);
    e.tension = station.current_tension;
  }
  e.functional = moment - e.current;
  e.current_strain = 0.5 * section.steel_diameter / section.EI * e.current;
  const double size = moment.norm();
  const Vec3 strain = size > 0.0 ? Vec3(station.strain / size * moment) : Vec3(station.strain * Vec3::UnitX());
  e.functional_strain = strain - e.current_strain;
  return e;
}

constexpr double kNodeTolerance = 1e-6;  ///< Tolerance of a node where two sections meet [m].

/// Returns the section of the stresses of a station at rest: where two meet, that of the element above, which contains
/// the station. Stresses of one section must not be compared with limits of the other.
std::size_t section_at_rest(const Model& model, double from_top) {
  return static_cast<std::size_t>(model.section_at(std::max(0.0, from_top - kNodeTolerance)));
}

/// True if the current's part of the static state counts as environmental load effect.
bool current_apart(const Model& model, const StaticResults& statics) {
  return model.description.checks.current_load == CurrentLoad::environmental && has_current_part(statics);
}

/// Returns functional moment and force of the nearest station [N m], [N].
std::pair<double, double> functional_at(const StaticResults& statics, double s) {
  const std::vector<Station>& all = statics.stations;
  const auto above =
      std::lower_bound(all.begin(), all.end(), s, [](const Station& station, double v) { return station.s < v; });
  const Station& station =
      above == all.end() || (above != all.begin() && s - (above - 1)->s < above->s - s) ? *(above - 1) : *above;
  return {std::hypot(station.vertical_moment - station.current_vertical_moment,
                     station.lateral_moment - station.current_lateral_moment),
          station.effective_tension - station.current_tension};
}

}  // namespace

void factor_static(CheckStation& station, const CheckSection& section, const std::vector<LoadFactors>& combinations) {
  FactoredEffects& effects = station.effects;
  for (const LoadFactors& f : combinations) {
    const double moment = design_size(f, effects.functional, effects.current);
    const double force = design_value(f, station.force, effects.tension);
    const double strain = section.strain_factor * design_size(f, effects.functional_strain, effects.current_strain);
    station.max_force = std::max(station.max_force, std::abs(force));
    if (strain >= station.design_strain) {
      station.design_strain = strain;
      effects.strain_factors = f;
    }
    const double used = load_terms(section.load, moment, force, station.overpressure, 0.0, station.share).utilisation();
    if (used >= station.load.value) {
      station.load.value = used;
      station.design_moment = moment;
      station.design_force = force;
      effects.load_factors = f;
    }
  }
  if (station.region == CheckRegion::overbend && section.strain.holds) {
    station.bend.value = strain_terms(section.strain, station.design_strain, station.overpressure, 0.0).utilisation();
  }
}

std::size_t section_of_node(const Model& model, double from_top) {
  const std::size_t upper = static_cast<std::size_t>(model.section_at(std::max(0.0, from_top - kNodeTolerance)));
  const std::size_t lower = static_cast<std::size_t>(model.section_at(from_top + kNodeTolerance));
  return reports_lower_section(model.sections[lower], model.sections[upper]) ? lower : upper;
}

CheckStations static_stations(const Model& model, const StaticResults& statics) {
  CheckStations out;
  out.current_separate = current_apart(model, statics);
  out.sections = check_sections(model);
  const std::vector<LoadFactors> combinations = load_combinations(model.description.checks);
  const Regions limits = regions(statics);
  const std::vector<double> rollers = roller_forces(statics);
  for (std::size_t i = 0; i < statics.stations.size(); ++i) {
    const Station& static_station = statics.stations[i];
    if (static_station.kind == SectionKind::structure) continue;  // the formulas do not apply to structures
    const StationPlace place{static_station.s, i > 0 ? statics.stations[i - 1].s : static_station.s,
                             statics.stations.back().s};
    CheckStation station = make_base_station(model, limits, place, static_station.p_W,
                                             section_at_rest(model, place.top - static_station.s));
    const CheckSection& section = out.section_for(station);
    if (section.cable) continue;
    station.effects = static_effects(static_station, model.sections[station.section], out.current_separate);
    station.moment = station.effects.functional.norm();
    station.force = static_station.effective_tension - station.effects.tension;
    station.strain = static_station.strain;
    station.von_mises = static_station.von_mises;
    station.max_von_mises.value = static_station.von_mises;
    station.max_strain.value = static_station.strain;
    station.max_tension.value = static_station.effective_tension;
    if (model.description.checks.point_load) {
      station.roller_force = rollers[i];
      station.share = point_load_factor(section.wall, section.fy, station.roller_force);
    }
    factor_static(station, section, combinations);
    out.stations.push_back(station);
  }
  return out;
}

CheckStations dynamic_stations(const Model& model, const StaticResults& statics, const DynamicResults& dynamics) {
  CheckStations out;
  out.in_time = true;
  out.duration = dynamics.duration;
  out.current_separate = current_apart(model, statics);
  out.sections = check_sections(model);
  const Regions limits = regions(statics);
  const StationDesign& design = dynamics.design;
  for (std::size_t i = 0; i < dynamics.station_s.size(); ++i) {
    const std::vector<double>& s = dynamics.station_s;
    const StationPlace place{s[i], i > 0 ? s[i - 1] : s[i], s.back()};
    const std::size_t section = section_of_node(model, place.top - s[i]);
    if (model.sections[section].kind == SectionKind::structure) continue;
    CheckStation station = make_base_station(model, limits, place, dynamics.static_place[i], section);
    if (out.section_for(station).cable) continue;
    station.moment = dynamics.static_moment[i];
    station.force = dynamics.static_tension[i];
    if (out.current_separate) {
      const auto [moment, force] = functional_at(statics, station.s);
      station.moment = moment;
      station.force = force;
    }
    station.strain = dynamics.static_strain[i];
    station.von_mises = dynamics.static_von_mises[i];
    station.load = {design.load[i], design.load_time[i]};
    station.design_moment = design.moment[i];
    station.design_force = design.force[i];
    station.load_pressure = design.load_pressure[i];
    station.share = design.share[i];
    station.max_force = design.max_force[i];
    station.bend = {design.strain[i], design.strain_time[i]};
    station.design_strain = design.design_strain[i];
    station.bend_pressure = design.strain_pressure[i];
    station.max_von_mises = {dynamics.von_mises.max[i], design.von_mises_time[i]};
    station.max_strain = {dynamics.strain.max[i], design.fibre_strain_time[i]};
    station.max_tension = {dynamics.effective_tension.max[i], design.tension_time[i]};
    out.stations.push_back(station);
  }
  return out;
}

}  // namespace overbend

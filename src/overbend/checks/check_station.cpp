#include "checks/check_station.h"

#include <algorithm>
#include <cmath>

#include "checks/current_part.h"
#include "results/regions.h"

namespace overbend {
namespace {

/// Places of a station, of the next below it and of the top [m].
struct StationPlace {
  double s, below, top;
};

CheckStation station_of(const Model& model, const Regions& limits, const StationPlace& place, const Vec3& p_W,
                        std::size_t section) {
  CheckStation station;
  station.s = place.s;
  station.from_top = place.top - place.s;
  station.p_W = p_W;
  station.region = limits.check_of(place.s);
  station.leaves = limits.leaves(place.below, place.s);
  station.lands = limits.lands(place.below, place.s);
  station.section = section;
  station.external_pressure = model.water_weight_density * std::max(-p_W.z(), 0.0);
  station.overpressure = station.external_pressure - pressure_on_bore(model.sections[section], p_W.z());
  station.load_pressure = station.bend_pressure = station.overpressure;
  return station;
}

/// Largest roller force on the stretch that is nearer to this station than to its neighbours; 0 without one.
std::vector<double> roller_forces(const StaticResults& statics) {
  std::vector<double> forces(statics.stations.size(), 0.0);
  for (const SupportResult& box : statics.supports) {
    for (const RowResult& row : box.rows) {
      const auto after = std::lower_bound(statics.stations.begin(), statics.stations.end(), row.s,
                                          [](const Station& at, double s) { return at.s < s; });
      if (row.s < 0.0 || after == statics.stations.end()) continue;
      auto near = static_cast<std::size_t>(after - statics.stations.begin());
      if (near > 0 && row.s - statics.stations[near - 1].s < statics.stations[near].s - row.s) --near;
      for (const RollerResult& roller : row.rollers) forces[near] = std::max(forces[near], roller.reaction);
    }
  }
  return forces;
}

/// Load effects of the static state; what is not of the current is functional.
FactoredEffects static_effects(const Station& at, const Section& section, bool current_apart) {
  FactoredEffects e;
  const Vec3 moment(at.vertical_moment, at.lateral_moment, 0.0);
  if (current_apart) {
    e.current = Vec3(at.current_vertical_moment, at.current_lateral_moment, 0.0);
    e.tension = at.current_tension;
  }
  e.functional = moment - e.current;
  e.current_strain = 0.5 * section.steel_diameter / section.EI * e.current;
  const double size = moment.norm();
  const Vec3 strain = size > 0.0 ? Vec3(at.strain / size * moment) : Vec3(at.strain * Vec3::UnitX());
  e.functional_strain = strain - e.current_strain;
  return e;
}

constexpr double kBeside = 1e-6;  ///< Of a node where two sections meet [m].

/// Section that the stresses of a station at rest are told of: where two meet, that of the element above, in which the
/// station lies. The stresses of one must not be held against the limits of the other.
std::size_t section_at_rest(const Model& model, double from_top) {
  return static_cast<std::size_t>(model.section_at(std::max(0.0, from_top - kBeside)));
}

/// Whether the current's part of the static state counts as environmental load effect.
bool current_apart(const Model& model, const StaticResults& statics) {
  return model.description.checks.current_load == CurrentLoad::environmental && tells_current(statics);
}

/// Functional moment and force of the nearest station [N m], [N].
std::pair<double, double> functional_at(const StaticResults& statics, double s) {
  const std::vector<Station>& all = statics.stations;
  const auto above = std::lower_bound(all.begin(), all.end(), s, [](const Station& at, double v) { return at.s < v; });
  const Station& at =
      above == all.end() || (above != all.begin() && s - (above - 1)->s < above->s - s) ? *(above - 1) : *above;
  return {std::hypot(at.vertical_moment - at.current_vertical_moment, at.lateral_moment - at.current_lateral_moment),
          at.effective_tension - at.current_tension};
}

}  // namespace

void factor_static(CheckStation& station, const CheckSection& section, const std::vector<LoadFactors>& combinations) {
  FactoredEffects& effects = station.effects;
  for (const LoadFactors& f : combinations) {
    const double moment = design_size(f, effects.functional, effects.current);
    const double force = design_value(f, station.force, effects.tension);
    const double strain = section.strain_factor * design_size(f, effects.functional_strain, effects.current_strain);
    station.largest_force = std::max(station.largest_force, std::abs(force));
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
  const std::size_t upper = static_cast<std::size_t>(model.section_at(std::max(0.0, from_top - kBeside)));
  const std::size_t lower = static_cast<std::size_t>(model.section_at(from_top + kBeside));
  return lower_is_told(model.sections[lower], model.sections[upper]) ? lower : upper;
}

CheckStations static_stations(const Model& model, const StaticResults& statics) {
  CheckStations out;
  out.current_separate = current_apart(model, statics);
  out.sections = check_sections(model);
  const std::vector<LoadFactors> combinations = load_combinations(model.description.checks);
  const Regions limits = regions(statics);
  const std::vector<double> rollers = roller_forces(statics);
  for (std::size_t i = 0; i < statics.stations.size(); ++i) {
    const Station& at = statics.stations[i];
    if (at.kind == SectionKind::structure) continue;  // no pipe: the formulas say nothing of it
    const StationPlace place{at.s, i > 0 ? statics.stations[i - 1].s : at.s, statics.stations.back().s};
    CheckStation station = station_of(model, limits, place, at.p_W, section_at_rest(model, place.top - at.s));
    const CheckSection& section = out.section_of(station);
    if (section.cable) continue;
    station.effects = static_effects(at, model.sections[station.section], out.current_separate);
    station.moment = station.effects.functional.norm();
    station.force = at.effective_tension - station.effects.tension;
    station.strain = at.strain;
    station.von_mises = at.von_mises;
    station.largest_von_mises.value = at.von_mises;
    station.largest_strain.value = at.strain;
    station.largest_tension.value = at.effective_tension;
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
    CheckStation station = station_of(model, limits, place, dynamics.static_place[i], section);
    if (out.section_of(station).cable) continue;
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
    station.largest_force = design.largest_force[i];
    station.bend = {design.strain[i], design.strain_time[i]};
    station.design_strain = design.design_strain[i];
    station.bend_pressure = design.strain_pressure[i];
    station.largest_von_mises = {dynamics.von_mises.max[i], design.von_mises_time[i]};
    station.largest_strain = {dynamics.strain.max[i], design.fibre_strain_time[i]};
    station.largest_tension = {dynamics.effective_tension.max[i], design.tension_time[i]};
    out.stations.push_back(station);
  }
  return out;
}

}  // namespace overbend

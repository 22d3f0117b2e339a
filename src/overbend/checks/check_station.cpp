#include "checks/check_station.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

/// Where the regions of the static state meet, by arc length from the anchor.
struct RegionLimits {
  double touchdown = 0.0;
  double inflection = std::numeric_limits<double>::infinity();  ///< Above it the pipe hogs.
  double departure = std::numeric_limits<double>::infinity();   ///< Last support in contact.

  CheckRegion of(double s) const {
    if (s < touchdown) return CheckRegion::seabed;
    if (s >= departure) return CheckRegion::overbend;
    return s > inflection ? CheckRegion::tip : CheckRegion::sagbend;
  }
};

RegionLimits region_limits(const StaticResults& statics) {
  const std::vector<Station>& all = statics.stations;
  RegionLimits limits;
  limits.touchdown = statics.touchdown.s;
  const auto first =
      std::find_if(all.begin(), all.end(), [](const Station& at) { return at.region == Region::overbend; });
  if (first == all.end()) return limits;
  limits.departure = first->s;
  auto at = first;
  while (at != all.begin() && at->s > limits.touchdown && at->vertical_moment <= 0.0) --at;
  limits.inflection = at->s;
  return limits;
}

double overpressure_at(const Model& model, const Section& section, double z) {
  const double internal = section.internal_pressure - section.contents_weight_density * z;
  return model.water_weight_density * std::max(-z, 0.0) - std::max(internal, 0.0);
}

CheckStation station_of(const Model& model, const RegionLimits& limits, double total, double s, const Vec3& p_W) {
  CheckStation station;
  station.s = s;
  station.from_top = total - s;
  station.p_W = p_W;
  station.region = limits.of(s);
  station.section = static_cast<std::size_t>(model.section_at(station.from_top));
  station.overpressure = overpressure_at(model, model.sections[station.section], p_W.z());
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

/// Design load effects of a state that does not move.
void factor_static(CheckStation& station, const CheckSection& section, const std::vector<LoadFactors>& combinations) {
  for (const LoadFactors& f : combinations) {
    const double moment = f.functional * station.moment;
    const double force = design_value(f, station.force, 0.0);
    station.largest_force = std::max(station.largest_force, std::abs(force));
    station.design_strain = std::max(station.design_strain, section.strain_factor * f.functional * station.strain);
    const double used = load_terms(section.load, moment, force, station.overpressure, 0.0, station.share).utilisation();
    if (used >= station.load.value) {
      station.load.value = used;
      station.design_moment = moment;
      station.design_force = force;
    }
  }
  if (station.region == CheckRegion::overbend && section.strain.holds) {
    station.bend.value = strain_terms(section.strain, station.design_strain, station.overpressure, 0.0).utilisation();
  }
}

}  // namespace

CheckStations static_stations(const Model& model, const StaticResults& statics) {
  CheckStations out;
  out.sections = check_sections(model);
  const std::vector<LoadFactors> combinations = load_combinations(model.description.checks);
  const RegionLimits limits = region_limits(statics);
  const std::vector<double> rollers = roller_forces(statics);
  for (std::size_t i = 0; i < statics.stations.size(); ++i) {
    const Station& at = statics.stations[i];
    CheckStation station = station_of(model, limits, statics.stations.back().s, at.s, at.p_W);
    const CheckSection& section = out.section_of(station);
    station.moment = at.bending_moment;
    station.force = at.effective_tension;
    station.strain = at.strain;
    station.von_mises = at.von_mises;
    station.largest_von_mises.value = at.von_mises;
    station.largest_strain.value = at.strain;
    station.largest_tension.value = at.effective_tension;
    if (model.description.checks.point_load) station.share = point_load_factor(section.wall, section.fy, rollers[i]);
    factor_static(station, section, combinations);
    out.stations.push_back(station);
  }
  return out;
}

CheckStations dynamic_stations(const Model& model, const StaticResults& statics, const DynamicResults& dynamics) {
  CheckStations out;
  out.in_time = true;
  out.sections = check_sections(model);
  const RegionLimits limits = region_limits(statics);
  const StationDesign& design = dynamics.design;
  for (std::size_t i = 0; i < dynamics.station_s.size(); ++i) {
    CheckStation station =
        station_of(model, limits, dynamics.station_s.back(), dynamics.station_s[i], dynamics.static_place[i]);
    station.moment = dynamics.static_moment[i];
    station.force = dynamics.static_tension[i];
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

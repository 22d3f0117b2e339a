#include "checks/line_stations.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "mechanics/stress.h"

namespace overbend {
namespace {

/// Sections of the pipe in a line, for the segments that are pipe.
struct LineSections {
  std::vector<CheckSection> checks;
  std::vector<Section> pipe;
  std::vector<int> of_segment;  ///< -1: not pipe.
};

LineSections find_sections(const Description& description, const FreeLineDescription& line) {
  LineSections sections;
  for (const LineSegmentDescription& segment : line.segments) {
    sections.of_segment.push_back(segment.section ? static_cast<int>(sections.checks.size()) : -1);
    if (!segment.section) continue;
    sections.checks.push_back(make_check_section(*segment.section, description.checks));
    sections.checks.back().name = segment.name.empty() ? line.name : line.name + ", " + segment.name;
    sections.pipe.push_back(
        derive_section(segment.name, *segment.section, description.environment.water_weight_density));
  }
  return sections;
}

/// A run with the static state of the same lines; null without one.
struct LineRun {
  const std::vector<LineResult>* rest = nullptr;
  const std::vector<LineDynamics>* lines = nullptr;

  const LineDynamics* find(const std::string& name) const {
    if (lines == nullptr) return nullptr;
    const auto found = ranges::find(*lines, name, &LineDynamics::name);
    return found == lines->end() ? nullptr : &*found;
  }
  const std::vector<LineNodeResult>& rest_nodes(const std::string& name) const {
    return ranges::find(*rest, name, &LineResult::name)->nodes;
  }
  /// Returns the tension of a node, on the side stored by the run [N].
  double rest_tension(const std::string& name, std::size_t node) const { return rest_nodes(name)[node].tension; }
  /// Returns the node of a line at an arc length.
  std::size_t node_at(const std::string& name, double s) const {
    const std::vector<LineNodeResult>& nodes = rest_nodes(name);
    const auto nearest =
        ranges::min_element(nodes, {}, [s](const LineNodeResult& node) { return std::abs(node.s - s); });
    return static_cast<std::size_t>(nearest - nodes.begin());
  }
};

/// Returns the maximum force of attachments to a line at a point [N].
double attached_force(const LiftResults& lift, const LineRun& run, const std::string& line, double arc_length) {
  constexpr double kSamePlace = 1e-6;  // [m]
  double max_force = 0.0;
  for (const LiftedWire& wire : lift.davits) {
    if (wire.on != line || std::abs(wire.location.arc_length - arc_length) > kSamePlace) continue;
    max_force = std::max(max_force, wire.force.norm());
    if (const LineDynamics* moved = run.find(wire.name)) max_force = std::max(max_force, moved->max_tension);
  }
  return max_force;
}

CheckStation make_station(const LiftedNode& node, const Section& pipe, double water_weight_density) {
  CheckStation station;
  station.region = CheckRegion::line;
  station.s = node.location.arc_length;
  station.p_W = node.location.place;
  station.external_pressure = water_weight_density * std::max(-node.location.place.z(), 0.0);
  station.overpressure = station.external_pressure - pressure_on_bore(pipe, node.location.place.z());
  station.load_pressure = station.bend_pressure = station.overpressure;
  station.effects.functional = Vec3(node.sagging, node.sideways, 0.0);
  station.effects.functional_strain = node.strain * Vec3::UnitX();
  station.moment = station.effects.functional.norm();
  station.force = node.tension;
  station.strain = station.max_strain.value = node.strain;
  station.von_mises = station.max_von_mises.value = node.von_mises;
  station.max_tension.value = node.tension;
  return station;
}

std::vector<LoadFactors> line_combinations(const Description& description) {
  std::vector<LoadFactors> combinations = load_combinations(description.checks);
  if (!raises_factors_for_current(description)) return combinations;
  for (LoadFactors& factors : combinations) factors.functional = std::max(factors.functional, factors.environmental);
  return combinations;
}

/// Adds the change of a run at a node: the larger moment about the axis of the static one, and a tension.
void add_run(double moment, double tension, const Section& pipe, CheckStation& station) {
  const double rest = station.moment, more = std::max(moment - rest, 0.0);
  const Vec3 axis = rest > 0.0 ? Vec3(station.effects.functional / rest) : Vec3::UnitX();
  station.effects.current = more * axis;
  station.effects.current_strain = more / pipe.EI * 0.5 * pipe.steel_diameter * Vec3::UnitX();
  station.effects.tension = tension - station.force;
  SectionLoads loads;
  loads.effective_tension = tension;
  loads.bending_moment = rest + more;
  loads.curvature = loads.bending_moment / pipe.EI;
  loads.z = station.p_W.z();
  loads.external_pressure = station.external_pressure;
  loads.internal_pressure = station.external_pressure - station.overpressure;
  const SectionStress stress = section_stress(pipe, loads);
  station.max_von_mises.value = std::max(station.max_von_mises.value, stress.von_mises);
  station.max_strain.value = std::max(station.max_strain.value, stress.strain);
  station.max_tension.value = std::max(station.max_tension.value, tension);
}

CheckStations make_stations(const Model& model, const LiftResults& lift, const LiftedLine& line, const LineRun& run) {
  const Description& description = model.description;
  const LineDynamics* const moved = run.find(line.name);
  const auto described = ranges::find(description.lines, line.name, &FreeLineDescription::name);
  const LineSections sections = find_sections(description, *described);
  const std::vector<LoadFactors> combinations = line_combinations(description);
  CheckStations out;
  out.line = line.name;
  out.sections = sections.checks;
  const bool moments = moved != nullptr && !moved->moment_at_nodes.empty();
  if (run.lines != nullptr && !moments) return out;
  for (const LiftedNode& node : line.nodes) {
    const int index = sections.of_segment.at(static_cast<std::size_t>(node.segment));
    if (index < 0) continue;
    const auto section = static_cast<std::size_t>(index);
    const CheckSection& check = sections.checks[section];
    const Section& pipe = sections.pipe[section];
    CheckStation station = make_station(node, pipe, description.environment.water_weight_density);
    station.section = section;
    if (description.checks.point_load) {
      station.roller_force = attached_force(lift, run, line.name, station.s);
      station.share = point_load_factor(check.wall, check.fy, station.roller_force);
    }
    factor_static(station, check, combinations);
    if (moments) {
      const std::size_t k = run.node_at(line.name, station.s);
      const double jump = station.force - run.rest_tension(line.name, k);  // in statics, at this side of the attachment
      for (const double tension : {moved->min_tension_at_nodes[k], moved->max_tension_at_nodes[k]}) {
        add_run(moved->moment_at_nodes[k], tension + jump, pipe, station);
        factor_static(station, check, combinations);
      }
    }
    out.stations.push_back(station);
  }
  return out;
}

}  // namespace

bool raises_factors_for_current(const Description& description) {
  return description.checks.current_load == CurrentLoad::environmental && !description.environment.current.empty();
}

std::vector<CheckStations> line_stations(const Model& model, const LiftResults& lift) {
  std::vector<CheckStations> all;
  for (const LiftedLine& line : lift.lines) all.push_back(make_stations(model, lift, line, {}));
  return all;
}

std::vector<CheckStations> line_stations_in_time(const Model& model, const StaticResults& statics,
                                                 const std::vector<LineDynamics>& run) {
  std::vector<CheckStations> all;
  const LineRun of_lines{&statics.lines, &run};
  for (const LiftedLine& line : statics.lift->lines) {
    all.push_back(make_stations(model, *statics.lift, line, of_lines));
  }
  return all;
}

}  // namespace overbend

#include "statics/recovery/recovery.h"

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "statics/recovery/recovery_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/version.h"
#include "mechanics/point_load.h"
#include "mechanics/quadrature.h"
#include "model/model_findings.h"
#include "statics/equations/bed_contacts.h"
#include "statics/equations/touchdown.h"
#include "statics/recovery/current_effect.h"
#include "statics/recovery/recovery_attachments.h"
#include "statics/recovery/recovery_bed.h"
#include "statics/recovery/recovery_cable.h"
#include "statics/recovery/recovery_dragging.h"
#include "statics/recovery/recovery_route.h"
#include "statics/recovery/recovery_stinger.h"
#include "statics/recovery/recovery_structures.h"
#include "statics/recovery/recovery_supports.h"
#include "statics/recovery/recovery_target.h"
#include "statics/recovery/static_findings.h"
#include "system/find_regions.h"

namespace overbend {
namespace {

/// Forces of the loads on [0, xi] of an element, and their moment about the point at xi.
CutForces loads_before(const StaticSystem& system, const LineState& state, int element, double xi) {
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * element));
  const double h = system.mesh().length[static_cast<std::size_t>(element)];
  const Vec3 end_point = centreline(q, xi, h).r;
  CutForces sum;
  for (int i = 0; i < kGaussPoints; ++i) {
    const CentrelinePoint point = centreline(q, kGaussXi[i] * xi, h);
    const Vec3 f =
        kGaussWeight[i] * xi * h * point_load(system.elements(), system.environment(), element, point.r, point.a).sum();
    sum.force += f;
    sum.moment += (point.r - end_point).cross(f);
  }
  for (const RollerContact& roller : system.contacts()) {
    if (roller.normal > 0.0 && roller.closest.element == element && roller.closest.xi < xi) {
      const Vec3 r = centreline(q, roller.closest.xi, h).r;
      sum.force += roller.force();
      sum.moment += (r - end_point).cross(roller.force());
    }
  }
  return sum;
}

}  // namespace

std::vector<CutForces> cut_forces(StaticSystem& system, const LineState& state) {
  system.evaluate(state, false);
  std::vector<CutForces> cuts;
  for (std::size_t node = 0; node < system.mesh().s.size(); ++node) {
    cuts.push_back(cut_at_node(system.cuts(), state.q, node));
  }
  return cuts;
}

CutForces cut_at(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts, int element,
                 double xi) {
  const CutForces& start = cuts[static_cast<std::size_t>(element)];
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * element));
  const double h = system.mesh().length[static_cast<std::size_t>(element)];
  const Vec3 lever = centreline(q, xi, h).r - q.segment<3>(0);
  const CutForces loads = loads_before(system, state, element, xi);
  // The part [0, xi] is in equilibrium under the reversed section forces at its start, after the attachments at that
  // node, its loads, and the section forces at its end.
  const Vec3 begins = start.force - attached_force(system, state, element);
  return {begins - loads.force, start.moment - lever.cross(begins) - loads.moment};
}

namespace {

/// A cable without bending stiffness is aligned with its tension; on a roller, with the mean of the directions on both
/// sides.
Vec3 cable_direction(const StaticSystem& system, const CutForces& cut, int element, double xi) {
  Vec3 pull = cut.force;
  for (const RollerContact& roller : system.contacts()) {
    const bool at_roller = roller.closest.element == element && roller.closest.xi == xi;
    if (roller.normal > 0.0 && at_roller) pull -= 0.5 * roller.force();
  }
  return pull.normalized();
}

}  // namespace

StationCut make_station(const StaticSystem& system, const LineState& state, const CutForces& cut, int element,
                        double xi) {
  const Model& model = system.model();
  const std::size_t e = static_cast<std::size_t>(element);
  const double h = system.mesh().length[e];
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * element));
  const CentrelinePoint point = centreline(q, xi, h);
  const bool cable = model.sections[static_cast<std::size_t>(system.mesh().section[e])].kind == SectionKind::cable;
  const Vec3 t = cable ? cable_direction(system, cut, element, xi) : Vec3(point.a.normalized());

  StationCut result;
  result.section = system.mesh().section[e];
  result.station.kind = model.sections[static_cast<std::size_t>(result.section)].kind;
  result.tangent = t;
  Station& station = result.station;
  station.s = system.mesh().s[e] + xi * h;
  station.p_W = point.r;
  station.astern = (point.r - point_from_ramp(model, model.mean_pose, Vec3::Zero())).dot(system.plane().astern_W);
  station.inclination = std::atan2(t.z(), std::hypot(t.x(), t.y()));
  station.effective_tension = cut.force.dot(t);
  const Vec3 moment = cut.moment - cut.moment.dot(t) * t;
  station.bending_moment = moment.norm();
  result.bend = moment.cross(t);
  const Vec3 horizontal(t.x(), t.y(), 0.0);
  const Vec3 port =
      horizontal.norm() > 1e-9 ? Vec3(Vec3::UnitZ().cross(horizontal.normalized())) : system.plane().port_W;
  station.lateral_moment = result.bend.dot(port);
  station.vertical_moment = result.bend.dot(t.cross(port));

  const PointLoad load = point_load(system.elements(), system.environment(), element, point.r, point.a);
  station.seabed_reaction = load.seabed_normal;
  station.penetration = load.penetration;
  return result;
}

namespace {

/// True if the section changes between an element and the next.
bool section_changes(const StaticSystem& system, int element) {
  const std::vector<int>& section = system.mesh().section;
  if (element < 0 || element + 1 >= system.mesh().elements()) return false;
  return section[static_cast<std::size_t>(element)] != section[static_cast<std::size_t>(element) + 1];
}

/// The station of a node belongs to the element that begins there. At a transition to a stiffer section the strain is
/// largest at the node, so both elements get a station close to it; so they do if an attachment at the node makes the
/// tension jump.
void add_places_next_to_nodes(const StaticSystem& system, int element, double length, std::vector<double>& places) {
  if (length <= 4.0 * kNodeStationOffset) return;
  if (section_changes(system, element - 1)) places.push_back(kNodeStationOffset / length);
  if (section_changes(system, element) || holds_something(system, element + 1)) {
    places.push_back(1.0 - kNodeStationOffset / length);
  }
}

/// Stations at nodes, roller contacts, touchdown and, in long elements, intermediate points.
std::vector<Station> make_stations(const StaticSystem& system, const LineState& state,
                                   const std::vector<CutForces>& cuts, const std::optional<ElementPlace>& touchdown,
                                   const std::vector<BendingMemory>& memory) {
  const std::vector<ElementPlace> edges = contact_places(system, state);
  std::vector<StationCut> stations;
  for (int e = 0; e < system.mesh().elements(); ++e) {
    std::vector<double> places{0.0};
    const double h = system.mesh().length[static_cast<std::size_t>(e)];
    const int parts = std::max(1, static_cast<int>(std::ceil(h / 2.0)));
    for (int k = 1; k < parts; ++k) {
      places.push_back(static_cast<double>(k) / parts);
    }
    for (const RollerContact& roller : system.contacts()) {
      if (roller.normal > 0.0 && roller.closest.element == e) {
        places.push_back(roller.closest.xi);
      }
    }
    if (touchdown && touchdown->element == e) {
      places.push_back(touchdown->xi);
    }
    for (const ElementPlace& edge : edges) {
      if (edge.element == e) places.push_back(edge.xi);
    }
    add_places_next_to_nodes(system, e, h, places);
    std::sort(places.begin(), places.end());
    for (const double xi : places) {
      const StationCut station = make_station(system, state, cut_at(system, state, cuts, e, xi), e, xi);
      if (stations.empty() || station.station.s > stations.back().station.s + 1e-6) {
        stations.push_back(station);
      }
    }
  }
  stations.push_back(make_station(system, state, cuts.back(), system.mesh().elements() - 1, 1.0));
  return finish_stations(system.model(), std::move(stations), system.mesh(), memory);
}

void update_maximum(Extreme& extreme, double value, const Station& station) {
  if (std::abs(value) > std::abs(extreme.value)) {
    extreme = {value, station.s, station.p_W, station.astern};
  }
}

/// A cable and structures have no pipe stresses; the tension of the cable is reported separately.
void update_maximum(RegionResult& region, const Station& station) {
  if (station.kind == SectionKind::cable || station.kind == SectionKind::structure) return;
  update_maximum(region.bending_moment, station.bending_moment, station);
  update_maximum(region.bending_stress, station.bending_stress, station);
  update_maximum(region.von_mises, station.von_mises, station);
  update_maximum(region.strain, station.strain, station);
  update_maximum(region.effective_tension, station.effective_tension, station);
}

Regions make_regions(const std::vector<Station>& stations, double touchdown, std::optional<double> departure,
                     bool clamped) {
  std::vector<double> s, moment, vertical;
  for (const Station& station : stations) {
    s.push_back(station.s);
    moment.push_back(station.bending_moment);
    vertical.push_back(station.vertical_moment);
  }
  return find_regions({s, moment, vertical}, touchdown, departure, clamped);
}

/// Finds the minimum tension. If it is constant over a stretch, as on a bed without friction, the end towards the top
/// is used, as the location of the minimum would depend on rounding.
void find_min_tension(StaticResults& results) {
  constexpr double kSame = 1e-7;  // relative to the maximum tension
  const auto less = [](const Station& a, const Station& b) { return a.effective_tension < b.effective_tension; };
  const double min_tension = ranges::min_element(results.stations, less)->effective_tension;
  for (const Station& station : results.stations) {
    if (station.effective_tension <= min_tension + kSame * std::abs(results.max_tension)) {
      results.min_effective_tension = {min_tension, station.s, station.p_W, station.astern};
    }
  }
}

/// Sets the regions of the stations and the extremes of each region.
void find_extremes(StaticResults& results, const Regions& regions) {
  results.departure_s = regions.departure;
  results.inflection_s = regions.inflection;
  if (regions.carried) results.overbend.emplace();
  results.max_tension = results.stations.front().effective_tension;
  bool pipe_over_supports = false;
  for (Station& station : results.stations) {
    station.region = regions.of(station.s);
    pipe_over_supports =
        pipe_over_supports || (station.region == Region::overbend && station.kind != SectionKind::cable);
    if (station.region == Region::tower && !results.tower) results.tower.emplace();
    if (station.region == Region::tower) update_maximum(*results.tower, station);
    if (station.region == Region::overbend) update_maximum(*results.overbend, station);
    if (station.region == Region::sagbend) update_maximum(results.sagbend, station);
    results.max_tension = std::max(results.max_tension, station.effective_tension);
  }
  find_min_tension(results);
  if (!pipe_over_supports) results.overbend.reset();  // only cable lies there
}

Station station_at(const std::vector<Station>& stations, double s) {
  const auto after =
      std::lower_bound(stations.begin(), stations.end(), s - 1e-9, [](const Station& a, double v) { return a.s < v; });
  return after == stations.end() ? stations.back() : *after;
}

/// Sums all forces on the line, each from its own law, so that their balance checks the assembly.
void sum_forces(StaticResults& results, StaticSystem& system, const LineState& state) {
  for (int e = 0; e < system.mesh().elements(); ++e) {
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    const double h = system.mesh().length[static_cast<std::size_t>(e)];
    for (int i = 0; i < kGaussPoints; ++i) {
      const CentrelinePoint point = centreline(q, kGaussXi[i], h);
      const PointLoad load = point_load(system.elements(), system.environment(), e, point.r, point.a);
      const double w = kGaussWeight[i] * h;
      results.sum_weight += w * load.weight;
      results.sum_buoyancy += w * load.buoyancy;
      results.sum_current += w * load.current;
      results.sum_seabed += w * load.seabed;
    }
  }
  for (const RollerContact& roller : system.contacts()) {
    results.sum_rollers += roller.force();
  }
  system.evaluate(state, false);
  results.sum_attached = attached_force(system, state);
  results.top_reaction = system.end_reaction(system.mesh().nodes() - 1);
  results.anchor_reaction = system.end_reaction(0) + state.far_force * system.far_direction();
  results.total_weight = system.total_weight();
  const Vec3 sum = results.sum_weight + results.sum_buoyancy + results.sum_current + results.sum_seabed +
                   results.sum_rollers + results.sum_attached + results.top_reaction + results.anchor_reaction;
  results.global_residual = sum.norm() / results.total_weight;
  system.hold(false);
  results.force_residual = system.relative_residual();
}

void copy_model(StaticResults& results, const Model& model) {
  const VesselDescription& vessel = model.description.vessel;
  results.title = model.description.title;
  results.version = kVersion;
  results.assumptions = assumptions(model);
  results.findings = model_findings(model);
  for (const Section& s : model.sections) {
    results.sections.push_back({s.name, s.EA, s.EI, s.weight_in_air, s.weight_submerged, s.steel_area, s.second_moment,
                                s.outer_diameter, s.mass()});
  }
  results.stern_shoe_W = point_from_ramp(model, model.mean_pose, Vec3::Zero());
  results.tensioner_W = lay_plane(model, model.mean_pose).tensioner_W;
  results.R_WV = model.mean_pose.R_WV;
  results.vessel_name = vessel.name;
  results.vessel_length = vessel.length;
  results.vessel_beam = vessel.beam;
  results.vessel_depth = vessel.depth;
  results.vessel_draught = vessel.draught;
  results.water_depth = model.description.environment.water_depth;
  results.pipe_outer_diameter = model.pipe_section().outer_diameter;
  results.steel_outer_diameter = model.pipe_section().steel_diameter;
  results.wanted_tension = model.description.tensioner.tension.value_or(0.0);
}

}  // namespace

namespace {

/// Warns of residual curvature. Roll would relieve the sagbend; the rod does not roll, so the moments are an upper
/// bound.
void warn_of_roll(StaticResults& results) {
  constexpr double kWorthSaying = 1e-4;  // strain at the outer fibre; in sagbends it is at least three times that
  if (0.5 * results.steel_outer_diameter * results.residual_curvature < kWorthSaying) {
    return;
  }
  results.findings.push_back(Finding{
      FindingCode::residual_curvature,
      fmt::format(
          "the pipe has yielded over the supports and reaches touchdown with a residual curvature of {}; "
          "a real pipe rolls until this curvature is favourable, the model does not, so the bending moments of the "
          "sagbend are an upper bound",
          shown(results.residual_curvature, "1/m", 5))}
                                 .on("pipe")
                                 .with("curvature", results.residual_curvature, "1/m"));
}

/// Stations of a solution on its system, evaluated there.
std::vector<Station> stations_on(const StaticSystem& system, const StaticSolution& solution,
                                 const std::vector<CutForces>& cuts, const std::optional<ElementPlace>& touchdown) {
  return make_stations(system, solution.state, cuts, touchdown,
                       solution.past.solution ? solution.bending : std::vector<BendingMemory>());
}

/// Horizontal tension at a place, from the total force, as shear contributes to it [N].
double horizontal_tension_at(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts,
                             const ElementPlace& place) {
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * place.element));
  const double h = system.mesh().length[static_cast<std::size_t>(place.element)];
  return horizontal_tension(cut_at(system, state, cuts, place.element, place.xi).force, centreline(q, place.xi, h).a);
}

}  // namespace

std::vector<Station> recover_stations(const Model& model, const StaticSolution& solution) {
  StaticSystem system = system_with_history(model, solution.mesh, solution.past);
  const std::vector<CutForces> cuts = cut_forces(system, solution.state);
  return stations_on(system, solution, cuts, landing(system, solution.state));
}

StaticResults recover_state(const Model& model, const StaticSolution& solution) {
  StaticResults results;
  copy_model(results, model);
  StaticSystem system = system_with_history(model, solution.mesh, solution.past);
  const LineState& state = solution.state;
  const std::optional<ElementPlace> touchdown = landing(system, state);
  const std::vector<CutForces> cuts = cut_forces(system, state);
  results.stations = stations_on(system, solution, cuts, touchdown);

  const Station top = results.stations.back();
  const Station landing = touchdown ? station_at(results.stations, touchdown->s) : results.stations.front();
  results.touchdown = {landing.p_W, landing.s, landing.astern};
  results.lay_back = landing.astern;
  results.top_to_touchdown = (landing.p_W - top.p_W).head<2>().norm();
  results.total_length = top.s;
  results.length_top_to_touchdown = top.s - landing.s;
  results.top_tension = top.effective_tension;
  results.top_inclination = top.inclination;
  results.residual_curvature = landing.residual_curvature;
  results.bottom_tension = horizontal_tension_at(system, state, cuts, touchdown.value_or(ElementPlace{}));
  results.anchor_W = results.stations.front().p_W;

  const Departure departure = recover_supports(results, system, state);
  const Station leaving = departure.carried ? station_at(results.stations, departure.s) : top;
  results.departure_angle = leaving.inclination;
  results.last_support = departure.support;
  results.suspended_length = leaving.s - landing.s;
  find_extremes(results,
                make_regions(results.stations, landing.s, departure.carried ? std::optional(departure.s) : std::nullopt,
                             model.description.tensioner.guide == Guide::clamped));
  results.structures = recover_structures(model, results);
  recover_attachments(results, system, state, cuts);
  recover_bed(results, system, state);
  sum_forces(results, system, state);
  recover_stinger(results, system, solution);
  recover_cable(results, system, state);
  recover_dragging(results, system, state);
  if (touchdown) recover_route(results, system, state);
  results.solve = solution.report;
  results.solve.force_residual = results.force_residual;
  return results;
}

StaticResults recover_in_current(const Model& model, const StaticSolution& solution) {
  StaticResults results = recover_state(model, solution);
  warn_of_roll(results);
  warn_statics(model, results);
  warn_of_uneven_bed(model, results);
  warn_of_dragging(results);
  warn_of_attachments(results);
  warn_of_missed_target(results, model);
  note_sensitive_tension(results, model, solution);
  return results;
}

StaticResults recover_statics(const Model& model, const StaticSolution& solution) {
  StaticResults results = recover_in_current(model, solution);
  find_current_effect(model, solution, results);
  return results;
}

}  // namespace overbend

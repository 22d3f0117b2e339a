#include "statics/moored/moored_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "model/pipe/line_types.h"
#include "model/vessel/mooring_queries.h"
#include "moorings/bed_departure.h"
#include "moorings/clearance.h"
#include "moorings/periods.h"

namespace overbend {
namespace {

/// Points per suspended span for figures and clearances.
constexpr int kShapePoints = 60;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kLargeAngle = 10.0 * kDegree;  ///< Angle above which hydrostatic restoring is not linear.

template <class Matrix>
std::vector<double> by_rows(const Matrix& matrix) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) values.push_back(matrix(i, k));
  }
  return values;
}

std::vector<PeriodResult> find_periods(const Model& model, const HullEquilibrium& rest, const Mat6& stiffness) {
  std::vector<PeriodResult> results;
  const std::optional<CoupledHullDescription>& hull = model.description.vessel.coupled;
  if (!hull || hull->mass <= 0.0) return results;
  const Vec3 pull = (rest.forces.moorings + rest.forces.station).head<3>();
  const Mat6 about_G = stiffness_about(stiffness, pull, hull->centre_of_gravity);
  for (const NaturalPeriod& period : natural_periods(*hull, about_G)) results.push_back({period.mode, period.period});
  return results;
}

/// Stiffness of lines, thrusters and water with respect to translation and rotation. Derivatives with respect to angles
/// and rotations agree for small angles, as assumed for the water.
Mat6 total_stiffness(const StaticHull& hull, const HullEquilibrium& rest) {
  Mat6 water = Mat6::Zero();
  water.block<3, 3>(2, 2) = hull.restoring;
  return rest.forces.mooring_stiffness + rest.forces.station_stiffness +
         stiffness_about(water, Vec3::Zero(), -hull.restoring_point_V);
}

VesselResult vessel_result(const Model& model, const StaticHull& hull, const HullEquilibrium& rest, bool free) {
  VesselResult result = vessel_offset(rest.offset);
  if (free) {
    const Mat6 stiffness = total_stiffness(hull, rest);
    result.stiffness = by_rows(stiffness);
    result.natural_periods = find_periods(model, rest, stiffness);
  }
  return result;
}

void add_clearance(const std::vector<SeabedObjectDescription>& objects, MooringLineResult& result) {
  for (const SeabedObjectDescription& object : objects) {
    const double distance = polyline_distance(result.shape_W, object.points);
    if (result.clearance && *result.clearance <= distance) continue;
    result.clearance = distance;
    result.nearest_object = object.name;
  }
}

MooringLineResult line_result(const Model& model, const MooredLine& line, const Vec3& fairlead,
                              const CatenarySolution& solution) {
  const LineDirection to = line_direction(line, fairlead);
  MooringLineResult result;
  result.name = line.name;
  result.length = line.line.length();
  result.first_segment_length = line.line.first_segment();
  result.fairlead_W = fairlead;
  result.anchor_W = line.anchor_W;
  result.horizontal_distance = to.distance;
  const double azimuth = std::atan2(to.direction_W.x(), to.direction_W.y());
  result.azimuth = azimuth < 0.0 ? azimuth + kFullTurn : azimuth;
  result.parted = line.parted;
  if (line.parted) return result;
  result.fairlead_tension = solution.tension();
  result.horizontal = solution.pull;
  result.declination = std::atan2(solution.sink, solution.pull);
  result.anchor_tension = solution.anchor_tension();
  result.anchor_uplift = solution.anchor_uplift;
  result.uplift_angle = std::atan2(solution.anchor_uplift, std::max(solution.anchor_pull, 1e-9));
  result.suspended_length = solution.trace.touchdown_s;
  result.touchdown_distance = solution.trace.touchdown_x;
  result.on_bed = solution.trace.on_bed;
  result.slack = solution.slack;
  if (line.breaking_load) result.utilisation = result.fairlead_tension / *line.breaking_load;
  if (line.holding) result.anchor_utilisation = result.anchor_tension / *line.holding;
  for (const Eigen::Vector2d& point : catenary_shape(line.line, solution, kShapePoints)) {
    const Vec3 flat(fairlead.x(), fairlead.y(), point.y());
    result.shape_W.push_back(flat + point.x() * to.direction_W);
  }
  add_clearance(model.description.moorings->objects, result);
  return result;
}

const char* drift_assumption(const Description& d) {
  if (d.statics.mean_drift.value_or(false)) {
    return "In statics steady current, wind and mean wave drift act on the hull at its equilibrium heading.";
  }
  return "In statics steady current and wind act on the hull at its equilibrium heading; mean wave drift is not "
         "included.";
}

/// Tension at which the brake of a winch renders; nullopt if the line has no winch or the winch no limit.
std::optional<double> find_brake_load(const MooringsDescription& moorings, const std::string& winch) {
  const auto named = std::find_if(moorings.winches.begin(), moorings.winches.end(),
                                  [&](const WinchDescription& candidate) { return candidate.name == winch; });
  return named == moorings.winches.end() ? std::nullopt : named->brake;
}

void assume_lines(const MooringsDescription& moorings, Assumptions& list) {
  list.push_back({AssumptionRank::governing,
                  "Mooring lines are elastic catenaries: without bending stiffness, without current and waves on them, "
                  "on a rigid bed at the line's axis, with the weight in air above the mean water level."});
  list.push_back(
      {AssumptionRank::other, "Sheaves, their friction and the line from the fairlead to the winch are not modelled."});
  for (const MooringLineDescription& line : moorings.lines) {
    for (const LineSegmentDescription& segment : line.segments) {
      if (segment.type.made_from.empty() || segment.type.made_from == kGivenNumbers) continue;
      list = merge(std::move(list),
                   {{AssumptionRank::other, fmt::format("Mooring line \"{}\": properties by diameter, {}.", line.name,
                                                        segment.type.made_from)}});
    }
  }
}

/// Warns of thrusters at their limit, which hold no further load.
void warn_of_thrust(const StationKeepingDescription& law, const MooredState& state, Findings& list) {
  constexpr std::array<const char*, 3> kNames = {"surge", "sway", "yaw"};
  for (std::size_t i = 0; i < state.thrust.size(); ++i) {
    if (std::abs(state.thrust[i]) < law.limit[static_cast<Eigen::Index>(i)]) continue;
    list.push_back(
        Finding{FindingCode::thrust_at_limit,
                fmt::format("{}: dynamic positioning is at its thrust limit in {}; it cannot hold more load.",
                            state.name, kNames[i])}
            .on(std::string("dynamic positioning, ") + kNames[i]));
  }
}

/// Warns of offsets beyond the range of linear hydrostatic restoring.
void warn_of_large_offset(const VesselDescription& vessel, const MooredState& state, Findings& list) {
  const double heave = std::abs(state.vessel.heave);
  if (std::max(std::abs(state.vessel.roll), std::abs(state.vessel.pitch)) > kLargeAngle) {
    list.push_back(Finding{FindingCode::vessel_angle_nonlinear,
                           fmt::format("{}: the vessel heels by {:.1f} deg and trims by {:.1f} deg: beyond 10 deg "
                                       "hydrostatic restoring is not linear, as assumed here.",
                                       state.name, kToDegrees * state.vessel.roll, kToDegrees * state.vessel.pitch)}
                       .on("vessel")
                       .with("roll", state.vessel.roll, "rad")
                       .with("pitch", state.vessel.pitch, "rad"));
  }
  if (heave > 0.5 * (vessel.depth - vessel.draught)) {
    list.push_back(Finding{FindingCode::vessel_heave_nonlinear,
                           fmt::format("{}: the vessel heaves by {}, more than half its freeboard: hydrostatic "
                                       "restoring is not linear there, as assumed here.",
                                       state.name, shown(state.vessel.heave, "m", 2))}
                       .on("vessel")
                       .with("heave", state.vessel.heave, "m"));
  }
}

/// Warns where the straight bed of the catenary differs from the seabed. A difference of 1 m has little effect on
/// tensions at usual water depths.
void warn_of_bed(const SeabedSurface& bed, const MooringLineResult& line, const std::string& head, Findings& list) {
  constexpr double kMinDeparture = 1.0;
  constexpr const char* kWhy =
      "statics assume a straight bed from below the fairlead to the anchor, but on the actual bed the line has another "
      "tension and stiffness; a time-domain simulation starts from its equilibrium on the actual bed.";
  const BedDeparture departure = bed_departure(bed, line.shape_W);
  if (departure.inside > kMinDeparture) {
    list.push_back(Finding{FindingCode::line_off_seabed,
                           fmt::format("{} runs up to {} in the seabed, {} from its anchor: {}", head,
                                       shown(departure.inside, "m", 1), shown(departure.inside_at, "m", 0), kWhy)}
                       .on("mooring line " + line.name)
                       .with("depth", departure.inside, "m"));
  } else if (departure.over_hollow > kMinDeparture) {
    list.push_back(Finding{FindingCode::line_off_seabed,
                           fmt::format("{} is assumed to lie up to {} above the seabed, {} from its anchor: {}", head,
                                       shown(departure.over_hollow, "m", 1), shown(departure.hollow_at, "m", 0), kWhy)}
                       .on("mooring line " + line.name)
                       .with("height", departure.over_hollow, "m"));
  }
}

}  // namespace

VesselResult vessel_offset(const HullOffset& u) {
  VesselResult result;
  result.surge = u[0];
  result.sway = u[1];
  result.heave = u[2];
  result.roll = u[3];
  result.pitch = u[4];
  result.yaw = std::remainder(u[5], kFullTurn);
  return result;
}

MooredState moored_state(const std::string& name, const Model& model, const MooringSpread& spread,
                         const StaticHull& hull, const HullEquilibrium& rest, bool free) {
  MooredState state;
  state.name = name;
  state.vessel = vessel_result(model, hull, rest, free);
  if (free) {
    state.mooring_force = by_rows(rest.forces.moorings);
    state.mooring_stiffness = by_rows(rest.forces.mooring_stiffness);
    if (hull.station) state.thrust = by_rows(rest.forces.thrust);
  }
  state.residual = rest.residual;
  state.iterations = rest.iterations;
  const HullPlace place = make_hull_place(hull, rest.offset);
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& line = spread.lines[i];
    state.moorings.push_back(line_result(model, line, place.p_W + place.R_WV * line.fairlead_V, rest.lines[i]));
  }
  return state;
}

Findings mooring_findings(const Model& model, const MooringSpread& spread, const MooredState& state) {
  Findings list;
  const MooringsDescription& moorings = find_moorings(model.description);
  int effective = 0;
  for (std::size_t i = 0; i < state.moorings.size(); ++i) {
    const MooringLineResult& line = state.moorings[i];
    const std::string head = fmt::format("{}: mooring line \"{}\"", state.name, line.name);
    const std::string tension = shown(line.fairlead_tension, "N", 1);
    if (line.parted) continue;
    effective += line.slack ? 0 : 1;
    if (line.slack) {
      list.push_back(
          Finding{FindingCode::line_slack, head + " is slack and carries no load."}.on("mooring line " + line.name));
    }
    if (line.utilisation && *line.utilisation > 1.0) {
      list.push_back(Finding{FindingCode::breaking_load_exceeded,
                             fmt::format("{} has {}, more than its breaking load.", head, tension)}
                         .on("mooring line " + line.name)
                         .with("tension", line.fairlead_tension, "N"));
    } else if (moorings.working_load && line.fairlead_tension > *moorings.working_load) {
      list.push_back(Finding{FindingCode::working_load_exceeded,
                             fmt::format("{} has {}, more than the working load.", head, tension)}
                         .on("mooring line " + line.name)
                         .with("tension", line.fairlead_tension, "N"));
    }
    if (const std::optional<double> brake = find_brake_load(moorings, moorings.lines[i].winch);
        brake && line.fairlead_tension > *brake) {
      list.push_back(Finding{FindingCode::winch_limit_exceeded,
                             fmt::format("{} has {}, more than the {} at which its winch's brake renders.", head,
                                         tension, shown(*brake, "N", 1))}
                         .on("mooring line " + line.name)
                         .with("tension", line.fairlead_tension, "N"));
    }
    if (line.anchor_uplift > 0.0) {
      list.push_back(Finding{FindingCode::anchor_lifted,
                             fmt::format("{} lifts its anchor with {}: no length of it is left on the bed.", head,
                                         shown(line.anchor_uplift, "N", 1))}
                         .on("mooring line " + line.name)
                         .with("uplift", line.anchor_uplift, "N"));
    } else if (line.on_bed <= 0.0) {
      list.push_back(Finding{FindingCode::no_length_on_seabed, head + " has no length on the bed."}.on("mooring line " +
                                                                                                       line.name));
    }
    if (line.anchor_utilisation && *line.anchor_utilisation > 1.0) {
      list.push_back(Finding{FindingCode::anchor_holding_exceeded,
                             fmt::format("{} pulls its anchor with {}, more than its holding power.", head,
                                         shown(line.anchor_tension, "N", 1))}
                         .on("mooring line " + line.name)
                         .with("tension", line.anchor_tension, "N"));
    }
    warn_of_bed(spread.bed, line, head, list);
    const std::optional<double>& drum = spread.lines[i].drum;
    if (drum && line.first_segment_length > *drum) {
      list.push_back(Finding{FindingCode::drum_length_exceeded,
                             fmt::format("{} has {} out, more than the {} that its winch's drum holds.", head,
                                         shown(line.first_segment_length, "m", 1), shown(*drum, "m", 1))}
                         .on("mooring line " + line.name)
                         .with("length", line.first_segment_length, "m"));
    }
  }
  if (is_positioned(model.description)) {
    warn_of_thrust(*model.description.station_keeping, state, list);
  } else if (effective < 3 && hull_is_free(model.description)) {
    list.push_back(Finding{
        FindingCode::vessel_not_held,
        fmt::format(
            "{}: only {} of the mooring lines are under tension; fewer than three do not hold surge, sway and yaw.",
            state.name, effective)}
                       .on("vessel"));
  }
  warn_of_large_offset(model.description.vessel, state, list);
  return list;
}

Assumptions mooring_assumptions(const Model& model) {
  Assumptions list = assumptions(model);
  if (has_mooring_lines(model.description)) assume_lines(*model.description.moorings, list);
  if (model.description.vessel.coupled) {
    list.push_back({AssumptionRank::other, drift_assumption(model.description)});
  }
  return list;
}

}  // namespace overbend

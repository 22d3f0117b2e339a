#include "statics/moored_rest.h"

#include <cmath>

#include "hull/make_hull.h"

namespace overbend {
namespace {

/// Rounds of ballast and lengths, each of which hardly changes the other.
constexpr int kTrimRounds = 4;

/// A held hull: the lines alone.
void solve_lines(MooredHull& moored) {
  moored.rest.forces = hull_forces(moored.spread, moored.hull, moored.rest.offset, moored.rest.lines);
  moored.rest.fault = moored.rest.forces.fault;
}

/// Lengths that hold the hull as drawn, with the least change of the pulls that the lines have as drawn.
void solve_lengths(MooredHull& moored, const TensionBounds& bounds) {
  solve_lines(moored);
  if (moored.rest.fault || !moored.free) return;
  const Eigen::VectorXd wished = pulls_of(moored.spread, moored.rest.lines);
  moored.rest = plan_lengths(moored.spread, moored.hull, HullOffset::Zero(), wished, bounds);
}

/// Of current and wind on the hull with its heading as drawn: force and moment about midship, axes D.
Vec6 steady_load(const Model& model, const HullAtRest& hull, const CoupledHullDescription& coupled) {
  const double heading = std::atan2(hull.axes_WD(1, 0), hull.axes_WD(0, 0));
  Vec6 load = current_force(make_hull_current(model, coupled), heading, Vec6::Zero(), {}).force +
              wind_force(make_hull_wind(coupled), heading);
  const Vec3 force = load.head<3>();
  load.tail<3>() += coupled.centre_of_gravity.cross(force);
  return load;
}

}  // namespace

TensionBounds bounds_of(const MooringsDescription& moorings) {
  TensionBounds bounds;
  bounds.least = moorings.least_tension.value_or(bounds.least);
  bounds.most = moorings.working_load.value_or(bounds.most);
  return bounds;
}

std::variant<MooredHull, StaticFailure> moored_hull(const Model& model) {
  const Description& d = model.description;
  SpreadOutcome outcome = build_spread(*d.moorings, model.seabed.surface, model.drawn_pose.R_WV);
  if (outcome.fault) {
    return StaticFailure{"the mooring lines cannot be as given", "", *outcome.fault};
  }
  if (d.operation.type == OperationType::pull_ahead && !hull_is_free(d)) {
    return StaticFailure{"a held hull cannot be pulled ahead", "operation.type",
                         "give vessel.hydrostatics or vessel.motion.coupled, or leave out the operation", true};
  }
  MooredHull moored;
  moored.spread = std::move(outcome.spread);
  moored.hull = hull_at_rest(d);
  moored.free = hull_is_free(d);
  if (d.vessel.coupled) {
    moored.hull.steady += steady_load(model, moored.hull, *d.vessel.coupled);
  }
  return moored;
}

void find_pose(MooredHull& moored) {
  if (moored.free) {
    moored.rest = find_rest(moored.spread, moored.hull, moored.rest.offset);
  } else {
    solve_lines(moored);
  }
}

void find_rest_at_start(const Description& d, MooredHull& moored) {
  const bool lengths = d.moorings->find == FindMooring::lengths;
  const bool trim = moored.free && d.vessel.coupled && d.vessel.coupled->ballast == Ballast::trim;
  for (int round = 0; round < (trim ? kTrimRounds : 1) && !moored.rest.fault; ++round) {
    if (trim) moored.rest = trim_ballast(moored.spread, moored.hull, HullOffset::Zero());
    if (moored.rest.fault) return;
    if (lengths) {
      solve_lengths(moored, bounds_of(*d.moorings));
    } else {
      find_pose(moored);
    }
  }
}

MooringFault broken_line(const MooredHull& moored) {
  const HullPlace place = place_of(moored.hull, moored.rest.offset);
  for (std::size_t i = 0; i < moored.spread.lines.size(); ++i) {
    const MooredLine& line = moored.spread.lines[i];
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    const bool stretched = (line.anchor_W - fairlead).norm() > line.line.length();
    if (!line.parted && stretched && line.breaking_load && moored.rest.lines[i].tension() > *line.breaking_load) {
      return line_fault(moored.spread, line, fairlead, CatenaryFault::too_short);
    }
  }
  return std::nullopt;
}

}  // namespace overbend

#include "statics/moored/moored_rest.h"

#include <memory>

#include "hull/make_hull.h"
#include "model/vessel/station.h"

namespace overbend {
namespace {

/// Rounds of ballast and lengths, each of which hardly changes the other.
constexpr int kTrimRounds = 4;

/// A held hull: the lines alone.
void find_lengths(MooredHull& moored) {
  moored.rest.forces = hull_forces(moored.spread, moored.hull, moored.rest.offset, moored.rest.lines);
  moored.rest.fault = moored.rest.forces.fault;
}

/// Lengths that hold the hull as drawn, with the least change of the wished pulls.
void solve_lengths(MooredHull& moored, const Eigen::VectorXd& wished, const TensionBounds& bounds) {
  moored.rest = plan_lengths(moored.spread, moored.hull, HullOffset::Zero(), wished, bounds);
}

/// The waves whose mean drift acts in statics: those of the model's own seed.
Sea drifting_sea(const Description& d) {
  if (!d.statics.mean_drift.value_or(false)) return {};
  return make_sea(d.environment.waves, d.environment.water_depth, d.environment.waves.seed);
}

/// Current, wind and drift on the hull turned by a yaw from its drawn heading: about midship, axes D.
void put_surroundings(const Model& model, const CoupledHullDescription& coupled, HullAtRest& hull) {
  auto around = std::make_shared<Hull>(hull_in_surroundings(model, coupled, drifting_sea(model.description)));
  around->mean_drift_from_start = true;
  const Vec3 arm = coupled.centre_of_gravity;
  hull.surroundings = [around = std::shared_ptr<const Hull>(std::move(around)), arm](double yaw) {
    const Mat3 turn = turned_about_z(yaw);
    const Vec6 load = steady_forces(*around, around->drawn(5) + yaw).sum();
    const Vec3 force = turn * load.head<3>(), moment = turn * load.tail<3>();
    return (Vec6() << force, moment + (turn * arm).cross(force)).finished();
  };
}

/// Lines whose type and model say nothing of friction rub on the seabed as everything else does.
MooringsDescription moorings_on_bed(const Description& d) {
  MooringsDescription moorings = moorings_of(d);
  if (!moorings.bed_friction) moorings.bed_friction = d.environment.seabed.friction_axial;
  return moorings;
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
  SpreadOutcome outcome = build_spread(moorings_on_bed(d), model.seabed.surface, model.drawn_pose.R_WV);
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
    put_surroundings(model, *d.vessel.coupled, moored.hull);
  }
  return moored;
}

void find_pose(MooredHull& moored) {
  if (moored.free) {
    moored.rest = find_rest(moored.spread, moored.hull, moored.rest.offset);
  } else {
    find_lengths(moored);
  }
}

void find_rest_at_start(const Description& d, MooredHull& moored) {
  const bool lengths = has_mooring_lines(d) && d.moorings->find == FindMooring::lengths;
  Eigen::VectorXd wished;  // what the lines pull with as described, the hull as drawn and before it gives way to loads
  if (lengths) {
    moored.rest.offset.setZero();
    find_lengths(moored);
    if (moored.rest.fault || !moored.free) return;
    wished = pulls_of(moored.spread, moored.rest.lines);
  }
  const bool trim = moored.free && d.vessel.coupled && d.vessel.coupled->ballast == Ballast::trim;
  for (int round = 0; round < (trim ? kTrimRounds : 1) && !moored.rest.fault; ++round) {
    if (trim) moored.rest = trim_ballast(moored.spread, moored.hull, HullOffset::Zero());
    if (moored.rest.fault) return;
    if (lengths) {
      solve_lengths(moored, wished, bounds_of(*d.moorings));
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

#include "statics/moored/moored_equilibrium.h"

#include <memory>

#include "hull/make_hull.h"
#include "model/site/wave_groups.h"
#include "model/vessel/mooring_queries.h"

namespace overbend {
namespace {

/// Iterations of ballast and lengths, which are weakly coupled.
constexpr int kTrimRounds = 4;

/// Solves the lines alone, for a held hull.
void find_lengths(MooredHull& moored) {
  moored.rest.forces = hull_forces(moored.spread, moored.hull, moored.rest.offset, moored.rest.lines);
  moored.rest.error = moored.rest.forces.error;
}

/// Finds the lengths that hold the hull in its nominal pose with the smallest change of the wanted forces.
void solve_lengths(MooredHull& moored, const Eigen::VectorXd& wished, const TensionBounds& bounds) {
  moored.rest = plan_lengths(moored.spread, moored.hull, HullOffset::Zero(), wished, bounds);
}

/// Waves of the mean drift in statics: those of the model's own seed.
Sea drifting_sea(const Description& d) {
  if (!d.statics.mean_drift.value_or(false)) return {};
  return make_sea(d.environment.waves, d.environment.water_depth, default_seed(d.environment.waves));
}

/// Sets current, wind and drift forces on the hull at a yaw from its nominal heading: about midship, axes D.
void set_environment(const Model& model, const CoupledHullDescription& coupled, StaticHull& hull) {
  auto around = std::make_shared<Hull>(make_hull_in_environment(model, coupled, drifting_sea(model.description)));
  around->mean_drift_from_start = true;
  const Vec3 arm = coupled.centre_of_gravity;
  hull.surroundings = [around = std::shared_ptr<const Hull>(std::move(around)), arm](double yaw) {
    const Mat3 turn = turned_about_z(yaw);
    const Vec6 load = steady_forces(*around, around->drawn(5) + yaw).sum();
    const Vec3 force = turn * load.head<3>(), moment = turn * load.tail<3>();
    return (Vec6() << force, moment + (turn * arm).cross(force)).finished();
  };
}

/// Mooring lines; those without a friction coefficient get the axial friction of the seabed.
MooringsDescription moorings_on_bed(const Description& d) {
  MooringsDescription moorings = find_moorings(d);
  if (!moorings.bed_friction) moorings.bed_friction = d.environment.seabed.friction_axial;
  return moorings;
}

}  // namespace

TensionBounds make_tension_bounds(const MooringsDescription& moorings) {
  TensionBounds bounds;
  bounds.lower = moorings.min_tension.value_or(bounds.lower);
  bounds.upper = moorings.working_load.value_or(bounds.upper);
  return bounds;
}

std::variant<MooredHull, StaticFailure> moored_hull(const Model& model) {
  const Description& d = model.description;
  SpreadOutcome outcome = build_spread(moorings_on_bed(d), model.seabed.surface, model.nominal_pose.R_WV);
  if (outcome.error) {
    return StaticFailure{"invalid mooring lines", "", *outcome.error};
  }
  if (d.operation.type == OperationType::pull_ahead && !hull_is_free(d)) {
    return StaticFailure{"a held hull cannot be pulled ahead", "operation.type",
                         "give vessel.hydrostatics or vessel.motion.coupled, or leave out the operation", true};
  }
  MooredHull moored;
  moored.spread = std::move(outcome.spread);
  moored.hull = make_static_hull(d);
  moored.free = hull_is_free(d);
  if (d.vessel.coupled) {
    set_environment(model, *d.vessel.coupled, moored.hull);
  }
  return moored;
}

void find_pose(MooredHull& moored) {
  if (moored.free) {
    moored.rest = find_hull_equilibrium(moored.spread, moored.hull, moored.rest.offset);
  } else {
    find_lengths(moored);
  }
}

void find_initial_equilibrium(const Description& d, MooredHull& moored) {
  const bool lengths = has_mooring_lines(d) && d.moorings->find == FindMooring::lengths;
  // forces of the lines as described, with the hull in its nominal pose before it is displaced by loads
  Eigen::VectorXd wished;
  if (lengths) {
    moored.rest.offset.setZero();
    find_lengths(moored);
    if (moored.rest.error || !moored.free) return;
    wished = horizontal_pulls(moored.spread, moored.rest.lines);
  }
  const bool trim = moored.free && d.vessel.coupled && d.vessel.coupled->ballast == Ballast::trim;
  for (int round = 0; round < (trim ? kTrimRounds : 1) && !moored.rest.error; ++round) {
    if (trim) moored.rest = trim_ballast(moored.spread, moored.hull, HullOffset::Zero());
    if (moored.rest.error) return;
    if (lengths) {
      solve_lengths(moored, wished, make_tension_bounds(*d.moorings));
    } else {
      find_pose(moored);
    }
  }
}

MooringError broken_line(const MooredHull& moored) {
  const HullPlace place = make_hull_place(moored.hull, moored.rest.offset);
  for (std::size_t i = 0; i < moored.spread.lines.size(); ++i) {
    const MooredLine& line = moored.spread.lines[i];
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    const bool stretched = (line.anchor_W - fairlead).norm() > line.line.length();
    if (!line.parted && stretched && line.breaking_load && moored.rest.lines[i].tension() > *line.breaking_load) {
      return line_error_message(moored.spread, line, fairlead, CatenaryError::too_short);
    }
  }
  return std::nullopt;
}

}  // namespace overbend

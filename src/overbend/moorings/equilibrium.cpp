#include "moorings/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/dense_algebra.h"
#include "base/interruption.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 300;
constexpr int kMaxIdle = 60;       ///< Maximum number of successive steps without improvement, to pass over a
                                   ///< maximum of the forces.
constexpr int kMaxTrials = 14;     ///< Per damped step.
constexpr double kMaxShift = 5.0;  ///< Per step [m].
constexpr double kMaxRotation = 2.0 * kDegree;  ///< Per step [rad].
constexpr double kMinRelativeStiffness = 1e-9;  ///< Minimum stiffness of a mode relative to the largest [-].
constexpr double kBalanced = 1e-9;              ///< Tolerance relative to the weight of the lines [-].

Mat3 turn(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

/// Attitude in D, and the axes of rotation of the three angles (columns).
struct Attitude {
  Mat3 R_DV, axes, yawed;
};
Attitude make_attitude(const StaticHull& hull, const HullOffset& u) {
  const Mat3 yaw = turn(2, u[5]), pitch = turn(1, hull.pitch + u[4]), roll = turn(0, hull.heel + u[3]);
  Attitude attitude;
  attitude.R_DV = yaw * pitch * roll;
  attitude.axes << yaw * pitch.col(0), yaw.col(1), Vec3::UnitZ();
  attitude.yawed = yaw;
  return attitude;
}

/// Heave, roll and pitch stiffness about a point that may differ from the reference point.
void add_restoring(const StaticHull& hull, const HullOffset& u, const Attitude& attitude, HullForces& sum) {
  const Vec3 drawn = make_attitude(hull, HullOffset::Zero()).R_DV * hull.restoring_point_V;
  const Vec3 arm = attitude.R_DV * hull.restoring_point_V;
  const Vec3 q(u[2] + arm.z() - drawn.z(), u[3], u[4]);
  const Vec3 g = -hull.restoring * q;
  const Vec3 force(0.0, 0.0, g[0]), level = attitude.yawed * Vec3(g[1], g[2], 0.0);
  sum.total.head<3>() += force;
  sum.total.tail<3>() += level + arm.cross(force);
  Eigen::Matrix<double, 3, 6> dq = Eigen::Matrix<double, 3, 6>::Zero();
  dq(0, 2) = 1.0;
  dq.row(0).tail<3>() = Vec3(arm.y(), -arm.x(), 0.0).transpose() * attitude.axes;
  dq(1, 3) = dq(2, 4) = 1.0;
  const Eigen::Matrix<double, 3, 6> dg = -hull.restoring * dq;
  sum.slope.row(2) -= dg.row(0);
  sum.slope.bottomRows<3>() -= attitude.yawed.leftCols<2>() * dg.bottomRows<2>() + arm.cross(Vec3::UnitZ()) * dg.row(0);
  sum.slope.block<3, 1>(3, 5) -= Vec3::UnitZ().cross(level);
  sum.slope.bottomRightCorner<3, 3>() -= cross_matrix(force) * cross_matrix(arm) * attitude.axes;
}

void add_loads(const StaticHull& hull, const Attitude& attitude, HullForces& sum) {
  sum.total += hull.steady;
  for (const VesselLoadDescription& load : hull.loads) {
    const Vec3 arm = attitude.R_DV * load.at;
    sum.total.head<3>() += load.force;
    sum.total.tail<3>() += load.moment + arm.cross(load.force);
    sum.slope.bottomRightCorner<3, 3>() -= cross_matrix(load.force) * cross_matrix(arm) * attitude.axes;
  }
}

void add_surroundings(const StaticHull& hull, const HullOffset& u, HullForces& sum) {
  if (!hull.surroundings) return;
  const double d = 1e-5;  // the forces change over degrees
  sum.total += hull.surroundings(u[5]);
  sum.slope.col(5) -= (hull.surroundings(u[5] + d) - hull.surroundings(u[5] - d)) / (2.0 * d);
}

/// Force of dynamic positioning: in the hull's horizontal axes, and about the reference point in D.
struct StationForce {
  Vec3 thrust;
  Vec6 load;
};
StationForce station_force(const StaticHull& hull, const HullOffset& u) {
  const StaticPositioning& station = *hull.station;
  const Attitude attitude = make_attitude(hull, u);
  const Vec3 arm = attitude.R_DV * station.point_V;
  const Vec3 shift = u.head<3>() + arm - make_attitude(hull, HullOffset::Zero()).R_DV * station.point_V;
  const Vec3 off_D(station.wanted.x() - shift.x(), station.wanted.y() - shift.y(), 0.0);
  Vec3 off = attitude.yawed.transpose() * off_D;
  off.z() = station.wanted.z() - u[5];
  const Vec3 thrust = station.law.stiffness.cwiseProduct(off).cwiseMax(-station.law.limit).cwiseMin(station.law.limit);
  const Vec3 force = attitude.yawed * Vec3(thrust.x(), thrust.y(), 0.0);
  return {thrust, (Vec6() << force, arm.cross(force) + thrust.z() * Vec3::UnitZ()).finished()};
}

void add_station(const StaticHull& hull, const HullOffset& u, HullForces& sum) {
  if (!hull.station) return;
  const double d = 1e-5;  // [m], [rad]; the law is linear up to the thrust limit
  const StationForce force = station_force(hull, u);
  sum.station = force.load;
  sum.thrust = force.thrust;
  for (int k = 0; k < 6; ++k) {
    const HullOffset step = d * HullOffset::Unit(k);
    sum.station_stiffness.col(k) =
        (station_force(hull, u - step).load - station_force(hull, u + step).load) / (2.0 * d);
  }
  sum.total += sum.station;
  sum.slope += sum.station_stiffness;
}

Mat6 turned(const Mat6& m, const Mat3& axes) {
  Mat6 result;
  for (const int i : {0, 3}) {
    for (const int k : {0, 3}) result.block<3, 3>(i, k) = axes.transpose() * m.block<3, 3>(i, k) * axes;
  }
  return result;
}

void add_lines(const MooringSpread& spread, const StaticHull& hull, const HullPlace& place, const Attitude& attitude,
               std::vector<CatenarySolution>& lines, HullForces& sum) {
  const MooringWrench wrench = mooring_wrench(spread, place, lines);
  sum.error = wrench.error;
  sum.moorings.head<3>() = hull.axes_WD.transpose() * wrench.load.head<3>();
  sum.moorings.tail<3>() = hull.axes_WD.transpose() * wrench.load.tail<3>();
  sum.mooring_stiffness = turned(wrench.stiffness, hull.axes_WD);
  sum.total += sum.moorings;
  sum.slope.leftCols<3>() += sum.mooring_stiffness.leftCols<3>();
  sum.slope.rightCols<3>() += sum.mooring_stiffness.rightCols<3>() * attitude.axes;
}

/// Unbalanced forces of the free modes relative to the force scale.
double unbalanced(const Vec6& total, const FreeModes& free, double weight, double arm) {
  double max_unbalanced = 0.0;
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) {
      max_unbalanced = std::max(max_unbalanced, std::abs(total[i]) / (i < 3 ? weight : weight * arm));
    }
  }
  return max_unbalanced;
}

/// Forces conjugate to the six coordinates, with angles and moments scaled by `arm`; zero for fixed modes.
Vec6 working_forces(const StaticHull& hull, const HullOffset& u, const Vec6& total, const FreeModes& free, double arm) {
  Vec6 work = total;
  work.tail<3>() = make_attitude(hull, u).axes.transpose() * total.tail<3>() / arm;
  for (int i = 0; i < 6; ++i) work[i] *= free[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
  return work;
}

/// Newton step, downhill in energy also where the stiffness is indefinite: absolute eigenvalues, bounded below by a
/// share of the largest (Nocedal & Wright, Numerical Optimization, 2006, section 3.4).
Vec6 compute_step(const StaticHull& hull, const HullEquilibrium& equilibrium, const FreeModes& free, double arm) {
  Mat6 slope = equilibrium.forces.slope;
  slope.bottomRows<3>() = make_attitude(hull, equilibrium.offset).axes.transpose() * slope.bottomRows<3>() / arm;
  slope.rightCols<3>() /= arm;
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) continue;
    slope.row(i).setZero();
    slope.col(i).setZero();
  }
  const SymmetricModes modes = symmetric_modes(0.5 * (slope + slope.transpose()));
  const Vec6 sizes = modes.values.cwiseAbs();
  const Vec6 floored = sizes.cwiseMax(kMinRelativeStiffness * sizes.maxCoeff());
  const Vec6 work = working_forces(hull, equilibrium.offset, equilibrium.forces.total, free, arm);
  Vec6 step = modes.vectors * (modes.vectors.transpose() * work).cwiseQuotient(floored);
  step.tail<3>() /= arm;
  if (!step.allFinite()) return Vec6::Zero();
  const double excess =
      std::max(step.head<3>().norm() / kMaxShift, step.tail<3>().lpNorm<Eigen::Infinity>() / kMaxRotation);
  return excess > 1.0 ? Vec6(step / excess) : step;
}

/// Takes one step, shortened where it passes far beyond the minimum of energy along it. Returns false if nothing is
/// gained.
bool advance(const MooringSpread& spread, const StaticHull& hull, const FreeModes& free, double weight, double arm,
             HullEquilibrium& equilibrium) {
  const Vec6 step = compute_step(hull, equilibrium, free, arm);
  const auto work_along = [&](const HullOffset& u, const Vec6& total) {
    Vec6 scaled = step;
    scaled.tail<3>() *= arm;
    return working_forces(hull, u, total, free, arm).dot(scaled);
  };
  const double start_work = work_along(equilibrium.offset, equilibrium.forces.total);
  double share = 1.0;
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    const HullOffset trial_offset = equilibrium.offset + share * step;
    std::vector<CatenarySolution> lines = equilibrium.lines;
    HullForces forces = hull_forces(spread, hull, trial_offset, lines);
    const double work = forces.error ? -start_work : work_along(trial_offset, forces.total);
    const double residual = unbalanced(forces.total, free, weight, arm);
    if (!forces.error && (work >= -0.5 * start_work || residual < equilibrium.residual)) {
      const bool gained = residual < equilibrium.residual || start_work > 0.0;
      equilibrium.offset = trial_offset;
      equilibrium.lines = std::move(lines);
      equilibrium.forces = std::move(forces);
      equilibrium.residual = residual;
      return gained;
    }
    share *= forces.error ? 0.5 : std::clamp(start_work / (start_work - work), 0.1, 0.7);
  }
  return false;
}

MooringError equilibrium_error_message(const MooringSpread& spread, const StaticHull& hull,
                                       const HullEquilibrium& equilibrium) {
  if (hull.station) {
    if (thrust_is_exhausted(hull, equilibrium.forces.thrust)) {
      return "no equilibrium of the hull: dynamic positioning is at its thrust limit (station_keeping.dp)";
    }
    const Vec3& stiffness = hull.station->law.stiffness;
    for (int i = 0; i < 3 && spread.lines.empty(); ++i) {
      constexpr std::array<const char*, 3> kNames = {"surge", "sway", "yaw"};
      if (stiffness[i] > 0.0) continue;
      return fmt::format("no equilibrium of the hull: nothing holds it in {0}; give station_keeping.dp.{0}",
                         kNames[static_cast<std::size_t>(i)]);
    }
    return fmt::format(
        "no equilibrium of the hull was found in {} iterations: unbalanced force {:.1e} of the force scale",
        equilibrium.iterations, equilibrium.residual);
  }
  const int effective = effective_lines(spread, equilibrium.lines);
  if (effective < 3) {
    return fmt::format(
        "no equilibrium of the hull: only {} of its mooring lines are under tension, and three are needed to hold "
        "surge, sway and yaw",
        effective);
  }
  return fmt::format(
      "no equilibrium of the hull was found in {} iterations: unbalanced force {:.1e} of the weight of the lines",
      equilibrium.iterations, equilibrium.residual);
}

}  // namespace

HullPlace make_hull_place(const StaticHull& hull, const HullOffset& offset) {
  return {hull.axes_WD * offset.head<3>(), hull.axes_WD * make_attitude(hull, offset).R_DV};
}

HullForces hull_forces(const MooringSpread& spread, const StaticHull& hull, const HullOffset& offset,
                       std::vector<CatenarySolution>& lines) {
  HullForces sum;
  const Attitude attitude = make_attitude(hull, offset);
  add_restoring(hull, offset, attitude, sum);
  add_loads(hull, attitude, sum);
  add_surroundings(hull, offset, sum);
  add_station(hull, offset, sum);
  add_lines(spread, hull, make_hull_place(hull, offset), attitude, lines, sum);
  return sum;
}

HullEquilibrium find_hull_equilibrium(const MooringSpread& spread, const StaticHull& hull, const HullOffset& start,
                                      const FreeModes& free) {
  HullEquilibrium equilibrium;
  equilibrium.offset = start;
  const double weight = force_scale(spread, hull.station ? std::optional(hull.station->law) : std::nullopt);
  const double arm = 0.5 * hull.length;
  equilibrium.forces = hull_forces(spread, hull, equilibrium.offset, equilibrium.lines);
  equilibrium.error = equilibrium.forces.error;
  if (equilibrium.error) return equilibrium;
  equilibrium.residual = unbalanced(equilibrium.forces.total, free, weight, arm);
  double min_residual = equilibrium.residual;
  int idle = 0;  // steps since the residual last improved
  for (; equilibrium.residual > kBalanced && equilibrium.iterations < kMaxIterations && idle < kMaxIdle;
       ++equilibrium.iterations) {
    check_interruption();
    if (!advance(spread, hull, free, weight, arm, equilibrium)) break;
    idle = equilibrium.residual < min_residual ? 0 : idle + 1;
    min_residual = std::min(min_residual, equilibrium.residual);
  }
  if (equilibrium.residual > 100.0 * kBalanced) {
    equilibrium.error = equilibrium_error_message(spread, hull, equilibrium);
  }
  return equilibrium;
}

Mat6 stiffness_about(const Mat6& stiffness, const Vec3& force, const Vec3& arm) {
  Mat6 to_point = Mat6::Identity();  // shift of the original point by that of the new one
  to_point.topRightCorner<3, 3>() = cross_matrix(arm);
  Mat6 about = to_point.transpose() * stiffness * to_point;
  about.bottomRightCorner<3, 3>() += cross_matrix(force) * cross_matrix(arm);  // the arm turns with the hull
  return about;
}

int effective_lines(const MooringSpread& spread, const std::vector<CatenarySolution>& lines) {
  int count = 0;
  for (std::size_t i = 0; i < spread.lines.size() && i < lines.size(); ++i) {
    count += !spread.lines[i].parted && !lines[i].slack ? 1 : 0;
  }
  return count;
}

double force_scale(const MooringSpread& spread, const std::optional<StationKeepingDescription>& station) {
  double sum = station ? station->stiffness.head<2>().maxCoeff() : 0.0;  // at an offset of 1 m
  for (const MooredLine& line : spread.lines) {
    for (const CatenaryPiece& piece : line.line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  }
  return std::max(sum, 1.0);
}

bool thrust_is_exhausted(const StaticHull& hull, const Vec3& thrust) {
  return hull.station && (thrust.cwiseAbs().array() >= hull.station->law.limit.array()).any();
}

}  // namespace overbend

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
constexpr int kMaxIdle = 60;           ///< Steps in a row that may leave the balance worse: over a hill of forces.
constexpr int kMaxTrials = 14;         ///< Of one damped step.
constexpr double kLongestShift = 5.0;  ///< Of one step [m].
constexpr double kLargestTurn = 2.0 * kDegree;  ///< Of one step [rad].
constexpr double kLeastStiffness = 1e-9;        ///< Of a mode, over the largest [-].
constexpr double kBalanced = 1e-9;              ///< Share of the weight of the lines [-].

Mat3 turn(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

/// Attitude in D, and what the three angles turn it about (columns).
struct Attitude {
  Mat3 R_DV, axes, yawed;
};
Attitude attitude_of(const HullAtRest& hull, const HullOffset& u) {
  const Mat3 yaw = turn(2, u[5]), pitch = turn(1, hull.pitch + u[4]), roll = turn(0, hull.heel + u[3]);
  Attitude attitude;
  attitude.R_DV = yaw * pitch * roll;
  attitude.axes << yaw * pitch.col(0), yaw.col(1), Vec3::UnitZ();
  attitude.yawed = yaw;
  return attitude;
}

/// Heave, roll and pitch spring, about a point that may lie beside the reference point.
void add_restoring(const HullAtRest& hull, const HullOffset& u, const Attitude& at, HullForces& sum) {
  const Vec3 drawn = attitude_of(hull, HullOffset::Zero()).R_DV * hull.restoring_point_V;
  const Vec3 arm = at.R_DV * hull.restoring_point_V;
  const Vec3 q(u[2] + arm.z() - drawn.z(), u[3], u[4]);
  const Vec3 g = -hull.restoring * q;
  const Vec3 force(0.0, 0.0, g[0]), level = at.yawed * Vec3(g[1], g[2], 0.0);
  sum.total.head<3>() += force;
  sum.total.tail<3>() += level + arm.cross(force);
  Eigen::Matrix<double, 3, 6> dq = Eigen::Matrix<double, 3, 6>::Zero();
  dq(0, 2) = 1.0;
  dq.row(0).tail<3>() = Vec3(arm.y(), -arm.x(), 0.0).transpose() * at.axes;
  dq(1, 3) = dq(2, 4) = 1.0;
  const Eigen::Matrix<double, 3, 6> dg = -hull.restoring * dq;
  sum.slope.row(2) -= dg.row(0);
  sum.slope.bottomRows<3>() -= at.yawed.leftCols<2>() * dg.bottomRows<2>() + arm.cross(Vec3::UnitZ()) * dg.row(0);
  sum.slope.block<3, 1>(3, 5) -= Vec3::UnitZ().cross(level);
  sum.slope.bottomRightCorner<3, 3>() -= cross_matrix(force) * cross_matrix(arm) * at.axes;
}

void add_loads(const HullAtRest& hull, const Attitude& at, HullForces& sum) {
  sum.total += hull.steady;
  for (const VesselLoadDescription& load : hull.loads) {
    const Vec3 arm = at.R_DV * load.at;
    sum.total.head<3>() += load.force;
    sum.total.tail<3>() += load.moment + arm.cross(load.force);
    sum.slope.bottomRightCorner<3, 3>() -= cross_matrix(load.force) * cross_matrix(arm) * at.axes;
  }
}

void add_surroundings(const HullAtRest& hull, const HullOffset& u, HullForces& sum) {
  if (!hull.surroundings) return;
  const double d = 1e-5;  // the forces change over degrees
  sum.total += hull.surroundings(u[5]);
  sum.slope.col(5) -= (hull.surroundings(u[5] + d) - hull.surroundings(u[5] - d)) / (2.0 * d);
}

/// Of dynamic positioning: in the hull's horizontal axes, and about the reference point in D.
struct StationForce {
  Vec3 thrust;
  Vec6 load;
};
StationForce station_force(const HullAtRest& hull, const HullOffset& u) {
  const StationAtRest& station = *hull.station;
  const Attitude at = attitude_of(hull, u);
  const Vec3 arm = at.R_DV * station.point_V;
  const Vec3 shift = u.head<3>() + arm - attitude_of(hull, HullOffset::Zero()).R_DV * station.point_V;
  const Vec3 off_D(station.wanted.x() - shift.x(), station.wanted.y() - shift.y(), 0.0);
  Vec3 off = at.yawed.transpose() * off_D;
  off.z() = station.wanted.z() - u[5];
  const Vec3 thrust = station.law.stiffness.cwiseProduct(off).cwiseMax(-station.law.limit).cwiseMin(station.law.limit);
  const Vec3 force = at.yawed * Vec3(thrust.x(), thrust.y(), 0.0);
  return {thrust, (Vec6() << force, arm.cross(force) + thrust.z() * Vec3::UnitZ()).finished()};
}

void add_station(const HullAtRest& hull, const HullOffset& u, HullForces& sum) {
  if (!hull.station) return;
  const double d = 1e-5;  // [m], [rad]; the law is a straight line but where it is cut off
  const StationForce here = station_force(hull, u);
  sum.station = here.load;
  sum.thrust = here.thrust;
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

void add_lines(const MooringSpread& spread, const HullAtRest& hull, const HullPlace& place, const Attitude& at,
               std::vector<CatenarySolution>& lines, HullForces& sum) {
  const MooringWrench wrench = mooring_wrench(spread, place, lines);
  sum.fault = wrench.fault;
  sum.moorings.head<3>() = hull.axes_WD.transpose() * wrench.load.head<3>();
  sum.moorings.tail<3>() = hull.axes_WD.transpose() * wrench.load.tail<3>();
  sum.mooring_stiffness = turned(wrench.stiffness, hull.axes_WD);
  sum.total += sum.moorings;
  sum.slope.leftCols<3>() += sum.mooring_stiffness.leftCols<3>();
  sum.slope.rightCols<3>() += sum.mooring_stiffness.rightCols<3>() * at.axes;
}

/// Unbalanced forces of the free modes as shares of the force scale.
double unbalanced(const Vec6& total, const FreeModes& free, double weight, double arm) {
  double largest = 0.0;
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) {
      largest = std::max(largest, std::abs(total[i]) / (i < 3 ? weight : weight * arm));
    }
  }
  return largest;
}

/// The forces that do work on the six coordinates, with angles and moments scaled by `arm`; held modes have none.
Vec6 working_forces(const HullAtRest& hull, const HullOffset& u, const Vec6& total, const FreeModes& free, double arm) {
  Vec6 work = total;
  work.tail<3>() = attitude_of(hull, u).axes.transpose() * total.tail<3>() / arm;
  for (int i = 0; i < 6; ++i) work[i] *= free[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
  return work;
}

/// A step of Newton, downhill in energy also where the stiffness is not positive: eigenvalues enter by their magnitude
/// and not below a share of the largest (Nocedal & Wright, Numerical Optimization, 2006, section 3.4).
Vec6 step_of(const HullAtRest& hull, const RestOutcome& at, const FreeModes& free, double arm) {
  Mat6 slope = at.forces.slope;
  slope.bottomRows<3>() = attitude_of(hull, at.offset).axes.transpose() * slope.bottomRows<3>() / arm;
  slope.rightCols<3>() /= arm;
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) continue;
    slope.row(i).setZero();
    slope.col(i).setZero();
  }
  const SymmetricModes modes = symmetric_modes(0.5 * (slope + slope.transpose()));
  const Vec6 sizes = modes.values.cwiseAbs();
  const Vec6 floored = sizes.cwiseMax(kLeastStiffness * sizes.maxCoeff());
  const Vec6 work = working_forces(hull, at.offset, at.forces.total, free, arm);
  Vec6 step = modes.vectors * (modes.vectors.transpose() * work).cwiseQuotient(floored);
  step.tail<3>() /= arm;
  if (!step.allFinite()) return Vec6::Zero();
  const double excess =
      std::max(step.head<3>().norm() / kLongestShift, step.tail<3>().lpNorm<Eigen::Infinity>() / kLargestTurn);
  return excess > 1.0 ? Vec6(step / excess) : step;
}

/// One step, cut where it goes far beyond the least energy on its way. False where nothing is gained.
bool advance(const MooringSpread& spread, const HullAtRest& hull, const FreeModes& free, double weight, double arm,
             RestOutcome& at) {
  const Vec6 step = step_of(hull, at, free, arm);
  const auto work_along = [&](const HullOffset& u, const Vec6& total) {
    Vec6 scaled = step;
    scaled.tail<3>() *= arm;
    return working_forces(hull, u, total, free, arm).dot(scaled);
  };
  const double here = work_along(at.offset, at.forces.total);
  double share = 1.0;
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    const HullOffset there = at.offset + share * step;
    std::vector<CatenarySolution> lines = at.lines;
    HullForces forces = hull_forces(spread, hull, there, lines);
    const double work = forces.fault ? -here : work_along(there, forces.total);
    const double residual = unbalanced(forces.total, free, weight, arm);
    if (!forces.fault && (work >= -0.5 * here || residual < at.residual)) {
      const bool gained = residual < at.residual || here > 0.0;
      at.offset = there;
      at.lines = std::move(lines);
      at.forces = std::move(forces);
      at.residual = residual;
      return gained;
    }
    share *= forces.fault ? 0.5 : std::clamp(here / (here - work), 0.1, 0.7);
  }
  return false;
}

MooringFault no_rest(const MooringSpread& spread, const HullAtRest& hull, const RestOutcome& at) {
  if (hull.station) {
    if (thrust_is_exhausted(hull, at.forces.thrust)) {
      return "no rest of the hull: dynamic positioning gives all the thrust that it has (station_keeping.dp)";
    }
    const Vec3& stiffness = hull.station->law.stiffness;
    for (int i = 0; i < 3 && spread.lines.empty(); ++i) {
      constexpr std::array<const char*, 3> kNames = {"surge", "sway", "yaw"};
      if (stiffness[i] > 0.0) continue;
      return fmt::format("no rest of the hull: nothing holds it in {0}; give station_keeping.dp.{0}",
                         kNames[static_cast<std::size_t>(i)]);
    }
    return fmt::format("no rest of the hull was found in {} iterations: unbalanced force {:.1e} of the force scale",
                       at.iterations, at.residual);
  }
  const int effective = effective_lines(spread, at.lines);
  if (effective < 3) {
    return fmt::format(
        "no rest of the hull: only {} of its mooring lines pull, and three are needed to hold surge, sway "
        "and yaw",
        effective);
  }
  return fmt::format(
      "no rest of the hull was found in {} iterations: unbalanced force {:.1e} of the weight of the lines",
      at.iterations, at.residual);
}

}  // namespace

HullPlace place_of(const HullAtRest& hull, const HullOffset& offset) {
  return {hull.axes_WD * offset.head<3>(), hull.axes_WD * attitude_of(hull, offset).R_DV};
}

HullForces hull_forces(const MooringSpread& spread, const HullAtRest& hull, const HullOffset& offset,
                       std::vector<CatenarySolution>& lines) {
  HullForces sum;
  const Attitude at = attitude_of(hull, offset);
  add_restoring(hull, offset, at, sum);
  add_loads(hull, at, sum);
  add_surroundings(hull, offset, sum);
  add_station(hull, offset, sum);
  add_lines(spread, hull, place_of(hull, offset), at, lines, sum);
  return sum;
}

RestOutcome find_rest(const MooringSpread& spread, const HullAtRest& hull, const HullOffset& start,
                      const FreeModes& free) {
  RestOutcome at;
  at.offset = start;
  const double weight = force_scale(spread, hull.station ? std::optional(hull.station->law) : std::nullopt);
  const double arm = 0.5 * hull.length;
  at.forces = hull_forces(spread, hull, at.offset, at.lines);
  at.fault = at.forces.fault;
  if (at.fault) return at;
  at.residual = unbalanced(at.forces.total, free, weight, arm);
  double least = at.residual;
  int idle = 0;  // steps since the balance last became better
  for (; at.residual > kBalanced && at.iterations < kMaxIterations && idle < kMaxIdle; ++at.iterations) {
    check_interruption();
    if (!advance(spread, hull, free, weight, arm, at)) break;
    idle = at.residual < least ? 0 : idle + 1;
    least = std::min(least, at.residual);
  }
  if (at.residual > 100.0 * kBalanced) at.fault = no_rest(spread, hull, at);
  return at;
}

Mat6 stiffness_about(const Mat6& stiffness, const Vec3& force, const Vec3& arm) {
  Mat6 to_point = Mat6::Identity();  // shift of the own point by that of the other
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
  double sum = station ? station->stiffness.head<2>().maxCoeff() : 0.0;  // a metre off
  for (const MooredLine& line : spread.lines) {
    for (const CatenaryPiece& piece : line.line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  }
  return std::max(sum, 1.0);
}

bool thrust_is_exhausted(const HullAtRest& hull, const Vec3& thrust) {
  return hull.station && (thrust.cwiseAbs().array() >= hull.station->law.limit.array()).any();
}

}  // namespace overbend

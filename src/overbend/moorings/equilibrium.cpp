#include "moorings/equilibrium.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr int kMaxIterations = 100;
constexpr int kMaxTrials = 14;                                   ///< Of one damped step.
constexpr double kLongestShift = 5.0;                            ///< Of one step [m].
constexpr double kLargestTurn = 2.0 * std::numbers::pi / 180.0;  ///< Of one step [rad].
constexpr double kBalanced = 1e-9;                               ///< Share of the weight of the lines [-].

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

/// Unbalanced forces of the free modes as shares of the weight of the lines.
double unbalanced(const Vec6& total, const FreeModes& free, double weight, double arm) {
  double largest = 0.0;
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) {
      largest = std::max(largest, std::abs(total[i]) / (i < 3 ? weight : weight * arm));
    }
  }
  return largest;
}

/// A step of Newton in scaled modes (angles times `arm`), held to a trust region by `damping`.
Vec6 step_of(const HullForces& forces, const FreeModes& free, double damping, double arm) {
  Mat6 slope = forces.slope;
  Vec6 right = forces.total;
  double largest = 0.0;
  for (int i = 0; i < 6; ++i) largest = std::max(largest, std::abs(slope(i, i)) / (i < 3 ? 1.0 : arm * arm));
  for (int i = 0; i < 6; ++i) {
    if (free[static_cast<std::size_t>(i)]) {
      slope(i, i) += damping * largest * (i < 3 ? 1.0 : arm * arm);
    } else {
      slope.row(i).setZero();
      slope.col(i).setZero();
      slope(i, i) = 1.0;
      right[i] = 0.0;
    }
  }
  Vec6 step = slope.fullPivLu().solve(right);
  const double excess =
      std::max(step.head<3>().norm() / kLongestShift, step.tail<3>().lpNorm<Eigen::Infinity>() / kLargestTurn);
  if (!step.allFinite()) return Vec6::Zero();
  return excess > 1.0 ? Vec6(step / excess) : step;
}

MooringFault no_rest(const MooringSpread& spread, const RestOutcome& at) {
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
  add_lines(spread, hull, place_of(hull, offset), at, lines, sum);
  return sum;
}

RestOutcome find_rest(const MooringSpread& spread, const HullAtRest& hull, const HullOffset& start,
                      const FreeModes& free) {
  RestOutcome at;
  at.offset = start;
  const double weight = weight_of_lines(spread), arm = 0.5 * hull.length;
  at.forces = hull_forces(spread, hull, at.offset, at.lines);
  at.fault = at.forces.fault;
  if (at.fault) return at;
  at.residual = unbalanced(at.forces.total, free, weight, arm);
  double damping = 0.0;
  for (; at.residual > kBalanced && at.iterations < kMaxIterations; ++at.iterations) {
    bool better = false;
    for (int trial = 0; trial < kMaxTrials && !better; ++trial) {
      const HullOffset there = at.offset + step_of(at.forces, free, damping, arm);
      std::vector<CatenarySolution> lines = at.lines;
      HullForces forces = hull_forces(spread, hull, there, lines);
      const double residual = unbalanced(forces.total, free, weight, arm);
      better = !forces.fault && residual < at.residual;
      if (better) {
        at.offset = there;
        at.lines = std::move(lines);
        at.forces = std::move(forces);
        at.residual = residual;
        damping = damping < 1e-6 ? 0.0 : 0.1 * damping;
      } else {
        damping = std::max(10.0 * damping, 1e-4);
      }
    }
    if (!better) break;
  }
  if (at.residual > 100.0 * kBalanced) at.fault = no_rest(spread, at);
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

double weight_of_lines(const MooringSpread& spread) {
  double sum = 0.0;
  for (const MooredLine& line : spread.lines) {
    for (const CatenaryPiece& piece : line.line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  }
  return std::max(sum, 1.0);
}

}  // namespace overbend

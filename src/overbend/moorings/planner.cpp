#include "moorings/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/dense_algebra.h"
#include "base/interruption.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

/// Heave, roll and pitch settle in three rounds: pulls and vertical forces hardly know of each other.
constexpr int kMaxRounds = 30;

enum class Held { free, at_least, at_most };

/// Change of the free pulls and multipliers of the three balances.
struct FreePulls {
  Eigen::VectorXd pulls;
  Vec3 multipliers = Vec3::Zero();
  bool balanced = false;
};
FreePulls least_change(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wished,
                       const std::vector<Held>& held, const Eigen::VectorXd& least, const Eigen::VectorXd& most) {
  FreePulls result;
  result.pulls = wished;
  Mat3 normal = Mat3::Zero();
  for (Eigen::Index i = 0; i < wished.size(); ++i) {
    const Held how = held[static_cast<std::size_t>(i)];
    if (how == Held::at_least) result.pulls[i] = least[i];
    if (how == Held::at_most) result.pulls[i] = most[i];
    if (how == Held::free) normal += arms.col(i) * arms.col(i).transpose();
  }
  const Vec3 open = arms * result.pulls + load;
  result.multipliers = least_squares(normal, open);
  for (Eigen::Index i = 0; i < wished.size(); ++i) {
    if (held[static_cast<std::size_t>(i)] == Held::free) result.pulls[i] -= arms.col(i).dot(result.multipliers);
  }
  const double size = load.norm() + (arms * wished.asDiagonal()).norm();
  result.balanced = (arms * result.pulls + load).norm() <= 1e-9 * std::max(size, 1.0);
  return result;
}

/// The next change of the active set: the pull furthest outside its bounds, or one that wants back inside.
bool change_active_set(const Eigen::Matrix3Xd& arms, const FreePulls& now, const Eigen::VectorXd& wished,
                       const Eigen::VectorXd& least, const Eigen::VectorXd& most, std::vector<Held>& held) {
  Eigen::Index worst = -1;
  double excess = 1e-9 * wished.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < wished.size(); ++i) {
    const double over = std::max(now.pulls[i] - most[i], least[i] - now.pulls[i]);
    if (held[static_cast<std::size_t>(i)] == Held::free && over > excess) {
      worst = i;
      excess = over;
    }
  }
  if (worst >= 0) {
    held[static_cast<std::size_t>(worst)] = now.pulls[worst] > most[worst] ? Held::at_most : Held::at_least;
    return true;
  }
  for (Eigen::Index i = 0; i < wished.size(); ++i) {
    Held& how = held[static_cast<std::size_t>(i)];
    const double wants = wished[i] - arms.col(i).dot(now.multipliers);
    if ((how == Held::at_most && wants < most[i]) || (how == Held::at_least && wants > least[i])) {
      how = Held::free;
      return true;
    }
  }
  return false;
}

/// Everything but the pulls that plan_lengths asks of the lines at one place.
struct Geometry {
  Eigen::Matrix3Xd arms;
  Eigen::VectorXd least, most;
  MooringFault fault;
};

/// The horizontal pull that goes with a tension, the line's length free.
double pull_for_tension(const MooredLine& line, const CatenarySite& site, double distance, double tension,
                        double otherwise) {
  CatenaryLine copy = line.line;
  const CatenarySolution solution = set_length_for_tension(copy, site, distance, tension);
  return solution.fault == CatenaryFault::none ? solution.pull : otherwise;
}

Geometry geometry_of(const MooringSpread& spread, const HullAtRest& hull, const HullPlace& place,
                     const TensionBounds& bounds) {
  const Eigen::Index n = static_cast<Eigen::Index>(spread.lines.size());
  Geometry geometry;
  geometry.arms = Eigen::Matrix3Xd::Zero(3, n);
  geometry.least = Eigen::VectorXd::Zero(n);
  geometry.most = Eigen::VectorXd::Constant(n, 1e300);
  for (Eigen::Index i = 0; i < n; ++i) {
    check_interruption();
    const MooredLine& line = spread.lines[static_cast<std::size_t>(i)];
    if (line.parted) {
      geometry.most[i] = 0.0;
      continue;
    }
    const Vec3 arm_W = place.R_WV * line.fairlead_V, fairlead = place.p_W + arm_W;
    const LineDirection to = line_direction(line, fairlead);
    const Vec3 arm = hull.axes_WD.transpose() * arm_W, pull = hull.axes_WD.transpose() * to.direction_W;
    geometry.arms.col(i) = Vec3(pull.x(), pull.y(), arm.x() * pull.y() - arm.y() * pull.x());
    const CatenarySite site = line_site(spread, line, fairlead);
    if (bounds.least > 0.0) geometry.least[i] = pull_for_tension(line, site, to.distance, bounds.least, 0.0);
    if (bounds.most < 1e300) geometry.most[i] = pull_for_tension(line, site, to.distance, bounds.most, 1e300);
  }
  return geometry;
}

MooringFault set_lengths(MooringSpread& spread, const HullPlace& place, const Eigen::VectorXd& pulls) {
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    MooredLine& line = spread.lines[i];
    if (line.parted) continue;
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    const double pull = pulls[static_cast<Eigen::Index>(i)];
    const CatenarySolution solution = set_length_for_pull(line.line, line_site(spread, line, fairlead),
                                                          line_direction(line, fairlead).distance, pull);
    if (solution.fault != CatenaryFault::none) {
      return fmt::format("mooring line \"{}\": no length gives a horizontal pull of {}", line.name,
                         shown(pull, "N", 1));
    }
  }
  return std::nullopt;
}

Vec3 horizontal(const Vec6& load) {
  return {load[0], load[1], load[5]};
}

}  // namespace

PullPlan balance_pulls(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wished,
                       const Eigen::VectorXd& least, const Eigen::VectorXd& most) {
  std::vector<Held> held(static_cast<std::size_t>(wished.size()), Held::free);
  FreePulls now;
  for (Eigen::Index round = 0; round < 10 * wished.size(); ++round) {
    now = least_change(arms, load, wished, held, least, most);
    if (!change_active_set(arms, now, wished, least, most, held)) return {now.pulls, now.balanced};
  }
  return {now.pulls, false};
}

Eigen::VectorXd pulls_of(const MooringSpread& spread, const std::vector<CatenarySolution>& lines) {
  Eigen::VectorXd pulls = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(spread.lines.size()));
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    if (!spread.lines[i].parted) pulls[static_cast<Eigen::Index>(i)] = lines[i].pull;
  }
  return pulls;
}

RestOutcome plan_lengths(MooringSpread& spread, const HullAtRest& hull, const HullOffset& offset,
                         const Eigen::VectorXd& wished, const TensionBounds& bounds) {
  RestOutcome rest;
  rest.offset = offset;
  double last = 1e300;
  for (int round = 0; round < kMaxRounds; ++round) {
    const HullPlace place = place_of(hull, rest.offset);
    const Geometry geometry = geometry_of(spread, hull, place, bounds);
    // Moorings apart, what pulls horizontally at this place.
    const HullForces forces = hull_forces(spread, hull, rest.offset, rest.lines);
    const Vec3 load = horizontal(forces.total - forces.moorings);
    const PullPlan plan = balance_pulls(geometry.arms, load, wished, geometry.least, geometry.most);
    if (!plan.balanced) {
      rest.fault = "no tensions of the mooring lines within their bounds hold the hull in place";
      return rest;
    }
    rest.fault = set_lengths(spread, place, plan.pulls);
    if (rest.fault) return rest;
    const HullOffset before = rest.offset;
    rest = find_rest(spread, hull, before, kVerticalFree);
    if (rest.fault) return rest;
    const double change = (rest.offset - before).lpNorm<Eigen::Infinity>();
    if (change <= 1e-11 || (change < 1e-8 && change >= last)) break;
    last = change;
  }
  return find_rest(spread, hull, rest.offset);  // everything free: nothing is left to move it
}

}  // namespace overbend

#include "moorings/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/dense_algebra.h"
#include "base/interruption.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

/// Maximum number of iterations; heave, roll and pitch need three, as horizontal and vertical forces are weakly
/// coupled.
constexpr int kMaxRounds = 30;

enum class BoundState { free, at_lower, at_upper };

/// Change of the free forces, and multipliers of the three equilibrium equations.
struct FreePulls {
  Eigen::VectorXd pulls;
  Vec3 multipliers = Vec3::Zero();
  bool balanced = false;
};
FreePulls solve_free_pulls(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wanted_pulls,
                           const std::vector<BoundState>& held, const Eigen::VectorXd& min_pulls,
                           const Eigen::VectorXd& max_pulls) {
  FreePulls result;
  result.pulls = wanted_pulls;
  Mat3 normal = Mat3::Zero();
  for (Eigen::Index i = 0; i < wanted_pulls.size(); ++i) {
    const BoundState how = held[static_cast<std::size_t>(i)];
    if (how == BoundState::at_lower) result.pulls[i] = min_pulls[i];
    if (how == BoundState::at_upper) result.pulls[i] = max_pulls[i];
    if (how == BoundState::free) normal += arms.col(i) * arms.col(i).transpose();
  }
  const Vec3 open = arms * result.pulls + load;
  result.multipliers = least_squares(normal, open);
  for (Eigen::Index i = 0; i < wanted_pulls.size(); ++i) {
    if (held[static_cast<std::size_t>(i)] == BoundState::free) result.pulls[i] -= arms.col(i).dot(result.multipliers);
  }
  const double size = load.norm() + (arms * wanted_pulls.asDiagonal()).norm();
  result.balanced = (arms * result.pulls + load).norm() <= 1e-9 * std::max(size, 1.0);
  return result;
}

/// Next change of the active set: the force furthest outside its bounds, or one whose multiplier releases it.
bool change_active_set(const Eigen::Matrix3Xd& arms, const FreePulls& current, const Eigen::VectorXd& wanted_pulls,
                       const Eigen::VectorXd& min_pulls, const Eigen::VectorXd& max_pulls,
                       std::vector<BoundState>& held) {
  Eigen::Index worst = -1;
  double excess = 1e-9 * wanted_pulls.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < wanted_pulls.size(); ++i) {
    const double over = std::max(current.pulls[i] - max_pulls[i], min_pulls[i] - current.pulls[i]);
    if (held[static_cast<std::size_t>(i)] == BoundState::free && over > excess) {
      worst = i;
      excess = over;
    }
  }
  if (worst >= 0) {
    held[static_cast<std::size_t>(worst)] =
        current.pulls[worst] > max_pulls[worst] ? BoundState::at_upper : BoundState::at_lower;
    return true;
  }
  for (Eigen::Index i = 0; i < wanted_pulls.size(); ++i) {
    BoundState& how = held[static_cast<std::size_t>(i)];
    const double wants = wanted_pulls[i] - arms.col(i).dot(current.multipliers);
    if ((how == BoundState::at_upper && wants < max_pulls[i]) ||
        (how == BoundState::at_lower && wants > min_pulls[i])) {
      how = BoundState::free;
      return true;
    }
  }
  return false;
}

/// Quantities of plan_lengths at one position other than the wanted forces.
struct Geometry {
  Eigen::Matrix3Xd arms;
  Eigen::VectorXd lower, upper;
  MooringError error;
};

/// Horizontal force for a given tension with the length of the line free.
double pull_for_tension(const MooredLine& line, const CatenarySite& site, double distance, double tension,
                        double otherwise) {
  CatenaryLine copy = line.line;
  const CatenarySolution solution = set_length_for_tension(copy, site, distance, tension);
  return solution.error == CatenaryError::none ? solution.pull : otherwise;
}

Geometry compute_geometry(const MooringSpread& spread, const StaticHull& hull, const HullPlace& place,
                          const TensionBounds& bounds) {
  const Eigen::Index n = static_cast<Eigen::Index>(spread.lines.size());
  Geometry geometry;
  geometry.arms = Eigen::Matrix3Xd::Zero(3, n);
  geometry.lower = Eigen::VectorXd::Zero(n);
  geometry.upper = Eigen::VectorXd::Constant(n, 1e300);
  for (Eigen::Index i = 0; i < n; ++i) {
    check_interruption();
    const MooredLine& line = spread.lines[static_cast<std::size_t>(i)];
    if (line.parted) {
      geometry.upper[i] = 0.0;
      continue;
    }
    const Vec3 arm_W = place.R_WV * line.fairlead_V, fairlead = place.p_W + arm_W;
    const LineDirection to = line_direction(line, fairlead);
    const Vec3 arm = hull.axes_WD.transpose() * arm_W, pull = hull.axes_WD.transpose() * to.direction_W;
    geometry.arms.col(i) = Vec3(pull.x(), pull.y(), arm.x() * pull.y() - arm.y() * pull.x());
    const CatenarySite site = line_site(spread, line, fairlead);
    if (bounds.lower > 0.0) geometry.lower[i] = pull_for_tension(line, site, to.distance, bounds.lower, 0.0);
    if (bounds.upper < 1e300) geometry.upper[i] = pull_for_tension(line, site, to.distance, bounds.upper, 1e300);
  }
  return geometry;
}

MooringError set_lengths(MooringSpread& spread, const HullPlace& place, const Eigen::VectorXd& pulls) {
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    MooredLine& line = spread.lines[i];
    if (line.parted) continue;
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    const double pull = pulls[static_cast<Eigen::Index>(i)];
    const CatenarySolution solution = set_length_for_pull(line.line, line_site(spread, line, fairlead),
                                                          line_direction(line, fairlead).distance, pull);
    if (solution.error != CatenaryError::none) {
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

PullPlan balance_pulls(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wanted_pulls,
                       const Eigen::VectorXd& min_pulls, const Eigen::VectorXd& max_pulls) {
  std::vector<BoundState> held(static_cast<std::size_t>(wanted_pulls.size()), BoundState::free);
  FreePulls current;
  for (Eigen::Index round = 0; round < 10 * wanted_pulls.size(); ++round) {
    current = solve_free_pulls(arms, load, wanted_pulls, held, min_pulls, max_pulls);
    if (!change_active_set(arms, current, wanted_pulls, min_pulls, max_pulls, held)) {
      return {current.pulls, current.balanced};
    }
  }
  return {current.pulls, false};
}

Eigen::VectorXd horizontal_pulls(const MooringSpread& spread, const std::vector<CatenarySolution>& lines) {
  Eigen::VectorXd pulls = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(spread.lines.size()));
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    if (!spread.lines[i].parted) pulls[static_cast<Eigen::Index>(i)] = lines[i].pull;
  }
  return pulls;
}

HullEquilibrium plan_lengths(MooringSpread& spread, const StaticHull& hull, const HullOffset& offset,
                             const Eigen::VectorXd& wanted_pulls, const TensionBounds& bounds) {
  HullEquilibrium rest;
  rest.offset = offset;
  double last = 1e300;
  for (int round = 0; round < kMaxRounds; ++round) {
    const HullPlace place = make_hull_place(hull, rest.offset);
    const Geometry geometry = compute_geometry(spread, hull, place, bounds);
    // Horizontal load at this position without the moorings.
    const HullForces forces = hull_forces(spread, hull, rest.offset, rest.lines);
    const Vec3 load = horizontal(forces.total - forces.moorings);
    const PullPlan plan = balance_pulls(geometry.arms, load, wanted_pulls, geometry.lower, geometry.upper);
    if (!plan.balanced) {
      rest.error = "no tensions of the mooring lines within their bounds hold the hull in place";
      return rest;
    }
    rest.error = set_lengths(spread, place, plan.pulls);
    if (rest.error) return rest;
    const HullOffset before = rest.offset;
    rest = find_hull_equilibrium(spread, hull, before, kVerticalFree);
    if (rest.error) return rest;
    const double change = (rest.offset - before).lpNorm<Eigen::Infinity>();
    if (change <= 1e-11 || (change < 1e-8 && change >= last)) break;
    last = change;
  }
  return find_hull_equilibrium(spread, hull, rest.offset);  // all coordinates free: the hull is already in equilibrium
}

}  // namespace overbend

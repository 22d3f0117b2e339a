/// Lengths of mooring lines for a position of the hull: the smallest change from the wanted forces that gives
/// equilibrium.
#pragma once

#include "moorings/equilibrium.h"

namespace overbend {

/// Bounds of the tension at each fairlead [N].
struct TensionBounds {
  double lower = 0.0, upper = 1e300;
};

/// Horizontal forces closest to the wanted ones (least squares) that balance surge, sway and yaw; active set on bounds.
/// Columns of `arms`: force and yaw moment of a unit force. `load`: all other loads [N, N, N m].
struct PullPlan {
  Eigen::VectorXd pulls;
  bool balanced = false;  ///< If false, no forces within the bounds give equilibrium.
};
PullPlan balance_pulls(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wanted_pulls,
                       const Eigen::VectorXd& min_pulls, const Eigen::VectorXd& max_pulls);

/// Sets the lengths so that the hull is in equilibrium at the surge, sway and yaw of `offset`; heave, roll and pitch
/// follow. `wished`: wanted horizontal force of each line [N].
HullEquilibrium plan_lengths(MooringSpread& spread, const StaticHull& hull, const HullOffset& offset,
                             const Eigen::VectorXd& wanted_pulls, const TensionBounds& bounds = {});

/// Returns the horizontal forces of solved lines, 0 for parted ones [N].
Eigen::VectorXd horizontal_pulls(const MooringSpread& spread, const std::vector<CatenarySolution>& lines);

}  // namespace overbend

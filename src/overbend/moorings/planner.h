/// Lengths of mooring lines for a place of the hull: the least change of the wished pulls that balances.
#pragma once

#include "moorings/equilibrium.h"

namespace overbend {

/// Bounds of the tension at every fairlead [N].
struct TensionBounds {
  double least = 0.0, most = 1e300;
};

/// Horizontal pulls closest to the wished ones (least sum of squares) that balance surge, sway and yaw; active set on
/// bounds. Columns of `arms`: force and yaw moment of a unit pull. `load`: of everything else [N, N, N m].
struct PullPlan {
  Eigen::VectorXd pulls;
  bool balanced = false;  ///< Else no pulls within the bounds balance.
};
PullPlan balance_pulls(const Eigen::Matrix3Xd& arms, const Vec3& load, const Eigen::VectorXd& wished,
                       const Eigen::VectorXd& least, const Eigen::VectorXd& most);

/// Sets the lengths so that the hull rests with the surge, sway and yaw of `offset`; heave, roll and pitch follow.
/// `wished`: horizontal pull of each line [N].
RestOutcome plan_lengths(MooringSpread& spread, const HullAtRest& hull, const HullOffset& offset,
                         const Eigen::VectorXd& wished, const TensionBounds& bounds = {});

/// Horizontal pulls of solved lines, 0 of parted ones [N].
Eigen::VectorXd pulls_of(const MooringSpread& spread, const std::vector<CatenarySolution>& lines);

}  // namespace overbend

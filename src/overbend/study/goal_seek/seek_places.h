/// Places within the bounds of a goal seek from which a search can begin.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace overbend {

/// Corners (of up to four unknowns), middle and a Latin hypercube of the unit cube, those nearest to `own` first. The
/// same on every machine.
std::vector<Eigen::VectorXd> places_within_bounds(const Eigen::VectorXd& own);

}  // namespace overbend

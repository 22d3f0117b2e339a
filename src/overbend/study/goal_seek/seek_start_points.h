/// Start points of a goal seek within its bounds.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace overbend {

/// Returns corners (of up to four unknowns), centre and a Latin hypercube of the unit cube, those nearest to `start`
/// first. The same on every machine.
std::vector<Eigen::VectorXd> start_points_within_bounds(const Eigen::VectorXd& start);

}  // namespace overbend

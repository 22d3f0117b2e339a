/// Least squares under linear inequalities, for small dense problems.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// Returns the x that minimises |R x - b| subject to C x >= d, R square and upper triangular with full rank
/// [lawson1974], chapter 23, problem LSI, by least distance programming. Contradicting inequalities give the nearest
/// approximation that the method finds.
Eigen::VectorXd inequality_least_squares(const Eigen::MatrixXd& r, const Eigen::VectorXd& b, const Eigen::MatrixXd& c,
                                         const Eigen::VectorXd& d);

}  // namespace overbend

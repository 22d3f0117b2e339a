/// Least squares under linear inequalities, for small dense problems.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// min |R x - b| with C x >= d, R square and upper triangular with full rank [lawson1974], chapter 23, problem LSI, by
/// least distance. Inequalities that contradict each other give the nearest to all that the method finds.
Eigen::VectorXd inequality_least_squares(const Eigen::MatrixXd& r, const Eigen::VectorXd& b, const Eigen::MatrixXd& c,
                                         const Eigen::VectorXd& d);

}  // namespace overbend

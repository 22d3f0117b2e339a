/// Least squares under linear inequalities, for small dense problems.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// min |A x - b| with x >= 0 [lawson1974], chapter 23, NNLS.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// min |R x - b| with C x >= d, R square and upper triangular with full rank (their problem LSI, by least distance).
/// Inequalities that contradict each other give the nearest to all that the method finds.
Eigen::VectorXd inequality_least_squares(const Eigen::MatrixXd& r, const Eigen::VectorXd& b, const Eigen::MatrixXd& c,
                                         const Eigen::VectorXd& d);

}  // namespace overbend

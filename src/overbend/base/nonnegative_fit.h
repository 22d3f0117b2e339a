/// Least squares with coefficients that may not be negative.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// x >= 0 with the least |A x - b|, by the active-set method (Lawson & Hanson 1974, chapter 23). For few columns.
Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace overbend

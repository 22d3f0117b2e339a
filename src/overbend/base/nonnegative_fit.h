/// Least squares with non-negative coefficients.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// Returns x >= 0 that minimises |A x - b|, by the active-set method (Lawson & Hanson 1974, chapter 23). For few
/// columns.
Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace overbend

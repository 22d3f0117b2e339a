#include "base/nonnegative_fit.h"

#include <algorithm>
#include <vector>

#include "base/dense_algebra.h"

namespace overbend {
namespace {

constexpr double kNothing = 1e-14;  ///< Zero tolerance of a coefficient, or of a gradient relative to the first.

/// Least squares over some of the columns.
Eigen::VectorXd fit_columns(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                            const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd part(A.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) part.col(static_cast<Eigen::Index>(j)) = A.col(columns[j]);
  return least_squares(part, b);
}

/// Fits the columns in use; columns with negative coefficients are removed, one after another.
void settle(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, std::vector<Eigen::Index>& used, Eigen::VectorXd& x) {
  while (!used.empty()) {
    const Eigen::VectorXd wanted = fit_columns(A, b, used);
    double share = 1.0;
    for (std::size_t j = 0; j < used.size(); ++j) {
      const double target = wanted(static_cast<Eigen::Index>(j)), present = x(used[j]);
      if (target <= 0.0) share = std::min(share, present / (present - target));
    }
    for (std::size_t j = 0; j < used.size(); ++j) {
      x(used[j]) += share * (wanted(static_cast<Eigen::Index>(j)) - x(used[j]));
    }
    if (share >= 1.0) return;
    std::erase_if(used, [&](Eigen::Index j) { return x(j) <= kNothing * x.maxCoeff(); });
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      if (std::find(used.begin(), used.end(), j) == used.end()) x(j) = 0.0;
    }
  }
}

}  // namespace

Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  std::vector<Eigen::Index> used;
  const double first = (A.transpose() * b).cwiseAbs().maxCoeff();
  for (Eigen::Index round = 0; round < 3 * A.cols(); ++round) {
    Eigen::VectorXd gradient = A.transpose() * (b - A * x);
    for (const Eigen::Index j : used) gradient(j) = 0.0;
    Eigen::Index best = 0;
    if (gradient.maxCoeff(&best) <= 1e2 * kNothing * first) break;
    used.push_back(best);
    settle(A, b, used, x);
  }
  return x;
}

}  // namespace overbend

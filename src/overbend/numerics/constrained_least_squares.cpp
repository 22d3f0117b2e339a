#include "numerics/constrained_least_squares.h"

#include <algorithm>

#include "base/nonnegative_fit.h"

namespace overbend {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd inequality_least_squares(const MatrixXd& r, const VectorXd& b, const MatrixXd& c, const VectorXd& d) {
  const auto triangle = r.triangularView<Eigen::Upper>();
  if (c.rows() == 0) {
    return triangle.solve(b);
  }
  // With y = R x - b: min |y| subject to G y >= h.
  MatrixXd g = triangle.transpose().solve(c.transpose()).transpose();
  VectorXd h = d - g * b;
  for (Index k = 0; k < g.rows(); ++k) {
    const double scale = 1.0 / std::max(g.row(k).norm(), 1e-300);
    g.row(k) *= scale;
    h(k) *= scale;
  }
  MatrixXd dual(g.cols() + 1, g.rows());
  dual << g.transpose(), h.transpose();
  VectorXd wanted = VectorXd::Zero(dual.rows());
  wanted(wanted.size() - 1) = 1.0;
  const VectorXd residual = dual * nonnegative_fit(dual, wanted) - wanted;
  const double last = residual(residual.size() - 1);
  const VectorXd y = last < 0.0 ? VectorXd(-residual.head(g.cols()) / last) : VectorXd(VectorXd::Zero(g.cols()));
  return triangle.solve(y + b);
}

}  // namespace overbend

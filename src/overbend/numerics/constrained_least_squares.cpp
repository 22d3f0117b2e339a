#include "numerics/constrained_least_squares.h"

#include <algorithm>
#include <vector>

#include <Eigen/QR>

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStationary = 1e-12;

/// Least squares in the columns that may differ from zero; zero in the others.
VectorXd solve_in(const MatrixXd& a, const VectorXd& b, const std::vector<Index>& columns) {
  MatrixXd part(a.rows(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    part.col(static_cast<Index>(k)) = a.col(columns[k]);
  }
  const VectorXd solution = part.colPivHouseholderQr().solve(b);
  VectorXd x = VectorXd::Zero(a.cols());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    x(columns[k]) = solution(static_cast<Index>(k));
  }
  return x;
}

/// Moves from x towards z as far as nothing becomes negative; columns that reach zero leave.
void step_to_bound(VectorXd& x, const VectorXd& z, std::vector<Index>& columns) {
  double share = 1.0;
  for (const Index j : columns) {
    if (z(j) <= 0.0) {
      share = std::min(share, x(j) / (x(j) - z(j)));
    }
  }
  x += share * (z - x);
  std::erase_if(columns, [&](Index j) { return x(j) <= 1e-14 * (1.0 + x.cwiseAbs().maxCoeff()); });
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& a, const VectorXd& b) {
  VectorXd x = VectorXd::Zero(a.cols());
  std::vector<Index> columns;
  for (Index round = 0; round < 3 * a.cols(); ++round) {
    VectorXd slope = a.transpose() * (b - a * x);
    for (const Index j : columns) {
      slope(j) = 0.0;
    }
    Index best = 0;
    if (slope.maxCoeff(&best) <= kStationary) {
      break;
    }
    columns.push_back(best);
    VectorXd z = solve_in(a, b, columns);
    while (!columns.empty() && std::any_of(columns.begin(), columns.end(), [&](Index j) { return z(j) <= 0.0; })) {
      const std::size_t before = columns.size();
      step_to_bound(x, z, columns);
      if (columns.size() == before) {
        return x;  // rounding: nothing left to gain
      }
      z = solve_in(a, b, columns);
    }
    x = z;
  }
  return x;
}

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
  const VectorXd residual = dual * nonnegative_least_squares(dual, wanted) - wanted;
  const double last = residual(residual.size() - 1);
  const VectorXd y = last < 0.0 ? VectorXd(-residual.head(g.cols()) / last) : VectorXd(VectorXd::Zero(g.cols()));
  return triangle.solve(y + b);
}

}  // namespace overbend

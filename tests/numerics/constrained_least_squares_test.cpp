#include "numerics/constrained_least_squares.h"

#include <gtest/gtest.h>

#include <random>

#include "base/nonnegative_fit.h"

namespace overbend {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

TEST(inequality_least_squares, inequalities_hold_and_only_those_that_act_cost) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Eigen::MatrixXd r = random_matrix(6, 6, seed).triangularView<Eigen::Upper>();
    r.diagonal().array() += 3.0;
    const Eigen::VectorXd b = random_matrix(6, 1, seed + 50), d = random_matrix(4, 1, seed + 90);
    const Eigen::MatrixXd c = random_matrix(4, 6, seed + 70);
    const Eigen::VectorXd x = inequality_least_squares(r, b, c, d);
    const Eigen::VectorXd slack = c * x - d;
    EXPECT_GT(slack.minCoeff(), -1e-9);
    // The gradient is a sum of the acting rows with multipliers of the right sign.
    const Eigen::VectorXd gradient = r.transpose() * (r * x - b);
    Eigen::MatrixXd acting = c.transpose();
    for (Eigen::Index k = 0; k < 4; ++k) {
      acting.col(k) *= slack(k) < 1e-9 ? 1.0 : 0.0;
    }
    const Eigen::VectorXd multipliers = nonnegative_fit(acting, gradient);
    EXPECT_LT((acting * multipliers - gradient).norm(), 1e-8 * (1.0 + gradient.norm()));
  }
}

TEST(inequality_least_squares, without_inequalities_it_is_the_plain_solution) {
  Eigen::MatrixXd r(2, 2);
  r << 2.0, 1.0, 0.0, 4.0;
  const Eigen::VectorXd x =
      inequality_least_squares(r, Eigen::Vector2d(4.0, 8.0), Eigen::MatrixXd(0, 2), Eigen::VectorXd(0));
  EXPECT_NEAR(x(0), 1.0, 1e-12);
  EXPECT_NEAR(x(1), 2.0, 1e-12);
}

}  // namespace
}  // namespace overbend

#include "base/nonnegative_fit.h"

#include <gtest/gtest.h>

#include <random>

namespace overbend {
namespace {

TEST(nonnegative_fit, finds_coefficients_that_are_not_negative_anyway) {
  Eigen::MatrixXd A(4, 2);
  A << 1, 0, 1, 1, 1, 2, 1, 3;
  const Eigen::VectorXd x = nonnegative_fit(A, A * Eigen::Vector2d(0.5, 2.0));
  EXPECT_NEAR(x(0), 0.5, 1e-12);
  EXPECT_NEAR(x(1), 2.0, 1e-12);
}

TEST(nonnegative_fit, leaves_out_what_would_be_negative) {
  Eigen::MatrixXd A(3, 2);
  A << 1, 1, 1, 2, 1, 3;
  const Eigen::VectorXd x = nonnegative_fit(A, Eigen::Vector3d(3.0, 2.0, 1.0));  // a falling line
  EXPECT_NEAR(x(0), 2.0, 1e-12);
  EXPECT_EQ(x(1), 0.0);
}

// Karush, Kuhn and Tucker: no gradient where a coefficient is in use, none downhill where it is not.
TEST(nonnegative_fit, no_other_choice_of_coefficients_is_better) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 50; ++round) {
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(20, 8, [&] { return normal(generator); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(20, [&] { return normal(generator); });
    const Eigen::VectorXd x = nonnegative_fit(A, b), gradient = A.transpose() * (A * x - b);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      EXPECT_GE(x(j), 0.0);
      EXPECT_GE(gradient(j), -1e-9);
      EXPECT_NEAR(x(j) * gradient(j), 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace overbend

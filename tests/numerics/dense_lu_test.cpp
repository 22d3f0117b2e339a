#include "numerics/dense_lu.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace overbend {
namespace {

DenseLu factorise(const Eigen::MatrixXd& matrix) {
  DenseLu lu(static_cast<int>(matrix.rows()));
  for (int i = 0; i < lu.size(); ++i) {
    for (int j = 0; j < lu.size(); ++j) {
      lu.matrix()[i * lu.size() + j] = matrix(i, j);
      lu.terms()[i * lu.size() + j] = std::abs(matrix(i, j));
    }
  }
  return lu;
}

TEST(dense_lu, solves_random_systems_and_knows_the_sign_of_their_determinant) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  for (int size = 1; size <= 40; ++size) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(generator); });
    const Eigen::VectorXd rhs = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(generator); });
    DenseLu lu = factorise(matrix);
    ASSERT_EQ(lu.factor(), -1);
    Eigen::VectorXd x = rhs;
    lu.solve(x.data());
    EXPECT_LT((matrix * x - rhs).norm(), 1e-11 * matrix.norm() * x.norm());  // backward error of some tens of rows
    EXPECT_EQ(lu.sign() > 0, matrix.fullPivLu().determinant() > 0.0);
  }
}

TEST(dense_lu, exchanges_rows_where_the_diagonal_is_zero) {
  DenseLu lu = factorise((Eigen::Matrix3d() << 0, 2, 0, 0, 0, 5, 4, 0, 0).finished());
  ASSERT_EQ(lu.factor(), -1);
  Eigen::Vector3d x(2.0, 5.0, 4.0);
  lu.solve(x.data());
  EXPECT_EQ(x, Eigen::Vector3d(1.0, 1.0, 1.0));
}

TEST(dense_lu, takes_a_pivot_that_is_rounding_of_its_terms_for_none) {
  DenseLu lu = factorise(Eigen::Matrix2d::Identity());
  lu.matrix()[3] = 1e-7;
  lu.terms()[3] = 1e9;
  EXPECT_EQ(lu.factor(), 1);
}

TEST(dense_lu, what_is_not_a_number_is_no_pivot) {
  DenseLu lu = factorise(Eigen::Matrix2d::Identity());
  lu.matrix()[0] = std::nan("");
  EXPECT_EQ(lu.factor(), 0);
}

}  // namespace
}  // namespace overbend

#include "base/dense_algebra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

namespace overbend {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

MatrixXd random_positive(Eigen::Index n, unsigned seed) {
  const MatrixXd a = random_matrix(2 * n, n, seed);
  return a.transpose() * a;
}

TEST(dense_algebra, what_a_least_squares_solution_leaves_is_across_every_column) {
  const MatrixXd a = random_matrix(9, 4, 1);
  const VectorXd b = random_matrix(9, 1, 2);
  EXPECT_LT((a.transpose() * (a * least_squares(a, b) - b)).norm(), 1e-12);
}

TEST(dense_algebra, of_many_solutions_the_shortest_has_no_part_that_changes_nothing) {
  MatrixXd a(3, 3);
  a << 1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 1.0, 0.0, 1.0;  // (2, 2, -2) changes nothing
  const VectorXd b = a * VectorXd::Ones(3), x = min_norm_solution(a, b);
  EXPECT_LT((a * x - b).norm(), 1e-13);
  EXPECT_NEAR(x(0) + x(1) - x(2), 0.0, 1e-13);
}

TEST(dense_algebra, a_triangle_stands_for_all_rows) {
  for (const Eigen::Index count : {7, 3}) {
    const MatrixXd rows = random_matrix(count, 5, 3), triangle = qr_triangle(rows);
    ASSERT_EQ(triangle.rows(), std::min<Eigen::Index>(count, 5));
    EXPECT_LT((triangle.transpose() * triangle - rows.transpose() * rows).norm(), 1e-12);
    for (Eigen::Index i = 1; i < triangle.rows(); ++i) {
      for (Eigen::Index j = 0; j < i; ++j) EXPECT_EQ(triangle(i, j), 0.0);
    }
  }
}

TEST(dense_algebra, directions_across_a_vector_are_across_it_and_each_other) {
  const VectorXd v = random_matrix(6, 1, 4);
  const MatrixXd across = directions_across(v);
  ASSERT_EQ(across.cols(), 5);
  EXPECT_LT((across.transpose() * across - MatrixXd::Identity(5, 5)).norm(), 1e-13);
  EXPECT_LT((across.transpose() * v).norm(), 1e-13);
}

TEST(dense_algebra, a_root_squared_is_the_matrix) {
  const MatrixXd positive = random_positive(5, 5), root = upper_root(positive);
  EXPECT_LT((root.transpose() * root - positive).norm(), 1e-11);
  EXPECT_EQ(root(3, 1), 0.0);
}

TEST(dense_algebra, modes_of_two_coupled_masses_are_those_of_the_textbook) {
  // Equal masses m, springs k to the walls and c between them: omega^2 = k/m and (k + 2 c)/m.
  const double k = 3.0, c = 1.5, m = 2.0;
  MatrixXd stiffness(2, 2);
  stiffness << k + c, -c, -c, k + c;
  const SymmetricModes modes = symmetric_modes(stiffness, m * MatrixXd::Identity(2, 2));
  EXPECT_NEAR(modes.values(0), k / m, 1e-14);
  EXPECT_NEAR(modes.values(1), (k + 2.0 * c) / m, 1e-14);
  EXPECT_NEAR(std::abs(modes.vectors(0, 0)), 1.0 / std::sqrt(2.0 * m), 1e-14);
  EXPECT_NEAR(modes.vectors(0, 0), modes.vectors(1, 0), 1e-14);
  EXPECT_NEAR(modes.vectors(0, 1), -modes.vectors(1, 1), 1e-14);
}

TEST(dense_algebra, modes_rise_and_build_the_matrix_again) {
  const MatrixXd half = random_matrix(6, 6, 7), matrix = half + half.transpose();
  const SymmetricModes modes = symmetric_modes(matrix);
  EXPECT_TRUE(std::is_sorted(modes.values.begin(), modes.values.end()));
  EXPECT_LT((modes.vectors * modes.values.asDiagonal() * modes.vectors.transpose() - matrix).norm(), 1e-12);
}

TEST(dense_algebra, eigenvalues_of_a_companion_matrix_are_the_roots) {
  // (x - 2)(x^2 + 2 x + 5): 2 and -1 +- 2 i.
  MatrixXd companion(3, 3);
  companion << 0.0, -1.0, 10.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  const Eigen::VectorXcd values = compute_eigenvalues(companion);
  for (const std::complex<double> root : {std::complex<double>(2.0), {-1.0, 2.0}, {-1.0, -2.0}}) {
    EXPECT_LT((values.array() - root).abs().minCoeff(), 1e-13);
  }
}

}  // namespace
}  // namespace overbend

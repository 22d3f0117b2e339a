#include "numerics/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "support/isas.h"

namespace overbend {
namespace {

struct DenseTwin {
  BlockTridiagonal blocks;
  Eigen::MatrixXd matrix, rhs;
};

enum class Heavy { on_the_diagonal, across_it };

/// A random unsymmetric system, and the same as a dense matrix. Large entries across the diagonal need row exchanges.
DenseTwin random_system(int nodes, unsigned seed, Heavy heavy = Heavy::across_it) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  DenseTwin twin{BlockTridiagonal(nodes), Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes), Eigen::MatrixXd(6 * nodes, 2)};
  for (int n = 0; n < nodes; ++n) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        const double d = normal(generator) + (i == (heavy == Heavy::across_it ? 5 - j : j) ? 9.0 : 0.0);
        twin.blocks.diag(n)[i * kRowWidth + j] = twin.matrix(6 * n + i, 6 * n + j) = d;
        if (n + 1 < nodes) {
          const double u = normal(generator);
          const double l = normal(generator);
          twin.blocks.upper(n)[i * kRowWidth + j] = twin.matrix(6 * n + i, 6 * n + 6 + j) = u;
          twin.blocks.lower(n)[i * kRowWidth + j] = twin.matrix(6 * n + 6 + i, 6 * n + j) = l;
        }
      }
      for (int side = 0; side < 2; ++side) {
        twin.blocks.rhs(n, i, side) = twin.rhs(6 * n + i, side) = normal(generator);
      }
    }
  }
  return twin;
}

class block_tridiagonal_of_any_kind : public ::testing::TestWithParam<Heavy> {};
INSTANTIATE_TEST_SUITE_P(block_tridiagonal, block_tridiagonal_of_any_kind,
                         ::testing::Values(Heavy::on_the_diagonal, Heavy::across_it), [](const auto& heavy) {
                           return heavy.param == Heavy::across_it ? "heavy_across_the_diagonal"
                                                                  : "heavy_on_the_diagonal";
                         });

TEST_P(block_tridiagonal_of_any_kind, solves_what_a_dense_solver_solves_on_every_instruction_set) {
  for (const Isa isa : available_isas()) {
    DenseTwin twin = random_system(40, 7, GetParam());
    const Eigen::MatrixXd expected = twin.matrix.fullPivLu().solve(twin.rhs);
    ASSERT_TRUE(solve_on(twin.blocks, isa).solved());
    double worst = 0.0;
    for (int n = 0; n < 40; ++n) {
      for (int i = 0; i < 6; ++i) {
        for (int side = 0; side < 2; ++side) {
          worst = std::max(worst, std::abs(twin.blocks.rhs(n, i, side) - expected(6 * n + i, side)));
        }
      }
    }
    EXPECT_LT(worst, 1e-10 * expected.cwiseAbs().maxCoeff());  // rounding of two eliminations
  }
}

TEST_P(block_tridiagonal_of_any_kind, solves_again_for_another_right_hand_side) {
  for (const Isa isa : available_isas()) {
    DenseTwin twin = random_system(40, 11, GetParam());
    const Eigen::VectorXd second = Eigen::VectorXd::LinSpaced(240, -1.0, 2.0);
    const Eigen::VectorXd expected = twin.matrix.fullPivLu().solve(second);
    ASSERT_TRUE(solve_on(twin.blocks, isa).solved());
    Eigen::VectorXd x = second;
    resolve_on(twin.blocks, x.data(), isa);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.cwiseAbs().maxCoeff());  // rounding
  }
}

TEST_P(block_tridiagonal_of_any_kind, factors_anew_from_the_node_where_blocks_have_changed) {
  constexpr int kChanged = 15;
  for (const Isa isa : available_isas()) {
    DenseTwin twin = random_system(40, 7, GetParam());
    const DenseTwin second_dense_twin = random_system(40, 8, GetParam());
    for (int n = kChanged; n < 40; ++n) {
      const int from = 6 * n, width = n + 1 < 40 ? 12 : 6;
      twin.matrix.block(from, from, 6, width) = second_dense_twin.matrix.block(from, from, 6, width);
      twin.matrix.block(from, from, width, 6) = second_dense_twin.matrix.block(from, from, width, 6);
    }
    ASSERT_TRUE(solve_on(twin.blocks, isa).solved());
    twin.blocks.copy_from(second_dense_twin.blocks, kChanged);
    ASSERT_TRUE(refactor_on(twin.blocks, kChanged, isa).solved());
    const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(240, -1.0, 2.0);
    Eigen::VectorXd x = rhs;
    resolve_on(twin.blocks, x.data(), isa);
    const Eigen::VectorXd expected = twin.matrix.fullPivLu().solve(rhs);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.cwiseAbs().maxCoeff());  // rounding
  }
}

/// A cantilever of n elements of unit length and bending stiffness that hardly stretch, each turned against the one
/// before by 0.2 rad in the plane of the first two freedoms, slopes in the third; a unit force at its tip.
DenseTwin rolled_up_cantilever(int n, double EA) {
  DenseTwin twin{BlockTridiagonal(n + 1), Eigen::MatrixXd::Zero(6 * n + 6, 6 * n + 6),
                 Eigen::MatrixXd::Zero(6 * n + 6, 2)};
  Eigen::Matrix<double, 6, 6> beam = Eigen::Matrix<double, 6, 6>::Zero();  // along, across, slope of either node
  beam << EA, 0, 0, -EA, 0, 0,                                             //
      0, 12, 6, 0, -12, 6,                                                 //
      0, 6, 4, 0, -6, 2,                                                   //
      -EA, 0, 0, EA, 0, 0,                                                 //
      0, -12, -6, 0, 12, -6,                                               //
      0, 6, 2, 0, -6, 4;
  for (int e = 0; e < n; ++e) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(-0.2 * e, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    Eigen::Matrix<double, 12, 12> element = Eigen::Matrix<double, 12, 12>::Identity();
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        element.block<3, 3>(6 * i, 6 * j) = turn.transpose() * beam.block<3, 3>(3 * i, 3 * j) * turn;
      }
    }
    if (e == 0) element.topRows<3>() = Eigen::Matrix<double, 3, 12>::Identity();
    add_element(twin.blocks, e, element);
    twin.matrix.block<12, 12>(6 * e, 6 * e) += element;
  }
  twin.blocks.rhs(n, 0, 0) = twin.rhs(6 * n, 0) = 1.0;
  return twin;
}

// The residual of the forces does not show how ill the system is conditioned: elimination that loses no digits leaves
// rounding of the largest of them.
TEST(block_tridiagonal, balances_forces_to_rounding_where_a_line_hardly_stretches) {
  constexpr int kElements = 64;
  for (const Isa isa : available_isas()) {
    DenseTwin twin = rolled_up_cantilever(kElements, 1e9);
    const Eigen::MatrixXd K = twin.matrix;
    ASSERT_TRUE(solve_on(twin.blocks, isa).solved());
    Eigen::VectorXd x(6 * (kElements + 1));
    for (int n = 0; n <= kElements; ++n) {
      for (int i = 0; i < kNodeDofs; ++i) x(6 * n + i) = twin.blocks.rhs(n, i, 0);
    }
    using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
    const Long left = K.cast<long double>() * x.cast<long double>() - twin.rhs.col(0).cast<long double>();
    const double max_value = (K.cwiseAbs() * x.cwiseAbs()).maxCoeff();
    EXPECT_LT(static_cast<double>(left.cwiseAbs().maxCoeff()), 1e-13 * max_value);
  }
}

TEST(block_tridiagonal, names_the_singular_node) {
  DenseTwin twin = random_system(10, 3);
  for (int j = 0; j < kRowWidth; ++j) {  // node 6 loses an equation
    twin.blocks.diag(6)[2 * kRowWidth + j] = 0.0;
    twin.blocks.upper(6)[2 * kRowWidth + j] = 0.0;
    twin.blocks.lower(5)[2 * kRowWidth + j] = 0.0;
  }
  EXPECT_EQ(solve(twin.blocks).singular_node, 6);
}

TEST(block_tridiagonal, counts_blocks_with_negative_determinant) {
  BlockTridiagonal system(3);
  for (int n = 0; n < 3; ++n) {
    for (int i = 0; i < 6; ++i) {
      system.diag(n)[i * kRowWidth + i] = n == 1 && i == 0 ? -2.0 : 2.0;
    }
  }
  EXPECT_EQ(solve(system).negative_blocks, 1);
}

}  // namespace
}  // namespace overbend

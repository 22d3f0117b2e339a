#include "system/held_directions.h"

#include <gtest/gtest.h>

#include <random>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// A regular system of three nodes with a residual.
struct Chain {
  BlockTridiagonal blocks{3};
  std::vector<double> residual = std::vector<double>(18);

  Chain() {
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    for (int node = 0; node < 2; ++node) {
      ElementMatrix k = ElementMatrix::Zero();
      for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) k(i, j) = 0.2 * normal(generator) + (i == j ? 5.0 : 0.0);
      }
      add_element(blocks, node, k);
    }
    for (double& r : residual) r = normal(generator);
  }
  std::vector<double> increments() {
    for (int node = 0; node < 3; ++node) {
      for (int i = 0; i < 6; ++i) blocks.rhs(node, i, 0) = -residual[static_cast<std::size_t>(6 * node + i)];
    }
    EXPECT_TRUE(solve(blocks).solved());
    std::vector<double> dq;
    for (int node = 0; node < 3; ++node) {
      for (int i = 0; i < 6; ++i) dq.push_back(blocks.rhs(node, i, 0));
    }
    return dq;
  }
};

TEST(held_directions, do_not_move_while_the_free_ones_balance) {
  const Vec3 direction = Vec3(1.0, -2.0, 0.5).normalized();
  HeldDirections held;
  held.position = across(direction);
  held.tangent = all_directions();
  Chain chain;
  const Eigen::MatrixXd before = testing::dense(chain.blocks);
  const std::vector<double> forces = chain.residual;
  hold_node(1, held, chain.residual, &chain.blocks);
  const std::vector<double> dq = chain.increments();
  const Vec3 moved(dq[6], dq[7], dq[8]), turned(dq[9], dq[10], dq[11]);
  EXPECT_LT(moved.cross(direction).norm(), 1e-12);
  EXPECT_GT(std::abs(moved.dot(direction)), 1e-3);
  EXPECT_LT(turned.norm(), 1e-12);
  // The equations of what is free hold in the full system.
  const Eigen::VectorXd balance =
      before * Eigen::Map<const Eigen::VectorXd>(dq.data(), 18) + Eigen::Map<const Eigen::VectorXd>(forces.data(), 18);
  EXPECT_LT(balance.head(6).norm() + balance.tail(6).norm(), 1e-12);
  EXPECT_LT(std::abs(direction.dot(Vec3(balance.segment<3>(6)))), 1e-12);
}

}  // namespace
}  // namespace overbend

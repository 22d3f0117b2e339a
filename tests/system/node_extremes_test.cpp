#include "system/node_extremes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/isas.h"

namespace overbend {
namespace {

std::vector<double> random_numbers(std::size_t count) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(count);
  for (double& number : numbers) number = normal(generator);
  return numbers;
}

/// Forces count as they are, moments by a share that differs from node to node.
std::vector<double> shares_of(std::size_t nodes) {
  std::vector<double> shares;
  for (std::size_t node = 0; node < nodes; ++node) {
    shares.insert(shares.end(), {1.0, 0.0, 0.0, 0.5 + 0.1 * static_cast<double>(node % 5), 0.0, 0.0});
  }
  return shares;
}

TEST(node_extremes, the_largest_force_or_moment_is_found_at_whatever_node_it_is) {
  for (const Isa isa : available_isas()) {
    for (const std::size_t nodes : {1, 2, 3, 7, 8, 21, 40}) {
      const std::vector<double> shares = shares_of(nodes);
      for (std::size_t at = 0; at < 6 * nodes; at += 3) {
        std::vector<double> values = random_numbers(6 * nodes);
        for (double& value : values) value *= 0.1;
        values[at] = -2.0;
        values[at + 1] = 3.0;
        values[at + 2] = 6.0;
        EXPECT_DOUBLE_EQ(largest_triple(values, shares, isa), 49.0 * shares[at]) << nodes << " nodes, number " << at;
      }
    }
  }
}

TEST(node_extremes, a_number_that_is_none_makes_the_largest_infinite) {
  const std::vector<double> shares = shares_of(19);
  for (const Isa isa : available_isas()) {
    for (const double none :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
      for (std::size_t at = 0; at < 6 * 19; ++at) {
        std::vector<double> values(6 * 19, 1.0);
        values[at] = none;
        EXPECT_EQ(largest_triple(values, shares, isa), std::numeric_limits<double>::infinity()) << none << " at " << at;
      }
    }
  }
}

TEST(node_extremes, the_largest_change_of_each_of_the_six_numbers_is_found) {
  for (const Isa isa : available_isas()) {
    for (const std::size_t nodes : {1, 3, 4, 5, 8, 22}) {
      const std::vector<double> then = random_numbers(6 * nodes);
      std::vector<double> now = then;
      double expected[6] = {};
      for (std::size_t i = 0; i < now.size(); ++i) {
        const double change = std::sin(static_cast<double>(3 * i + nodes));
        now[i] += change;
        expected[i % 6] = std::max(expected[i % 6], change * change);
      }
      const LargestChanges found = largest_changes(now, then, isa);
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(found.squares[k], expected[k], 1e-14) << nodes << " nodes, number " << k;
    }
  }
}

}  // namespace
}  // namespace overbend

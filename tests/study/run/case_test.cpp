#include "study/run/case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace overbend {
namespace {

TEST(case_of_a_study, has_a_duration_that_can_be_meant) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double duration : {kInfinite, -kInfinite, std::nan(""), 0.0, -1.0, 1e-4, 1.1e7}) {
    Description description;
    EXPECT_THROW(set_duration(description, duration), std::invalid_argument) << duration;
    EXPECT_FALSE(description.dynamics);
  }
  Description description;
  set_duration(description, 600.0);
  ASSERT_TRUE(description.dynamics);
  EXPECT_EQ(description.dynamics->duration, 600.0);
}

TEST(case_of_a_study, has_a_seed_that_a_double_holds) {
  EXPECT_NO_THROW(require_seeds({0, 1, kMaxSeed}));
  EXPECT_THROW(require_seeds({1, kMaxSeed + 1}), std::invalid_argument);
  EXPECT_EQ(static_cast<std::uint64_t>(static_cast<double>(kMaxSeed)), kMaxSeed);
}

}  // namespace
}  // namespace overbend

#include "statics/recovery/recovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/stiff_pipe.h"

namespace overbend {
namespace {

// A level bed without friction takes no horizontal force: what pulls at touchdown pulls at the straight far end too.
TEST(recovery, horizontal_tension_at_touchdown_is_the_pull_of_the_laid_pipe) {
  const Model model = build_model(testing::stiff_pipe());
  const StaticResults r = recover_statics(model, solve_statics(model).solution.value());
  EXPECT_NEAR(r.bottom_tension, r.stations.front().effective_tension, 1e-6 * r.bottom_tension);  // of the solver
  EXPECT_NEAR(r.bottom_tension, r.anchor_reaction.head<2>().norm(), 1e-6 * r.bottom_tension);
  const auto landing =
      std::ranges::find_if(r.stations, [&](const Station& station) { return station.s >= r.touchdown.s - 1e-9; });
  EXPECT_GT(r.bottom_tension, 1.009 * landing->effective_tension * std::cos(landing->inclination));  // shear has part
}

TEST(recovery, horizontal_tension_of_a_line_that_is_pushed_is_negative) {
  EXPECT_DOUBLE_EQ(horizontal_tension({3.0, -4.0, 7.0}, {0.6, -0.8, 0.1}), 5.0);
  EXPECT_DOUBLE_EQ(horizontal_tension({3.0, -4.0, 7.0}, {-0.6, 0.8, 0.1}), -5.0);
}

}  // namespace
}  // namespace overbend

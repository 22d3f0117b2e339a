#include "checks/load_effects.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(load_effects, parts_that_act_together_take_the_unfavourable_factors) {
  const LoadFactors f = local_check_factors(1.0);
  EXPECT_NEAR(design_size(f, Vec3(0, 0, 100), Vec3(0, 0, 50)), 1.1 * 100 + 1.3 * 50, 1e-12);
  EXPECT_NEAR(design_value(f, -100, -50), -(1.1 * 100 + 1.3 * 50), 1e-12);
}

TEST(load_effects, a_functional_part_that_relieves_counts_less) {
  const LoadFactors f = local_check_factors(1.0);
  EXPECT_NEAR(design_size(f, Vec3(0, 0, 10), Vec3(0, 0, -100)), 1.3 * 100 - 10 / 1.1, 1e-12);
  EXPECT_NEAR(design_value(f, 10, -100), 10 / 1.1 - 130, 1e-12);
}

TEST(load_effects, an_environmental_part_that_relieves_counts_less) {
  const LoadFactors f = local_check_factors(1.0);
  EXPECT_NEAR(design_size(f, Vec3(0, 100, 0), Vec3(0, -10, 0)), 1.1 * 100 - 10 / 1.3, 1e-12);
}

TEST(load_effects, parts_across_each_other_add_as_vectors) {
  const LoadFactors f = local_check_factors(1.0);
  EXPECT_NEAR(design_size(f, Vec3(30, 0, 0), Vec3(0, 40, 0)), std::hypot(1.1 * 30, 1.3 * 40), 1e-12);
}

TEST(load_effects, without_motion_the_condition_factor_scales_the_static_part) {
  EXPECT_NEAR(design_size(local_check_factors(0.82), Vec3(0, 0, 100), Vec3::Zero()), 1.1 * 0.82 * 100, 1e-12);
  EXPECT_NEAR(design_size(system_check_factors(1.0), Vec3(0, 0, 100), Vec3::Zero()), 120, 1e-12);
}

TEST(load_effects, a_moment_that_only_turns_with_the_pipe_has_not_changed) {
  const Vec3 from = Vec3(1, 0, 0), to = Vec3(std::cos(0.3), 0.0, std::sin(0.3));
  const Vec3 moment(0, 0, 5), turned(-5 * std::sin(0.3), 0, 5 * std::cos(0.3));
  EXPECT_NEAR((transported(moment, from, to) - turned).norm(), 0.0, 1e-12);
  const Vec3 across(0, 2, 0);
  EXPECT_NEAR((transported(across, from, to) - across).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace overbend

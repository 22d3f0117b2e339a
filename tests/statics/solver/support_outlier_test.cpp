#include "statics/solver/support_outlier.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

Description first_model() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/first-model.yaml").description.value();
}

std::optional<SupportOutlier> outlier(const Description& d) {
  return support_outlier(build_model(d));
}

TEST(support_outlier, a_stinger_on_its_curve_has_none) {
  EXPECT_FALSE(outlier(first_model()));
}

TEST(support_outlier, the_slip_of_a_sign_or_digit_is_traced_to_its_box_the_first_and_last_too) {
  for (std::size_t i = 2; i < 6; ++i) {  // the first two boxes stand where another sign or digit makes a metre
    for (const double factor : {-1.0, 0.1, 3.0}) {
      Description d = first_model();
      d.supports.boxes[i].z *= factor;
      const auto found = outlier(d);
      if (std::abs(d.supports.boxes[i].z / factor * (factor - 1.0)) < 2.0) continue;
      ASSERT_TRUE(found) << i << " " << factor;
      EXPECT_EQ(found->name, "the box '" + d.supports.boxes[i].name + "'") << factor;
      const double up = d.supports.boxes[i].z - d.supports.boxes[i].z / factor;
      EXPECT_EQ(found->height > 0.0, up > 0.0);
    }
  }
}

TEST(support_outlier, of_the_last_box_the_height_is_that_above_the_line_of_the_two_before) {
  Description d = first_model();
  d.supports.boxes[5].z = 11.12;
  const auto found = outlier(d);
  ASSERT_TRUE(found);
  // (5, -4.03), (15, -7.18) go on to (25, -10.33), falling by 0.315 a metre.
  EXPECT_NEAR(found->height, (11.12 + 10.33) / std::hypot(1.0, 0.315), 1e-9);
}

TEST(support_outlier, a_tensioner_below_its_ramp_is_traced) {
  Description d = first_model();
  d.tensioner.z = -1.6;
  const auto found = outlier(d);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "the tensioner");
  EXPECT_LT(found->height, -2.0);
}

TEST(support_outlier, is_named_where_no_equilibrium_is_found) {
  Description d = first_model();
  d.supports.boxes[5].z = 11.12;
  const StaticOutcome outcome = solve_statics(build_model(d));
  ASSERT_TRUE(outcome.failure);
  EXPECT_NE(outcome.failure->why.find("the box 'stinger 3' is 20.46 m above the line"), std::string::npos)
      << outcome.failure->why;
}

}  // namespace
}  // namespace overbend

// Rules of thumb for a first model; whether the lay passes its checks is for study/new_lay_test.cpp.
#include "model/new_model.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(new_model, the_wall_stands_the_water_pressure) {
  // 16 in at 2500 m: API RP 1111 with 0.7 asks for a D/t of about 20; shallow water for 40 at most.
  NewOptions options;
  options.pipe = "16";
  options.depth = "2500 m";
  const NewModel deep = std::get<NewModel>(choose_model(options));
  EXPECT_LT(deep.diameter / deep.wall, 22.0);
  options.depth = "20 m";
  options.concrete = "40 mm";  // weight that the wall need not give
  const NewModel shallow = std::get<NewModel>(choose_model(options));
  EXPECT_LE(shallow.diameter / shallow.wall, 40.0);
  EXPECT_GT(shallow.diameter / shallow.wall, 30.0);
}

TEST(new_model, a_pipe_lies_still_without_concrete_that_was_not_asked_for) {
  NewOptions options;
  options.pipe = "36";
  options.depth = "30 m";
  const NewModel heavy = std::get<NewModel>(choose_model(options));
  EXPECT_EQ(heavy.concrete, 0.0);
  EXPECT_GT(heavy.submerged_weight, 0.05 * heavy.weight_in_air);
}

TEST(new_model, no_flat_barge_is_sent_to_deep_water) {
  NewOptions options;
  options.pipe = "16";
  options.depth = "1200 m";
  EXPECT_EQ(std::get<NewModel>(choose_model(options)).vessel, "ship");
  for (const char* barge : {"barge", "BGL-1"}) {
    options.vessel = barge;
    EXPECT_NE(std::get<std::string>(choose_model(options)).find("--vessel"), std::string::npos);
  }
}

TEST(new_model, nominal_sizes_are_those_of_api_5l) {
  EXPECT_DOUBLE_EQ(nominal_diameter(4).value_or(0.0), 0.1143);
  EXPECT_DOUBLE_EQ(nominal_diameter(12).value_or(0.0), 0.3239);
  EXPECT_DOUBLE_EQ(nominal_diameter(16).value_or(0.0), 0.4064);
  EXPECT_DOUBLE_EQ(nominal_diameter(48).value_or(0.0), 1.2192);
  EXPECT_FALSE(nominal_diameter(17).has_value());
  EXPECT_FALSE(nominal_diameter(50).has_value());
}

}  // namespace
}  // namespace overbend

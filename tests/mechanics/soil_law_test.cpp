#include "mechanics/soil_law.h"

#include <gtest/gtest.h>

#include <initializer_list>

#include "mechanics/line_kernel.h"

namespace overbend {
namespace {

LineEnvironment make_bed(int soil) {
  LineEnvironment env;
  env.bed_stiffness = 100e3;
  env.bed_bearing = 4e3;
  env.bed_soil = soil;
  return env;
}

TEST(soil_law, begins_with_the_stiffness_whatever_the_soil) {
  for (const int soil : {0, kHyperbolicSoil, kBilinearSoil}) {
    EXPECT_NEAR(soil_force(make_bed(soil), 1e-6), 0.1, 1e-5);
    EXPECT_EQ(soil_force(make_bed(soil), 0.0), 0.0);
  }
}

TEST(soil_law, hyperbola_has_half_the_bearing_force_where_the_line_has_all) {
  EXPECT_DOUBLE_EQ(soil_force(make_bed(kHyperbolicSoil), 0.04), 2e3);
  EXPECT_LT(soil_force(make_bed(kHyperbolicSoil), 1e3), 4e3);
}

TEST(soil_law, bilinear_soil_grows_by_a_tenth_beyond_its_bearing_force) {
  EXPECT_DOUBLE_EQ(soil_force(make_bed(kBilinearSoil), 0.03), 3e3);
  EXPECT_DOUBLE_EQ(soil_force(make_bed(kBilinearSoil), 0.14), 5e3);
}

}  // namespace
}  // namespace overbend

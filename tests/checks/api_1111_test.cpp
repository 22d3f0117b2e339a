#include "checks/api_1111.h"

#include <gtest/gtest.h>

#include <cmath>

#include "checks/test_pipes.h"

namespace overbend {
namespace {

constexpr double kDelta = 0.005;

TEST(api_1111, collapse_bending_and_propagation_are_those_computed_apart) {
  for (const TestPipe& p : kTestPipes) {
    SCOPED_TRACE(p.name);
    const ApiPipe pipe = p.api();
    EXPECT_NEAR(1e-6 * api_collapse_pressure(pipe), p.api_collapse, 0.5e-4);
    EXPECT_NEAR(p.pressure() / (0.7 * api_collapse_pressure(pipe)), p.api_collapse_share, 0.5e-5);
    EXPECT_NEAR(api_buckling_strain(pipe), p.api_buckling, 0.5e-5);
    EXPECT_NEAR(1e-6 * api_propagation_pressure(pipe), p.api_propagation, 0.5e-4);
    const double strain = 3.33 * 0.0015;
    EXPECT_NEAR(api_bending_utilisation(pipe, strain, p.pressure(), 1.0, kDelta), p.api_bending_third, 0.5e-5);
    const double fourth = 0.6 / api_ovality_factor(kDelta);
    EXPECT_NEAR(api_bending_utilisation(pipe, strain, p.pressure(), fourth, kDelta), p.api_bending_fourth, 0.5e-5);
  }
}

TEST(api_1111, collapse_lies_below_both_yield_and_elastic_collapse_and_tends_to_the_smaller) {
  const ApiPipe thick{1.0, 0.1, 450e6, 207e9, 0.3}, thin{1.0, 0.005, 450e6, 207e9, 0.3};
  EXPECT_LT(api_collapse_pressure(thick), 2.0 * 450e6 * 0.1);
  EXPECT_NEAR(api_collapse_pressure(thick) / (2.0 * 450e6 * 0.1), 1.0, 0.03);  // P_e is five times as large
  const double elastic = 2.0 * 207e9 * std::pow(0.005, 3) / 0.91;
  EXPECT_LT(api_collapse_pressure(thin), elastic);
  EXPECT_NEAR(api_collapse_pressure(thin) / elastic, 1.0, 0.001);  // P_y is eighty times as large
}

TEST(api_1111, pure_bending_is_used_up_at_the_buckling_strain_of_a_round_pipe) {
  const ApiPipe pipe = kTestPipes[0].api();
  EXPECT_DOUBLE_EQ(api_bending_utilisation(pipe, api_buckling_strain(pipe), 0.0, 1.0, 0.0), 1.0);
  EXPECT_GT(api_bending_utilisation(pipe, 0.002, 0.0, 1.0, 0.01), api_bending_utilisation(pipe, 0.002, 0.0, 1.0, 0.0));
}

TEST(api_1111, tension_alone_and_pressure_alone_use_up_the_combined_load) {
  const ApiPipe pipe = kTestPipes[0].api();
  EXPECT_DOUBLE_EQ(api_combined_load(pipe, 517e6, 0.0, api_yield_tension(pipe)), 1.0);
  EXPECT_DOUBLE_EQ(api_combined_load(pipe, 517e6, -api_burst_pressure(pipe, 517e6), 0.0), 1.0);
  EXPECT_NEAR(api_yield_tension(pipe), 414e6 * 0.0138151, 1.0e3);  // area of 406.4 x 11.125 mm to six digits
}

}  // namespace
}  // namespace overbend

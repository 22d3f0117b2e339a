#include "model/pipe/contact_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// Deflection under one of two opposite point loads at the middle of a cylinder on end diaphragms, whose waves along it
/// are whole numbers of halves.
double pinched_cylinder(const Shell& shell, double length) {
  double sum = 0.0;
  for (int m = 1; m <= 1201; m += 2) {
    for (int n = 0; n <= 800; n += 2) {
      const double share = (n == 0 ? 1.0 : 2.0) / (2.0 * std::numbers::pi * shell.radius) * 2.0 / length;
      sum += 2.0 * share * shell.response(n, m * std::numbers::pi * shell.radius / length);
    }
  }
  return sum;
}

// The pinched cylinder of Belytschko et al. (1985), CMAME 51: 1.8248e-5 under a unit load.
TEST(shell_response, deflects_a_pinched_cylinder_as_published) {
  EXPECT_NEAR(pinched_cylinder({300.0, 3.0, 3e6, 0.3}, 600.0), 1.8248e-5, 1e-3 * 1.8248e-5);
}

const Shell kSixteenInch{0.5 * (0.4064 - 0.011125), 0.011125, 207e9, 0.3};

// 59.7 MN/m by a sum over the same waves with 400 points of quadrature each.
TEST(shell_stiffness, of_a_pipe_over_a_point) {
  EXPECT_NEAR(shell_stiffness(kSixteenInch, 0.0), 59.7e6, 0.1e6);
}

TEST(shell_stiffness, grows_with_the_bearing_and_with_the_modulus) {
  EXPECT_GT(shell_stiffness(kSixteenInch, 0.2), 1.2 * shell_stiffness(kSixteenInch, 0.0));
  Shell soft = kSixteenInch;
  soft.youngs_modulus *= 0.5;
  EXPECT_NEAR(shell_stiffness(soft, 0.1), 0.5 * shell_stiffness(kSixteenInch, 0.1), 1.0);
}

TEST(contact_stiffness, is_that_of_springs_in_series) {
  const ContactStiffness parts{60e6, 0.0, 30e6};
  EXPECT_NEAR(parts.total(), 20e6, 1e-3);
  EXPECT_NEAR((ContactStiffness{60e6, 60e6, 30e6}.total()), 15e6, 1e-3);
}

TEST(contact_stiffness, takes_a_layer_as_it_bears) {
  SectionDescription layers = testing::sixteen_inch_pipe();
  const Section pipe = derive_section("pipe", layers, 10.05e3);
  EXPECT_EQ(contact_stiffness(pipe, layers, 0.6, 50e6).coating, 0.0);
  layers.coatings.back().youngs_modulus = 1e9;
  double thickness = 0.0;
  for (const CoatingDescription& layer : layers.coatings) thickness += layer.thickness;
  const double bearing = contact_length(0.6, pipe.outer_diameter, pipe.steel_diameter);
  EXPECT_NEAR(contact_stiffness(pipe, layers, 0.6, 50e6).coating,
              1e9 * bearing * thickness / layers.coatings.back().thickness, 1.0);
}

TEST(contact_stiffness, is_of_the_pipe_that_lies_over_the_roller) {
  Description d = testing::plain_description();
  d.rollers.push_back({"v", {0.15, 0.6}, std::nullopt, std::nullopt, 0.1, 0.3, 0.4});
  BoxDescription box;
  box.x = 10.0;
  box.roller = "v";
  d.supports.boxes.push_back(box);
  const Model thin = build_model(d);
  SegmentDescription thick{"thick", 500.0, d.pipe.section};
  thick.section.steel.wall_thickness *= 2.0;
  d.pipe.segments.push_back(thick);
  const Model covered = build_model(d);
  EXPECT_EQ(covered.section_over(covered.supports.rollers[0]).name, "thick");
  EXPECT_GT(covered.supports.rollers[0].stiffness, thin.supports.rollers[0].stiffness);
  d.rollers[0].default_stiffness = RollerStiffness::penalty;
  EXPECT_EQ(build_model(d).supports.rollers[0].stiffness, 0.0);
}

}  // namespace
}  // namespace overbend

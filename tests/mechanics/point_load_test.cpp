#include "mechanics/point_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanics/stress.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(point_load, half_a_pipe_under_water_is_half_wetted) {
  EXPECT_NEAR(wetted_fraction(0.0, 0.3).value, 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(wetted_fraction(-0.3, 0.3).value, 1.0);
  EXPECT_DOUBLE_EQ(wetted_fraction(0.3, 0.3).value, 0.0);
}

TEST(point_load, wetted_slope_is_the_derivative) {
  for (const double z : {-0.25, -0.1, 0.05, 0.2}) {
    const double difference = (wetted_fraction(z + 1e-6, 0.3).value - wetted_fraction(z - 1e-6, 0.3).value) / 2e-6;
    EXPECT_NEAR(wetted_fraction(z, 0.3).slope, difference, 1e-8);
  }
}

TEST(point_load, drag_across_a_level_pipe_is_half_rho_Cd_D_U_squared) {
  Description d = testing::plain_description();
  d.environment.current = {{0.0, 1.02, 0.0}};
  const Model model = build_model(d);
  const LineElements elements = line_elements(model, {1.0}, {0});
  const LineEnvironment env = line_environment(model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
  const PointLoad load = point_load(elements, env, 0, Vec3(0, 0, -30), Vec3::UnitX());
  EXPECT_NEAR(load.current.y(), 0.5 * 10.05e3 / kGravity * 1.2 * 0.489 * 1.02 * 1.02, 1e-9);  // current goes north
  EXPECT_NEAR(load.weight.z() + load.buoyancy.z(), -368.493, 1e-3);  // [silva2009] table 4, to its printed digits
}

TEST(point_load, drag_along_a_pipe_is_the_axial_law) {
  Description d = testing::plain_description();
  d.environment.current = {{0.0, 0.8, 0.5 * std::numbers::pi}};
  const Model model = build_model(d);
  const LineElements elements = line_elements(model, {1.0}, {0});
  const LineEnvironment env = line_environment(model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
  const PointLoad load = point_load(elements, env, 0, Vec3(0, 0, -30), Vec3::UnitX());
  const double expected = 0.5 * 10.05e3 / kGravity * std::numbers::pi * 0.489 * 0.03 * 0.64;
  EXPECT_NEAR(load.current.x(), expected, 1e-9);
}

TEST(stress, a_thin_pipe_under_inner_pressure_has_the_boiler_stress) {
  SectionDescription pipe;
  pipe.steel = {0.5, 0.0005, 207e9, 0.3, 450e6, std::nullopt, 77e3, {}};
  const Section section = derive_section("thin", pipe, 10.05e3);
  SectionLoads loads;
  loads.internal_pressure = 1e5;
  const SectionStress stress = section_stress(section, loads);
  EXPECT_NEAR(stress.hoop, 1e5 * 0.5 / (2 * 0.0005), 0.003 * stress.hoop);  // t/D = 1/1000
}

TEST(stress, a_cable_has_the_pressure_of_the_water_across_it) {
  CableDescription cable;
  cable.diameter = 0.076;
  cable.weight_in_air = 240.0;
  cable.weight_submerged = 205.0;
  cable.axial_stiffness = 270e6;
  SectionLoads loads;
  loads.external_pressure = 0.9e6;
  const SectionStress stress = section_stress(cable_section(cable, 10.05e3), loads);
  EXPECT_DOUBLE_EQ(stress.hoop, -0.9e6);  // Lame for a solid bar
  EXPECT_TRUE(std::isfinite(stress.von_mises));
}

TEST(stress, a_closed_end_under_water_with_no_effective_tension_is_in_hydrostatic_balance) {
  const Section section = derive_section("pipe", testing::sixteen_inch_pipe(), 10.05e3);
  SectionLoads loads;
  loads.external_pressure = 1e6;
  const SectionStress stress = section_stress(section, loads);
  EXPECT_NEAR(stress.wall_tension, -1e6 * std::numbers::pi / 4 * 0.4064 * 0.4064, 1e-6);
  EXPECT_NEAR(stress.axial, stress.wall_tension / section.steel_area, 1e-6);
}

TEST(stress, bending_stress_is_E_kappa_D_over_two) {
  const Section section = derive_section("pipe", testing::sixteen_inch_pipe(), 10.05e3);
  SectionLoads loads;
  loads.curvature = 1.0 / 150.0;
  loads.bending_moment = section.EI * loads.curvature;
  EXPECT_NEAR(section_stress(section, loads).bending, 280.416e6, 1e3);  // E r/R of the example, 280.4 MPa
}

}  // namespace
}  // namespace overbend

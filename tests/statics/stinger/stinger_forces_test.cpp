#include "statics/stinger/stinger_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/vessel/stinger_rotation.h"
#include "statics/stinger/stinger_equilibrium.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

constexpr double kWater = 10.05e3;

/// A stinger without rollers that counts: sections given by the test, hinges on the stern shoe's frame. The shoe is 3 m
/// above the water.
Description hinged(std::vector<StingerSectionDescription> sections) {
  Description d = testing::plain_description();
  d.environment.water_weight_density = kWater;
  d.vessel.stern_shoe_z = 3.0;
  d.supports = {};
  d.supports.sections = std::move(sections);
  return d;
}

StingerSectionDescription section_at(double x, double z) {
  StingerSectionDescription section;
  section.hinge = {x, z};
  return section;
}

StingerSectionDescription with_body(double x, double z, double weight, const StingerPoint& stinger_point) {
  StingerSectionDescription section = section_at(x, z);
  section.body.emplace();
  section.body->weight = weight;
  section.body->at = stinger_point;
  return section;
}

double moment_at(Model& model, const std::vector<double>& angles, std::size_t section = 0) {
  rotate_stinger(model.supports, angles);
  return hinge_moments(model, {})[section];
}

/// A level tank of 4 m across a current of 1.5 m/s: 1/2 rho Cd d l u^2 at its middle.
TEST(stinger_forces, a_current_pushes_a_tank_across_its_axis) {
  StingerSectionDescription section = section_at(0.0, -1.0);
  section.tanks.push_back({"t", {2.0, -6.0}, {2.0, -10.0}, 0.0, 1.2, 30e3, 0.0});
  section.tanks.back().drag = 0.9;
  Description d = hinged({section});
  const Model at_rest = build_model(d);
  d.environment.current = {{0.0, 1.5, d.vessel.heading}, {50.0, 1.5, d.vessel.heading}};
  const Model model = build_model(d);
  const HingeAxis hinge = hinge_axis(model, 0);
  const double drag = 0.5 * kWater / kGravity * 0.9 * 1.2 * 4.0 * 1.5 * 1.5;  // forward, 7 m below the hinge: tip down
  const double moment =
      moment_about(hinge, floating_forces(model, 0)) - moment_about(hinge, floating_forces(at_rest, 0));
  EXPECT_NEAR(std::abs(moment), 7.0 * drag, 1e-9 * 7.0 * drag);
}

TEST(stinger_forces, a_tank_floats_with_the_length_of_its_axis_below_the_water) {
  StingerSectionDescription section = section_at(0.0, -1.0);
  section.tanks.push_back({"t", {2.0, 1.0}, {6.0, -7.0}, 0.5, 1.2, 30e3, 0.25});
  const Model model = build_model(hinged({section}));
  const FloatingTank tank = floating_tank(model, 0, section.tanks[0]);
  // World heights 4 m and -4 m: half of it is wet.
  const double full = kWater * 0.25 * std::numbers::pi * 1.44 * std::hypot(4.0, 8.0);
  EXPECT_NEAR(tank.buoyancy, 0.5 * full, 1e-6);
  EXPECT_NEAR(tank.weight, 30e3 + 0.25 * full, 1e-6);
  EXPECT_NEAR(tank.submerged, 0.5, 1e-12);
  EXPECT_NEAR(tank.draught, 4.0, 1e-12);
  EXPECT_NEAR(tank.buoyancy_at_W.z(), -2.0, 1e-12);
  EXPECT_NEAR(tank.weight_at_W.z(), 0.0, 1e-12);
}

/// A tube hinged h above the water: W L/2 = gamma A s (L - s/2) with s of its length wet, sin(dip) = h / (L - s).
TEST(stinger_forces, balance_a_tube_hinged_above_the_water_where_statics_of_a_stick_has_it) {
  const double length = 30.0, height = 2.0, per_length = kWater * 0.25 * std::numbers::pi;
  const double weight = 0.6 * per_length * length;
  const double wet = length - std::sqrt(length * length - weight * length / per_length);
  const double dip = std::asin(height / (length - wet));
  StingerSectionDescription section = section_at(0.0, height - 3.0);
  section.tanks.push_back({"tube", {0.0, height - 3.0}, {length, height - 3.0}, 0.0, 1.0, weight});
  Model model = build_model(hinged({section}));
  EXPECT_NEAR(moment_at(model, {dip}), 0.0, 1e-9 * weight * length);
  EXPECT_GT(moment_at(model, {dip - 0.01}), 0.0);
  EXPECT_LT(moment_at(model, {dip + 0.01}), 0.0);
}

TEST(stinger_forces, of_two_sections_are_those_of_a_chain_of_two_pendulums) {
  const double w1 = 400e3, w2 = 250e3, a1 = 7.0, l1 = 15.0, a2 = 6.0, t1 = 0.3, t2 = 0.5;
  Model model = build_model(hinged({with_body(0.0, 0.0, w1, {a1, 0.0}), with_body(l1, 0.0, w2, {l1 + a2, 0.0})}));
  EXPECT_NEAR(moment_at(model, {t1, t2}, 0), (w1 * a1 + w2 * l1) * std::cos(t1) + w2 * a2 * std::cos(t1 + t2), 1e-3);
  EXPECT_NEAR(moment_at(model, {t1, t2}, 1), w2 * a2 * std::cos(t1 + t2), 1e-3);
}

TEST(stinger_forces, are_the_slope_of_their_energy) {
  StingerSectionDescription first = with_body(0.0, -1.0, 500e3, {8.0, -3.0});
  first.body->buoyancy = 300e3;
  first.body->buoyancy_at = StingerPoint{9.0, -5.0};
  first.tanks.push_back({"t", {1.0, -2.0}, {9.0, -6.0}, 1.0, 1.5, 40e3, 0.3});
  first.springs.push_back({"wire", {-1.0, 9.0}, {8.0, -2.0}, 2e6, 100e3, true});
  StingerSectionDescription second = with_body(10.0, -3.0, 200e3, {16.0, -6.0});
  second.tanks.push_back({"u", {11.0, -4.0}, {19.0, -8.0}, 0.0, 1.2, 20e3});
  Model model = build_model(hinged({first, second}));
  const auto energy = [&](const std::vector<double>& angles) {
    rotate_stinger(model.supports, angles);
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      for (const PointForce& force : floating_forces(model, i)) {
        // A tank that stays under water: its buoyancy stands at its middle and does not change.
        sum -= force.force_W.z() * force.at_W.z();
      }
    }
    const StingerSpringDescription& wire = first.springs[0];
    const double force = spring_force(first, model.supports.sections[0], wire);
    return sum + 0.5 * force * force / wire.stiffness;
  };
  const std::vector<double> sample = {0.4, 0.1};
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> low = sample, high = sample;
    low[i] -= 1e-5;
    high[i] += 1e-5;
    const double slope = (energy(high) - energy(low)) / 2e-5;
    EXPECT_NEAR(moment_at(model, sample, i), -slope, 1e-6 * std::abs(slope) + 1.0) << "hinge " << i;
  }
}

TEST(stinger_forces, a_wire_does_not_push) {
  StingerSectionDescription section = with_body(0.0, 0.0, 1e5, {5.0, 0.0});
  section.springs.push_back({"wire", {0.0, 10.0}, {10.0, 0.0}, 1e6, 50e3, true});
  section.springs.push_back({"strut", {0.0, 10.0}, {10.0, 0.0}, 1e6, 50e3, false});
  Model model = build_model(hinged({section}));
  rotate_stinger(model.supports, {-0.3});
  EXPECT_EQ(spring_force(section, model.supports.sections[0], section.springs[0]), 0.0);
  EXPECT_LT(spring_force(section, model.supports.sections[0], section.springs[1]), 0.0);
  rotate_stinger(model.supports, {0.0});
  EXPECT_DOUBLE_EQ(spring_force(section, model.supports.sections[0], section.springs[0]), 50e3);
}

TEST(stinger_forces, turn_with_the_trim_of_the_vessel) {
  Description d = hinged({with_body(0.0, 0.0, 1e5, {10.0, 0.0})});
  d.vessel.trim = 0.1;  // bow up: what points astern dips
  Model model = build_model(d);
  EXPECT_NEAR(moment_at(model, {0.2}), 1e6 * std::cos(0.3), 1e-3);
}

/// A rod of even weight, hinged at its end, hangs plumb: period 2 pi sqrt(2 L / 3 g).
TEST(stinger_forces, inertia_gives_the_period_of_a_suspended_rod) {
  const double length = 12.0;
  StingerSectionDescription section = with_body(0.0, 0.0, 3e5, {0.5 * length, 0.0});
  section.body->radius_of_gyration = length / std::sqrt(12.0);
  Model model = build_model(hinged({section}));
  const double inertia = inertia_about_hinge(model, 0);
  const double plumb = 0.5 * std::numbers::pi;
  const double stiffness = (moment_at(model, {plumb - 1e-4}) - moment_at(model, {plumb + 1e-4})) / 2e-4;
  EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(inertia / stiffness),
              2.0 * std::numbers::pi * std::sqrt(2.0 * length / (3.0 * kGravity)), 1e-5);
}

/// Water about a submerged tank that turns about a hinge on its axis: rho A L^3 / 3 next to the rod's m L^2 / 3.
TEST(stinger_forces, inertia_has_the_water_that_a_tank_pushes_across_its_axis) {
  StingerSectionDescription section = section_at(0.0, -10.0);
  section.tanks.push_back({"t", {0.0, -10.0}, {9.0, -10.0}, 0.0, 2.0, 80e3});
  const Model model = build_model(hinged({section}));
  const double water = kWater / kGravity * std::numbers::pi * 729.0 / 3.0;
  EXPECT_NEAR(inertia_about_hinge(model, 0), 80e3 / kGravity * 81.0 / 3.0 + water, 1e-3);
}

}  // namespace
}  // namespace overbend

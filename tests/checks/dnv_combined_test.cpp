#include "checks/dnv_combined.h"

#include <gtest/gtest.h>

#include "checks/dnv_strain.h"
#include "checks/dnv_strength.h"
#include "checks/test_pipes.h"

namespace overbend {
namespace {

LoadCapacity make_capacity(const TestPipe& p) {
  const double collapse = collapse_pressure(p.geometry(), p.fy(), p.alpha_fab, 0.005);
  return load_capacity(p.geometry(), p.fy(), p.fu(), collapse, kGammas);
}

StrainCapacity make_strain_capacity(const TestPipe& p) {
  const double collapse = collapse_pressure(p.geometry(), p.fy(), p.alpha_fab, 0.005);
  return {2.0 / strain_capacity(p.geometry(), 0.93, 0.0, 0.0), kGammas / collapse, 0.0, true};
}

TEST(dnv_combined, load_controlled_is_that_computed_apart) {
  for (const TestPipe& p : kTestPipes) {
    SCOPED_TRACE(p.name);
    const Wall wall = p.geometry();
    EXPECT_NEAR(slenderness_factor(wall.slenderness()), p.beta, 0.5e-5);
    EXPECT_NEAR(flow_stress_factor(wall.slenderness(), p.fy(), p.fu()), p.alpha_c, 0.5e-5);
    EXPECT_NEAR(1e-3 * plastic_axial_force(wall, p.fy()), p.plastic_force, 0.5e-2);
    EXPECT_NEAR(1e-3 * plastic_moment(wall, p.fy()), p.plastic_moment, 0.5e-3);
    const LoadTerms terms = load_terms(make_capacity(p), 1e3 * p.moment, 1e3 * p.force, p.pressure(), 0.0);
    EXPECT_NEAR(terms.utilisation(), p.lcc, 0.5e-5);
  }
}

TEST(dnv_combined, displacement_controlled_is_that_computed_apart) {
  for (const TestPipe& p : kTestPipes) {
    SCOPED_TRACE(p.name);
    EXPECT_NEAR(girth_weld_factor(p.geometry().slenderness()), p.girth_weld, 0.5e-4);
    EXPECT_NEAR(strain_capacity(p.geometry(), 0.93, 0.0, 0.0), p.strain_capacity, 0.5e-5);
    EXPECT_NEAR(strain_terms(make_strain_capacity(p), 0.002, p.pressure(), 0.0).utilisation(), p.dcc, 0.5e-5);
  }
}

/// The criteria as Achanta, RigidPipe (2018), restates those of OS-F101, evaluated apart from the program: 406.4 x 15.9
/// mm, f_y 432 and f_u 513.6 MPa, UOE, medium safety class, 400 kN m and 500 kN; 0.3 % of strain.
TEST(dnv_combined, both_criteria_are_those_of_a_public_restatement) {
  const Wall wall{0.4064, 0.0159, 207e9, 0.3};
  constexpr double kFactor = 1.15 * 1.14;
  const double collapse = collapse_pressure(wall, 432e6, 0.85, 0.005);
  const LoadCapacity capacity = load_capacity(wall, 432e6, 513.6e6, collapse, kFactor);
  EXPECT_NEAR(1e-6 * collapse, 21.410832, 1e-6);
  EXPECT_NEAR(1e-6 * capacity.burst, 40.621803, 1e-6);
  EXPECT_NEAR(capacity.alpha_c, 1.072282, 1e-6);
  const auto load = [&](double out, double in) { return load_terms(capacity, 400e3, 500e3, out, in).utilisation(); };
  EXPECT_NEAR(load(5e6, 0.0), 0.316675, 1e-6);
  EXPECT_NEAR(load(0.0, 15e6), 0.268139, 1e-6);
  EXPECT_NEAR(load(0.0, 30e6), 0.455259, 1e-6);  // above two thirds of the burst pressure
  const double eps_c = strain_capacity(wall, 0.93, 0.0, 0.0);
  EXPECT_NEAR(eps_c, 0.02392096, 1e-8);
  const StrainCapacity strains{2.5 / eps_c, kFactor / collapse, capacity.burst, true};
  EXPECT_NEAR(strain_terms(strains, 0.003, 5e6, 0.0).utilisation(), 0.701544, 1e-6);
  EXPECT_NEAR(strain_terms(strains, 0.003, 0.0, 15e6).utilisation(), 0.100387, 1e-6);
}

TEST(dnv_combined, load_effects_times_the_reserve_factor_use_the_whole_capacity) {
  for (const TestPipe& p : kTestPipes) {
    const LoadCapacity capacity = make_capacity(p);
    const double reserve = load_reserve(load_terms(capacity, 1e3 * p.moment, 1e3 * p.force, p.pressure(), 0.0));
    const LoadTerms scaled = load_terms(capacity, 1e3 * reserve * p.moment, 1e3 * reserve * p.force, p.pressure(), 0.0);
    EXPECT_GT(reserve, 1.0) << p.name;
    EXPECT_NEAR(scaled.utilisation(), 1.0, 1e-12) << p.name;  // rounding
    const StrainCapacity strains = make_strain_capacity(p);
    const double strain_reserve = strain_terms(strains, 0.002, p.pressure(), 0.0).reserve();
    EXPECT_NEAR(strain_terms(strains, 0.002 * strain_reserve, p.pressure(), 0.0).utilisation(), 1.0, 1e-12);
  }
}

TEST(dnv_combined, pressure_beyond_collapse_leaves_no_reserve_and_no_load_leaves_the_largest) {
  const TestPipe& p = kTestPipes[0];
  EXPECT_EQ(load_reserve(load_terms(make_capacity(p), 1e5, 0.0, 20e6, 0.0)), 0.0);
  EXPECT_EQ(load_reserve(load_terms(make_capacity(p), 0.0, 0.0, 1e5, 0.0)), kMaxReserve);
  EXPECT_EQ(strain_terms(make_strain_capacity(p), 0.001, 20e6, 0.0).reserve(), 0.0);
}

TEST(dnv_combined, both_signs_of_the_force_weigh_the_same) {
  const LoadCapacity capacity = make_capacity(kTestPipes[1]);
  EXPECT_DOUBLE_EQ(load_terms(capacity, 9e5, 1e6, 1e7, 0.0).utilisation(),
                   load_terms(capacity, 9e5, -1e6, 1e7, 0.0).utilisation());
}

TEST(dnv_combined, external_and_internal_formula_meet_where_the_pressures_are_equal) {
  const LoadCapacity capacity = make_capacity(kTestPipes[1]);
  const double outside = load_terms(capacity, 9e5, 1e6, 1e6 + 1e-3, 1e6).utilisation();
  const double inside = load_terms(capacity, 9e5, 1e6, 1e6 - 1e-3, 1e6).utilisation();
  EXPECT_NEAR(outside, inside, 1e-12);
}

TEST(dnv_combined, internal_overpressure_counts_against_the_burst_pressure) {
  const LoadCapacity capacity = make_capacity(kTestPipes[1]);
  const double half = load_terms(capacity, 0.0, 0.0, 0.0, 0.5 * capacity.burst).utilisation();
  const double expected = (1.0 - capacity.beta) * 0.5 / capacity.alpha_c;
  EXPECT_NEAR(half, expected * expected, 1e-12);
  const double full = load_terms(capacity, 0.0, 0.0, 0.0, capacity.burst).utilisation();
  EXPECT_NEAR(full, 1.0 / (capacity.alpha_c * capacity.alpha_c), 1e-12);  // alpha_p has come to 1
}

TEST(dnv_combined, the_formula_says_where_it_does_not_hold) {
  const LoadCapacity capacity = make_capacity(kTestPipes[1]);
  EXPECT_TRUE(load_formula_holds(capacity, 0.99 * capacity.axial_limit));
  EXPECT_FALSE(load_formula_holds(capacity, 1.01 * capacity.axial_limit));
  EXPECT_FALSE(load_formula_holds(capacity, -1.01 * capacity.axial_limit));
  for (const double slenderness : {14.0, 46.0}) {
    const Wall wall{1.0, 1.0 / slenderness, 207e9, 0.3};
    EXPECT_FALSE(load_formula_holds(load_capacity(wall, 430e6, 510e6, 5e6, kGammas), 0.0)) << slenderness;
  }
}

TEST(dnv_combined, a_roller_force_takes_from_the_plastic_moment) {
  const Wall wall = kTestPipes[0].geometry();
  const double fy = kTestPipes[0].fy(), yielding = 3.9 * fy * wall.thickness * wall.thickness;
  EXPECT_EQ(point_load_factor(wall, fy, 0.0), 1.0);
  EXPECT_NEAR(point_load_factor(wall, fy, yielding), 1.0 - wall.slenderness() / 130.0, 1e-12);
  EXPECT_EQ(point_load_factor(wall, fy, 100.0 * yielding), 0.05);
  const LoadCapacity capacity = make_capacity(kTestPipes[0]);
  EXPECT_NEAR(load_terms(capacity, 1e5, 0.0, 0.0, 0.0, 0.5).moment, load_terms(capacity, 2e5, 0.0, 0.0, 0.0).moment,
              1e-12);
}

TEST(dnv_combined, a_higher_safety_class_asks_for_more) {
  EXPECT_LT(safety_class_factor(SafetyClass::low), safety_class_factor(SafetyClass::medium));
  EXPECT_LT(safety_class_factor(SafetyClass::medium), safety_class_factor(SafetyClass::high));
  EXPECT_LT(strain_safety_factor(SafetyClass::low), strain_safety_factor(SafetyClass::medium));
  EXPECT_LT(strain_safety_factor(SafetyClass::medium), strain_safety_factor(SafetyClass::high));
}

}  // namespace
}  // namespace overbend

#include "checks/dnv_pressure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "checks/dnv_strength.h"
#include "checks/test_pipes.h"

namespace overbend {
namespace {

constexpr double kDigits4 = 0.5e-4;  // the values are printed to four digits after the point

TEST(dnv_pressure, collapse_and_propagation_are_those_computed_apart) {
  for (const TestPipe& p : kTestPipes) {
    SCOPED_TRACE(p.name);
    const Wall wall = p.geometry();
    const double collapse = collapse_pressure(wall, p.fy(), p.alpha_fab, 0.005);
    const double propagation = propagation_pressure(wall, p.fy(), p.alpha_fab);
    EXPECT_NEAR(1e-6 * p.pressure(), p.external, kDigits4);
    EXPECT_NEAR(1e-6 * elastic_collapse_pressure(wall), p.elastic, kDigits4);
    EXPECT_NEAR(1e-6 * plastic_collapse_pressure(wall, p.fy(), p.alpha_fab), p.plastic, kDigits4);
    EXPECT_NEAR(1e-6 * collapse, p.collapse, kDigits4);
    EXPECT_NEAR(1e-6 * propagation, p.propagation, kDigits4);
    EXPECT_NEAR(p.pressure() * kGammas / collapse, p.collapse_share, 0.5e-5);
    EXPECT_NEAR(p.pressure() * kGammas / propagation, p.propagation_share, 0.5e-5);
  }
}

/// Worked numbers of McEntee, PDover2t (2018), for ST-F101: 660 x 19.7 and 20.7 mm, f_y 444 MPa, UOE, 410 m of water.
/// To the digits that are printed there.
TEST(dnv_pressure, collapse_and_propagation_are_those_that_a_public_implementation_prints) {
  const Wall thinnest{0.660, 0.0197, 207e9, 0.3}, nominal{0.660, 0.0207, 207e9, 0.3};
  const double collapse = collapse_pressure(thinnest, 444e6, 0.85, 0.005);
  const double propagation = propagation_pressure(nominal, 444e6, 0.85);
  const double outside = 1027.0 * 9.81 * 410.0, medium = 1.15 * safety_class_factor(SafetyClass::medium);
  EXPECT_NEAR(elastic_collapse_pressure(thinnest), 12098341.0, 1.0);
  EXPECT_NEAR(plastic_collapse_pressure(thinnest, 444e6, 0.85), 22529636.4, 1.0);
  EXPECT_NEAR(collapse, 10831164.1, 1.0);
  EXPECT_NEAR(propagation, 2301102.5, 1.0);
  EXPECT_NEAR(medium * outside / collapse, 0.500, 1e-3);
  EXPECT_NEAR(medium * outside / propagation, 2.353, 1e-3);
}

/// Worked numbers of Subsea Energies, refpy, for four pipes.
TEST(dnv_pressure, burst_is_that_which_a_public_implementation_prints) {
  struct Printed {
    double diameter, wall, strength, burst;
  };
  for (const Printed& p :
       {Printed{0.2731, 0.0097, 414.72e6, 35270393.70}, Printed{0.3239, 0.0129, 399.36e6, 38255444.18},
        Printed{0.2731, 0.0097, 460.80e6, 39189326.34}, Printed{0.3239, 0.0129, 436.80e6, 41841892.07}}) {
    EXPECT_NEAR(burst_pressure({p.diameter, p.wall, 207e9, 0.3}, p.strength), p.burst, 0.01);
  }
}

/// Root between 0 and the smaller of both pressures, by halving.
double by_bisection(double elastic, double plastic, double right) {
  const auto excess = [&](double p) { return (p - elastic) * (p * p - plastic * plastic) - p * right; };
  double low = 0.0, high = std::min(elastic, plastic);
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST(dnv_pressure, the_closed_solution_of_the_cubic_is_its_root) {
  for (double slenderness = 10.0; slenderness <= 80.0; slenderness += 2.5) {
    for (const double ovality : {0.0005, 0.005, 0.03}) {
      const Wall wall{1.0, 1.0 / slenderness, 207e9, 0.3};
      const double elastic = elastic_collapse_pressure(wall), plastic = plastic_collapse_pressure(wall, 430e6, 0.85);
      const double root = by_bisection(elastic, plastic, elastic * plastic * ovality * slenderness);
      // If elastic and plastic pressure meet, the root is nearly double, and half of the digits are left.
      EXPECT_NEAR(collapse_pressure(wall, 430e6, 0.85, ovality) / root, 1.0, 1e-8) << slenderness << " " << ovality;
    }
  }
}

TEST(dnv_pressure, a_rounder_pipe_stands_more_and_a_round_one_the_least_of_both_pressures) {
  const Wall wall = kTestPipes[1].geometry();
  double last = 0.0;
  for (const double ovality : {0.03, 0.01, 0.005, 0.001, 1e-9}) {
    const double collapse = collapse_pressure(wall, 430e6, 0.85, ovality);
    EXPECT_GT(collapse, last);
    last = collapse;
  }
  const double min_value = std::min(elastic_collapse_pressure(wall), plastic_collapse_pressure(wall, 430e6, 0.85));
  EXPECT_NEAR(last / min_value, 1.0, 1e-4);  // the ovality left is small, not nothing
}

TEST(dnv_pressure, a_long_arrestor_is_crossed_at_its_own_pressure_and_none_at_the_pipes) {
  const Wall wall = kTestPipes[1].geometry();
  EXPECT_DOUBLE_EQ(crossover_pressure(wall, 4e6, 20e6, 0.0), 4e6);
  EXPECT_NEAR(crossover_pressure(wall, 4e6, 20e6, 100.0), 20e6, 1.0);
  const double between = crossover_pressure(wall, 4e6, 20e6, 0.6096);
  EXPECT_NEAR(between, 4e6 + 16e6 * (1.0 - std::exp(-20.0 / 24.0)), 1.0);  // t L/D^2 = 1/24
}

TEST(dnv_pressure, burst_is_the_thin_ring_times_two_over_root_three) {
  const Wall wall{1.0, 0.05, 207e9, 0.3};
  EXPECT_NEAR(burst_pressure(wall, 400e6), 0.1 / 0.95 * 400e6 * 1.1547005, 20.0);
}

}  // namespace
}  // namespace overbend

#include "moorings/periods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hull/damping_ratios.h"
#include "moorings/equilibrium.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

/// BGL-1 with its added mass at 0.1 rad/s (data/bgl1/bgl1.1, water of 1,025 kg/m3).
CoupledHullDescription barge() {
  CoupledHullDescription hull;
  hull.mass = 19121.58e3;
  hull.centre_of_gravity = {0.0, 0.0, 0.818};
  hull.gyration = {10.5, 30.0, 30.0};
  RadiationPoint slow;
  slow.omega = 0.1;
  Mat6& a = slow.added_mass;
  a.diagonal() << 1.813214e3, 8.509056e3, 9.744683e4, 1.455075e6, 5.723950e7, 8.407294e6;
  a(0, 4) = a(4, 0) = 9.870552e4;
  a(1, 3) = a(3, 1) = -2.383914e4;
  a *= 1025.0;
  hull.data.emplace().radiation = {slow};
  return hull;
}

double find_period(const std::vector<NaturalPeriod>& periods, const std::string& mode) {
  for (const NaturalPeriod& natural_period : periods) {
    if (natural_period.mode == mode) return natural_period.period;
  }
  return 0.0;
}

TEST(natural_periods, of_the_moored_barge_are_those_of_its_lines) {
  // Lines at 300 kN, about the centre of gravity, with the water's restoring.
  Mat6 k = Mat6::Zero();
  k.diagonal() << 1.8479e5, 1.8479e5, 1.1845e4 + 3600.0 * 1025.0 * 9.81, 2.7285e7 + 2.064044e5 * 1025.0 * 9.81,
      1.3382e8 + 4.256404e6 * 1025.0 * 9.81, 5.1281e8;
  k(0, 4) = k(4, 0) = 2.455e6;
  k(1, 3) = k(3, 1) = -9.4315e5;
  const std::vector<NaturalPeriod> periods = natural_periods(barge(), k);
  ASSERT_EQ(periods.size(), 6);
  EXPECT_NEAR(find_period(periods, "surge"), 66.9, 0.1);
  EXPECT_NEAR(find_period(periods, "sway"), 77.1, 0.1);
  EXPECT_NEAR(find_period(periods, "yaw"), 44.6, 0.1);
  EXPECT_EQ(periods.front().mode, "sway");
}

TEST(natural_periods, take_the_added_mass_at_their_own_frequency) {
  CoupledHullDescription hull = barge();
  hull.gyration = {1.0, 1.0, 1.0};
  RadiationPoint slow, fast;
  slow.omega = 0.1;
  fast.omega = 2.1;
  slow.added_mass.setZero();
  fast.added_mass = 20.0 * hull.mass * Mat6::Identity();
  hull.data->radiation = {slow, fast};
  const Mat6 k = hull.mass * Vec6(Vec6::Constant(1.0)).asDiagonal();
  // omega^2 (1 + 10 (omega - 0.1)) = 10 omega^3 = 1.
  for (const NaturalPeriod& natural_period : natural_periods(hull, k))
    EXPECT_NEAR(6.283185307179586 / natural_period.period, std::cbrt(0.1), 1e-4);
}

/// Heave and roll of BGL-1 with its centre of gravity 4 m ahead, 1.5 m aside and 2 m up share their modes: each is
/// found, and neither twice. The determinant of K - w^2 M(w) changes its sign at each.
TEST(natural_periods, are_six_where_modes_are_mixed) {
  CoupledHullDescription hull = barge();
  hull.data = testing::bgl1_hydrodynamics();
  Mat6 to_file = Mat6::Identity();  // shift of the file's point by that of the centre of gravity
  to_file.topRightCorner<3, 3>() = cross_matrix(Vec3(4.0, 1.5, 2.0));
  for (RadiationPoint& point : hull.data->radiation) {
    point.added_mass = to_file.transpose() * point.added_mass * to_file;
  }
  Mat6 k = Mat6::Zero();
  k.diagonal() << 1.8479e5, 1.8479e5, 3.62e7, 2.1e9, 4.29e10, 5.1281e8;
  k = to_file.transpose() * k * to_file;
  const std::vector<NaturalPeriod> periods = natural_periods(hull, k);
  ASSERT_EQ(periods.size(), 6U);
  const auto determinant = [&](double omega) {
    Mat6 mass = added_mass_at(*hull.data, omega);
    mass.diagonal().head<3>().array() += hull.mass;
    mass.diagonal().tail<3>() += hull.mass * hull.gyration.cwiseAbs2();
    return Mat6(k - omega * omega * mass).determinant();
  };
  for (const NaturalPeriod& natural_period : periods) {
    const double omega = 2.0 * std::numbers::pi / natural_period.period;
    EXPECT_LT(determinant(0.999 * omega) * determinant(1.001 * omega), 0.0) << natural_period.mode;
  }
  for (std::size_t i = 1; i < 6; ++i) EXPECT_GT(periods[i - 1].period, 1.001 * periods[i].period) << i;
}

TEST(natural_periods, leave_out_what_nothing_holds) {
  Mat6 k = Mat6::Zero();
  k.diagonal() << 0.0, 0.0, 3.6e7, 2e9, 4e10, 0.0;
  EXPECT_EQ(natural_periods(barge(), k).size(), 3);
}

}  // namespace
}  // namespace overbend

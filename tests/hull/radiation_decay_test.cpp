#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/constants.h"
#include "hull/linear_decay.h"
#include "hull/made_radiation.h"

namespace overbend {
namespace {

constexpr double kStep = 0.02;

void expect_extrema(const std::vector<Vec6>& motion, int freedom, double unit,
                    const std::vector<testing::Extremum>& wanted, double time_tolerance, double value_tolerance) {
  const std::vector<testing::Extremum> found = testing::extrema(motion, freedom, kStep);
  ASSERT_GE(found.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    EXPECT_NEAR(found[k].time, wanted[k].time, time_tolerance) << k;
    EXPECT_NEAR(found[k].value / unit, wanted[k].value, value_tolerance) << k;
  }
}

// Numbers of an independent program that convolves directly. Tolerances: of the table's digits and of the fit.
TEST(radiation_decay, heave_of_bgl1_from_one_metre) {
  const testing::LinearHull hull = testing::bgl1_hull(testing::bgl1_data());
  for (const Radiation kind : {Radiation::state_space, Radiation::convolution}) {
    const auto motion = testing::decay(hull, testing::bgl1_radiation(kind).model, Vec6::Unit(2), kStep, 700);
    const double wanted[][2] = {{1, 0.7484},  {2, 0.1523},  {3, -0.4299}, {4, -0.6894},
                                {5, -0.5528}, {6, -0.1842}, {8, 0.3012},  {10, 0.0346}};
    for (const auto& [time, value] : wanted) {
      EXPECT_NEAR(motion[static_cast<std::size_t>(std::lround(time / kStep))](2), value, 0.002) << time;
    }
    expect_extrema(motion, 2, 1.0, {{4.12, -0.6925}, {8.08, 0.3021}, {11.76, -0.1537}}, 0.03, 0.002);
  }
}

TEST(radiation_decay, roll_of_bgl1_from_five_degrees_with_sway_and_yaw_free) {
  testing::LinearHull hull = testing::bgl1_hull(testing::bgl1_data());
  hull.damping(3, 3) = 2.6871e8;  // viscous, hydrostatics_mass.json
  const auto motion = testing::decay(hull, testing::bgl1_radiation(Radiation::state_space).model,
                                     5.0 * kDegree * Vec6::Unit(3), kStep, 900);
  expect_extrema(motion, 3, kDegree, {{4.08, -4.170}, {8.18, 3.350}, {12.30, -2.649}, {16.40, 2.087}}, 0.02, 0.02);
}

TEST(radiation_decay, pitch_of_bgl1_from_two_degrees_with_surge_free) {
  const testing::LinearHull hull = testing::bgl1_hull(testing::bgl1_data());
  const auto motion = testing::decay(hull, testing::bgl1_radiation(Radiation::state_space).model,
                                     2.0 * kDegree * Vec6::Unit(4), kStep, 800);
  expect_extrema(motion, 4, kDegree, {{3.70, -1.6645}, {7.40, 1.0074}, {10.96, -0.5012}, {14.30, 0.2602}}, 0.02, 0.01);
}

/// Columns of six codes by time.
std::vector<std::vector<double>> six_codes() {
  std::ifstream file(std::string(OVERBEND_SOURCE_DIR) + "/validation/sphere/decay_six_codes.txt");
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<double> row(7);
    for (double& cell : row) {
      cells >> cell;
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(radiation_decay, sphere_of_task_10_stays_within_the_spread_of_six_codes) {
  const auto codes = six_codes();
  ASSERT_GE(codes.size(), 2000U);
  testing::LinearHull hull;
  hull.mass = 261.8e3 * Mat6::Identity();
  hull.stiffness = testing::sphere_data().hydrostatic_stiffness;
  const Radiated radiated = make_radiation(testing::sphere_data(), Radiation::state_space);
  EXPECT_EQ(radiated.model.kind, Radiation::state_space);
  const auto motion = testing::decay(hull, radiated.model, Vec6::Unit(2), kStep, 1000);
  for (const double time : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0}) {
    const auto& row = codes[static_cast<std::size_t>(std::lround(time / 0.01)) - 1];
    ASSERT_NEAR(row[0], time, 1e-6);
    const double value = motion[static_cast<std::size_t>(std::lround(time / kStep))](2);
    EXPECT_GE(value, *std::min_element(row.begin() + 1, row.end())) << time;
    EXPECT_LE(value, *std::max_element(row.begin() + 1, row.end())) << time;
  }
  // A plain linear integration by an independent program; its digits and the fit.
  expect_extrema(motion, 2, 1.0,
                 {{2.21, -0.8661}, {4.42, 0.6363}, {6.60, -0.4644}, {8.77, 0.3455}, {10.95, -0.2581}, {13.13, 0.1912}},
                 0.015, 0.003);
}

}  // namespace
}  // namespace overbend

#include "hull/make_radiation.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "hull/linear_decay.h"
#include "hull/made_radiation.h"
#include "hull/radiation_groups.h"

namespace overbend {
namespace {

TEST(make_radiation, memory_of_bgl1_represents_its_damping_and_added_mass) {
  const Radiated& made = testing::bgl1_radiation(Radiation::state_space);
  EXPECT_EQ(made.model.kind, Radiation::state_space);
  EXPECT_TRUE(made.report.findings.empty());
  EXPECT_EQ(made.model.groups, (std::vector<std::vector<int>>{{0, 4}, {1, 3}, {2}, {5}}));
  EXPECT_LE(made.report.states, 120);
  ASSERT_EQ(made.report.entries.size(), 8U);
  for (const RadiationEntryReport& entry : made.report.entries) {
    EXPECT_LT(entry.damping_error, 0.01) << entry.i << entry.j;
    // Up to 2.2 rad/s, where added mass and damping of the file contradict each other by 1 % (Ogilvie's relation).
    EXPECT_LT(entry.mass_error, 0.012) << entry.i << entry.j;
    EXPECT_NEAR(entry.added_mass_used / entry.added_mass_file, 1.0, entry.i == entry.j ? 0.012 : 0.06);
  }
  for (const RadiationGroupReport& group : made.report.groups) {
    EXPECT_GT(group.min_fitted_damping, -1e-5);
    EXPECT_GT(group.order, 0);
  }
}

// A hull on its moorings swings where radiation damps next to nothing: the wrong sign there makes it unstable.
TEST(make_radiation, memory_never_feeds_the_hull_at_any_frequency) {
  const RadiationModel& model = testing::bgl1_radiation(Radiation::state_space).model;
  Vec6 peak = Vec6::Zero();
  for (const RadiationPoint& point : testing::bgl1_data().radiation) {
    peak = peak.cwiseMax(point.damping.diagonal());
  }
  const Vec6 unit = peak.cwiseSqrt().cwiseInverse();
  for (double omega = 0.0017; omega < 40.0; omega *= 1.013) {  // other frequencies than the fit's own
    const Mat6 damping = unit.asDiagonal() * radiation_at(model, omega).damping * unit.asDiagonal();
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat6>(damping).eigenvalues()(0), -1e-5) << omega;
  }
}

TEST(make_radiation, damping_at_moored_periods_is_that_of_the_file_within_what_moorings_notice) {
  const RadiationModel& model = testing::bgl1_radiation(Radiation::state_space).model;
  // Critical damping of surge, sway and yaw on moorings of some 60 s [N s/m, N m s].
  const double critical[] = {4e6, 4.5e6, 6e9};
  const RadiationPoint made = radiation_at(model, testing::bgl1_data().radiation[0].omega);
  const Mat6& file = testing::bgl1_data().radiation[0].damping;
  int k = 0;
  for (const int mode : {0, 1, 5}) {
    EXPECT_NEAR(made.damping(mode, mode), file(mode, mode), 2e-3 * critical[k++]) << mode;
  }
}

TEST(make_radiation, models_made_before_do_not_affect_that_of_other_coefficients) {
  const Radiated& made = testing::bgl1_radiation(Radiation::state_space);
  HydrodynamicData doubled = testing::bgl1_data();
  for (RadiationPoint& point : doubled.radiation) {
    point.damping *= 2.0;
    point.added_mass *= 2.0;
  }
  doubled.added_mass_infinite *= 2.0;
  for (const double factor : {2.0, 1.0, 2.0}) {  // the second and third were made before
    const Radiated again = make_radiation(factor == 2.0 ? doubled : testing::bgl1_data(), made.model.kind);
    for (const double omega : {0.3, 0.7, 1.5}) {
      const Mat6 expected = factor * radiation_at(made.model, omega).damping;
      const double scale = expected.cwiseAbs().maxCoeff();
      EXPECT_LT((radiation_at(again.model, omega).damping - expected).cwiseAbs().maxCoeff(), 1e-6 * scale) << omega;
    }
  }
  EXPECT_EQ(make_radiation(doubled, Radiation::convolution).model.kind, Radiation::convolution);
}

TEST(make_radiation, memory_of_the_fit_is_that_of_the_convolution) {
  const RadiationModel& fitted = testing::bgl1_radiation(Radiation::state_space).model;
  const RadiationModel& direct = testing::bgl1_radiation(Radiation::convolution).model;
  for (const RadiationPoint& point : testing::bgl1_data().radiation) {
    const RadiationPoint radiation_point = radiation_at(fitted, point.omega),
                         second = radiation_at(direct, point.omega);
    for (int i = 0; i < 6; ++i) {
      const double scale = testing::bgl1_data().added_mass_infinite(i, i);
      EXPECT_NEAR(radiation_point.added_mass(i, i), second.added_mass(i, i), 0.02 * scale) << point.omega << " " << i;
    }
  }
}

/// Motion per wave amplitude of the free hull.
CVec6 response(const testing::LinearHull& hull, const Mat6& added_mass, const Mat6& damping, double omega,
               const CVec6& force) {
  const std::complex<double> i_omega(0.0, omega);
  const CMat6 left = (hull.stiffness - omega * omega * (hull.mass + added_mass)).cast<std::complex<double>>() +
                     i_omega * (hull.damping + damping).cast<std::complex<double>>();
  return left.partialPivLu().solve(force);
}

// All headings, from 0.25 rad/s up, as share of the mode's largest response: the measure of the fit that matters.
TEST(make_radiation, responses_with_the_memory_are_those_with_the_files_coefficients) {
  const HydrodynamicData& data = testing::bgl1_data();
  const RadiationModel& model = testing::bgl1_radiation(Radiation::state_space).model;
  testing::LinearHull hull = testing::bgl1_hull(data);
  hull.damping(3, 3) = 2.6871e8;
  Vec6 max_value = Vec6::Zero(), error = Vec6::Zero();
  for (std::size_t i = 0; i < data.radiation.size(); ++i) {
    const RadiationPoint& file = data.radiation[i];
    if (file.omega < 0.249) {
      continue;
    }
    const RadiationPoint made = radiation_at(model, file.omega);
    for (std::size_t j = 0; j < data.excitation.heading.size(); ++j) {
      const CVec6& force = data.force[data.excitation.index(i, j)];
      const CVec6 right = response(hull, file.added_mass, file.damping, file.omega, force);
      max_value = max_value.cwiseMax(right.cwiseAbs());
      error = error.cwiseMax((response(hull, made.added_mass, made.damping, file.omega, force) - right).cwiseAbs());
    }
  }
  const char* names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  for (int k = 0; k < 6; ++k) {
    RecordProperty(names[k], std::to_string(error(k) / max_value(k)));
    EXPECT_LT(error(k) / max_value(k), 0.01) << names[k];
  }
}

TEST(make_radiation, without_the_infinite_block_added_mass_follows_from_ogilvie) {
  HydrodynamicData data = testing::bgl1_data();
  data.has_infinite = false;
  data.added_mass_infinite.setZero();
  const Radiated made = make_radiation(data, Radiation::convolution);
  for (const int mode : {2, 3, 4}) {  // the others depend on the tail, which is then a guess
    const double file = testing::bgl1_data().added_mass_infinite(mode, mode);
    EXPECT_NEAR(made.model.added_mass(mode, mode) / file, 1.0, 0.012) << mode;
  }
  for (const int mode : {0, 1, 5}) {
    const double file = testing::bgl1_data().added_mass_infinite(mode, mode);
    EXPECT_NEAR(made.model.added_mass(mode, mode) / file, 1.0, 0.03) << mode;
  }
}

TEST(make_radiation, what_no_exponentials_represent_is_convolved_and_reported) {
  HydrodynamicData data = testing::bgl1_data();
  for (std::size_t k = 0; k < data.radiation.size(); ++k) {
    data.radiation[k].damping *= k % 2 == 0 ? 0.6 : 1.4;  // a saw, as of a tank's walls
  }
  const Radiated made = make_radiation(data, Radiation::state_space);
  EXPECT_EQ(made.model.kind, Radiation::convolution);
  EXPECT_TRUE(made.model.poles.empty());
  ASSERT_FALSE(made.report.findings.empty());
  EXPECT_NE(messages(made.report.findings)[0].find("direct convolution is used instead"), std::string::npos);
  EXPECT_EQ(made.report.groups[0].order, 0);
  EXPECT_EQ(static_cast<std::size_t>(made.report.states), make_bending_memory(made.model).values.size());
}

TEST(make_radiation, a_file_that_contradicts_itself_is_reported) {
  HydrodynamicData data = testing::bgl1_data();
  data.added_mass_infinite(2, 2) *= 1.1;
  data.radiation[30].damping(5, 5) *= -1.0;
  const Radiated made = make_radiation(data, Radiation::convolution);
  ASSERT_GE(made.report.findings.size(), 2U);
  EXPECT_NE(messages(made.report.findings)[0].find("negative radiation damping"), std::string::npos);
  EXPECT_NE(messages(made.report.findings)[1].find("added mass of heave"), std::string::npos);
}

/// The hull of the data in other units of mass, length and time, or a model of it.
HydrodynamicData in_units(HydrodynamicData data, double mass, double length, double time) {
  const auto scaled = [&](const Mat6& m, double unit) {
    Mat6 out = m / unit;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) out(i, j) /= std::pow(length, (i > 2 ? 1.0 : 0.0) + (j > 2 ? 1.0 : 0.0));
    }
    return out;
  };
  for (RadiationPoint& point : data.radiation) {
    point = {point.omega * time, scaled(point.added_mass, mass), scaled(point.damping, mass / time)};
  }
  data.added_mass_infinite = scaled(data.added_mass_infinite, mass);
  data.added_mass_zero = scaled(data.added_mass_zero, mass);
  return data;
}

// The memory of a hull does not depend on the units of its file, nor that of its model in a tank on the scale: of both
// only rounding is left, which the fit magnifies ten-thousandfold.
TEST(make_radiation, memory_is_the_same_in_any_units_and_at_any_scale) {
  const HydrodynamicData& data = testing::bgl1_data();
  const Radiated& radiated = testing::bgl1_radiation(Radiation::state_space);
  const Vec6 damping = max_diagonals(data, &RadiationPoint::damping);
  struct Units {
    double mass, length, time;
  };
  for (const Units& u : {Units{1e3, 1.0, 1.0},
                         {14.5939, 0.3048, 1.0},
                         {125e3, 50.0, std::sqrt(50.0)},
                         {std::pow(40.0, -3.0), 1.0 / 40.0, std::sqrt(1.0 / 40.0)}}) {
    const Radiated made = make_radiation(in_units(data, u.mass, u.length, u.time), Radiation::state_space);
    for (std::size_t i = 0; i < radiated.report.groups.size(); ++i) {
      EXPECT_EQ(made.report.groups[i].order, radiated.report.groups[i].order) << u.mass << " " << i;
    }
    HydrodynamicData memory;
    for (const RadiationPoint& point : data.radiation) {
      memory.radiation.push_back(radiation_at(made.model, point.omega * u.time));
    }
    memory = in_units(memory, 1.0 / u.mass, 1.0 / u.length, 1.0 / u.time);
    for (const RadiationPoint& point : memory.radiation) {
      const RadiationPoint same = radiation_at(radiated.model, point.omega);
      for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(point.added_mass(i, i), same.added_mass(i, i), 1e-6 * same.added_mass(i, i)) << u.mass << " " << i;
        EXPECT_NEAR(point.damping(i, i), same.damping(i, i), 1e-6 * damping(i)) << u.mass << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace overbend

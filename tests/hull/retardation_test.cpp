#include "hull/retardation.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "hull/damping_interpolation.h"
#include "hull/made_radiation.h"

namespace overbend {
namespace {

const DampingSpectrum& bgl1_spectrum() {
  static const DampingSpectrum spectrum = damping_spectrum(testing::bgl1_data());
  return spectrum;
}

// K, and A from K by its sine transform in time, against the file: 1 % of the largest A (Ogilvie 1964).
TEST(retardation, kernel_of_bgl1_gives_back_its_added_mass) {
  const double interval = 0.1;
  const std::vector<Mat6> kernel = retardation_samples(bgl1_spectrum(), interval, 801);
  Mat6 max_value = Mat6::Zero();
  for (const RadiationPoint& point : testing::bgl1_data().radiation) {
    max_value = max_value.cwiseMax(point.added_mass.cwiseAbs());
  }
  for (const RadiationPoint& point : testing::bgl1_data().radiation) {
    if (point.omega < 0.19 || point.omega > 2.01) {
      continue;
    }
    Mat6 sine = Mat6::Zero();  // K linear between samples
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const double x = point.omega * interval, filter = 2.0 * (1.0 - std::cos(x)) / (x * x);
      sine += interval * filter * std::sin(point.omega * interval * static_cast<double>(k)) * kernel[k];
    }
    // Half a sample at t = 0, which the sum leaves out.
    sine += kernel[0] / point.omega * (1.0 - std::sin(point.omega * interval) / (point.omega * interval));
    const Mat6 made = bgl1_spectrum().added_mass - sine / point.omega;
    for (const auto& [i, j] :
         {std::pair{0, 0}, {0, 4}, {1, 1}, {1, 3}, {2, 2}, {3, 3}, {3, 1}, {4, 4}, {4, 0}, {5, 5}}) {
      EXPECT_NEAR(made(i, j), point.added_mass(i, j), 0.01 * max_value(i, j)) << point.omega << " " << i << j;
    }
  }
}

TEST(retardation, relation_in_frequency_is_that_in_time_for_a_closed_form) {
  // K = exp(-a t)(1 - a t): B = 2 a w^2/(w^2 + a^2)^2, A - A_inf = (a^2 - w^2)/(w^2 + a^2)^2. Tolerances: B ends at
  // 10 rad/s, behind which the tail is a power law that the averaged A_inf chooses.
  HydrodynamicData data;
  const double a = 0.7;
  for (int k = 1; k <= 200; ++k) {
    RadiationPoint point;
    point.omega = 0.05 * k;
    const double square = point.omega * point.omega, sum = square + a * a;
    point.damping.diagonal().setConstant(2.0 * a * square / (sum * sum));
    point.added_mass.diagonal().setConstant(0.01 + (a * a - square) / (sum * sum));
    data.radiation.push_back(point);
  }
  data.has_infinite = true;
  data.added_mass_infinite.diagonal().setConstant(0.01);
  const DampingSpectrum spectrum = damping_spectrum(data);
  for (const double w : {0.1, 0.5, 1.0, 3.0}) {
    const double sum = w * w + a * a;
    EXPECT_NEAR(added_mass_above_infinite(spectrum, w)(2, 2), (a * a - w * w) / (sum * sum), 2e-3) << w;
  }
  for (const double t : {0.0, 0.5, 1.0, 2.0, 5.0, 9.0}) {
    EXPECT_NEAR(retardation(spectrum, t)(2, 2), std::exp(-a * t) * (1.0 - a * t), 3e-3) << t;
  }
}

// Exact solution for the hemisphere in deep water; from K a = 0.6 on, below it the file's finite depth shows.
TEST(retardation, sphere_of_the_file_is_hulmes_hemisphere) {
  const double table[][3] = {{0.6, 0.5381, 0.3271}, {0.7, 0.4999, 0.3098}, {0.8, 0.4698, 0.2899}, {0.9, 0.4464, 0.2691},
                             {1.0, 0.4284, 0.2484}, {1.2, 0.4047, 0.2096}, {1.4, 0.3924, 0.1756}, {1.6, 0.3871, 0.1469},
                             {1.8, 0.3864, 0.1229}, {2.0, 0.3884, 0.1031}};
  const double displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const auto& points = testing::sphere_data().radiation;
  const DampingSpectrum spectrum = damping_spectrum(testing::sphere_data());
  for (const auto& [ka, mass, damping] : table) {
    const double omega = std::sqrt(ka * 9.81 / 5.0);
    std::size_t right = 1;
    while (points[right].omega < omega) {
      ++right;
    }
    const double share = (omega - points[right - 1].omega) / (points[right].omega - points[right - 1].omega);
    const auto between = [&](auto value) {
      return (1.0 - share) * value(points[right - 1]) + share * value(points[right]);
    };
    const double file_mass = between([](const RadiationPoint& p) { return p.added_mass(2, 2); });
    const double file_damping = between([](const RadiationPoint& p) { return p.damping(2, 2) / p.omega; });
    EXPECT_NEAR(file_mass / displaced, mass, 1e-3) << ka;
    EXPECT_NEAR(file_damping / displaced, damping, 1e-3) << ka;
    // And from the damping alone: A_inf of the kernel plus Ogilvie's relation.
    const double made = spectrum.added_mass(2, 2) + added_mass_above_infinite(spectrum, omega)(2, 2);
    EXPECT_NEAR(made / displaced, mass, 1e-3) << ka;
  }
}

TEST(retardation, low_frequencies_follow_a_power_law_of_at_least_one) {
  EXPECT_NEAR(low_exponent({0.1, 0.2, 0.4}, {1.0, 8.0, 64.0}), 3.0, 1e-12);
  EXPECT_EQ(low_exponent({0.1, 0.2, 0.4}, {1.0, 1.0, 1.0}), 1.0);
  EXPECT_EQ(low_exponent({0.1, 0.2, 0.4}, {1.0, -1.0, 1.0}), 2.0);
}

TEST(retardation, kernel_for_convolution_has_no_damping_at_zero_frequency) {
  const RadiationSamples samples = convolution_samples(bgl1_spectrum());
  EXPECT_LT(samples.once.back().norm(), 1e-12 * samples.once[20].norm());
  EXPECT_GE(samples.once.size(), 201U);
  EXPECT_LE(samples.once.size(), 801U);
}

}  // namespace
}  // namespace overbend

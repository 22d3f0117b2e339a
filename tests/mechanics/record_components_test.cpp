#include "mechanics/record_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "mechanics/sea.h"

namespace overbend {
namespace {

/// A record of three waves that do not fit into its duration.
ElevationRecord three_waves(std::size_t rows, double step) {
  ElevationRecord record;
  record.step = step;
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = step * static_cast<double>(i);
    record.elevation.push_back(1.1 * std::cos(0.7 * t) + 0.4 * std::cos(1.13 * t + 2.0) - 0.2 * std::sin(0.31 * t));
  }
  return record;
}

double sum_at(const std::vector<RecordComponent>& components, double t) {
  double sum = 0.0;
  for (const RecordComponent& c : components) sum += c.amplitude * std::cos(c.phase - c.omega * t);
  return sum;
}

TEST(record_components, meet_the_record_at_every_instant) {
  for (const auto& [rows, step] : {std::pair<std::size_t, double>{601, 0.5}, {1000, 0.25}, {77, 1.0}, {20, 0.5}}) {
    const ElevationRecord record = three_waves(rows, step);
    const std::vector<RecordComponent> components = record_components(record);
    for (std::size_t i = 0; i < rows; ++i) {
      EXPECT_NEAR(sum_at(components, step * static_cast<double>(i)), record.elevation[i], 0.006) << rows << " " << i;
    }
  }
}

TEST(record_components, rise_in_frequency_and_are_no_shorter_than_half_a_second) {
  const std::vector<RecordComponent> components = record_components(three_waves(6001, 0.1));
  EXPECT_TRUE(std::is_sorted(components.begin(), components.end(),
                             [](const auto& a, const auto& b) { return a.omega < b.omega; }));
  EXPECT_LE(components.back().omega, kTurn / 0.5);
}

TEST(record_components, lead_from_the_end_back_to_the_beginning_without_a_jump) {
  const ElevationRecord record = three_waves(601, 0.5);
  const std::vector<RecordComponent> components = record_components(record);
  const double bridge = record_bridge(record);
  EXPECT_GE(bridge, 20.0);
  EXPECT_LT(bridge, 30.0);
  for (double t = -bridge - 1.0; t < 1.0; t += 0.05) {
    EXPECT_LT(std::abs(sum_at(components, t)), 3.5);
    EXPECT_LT(std::abs(sum_at(components, t) - sum_at(components, t - 0.05)), 0.15) << t;
  }
  EXPECT_NEAR(sum_at(components, -bridge), record.elevation.back(), 0.006);
}

TEST(record_components, of_a_wave_that_fits_are_that_wave) {
  ElevationRecord record;
  record.step = 0.5;
  for (int i = 0; i < 400; ++i) record.elevation.push_back(std::cos(kTurn * 0.5 * i / 10.0));
  const std::vector<RecordComponent> components = record_components(record);
  const auto peak = std::max_element(components.begin(), components.end(),
                                     [](const auto& a, const auto& b) { return a.amplitude < b.amplitude; });
  EXPECT_NEAR(peak->omega, kTurn / 10.0, 0.015);
  EXPECT_GT(peak->amplitude, 0.6);
}

TEST(record_components, of_no_record_are_none) {
  EXPECT_TRUE(record_components({}).empty());
  EXPECT_EQ(record_bridge({}), 0.0);
}

TEST(measured_sea, meets_its_record_at_its_point_and_travels_with_the_waves) {
  WavesDescription waves;
  waves.type = WaveType::elevation;
  waves.record = three_waves(601, 0.5);
  waves.from = 240.0 * kDegree;
  waves.measured_at = Vec3(35.0, -80.0, 0.0);
  const Sea sea = make_sea(waves, 70.0, 1);
  const BuildUp full;
  for (int i = 0; i < 601; i += 37) {
    EXPECT_NEAR(elevation(sea, 0.5 * i, full, 35.0, -80.0), waves.record.elevation[static_cast<std::size_t>(i)], 0.006);
  }
  for (const WaveComponent& c : sea.components) {  // towards 60 deg
    EXPECT_NEAR(std::atan2(c.kx, c.ky), 60.0 * kDegree, 1e-9);
  }
  EXPECT_EQ(make_sea(waves, 70.0, 2).components.front().phase, sea.components.front().phase);
}

}  // namespace
}  // namespace overbend

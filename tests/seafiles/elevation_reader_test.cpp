#include "seafiles/elevation_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mechanics/sea.h"
#include "model/site/sea_statistics.h"
#include "support/sea_files.h"

namespace overbend {
namespace {

using testing::read_waves;
using testing::sea_file;
using testing::WavesRead;

TEST(elevation_reader, gives_the_record_without_its_mean_and_its_statistics) {
  const WavesRead read = read_waves(sea_file("elevation.csv"), "", WaveType::elevation);
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  const ElevationRecord& record = read.waves.record;
  ASSERT_EQ(record.elevation.size(), 1201U);
  EXPECT_NEAR(record.step, 0.5, 1e-12);
  EXPECT_NEAR(record.duration(), 600.0, 1e-9);
  EXPECT_NEAR(record.mean, 0.0005557035803497087, 1e-12);
  EXPECT_NEAR(*std::max_element(record.elevation.begin(), record.elevation.end()) + record.mean, 1.4015, 1e-12);
  EXPECT_NEAR(*std::min_element(record.elevation.begin(), record.elevation.end()) + record.mean, -1.3351, 1e-12);
  EXPECT_NEAR(read.waves.hs, 1.9797019818056207, 1e-12);
  EXPECT_NEAR(record_statistics(record).tz, 6.741573033707865, 1e-9);
}

TEST(elevation_reader, the_sea_of_a_record_meets_it_at_its_point) {
  WavesDescription waves = read_waves(sea_file("elevation.csv"), "", WaveType::elevation).waves;
  waves.from = 1.0;
  waves.measured_at = Vec3(30.0, -20.0, 0.0);
  const Sea sea = make_sea(waves, 80.0, 1);
  const BuildUp full;
  // Components with 1e-7 of the variance are left out: 0.00016 m, and five times that at a peak. They add up where the
  // record is closed to a period, at its ends, where the reference's 2 % of the standard deviation is asked.
  const std::vector<double>& measured_waves = waves.record.elevation;
  for (std::size_t i = 0; i < measured_waves.size(); ++i) {
    const bool at_end = i < 5 || i + 5 >= measured_waves.size();
    EXPECT_NEAR(elevation(sea, 0.5 * static_cast<double>(i), full, 30.0, -20.0), measured_waves[i],
                at_end ? 0.0098985 : 8e-4)
        << i;
  }
  // With the mean.
  for (const auto& [time, measured] : {std::pair{0.0, -0.1671}, {120.0, 0.1002}, {333.0, 0.3872}}) {
    EXPECT_NEAR(elevation(sea, time, full, 30.0, -20.0), measured, 0.0099);
  }
}

std::string message(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_elevation_text(text, "a.csv", diagnostics)) << text;
  return diagnostics.lines(Severity::error).at(0);
}

std::string rows(int count, const std::string& special = "", int place = -1) {
  std::string text = "time_s,elevation_m\n";
  for (int i = 0; i < count; ++i) {
    text += i == place ? special : std::to_string(0.5 * i) + "," + std::to_string(std::sin(0.4 * i));
    text += "\n";
  }
  return text;
}

TEST(elevation_reader, what_it_cannot_use_is_rejected_with_line_and_remedy) {
  EXPECT_NE(message("").find("found no rows"), std::string::npos);
  EXPECT_NE(message("t,eta\n0,1\n").find("a.csv:1: found the columns 't and eta', expected time_s and elevation_m"),
            std::string::npos);
  EXPECT_NE(message(rows(5)).find("found 5 instants"), std::string::npos);
  EXPECT_NE(message(rows(40, "5.0,high", 10)).find("a.csv:12: found 'high'"), std::string::npos);
  EXPECT_NE(message(rows(40, "5.0,999", 10)).find("a.csv:12: found 999 m, which recorders write for missing values"),
            std::string::npos);
  EXPECT_NE(message(rows(40, "5.0", 10)).find("a.csv:12: found 1 cells"), std::string::npos);
  EXPECT_NE(message(rows(40, "5.2,0.1", 10)).find("even steps"), std::string::npos);
  EXPECT_NE(message(rows(40, "# a gap", 10)).find("a.csv:13: found a step of 1 s, the first is 0.5 s"),
            std::string::npos);
  std::string flat = "time_s,elevation_m\n";
  for (int i = 0; i < 30; ++i) flat += std::to_string(i) + ",0.3\n";
  EXPECT_NE(message(flat).find("the same elevation in every row"), std::string::npos);
}

TEST(elevation_reader, a_table_of_a_spreadsheet_with_clock_times_is_read) {
  std::string text = "Time;Surface elevation (cm)\n";
  for (int i = 0; i < 40; ++i) {
    text += "23:59:" + std::to_string(10 + i) + ";" + (i % 2 == 0 ? "12,5\n" : "-7,5\n");
  }
  Diagnostics diagnostics;
  const auto record = read_elevation_text(text, "a.csv", diagnostics);
  ASSERT_TRUE(record) << diagnostics.lines(Severity::error).at(0);
  EXPECT_DOUBLE_EQ(record->step, 1.0);
  EXPECT_NEAR(record->mean, 0.025, 1e-12);
  EXPECT_NEAR(record->elevation[0], 0.1, 1e-12);
}

TEST(elevation_reader, damaged_files_are_read_or_rejected) {
  testing::read_damaged_copies(testing::sea_file_text("elevation.csv"), "", WaveType::elevation, 100);
}

}  // namespace
}  // namespace overbend

#include "seafiles/ndbc_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "support/sea_files.h"

namespace overbend {
namespace {

using testing::read_waves;
using testing::sea_file;
using testing::WavesRead;

TEST(ndbc_sea_states, give_height_period_and_direction_of_the_chosen_time) {
  struct Row {
    const char* time;
    double hs, tp, from;
  };
  for (const Row& row : {Row{"2026-06-01 11:40", 1.8, 9.0, 262.0}, Row{"2026-06-01 10:40", 1.6, 8.0, 258.0},
                         Row{"2026 06 01 09 40", 1.5, 13.0, 291.0}}) {
    const WavesRead read = read_waves(sea_file("ndbc-standard.txt"), row.time, WaveType::jonswap);
    ASSERT_TRUE(read.errors.empty()) << read.errors.front();
    EXPECT_DOUBLE_EQ(read.waves.hs, row.hs);
    EXPECT_DOUBLE_EQ(read.waves.tp, row.tp);
    EXPECT_NEAR(read.waves.from, row.from * kDegree, 1e-12);
    EXPECT_TRUE(read.waves.file_gives_direction);
  }
}

TEST(ndbc_sea_states, whose_mean_period_is_that_of_another_shape_are_reported) {
  EXPECT_TRUE(read_waves(sea_file("ndbc-standard.txt"), "2026-06-01 11:40", WaveType::jonswap).warnings.empty());
  const WavesRead swell = read_waves(sea_file("ndbc-standard.txt"), "2026-06-01 09:40", WaveType::jonswap);
  ASSERT_EQ(swell.warnings.size(), 1U);
  EXPECT_NE(swell.warnings[0].find(":6: APD: the measured zero up-crossing period is 5.7 s"), std::string::npos);
}

TEST(ndbc_sea_states, without_waves_are_rejected_by_name) {
  const WavesRead read = read_waves(sea_file("ndbc-standard.txt"), "2026-06-01 11:50", WaveType::jonswap);
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_NE(read.errors[0].find("ndbc-standard.txt:3: WVHT: found MM at 2026-06-01 11:50"), std::string::npos);
  const testing::WrittenFiles files("overbend_ndbc");
  const std::string old = files.write("old.txt",
                                      "YY MM DD hh WVHT DPD APD MWD\n98 01 01 00 99.00 10.0 6.0 270\n"
                                      "98 01 01 01 2.00 99.00 6.0 270\n98 01 01 02 2.00 10.00 6.0 999\n");
  EXPECT_NE(read_waves(old, "1998-01-01 00:00", WaveType::jonswap).errors.at(0).find("WVHT: found 99.00"),
            std::string::npos);
  EXPECT_NE(read_waves(old, "1998-01-01 01:00", WaveType::jonswap).errors.at(0).find("DPD: found 99.00"),
            std::string::npos);
  const WavesRead undirected = read_waves(old, "1998-01-01 02:00", WaveType::jonswap);
  EXPECT_TRUE(undirected.errors.empty());
  EXPECT_FALSE(undirected.waves.file_gives_direction);
}

TEST(ndbc_sea_states, need_a_type_of_waves_that_has_a_shape) {
  const WavesRead read = read_waves(sea_file("ndbc-standard.txt"), "2026-06-01 11:40", WaveType::user);
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_NE(read.errors[0].find("give type jonswap or pierson_moskowitz"), std::string::npos) << read.errors[0];
  EXPECT_NE(read_waves(sea_file("swan-1d.spc"), "", WaveType::jonswap).errors.at(0).find("expected type user"),
            std::string::npos);
}

TEST(ndbc_density, of_each_time_has_the_moments_of_the_file) {
  struct Row {
    const char* time;
    double m0, m1, m2, peak;
  };
  for (const Row& row : {Row{"2025 11 03 00 40", 0.3362125, 0.318845539850431, 0.34612178003461447, 0.14},
                         Row{"2025-11-03 01:40", 0.433875, 0.3939906689784313, 0.40825552602126713, 0.13},
                         Row{"2025-11-03 02:40", 0.5101125, 0.4435979877749409, 0.44161234616985995, 0.13}}) {
    const WavesRead read = read_waves(sea_file("ndbc-density.txt"), row.time);
    ASSERT_TRUE(read.errors.empty()) << read.errors.front();
    const std::vector<SpectrumPoint>& points = read.waves.spectrum;
    EXPECT_NEAR(testing::trapezium_moment(points, 0), row.m0, 1e-12);
    EXPECT_NEAR(testing::trapezium_moment(points, 1), row.m1, 1e-12);
    EXPECT_NEAR(testing::trapezium_moment(points, 2), row.m2, 1e-12);
    EXPECT_NEAR(read.waves.hs, 4.0 * std::sqrt(row.m0), 1e-12);
    const auto peak = std::max_element(points.begin(), points.end(),
                                       [](const auto& a, const auto& b) { return a.density < b.density; });
    EXPECT_NEAR(peak->omega / kTurn, row.peak, 1e-12);
    EXPECT_TRUE(read.waves.directions.empty());
    EXPECT_FALSE(read.waves.file_gives_direction);
  }
}

TEST(ndbc_density, of_several_times_needs_a_choice) {
  const WavesRead read = read_waves(sea_file("ndbc-density.txt"));
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_NE(read.errors[0].find("found 3 times, 2025-11-03 00:40 to 2025-11-03 02:40, and no choice"),
            std::string::npos)
      << read.errors[0];
}

TEST(ndbc_realtime, has_the_directions_and_spreading_of_the_files_next_to_it) {
  const WavesRead read = read_waves(sea_file("46990/46990.data_spec"));
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  const WavesDescription& waves = read.waves;
  ASSERT_EQ(waves.spectrum.size(), 47U);
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 0), 0.376143, 1e-12);
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 2), 0.36170865787918083, 1e-12);
  EXPECT_NEAR(waves.hs, 2.453219924915009, 1e-12);
  constexpr std::size_t kPeak = 17;  // 0.140 Hz
  EXPECT_NEAR(waves.spectrum[kPeak].omega, kTurn * 0.14, 1e-12);
  EXPECT_NEAR(waves.directions.from[kPeak], 248.7 * kDegree, 1e-12);
  EXPECT_NEAR(waves.directions.spreading[kPeak], 0.78 / 0.22, 1e-12);
  ASSERT_EQ(waves.assumptions.size(), 1U);
  EXPECT_NE(waves.assumptions[0].text.find("s = r1/(1 - r1)"), std::string::npos);
}

/// Mean direction over a range of frequencies, by density [deg].
double mean_direction(const WavesDescription& waves, double from_hertz, double to_hertz) {
  double east = 0.0, north = 0.0;
  for (std::size_t i = 0; i < waves.spectrum.size(); ++i) {
    const double f = waves.spectrum[i].omega / kTurn;
    if (f < from_hertz || f >= to_hertz) continue;
    east += waves.spectrum[i].density * std::sin(waves.directions.from[i]);
    north += waves.spectrum[i].density * std::cos(waves.directions.from[i]);
  }
  return std::fmod(std::atan2(east, north) / kDegree + 360.0, 360.0);
}

TEST(ndbc_realtime, swell_and_wind_sea_come_from_their_directions) {
  const WavesDescription waves = read_waves(sea_file("46990/46990.data_spec")).waves;
  EXPECT_NEAR(mean_direction(waves, 0.0, 0.117), 286.5, 0.05);
  EXPECT_NEAR(mean_direction(waves, 0.117, 1.0), 249.2, 0.05);
}

TEST(ndbc_realtime, without_other_files_has_no_directions) {
  const testing::WrittenFiles files("overbend_ndbc");
  const WavesRead read = read_waves(files.write("a.data_spec", testing::sea_file_text("46990/46990.data_spec")));
  EXPECT_TRUE(read.errors.empty());
  EXPECT_TRUE(read.waves.directions.empty());
}

TEST(ndbc_realtime, with_a_frequency_out_of_order_is_rejected_by_line_and_value) {
  const WavesRead read = read_waves(sea_file("damaged-frequency.data_spec"));
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_NE(read.errors[0].find("damaged-frequency.data_spec:2: found the frequency 0.410 between 0.130 and 0.150, "
                                "expected increasing frequencies"),
            std::string::npos)
      << read.errors[0];
}

TEST(ndbc_realtime, missing_directions_are_filled_only_where_there_is_no_energy) {
  const testing::WrittenFiles files("overbend_ndbc");
  const std::string spectrum =
      "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) >\n2026 06 01 09 00 0.1 0.001 (0.05) 2.0 "
      "(0.10) 1.0 (0.15)\n";
  const auto with_directions = [&](const std::string& row) {
    files.write("a.swdir", "#YY MM DD hh mm alpha1_1 (freq_1) >\n2026 06 01 09 00 " + row + "\n");
    return read_waves(files.write("a.data_spec", spectrum));
  };
  const WavesRead filled = with_directions("999.0 (0.05) 99.0 (0.10) 110.0 (0.15)");
  ASSERT_TRUE(filled.errors.empty()) << filled.errors.front();
  EXPECT_NEAR(filled.waves.directions.from[0], 99.0 * kDegree, 1e-12);  // 99 deg is a direction
  EXPECT_TRUE(filled.waves.directions.spreading.empty());
  EXPECT_NE(with_directions("999.0 (0.05) 999.0 (0.10) 110.0 (0.15)").errors.at(0).find("a missing value where"),
            std::string::npos);
  EXPECT_NE(with_directions("100 (0.05) 99.0 (0.11) 110.0 (0.15)").errors.at(0).find("the same frequencies"),
            std::string::npos);
}

TEST(ndbc_yearly, files_of_directions_and_hundredths_of_r1_belong_to_those_of_densities) {
  const testing::WrittenFiles files("overbend_ndbc");
  const std::string head = "#YY MM DD hh mm .0500 .1000 .1500\n2019 06 01 09 00 ";
  files.write("46990d2019.txt", head + "200 210 220\n");
  files.write("46990j2019.txt", head + "80 75 60\n");
  const WavesRead read = read_waves(files.write("46990w2019.txt", head + "0.1 2.0 1.0\n"));
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  EXPECT_NEAR(read.waves.directions.from[1], 210.0 * kDegree, 1e-12);
  EXPECT_NEAR(read.waves.directions.spreading[1], 3.0, 1e-12);
}

TEST(ndbc_reader, damaged_files_are_read_or_rejected) {
  const struct {
    const char *file, *time;
    WaveType type;
  } cases[] = {{"ndbc-standard.txt", "2026-06-01 10:40", WaveType::jonswap},
               {"ndbc-density.txt", "2025-11-03 01:40", WaveType::user},
               {"46990/46990.data_spec", "", WaveType::user}};
  for (const auto& one_case : cases) {
    testing::read_damaged_copies(testing::sea_file_text(one_case.file), one_case.time, one_case.type, 120);
  }
}

}  // namespace
}  // namespace overbend

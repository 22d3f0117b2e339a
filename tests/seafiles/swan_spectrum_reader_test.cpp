#include "seafiles/swan_spectrum_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "support/sea_files.h"

namespace overbend {
namespace {

using testing::read_waves;
using testing::sea_file;
using testing::WavesRead;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

WavesRead read_text(const std::string& text, const std::string& time = "", std::optional<int> location = {}) {
  const testing::WrittenFiles files("overbend_swan");
  WavesRead read;
  read.waves.type = WaveType::user;
  read.waves.spectrum_file = files.write("waves.spc", text);
  read.waves.time = time;
  read.waves.location = location;
  Diagnostics diagnostics;
  read_wave_file(read.waves, diagnostics);
  read.errors = diagnostics.lines(Severity::error);
  return read;
}

TEST(swan_1d, has_density_nautical_direction_and_spreading_by_frequency) {
  const WavesRead read = read_waves(sea_file("swan-1d.spc"));
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  const WavesDescription& waves = read.waves;
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 0), 0.39073708039198074, 1e-12);
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 1), 0.331060911400503, 1e-12);
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 2), 0.31165800193661997, 1e-12);
  EXPECT_NEAR(waves.hs, 2.5003586315310233, 1e-12);
  EXPECT_NEAR(waves.from, 225.0 * kDegree, 1e-9);
  ASSERT_EQ(waves.directions.spreading.size(), 27U);
  EXPECT_NEAR(waves.directions.spreading[11], 7.374505994927919, 1e-9);
  EXPECT_NEAR(waves.directions.spreading[0], 7.374505994927919, 1e-9);  // an exception value without energy
}

TEST(swan_2d, becomes_sectors_of_the_azimuth_from_which_the_waves_come) {
  const WavesRead read = read_waves(sea_file("swan-2d.sp2"));
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  const WavesDescription& waves = read.waves;
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 0), 0.37599782365323636, 1e-9);
  EXPECT_NEAR(testing::trapezium_moment(waves.spectrum, 2), 0.36065202286290504, 1e-8);
  EXPECT_NEAR(waves.hs, 2.452746456210218, 1e-8);
  EXPECT_NEAR(waves.from / kDegree, 254.26, 0.01);
  constexpr std::ptrdiff_t kPeak = 13;  // 0.1381 Hz
  EXPECT_NEAR(waves.spectrum[kPeak].omega, kTurn * 0.1381, 1e-12);
  const auto row = waves.directions.density.begin() + 36 * kPeak;
  const auto sector = static_cast<std::size_t>(std::max_element(row, row + 36) - row);
  EXPECT_NEAR(std::remainder(waves.directions.sectors[sector] / kDegree - 245.0, 360.0), 0.0, 1e-9);
  EXPECT_NE(waves.assumptions.at(0).text.find("Cartesian directions"), std::string::npos);
}

TEST(swan_2d, components_of_the_sea_have_the_distribution_of_the_file) {
  WavesDescription waves = read_waves(sea_file("swan-2d.sp2")).waves;
  waves.components = 4000;
  double east = 0.0, north = 0.0, beyond = 0.0, below = 0.0;
  for (const WaveComponent& c : make_sea(waves, 300.0, 7).components) {
    east -= c.kx / c.wave_number;
    north -= c.ky / c.wave_number;
    const double from = std::remainder(std::atan2(-c.kx, -c.ky) / kDegree - 245.0, 360.0);
    (c.omega < kTurn * 0.1 ? below : beyond) += std::abs(from) < 20.0 ? 0.0 : 1.0;
  }
  EXPECT_NEAR(std::fmod(std::atan2(east, north) / kDegree + 360.0, 360.0), 254.26, 1.0);
  EXPECT_GT(below, beyond * 0.2);  // the swell comes from another direction
}

TEST(swan_2d, with_a_short_row_is_rejected_by_line) {
  const WavesRead read = read_waves(sea_file("damaged-row.sp2"));
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_NE(read.errors[0].find("damaged-row.sp2:86: found 33 values, expected 36, one per direction"),
            std::string::npos)
      << read.errors[0];
}

constexpr const char* kTwoTimes =
    "SWAN   1\nTIME\n 1\nLOCATIONS\n 2\n 0 0\n 5 5\nAFREQ\n 2\n 0.1\n 0.2\nQUANT\n 1\nVaDens\nm2/Hz\n -99\n"
    "20260601.090000\nLOCATION 1\n 1.0\n 2.0\nNODATA\n20260601.120000\nLOCATION 1\n 3.0\n 4.0\nLOCATION 2\n 5.0\n "
    "6.0\n";

TEST(swan_reader, of_several_times_and_locations_needs_a_choice_of_both) {
  EXPECT_NE(read_text(kTwoTimes).errors.at(0).find("found 2 locations and no choice"), std::string::npos);
  EXPECT_NE(read_text(kTwoTimes, "", 1).errors.at(0).find("2 times, 2026-06-01 09:00 to 2026-06-01 12:00"),
            std::string::npos);
  EXPECT_NE(read_text(kTwoTimes, "", 3).errors.at(0).find("found location 3, expected 1 to 2"), std::string::npos);
  EXPECT_NE(read_text(kTwoTimes, "2026-06-01 09:00", 2).errors.at(0).find("found NODATA"), std::string::npos);
  const WavesRead read = read_text(kTwoTimes, "20260601.120000", 2);
  ASSERT_TRUE(read.errors.empty()) << read.errors.front();
  EXPECT_NEAR(read.waves.spectrum[1].density * kTurn, 6.0, 1e-12);
  EXPECT_TRUE(read.waves.directions.empty());
}

TEST(swan_reader, relative_frequencies_are_reported) {
  const WavesRead read = read_text(replaced(testing::sea_file_text("swan-1d.spc"), "AFREQ", "RFREQ"));
  ASSERT_EQ(read.waves.assumptions.size(), 2U);
  EXPECT_NE(read.waves.assumptions[1].text.find("relative to the current"), std::string::npos);
}

TEST(swan_reader, what_it_cannot_read_is_rejected_with_line_and_remedy) {
  const std::string spectrum = testing::sea_file_text("swan-1d.spc"), table = testing::sea_file_text("swan-2d.sp2");
  const auto expect = [](const std::string& text, const std::string& wanted) {
    const WavesRead read = read_text(text);
    ASSERT_FALSE(read.errors.empty()) << wanted;
    EXPECT_NE(read.errors[0].find(wanted), std::string::npos) << read.errors[0];
  };
  expect(replaced(replaced(spectrum, "VaDens ", "EnDens "), "m2/Hz    ", "J/m2/Hz  "), "expected variance density");
  expect(replaced(spectrum, "    0.0484", "    0.0400"), "found a frequency of 0.04 Hz after 0.044");
  expect(replaced(spectrum, "    27   ", "  9999   "), "lines left");
  expect(replaced(spectrum, "  2.1839E+00    225.0", "  2.1839E+00   -999.0"),
         "no direction where the density is large");
  expect(replaced(spectrum, "  2.1839E+00", " -0.9900E+02"), "exception value");
  expect(replaced(spectrum, "LOCATION     1", "SOMETHING"), "expected LOCATION or NODATA");
  expect(replaced(table, "   15.0000", "   17.0000"), "directions in even steps");
  expect(replaced(table, "    9.33576994E-08", "    0"), "a factor above 0");
  expect(table.substr(0, table.find("FACTOR")) + "ZERO\n", "found ZERO");
  expect(table.substr(0, table.find("   75.0000")), "found 36 with 7 lines left");
  expect("SWAN   1\n", "the end of the file");
}

TEST(swan_reader, damaged_files_are_read_or_rejected) {
  for (const char* file : {"swan-1d.spc", "swan-2d.sp2"}) {
    testing::read_damaged_copies(testing::sea_file_text(file), "", WaveType::user, 120);
  }
}

}  // namespace
}  // namespace overbend

#include "seafiles/spectrum_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

TEST(spectrum_reader, reads_angular_frequencies_as_they_stand) {
  Diagnostics diagnostics;
  const auto points =
      read_spectrum_text("# measured\n\n omega_rad_s , density_m2s\r\n0, 0\n0.5,1.25\r\n0.9,0\n", "a.csv", diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].omega, 0.5);
  EXPECT_EQ(points[1].density, 1.25);
}

TEST(spectrum_reader, turns_hertz_into_rad_per_s_and_keeps_the_energy) {
  Diagnostics diagnostics;
  const auto points = read_spectrum_text("frequency_hz,density_m2_hz\n0.1,10\n0.2,10", "a.csv", diagnostics);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_DOUBLE_EQ(points[1].omega, 0.4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ((points[1].omega - points[0].omega) * points[0].density, 1.0);  // 0.1 Hz times 10 m2/Hz
}

TEST(spectrum_reader, every_error_is_reported_with_file_line_and_column) {
  struct BadInput {
    const char *text, *place, *expected_text;
  };
  const BadInput errors[] = {
      {"", "a.csv: ", "empty file"},
      {"f,S\n1,2\n", "a.csv:1: ", "frequency_hz,density_m2_hz"},
      {"omega_rad_s,density_m2_hz\n1,2\n", "a.csv:1: ", "the header"},
      {"omega_rad_s,density_m2s\n0.1,1\n", "a.csv: ", "at least 2 rows"},
      {"omega_rad_s,density_m2s\n0.1,1\n0.2,x\n", "a.csv:3: density_m2s: ", "'x'"},
      {"omega_rad_s,density_m2s\n0.1,1\n0.2,nan\n", "a.csv:3: density_m2s: ", "'nan'"},
      {"omega_rad_s,density_m2s\n0.1,1\n0.2,-1\n", "a.csv:3: density_m2s: ", "0 or more"},
      {"omega_rad_s,density_m2s\n0.1,1\n0.2\n", "a.csv:3: ", "2, as in the header"},
      {"omega_rad_s,density_m2s\n# once\n0.3,1\n0.3,2\n", "a.csv:4: omega_rad_s: ", "more than the previous frequency"},
      {"omega_rad_s,density_m2s\n0.0,1\n0.3,2\n", "a.csv:2: density_m2s: ", "0 at frequency 0"},
      {"omega_rad_s,density_m2s\n0.1,0\n0.3,0\n", "a.csv: density_m2s: ", "with energy"},
      // 110 m2 of variance, for example densities in cm2 s.
      {"omega_rad_s,density_m2s\n0.1,0\n1.2,200\n", "a.csv: density_m2s: ", "a significant wave height of 42 m"},
  };
  for (const BadInput& damage : errors) {
    Diagnostics diagnostics;
    EXPECT_TRUE(read_spectrum_text(damage.text, "a.csv", diagnostics).empty()) << damage.text;
    ASSERT_EQ(diagnostics.error_count(), 1) << damage.text;
    const std::string line = diagnostics.lines(Severity::error)[0];
    EXPECT_EQ(line.find(damage.place), 0U) << line;
    EXPECT_NE(line.find(damage.expected_text), std::string::npos) << line;
  }
}

class SpectrumFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  ModelReading read(const std::string& waves) const {
    std::string text = testing::kGoodModel;
    const std::string sea = "{type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg, seed: 7}";
    text.replace(text.find(sea), sea.size(), waves);
    return read_model_text(text, (folder / "model.yaml").string());
  }
  void write(const std::string& text) const { std::ofstream(folder / "sea.csv") << text; }

  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("overbend_spectrum_" + std::to_string(::getpid()));
  const std::string user = "{type: user, spectrum_file: sea.csv, from: 180 deg}";
};

TEST_F(SpectrumFile, next_to_the_model_is_part_of_it) {
  write("frequency_hz,density_m2_hz\n0.05,0\n0.1,10\n0.3,0\n");
  const ModelReading reading = read(user);
  ASSERT_TRUE(reading.description.has_value());
  EXPECT_EQ(reading.description->environment.waves.front().spectrum.size(), 3U);
  EXPECT_NEAR(reading.description->environment.waves.front().hs, 4.0 * std::sqrt(0.5 * 0.25 * 10.0), 1e-12);
  EXPECT_TRUE(reading.description->findings.empty());
}

TEST_F(SpectrumFile, that_begins_with_a_byte_order_mark_is_read_as_any_other_table) {
  write(
      "\xef\xbb\xbf"
      "frequency_hz,density_m2_hz\n0.05,0\n0.1,10\n0.3,0\n");
  const ModelReading reading = read(user);
  ASSERT_TRUE(reading.description.has_value());
  EXPECT_EQ(reading.description->environment.waves.front().spectrum.size(), 3U);
}

TEST_F(SpectrumFile, and_spectra_by_height_whose_waves_break_on_the_bed_are_doubtful) {
  const auto shallow = [&](const std::string& waves, const std::string& depth) {
    std::string text = testing::kGoodModel;
    const std::string sea = "{type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg, seed: 7}";
    text.replace(text.find(sea), sea.size(), waves);
    const std::size_t index = text.find("water_depth: ");
    text.replace(index, text.find('\n', index) - index, "water_depth: " + depth);
    const ModelReading reading = read_model_text(text, (folder / "model.yaml").string());
    const std::vector<std::string> lines = reading.diagnostics.lines(Severity::warning);
    return std::ranges::any_of(lines, [](const std::string& line) {
      return line.find("the highest is ") != std::string::npos &&
             line.find("break in a water depth") != std::string::npos;
    });
  };
  // 1.858 Hs against 0.78 of the depth.
  EXPECT_TRUE(shallow("{type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg}", "9.4 m"));
  EXPECT_FALSE(shallow("{type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg}", "9.7 m"));
  EXPECT_TRUE(shallow("{type: pierson_moskowitz, hs: 4 m, tp: 12.9 s, from: 180 deg}", "9.4 m"));
  write("frequency_hz,density_m2_hz\n0.05,0\n0.1,8\n0.3,0\n");  // Hs 4 m
  EXPECT_TRUE(shallow(user, "9.4 m"));
  EXPECT_FALSE(shallow(user, "9.7 m"));
}

TEST_F(SpectrumFile, with_an_error_stops_the_model_at_its_own_line) {
  write("frequency_hz,density_m2_hz\n0.05,0\n0.1,ten\n");
  const ModelReading reading = read(user);
  EXPECT_FALSE(reading.description.has_value());
  ASSERT_EQ(reading.diagnostics.error_count(), 1);
  EXPECT_NE(reading.diagnostics.lines(Severity::error)[0].find("sea.csv:3: density_m2_hz: found 'ten'"),
            std::string::npos);
}

TEST_F(SpectrumFile, that_is_not_there_is_reported_but_does_not_stop_statics) {
  const ModelReading reading = read(user);
  ASSERT_TRUE(reading.description.has_value());
  ASSERT_EQ(reading.description->findings.size(), 1U);
  EXPECT_NE(messages(reading.description->findings)[0].find("dynamic analysis will require it"), std::string::npos);
}

TEST_F(SpectrumFile, that_is_a_folder_is_rejected) {
  std::filesystem::create_directories(folder / "sea.csv");
  EXPECT_FALSE(read(user).description.has_value());
}

TEST_F(SpectrumFile, waves_of_the_file_are_bound_with_all_their_keys) {
  const ModelReading reading = read("{type: stokes5, height: 6 m, period: 11 s, phase: 90 deg, from: 180 deg}");
  ASSERT_TRUE(reading.description.has_value());
  const WavesDescription& waves = reading.description->environment.waves.front();
  EXPECT_EQ(waves.type, WaveType::stokes5);
  EXPECT_DOUBLE_EQ(waves.phase, 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(waves.height, 6.0);
  EXPECT_TRUE(reading.description->findings.empty());
}

TEST_F(SpectrumFile, doubtful_waves_are_reported) {
  struct Doubt {
    const char *waves, *expected_text;
  };
  const Doubt doubts[] = {
      {"{type: jonswap, hs: 8 m, tp: 8 s, from: 0 deg}", "steeper than a wind sea"},
      {"{type: airy, height: 2 m, period: 8 s, gamma: 2, from: 0 deg}", "has no effect for waves of type airy"},
      {"{type: pierson_moskowitz, hs: 2 m, tp: 8 s, gamma: 2, from: 0 deg}", "no effect"},
      {"{type: jonswap, hs: 2 m, tp: 8 s, phase: 20 deg, from: 0 deg}", "no effect"},
      {"{type: jonswap, hs: 2 m, tp: 8 s}", "from the north"},
  };
  for (const Doubt& doubt : doubts) {
    const ModelReading reading = read(doubt.waves);
    ASSERT_TRUE(reading.description.has_value()) << doubt.waves;
    ASSERT_EQ(reading.description->findings.size(), 1U) << doubt.waves;
    const std::string line = messages(reading.description->findings)[0];
    EXPECT_NE(line.find(doubt.expected_text), std::string::npos) << line;
  }
}

TEST(spectrum_reader, a_value_that_stands_for_none_is_rejected_and_a_lone_peak_warned_of) {
  const std::string head = "frequency_hz,density_m2_hz\n0.05,0\n0.1,1.2\n0.12,";
  const auto said = [&](const std::string& cell, Severity severity) {
    Diagnostics diagnostics;
    read_spectrum_text(head + cell + "\n0.14,1.1\n0.2,0.2\n0.3,0\n", "a.csv", diagnostics);
    const std::vector<std::string> lines = diagnostics.lines(severity);
    return lines.empty() ? "" : lines.front();
  };
  for (const char* cell : {"99.9", "99.99", "999", "9.99"}) {
    EXPECT_NE(said(cell, Severity::error).find("write for missing values"), std::string::npos) << cell;
    EXPECT_NE(said(cell, Severity::error).find("a.csv:4"), std::string::npos) << cell;
  }
  EXPECT_NE(said("-999", Severity::error).find("write for missing values"), std::string::npos);
  EXPECT_NE(said("12", Severity::warning).find("10 times the second largest density"), std::string::npos);
  EXPECT_EQ(said("3", Severity::warning) + said("3", Severity::error), "");
}

/// Rows of a JONSWAP-like hump of 8 s and a height of 2 m.
std::string hump(const std::function<double(int, double)>& density, double unit = 1.0) {
  std::string text = "omega_rad_s,density_m2s\n";
  for (int i = 0; i < 40; ++i) {
    const double omega = 0.3 + 0.04 * i;
    text += std::to_string(omega * unit) + "," + std::to_string(density(i, omega) / unit) + "\n";
  }
  return text;
}

double swell_of_8_s(int, double omega) {
  return 0.6 * std::exp(-std::pow((omega - 0.785) / 0.2, 2));
}

TEST(spectrum_reader, values_that_stand_for_none_are_rejected_in_several_rows_too) {
  for (const int last : {25, 30, 39}) {
    Diagnostics diagnostics;
    const auto density = [&](int i, double omega) { return i >= 25 && i <= last ? 9.99 : swell_of_8_s(i, omega); };
    read_spectrum_text(hump(density), "a.csv", diagnostics);
    const std::vector<std::string> lines = diagnostics.lines(Severity::error);
    ASSERT_EQ(lines.size(), 1U) << last;
    EXPECT_NE(lines[0].find("a.csv:27: density_m2s: found 9.99, which recorders"), std::string::npos) << lines[0];
  }
}

TEST(spectrum_reader, a_sea_that_no_wind_raises_is_warned_of) {
  const auto warned = [](const std::string& text) {
    Diagnostics diagnostics;
    read_spectrum_text(text, "a.csv", diagnostics);
    const std::vector<std::string> lines = diagnostics.lines(Severity::warning);
    return lines.empty() ? std::string() : lines.front();
  };
  EXPECT_EQ(warned(hump(swell_of_8_s)), "");
  EXPECT_NE(warned(hump(swell_of_8_s, 0.5 / std::numbers::pi)).find("Are the frequencies in rad/s?"),
            std::string::npos);
  const auto in_cm = [](int i, double omega) { return 100.0 * swell_of_8_s(i, omega); };
  EXPECT_NE(warned(hump(in_cm)).find("seas break at about 0.1"), std::string::npos) << warned(hump(in_cm));
}

}  // namespace
}  // namespace overbend

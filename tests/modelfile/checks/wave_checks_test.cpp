// Groups of waves: what the reader binds, rejects and warns of, by name.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/sea_files.h"

namespace overbend {
namespace {

ModelReading read(const std::string& waves, const std::string& path = "sea.yaml") {
  std::string text = testing::kGoodModel;
  const std::string sea = "{type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg, seed: 7}";
  return read_model_text(text.replace(text.find(sea), sea.size(), waves), path);
}

WaveGroups groups(const std::string& waves) {
  const ModelReading reading = read(waves);
  EXPECT_TRUE(reading.description) << waves;
  if (!reading.description) {
    ADD_FAILURE() << reading.diagnostics.lines(Severity::error).at(0);
    return {WavesDescription{}};
  }
  return reading.description->environment.waves;
}

std::string error(const std::string& waves) {
  const std::vector<std::string> errors = read(waves).diagnostics.lines(Severity::error);
  EXPECT_EQ(errors.size(), 1U) << waves;
  return errors.empty() ? "" : errors.front();
}

std::string warning(const std::string& waves) {
  const std::vector<std::string> warnings = read(waves).diagnostics.lines(Severity::warning);
  EXPECT_EQ(warnings.size(), 1U) << waves;
  return warnings.empty() ? "" : warnings.front();
}

bool has(const std::string& text, const std::string& wanted) {
  return text.find(wanted) != std::string::npos;
}

constexpr const char* kTwo =
    "[{type: jonswap, hs: 2.2 m, tp: 7.4 s, gamma: 3, from: 240 deg, spreading: 8},"
    " {type: jonswap, hs: 1.1 m, tp: 13.5 s, gamma: 6, from: 300 deg, seed: 4}]";

TEST(wave_groups, of_a_list_have_keys_of_their_own) {
  const WaveGroups two = groups(kTwo);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].key, "environment.waves[0]");
  EXPECT_EQ(two[1].key, "environment.waves[1]");
  EXPECT_DOUBLE_EQ(two[0].hs, 2.2);
  EXPECT_DOUBLE_EQ(two[1].tp, 13.5);
  EXPECT_EQ(two[0].spreading, 8.0);
  EXPECT_FALSE(two[1].spreading);
  EXPECT_EQ(two[0].seed, 1U);
  EXPECT_EQ(two[1].seed, 4U);
  EXPECT_EQ(groups("{type: airy, height: 2 m, period: 8 s, from: 0 deg}").at(0).key, "environment.waves");
}

TEST(wave_groups, are_one_to_twenty) {
  EXPECT_TRUE(has(error("[]"), "an empty list"));
  std::string many;
  for (int i = 0; i < 21; ++i) many += ", {type: none}";
  EXPECT_TRUE(has(error("[" + many.substr(2) + "]"), "found a list of 21, expected at most 20"));
  EXPECT_TRUE(has(error("rough"), "a group of keys or a list"));
}

TEST(wave_groups, errors_and_warnings_name_the_group) {
  EXPECT_TRUE(has(error("[{type: airy, height: 2 m, period: 8 s, from: 0 deg}, {type: jonswap, hs: 2 m, from: 0 deg}]"),
                  "environment.waves[1].tp: found nothing"));
  EXPECT_TRUE(has(warning("[{type: airy, height: 2 m, period: 8 s}, {type: none}]"),
                  "environment.waves[0]: no direction is given"));
}

TEST(wave_groups, a_stokes_wave_is_not_superposed) {
  const std::string stokes = "{type: stokes5, height: 3 m, period: 9 s, from: 0 deg}";
  EXPECT_TRUE(
      has(error("[" + stokes + ", {type: airy, height: 2 m, period: 8 s, from: 0 deg}]"),
          "environment.waves[0].type: found stokes5 among 2 groups of waves, expected type airy, or stokes5 alone"));
  EXPECT_EQ(groups("[" + stokes + ", {type: none}]").size(), 2U);
}

TEST(wave_groups, break_by_the_height_of_all_together) {
  const std::string high = "{type: pierson_moskowitz, hs: 26 m, tp: 20 s, from: 0 deg}";  // in 89 m
  EXPECT_TRUE(groups(high).size() == 1);
  const auto breaks = [](const std::string& waves) {
    for (const std::string& line : read(waves).diagnostics.lines(Severity::warning)) {
      if (has(line, "the highest is ")) return true;
    }
    return false;
  };
  EXPECT_FALSE(breaks("[" + high + ", {type: none}]"));
  EXPECT_TRUE(breaks("[" + high + ", " + high + ", " + high + "]"));
}

TEST(wave_periods, tz_gives_tp_by_integrals_over_the_spectrum) {
  EXPECT_NEAR(groups("{type: jonswap, hs: 2 m, tz: 7 s, gamma: 3.3, from: 0 deg}")[0].tp / 7.0, 1.2863, 5e-5);
  EXPECT_NEAR(groups("{type: pierson_moskowitz, hs: 2 m, tz: 7 s, from: 0 deg}")[0].tp / 7.0, 1.4077, 5e-5);
  const WavesDescription ruled = groups("{type: jonswap, hs: 4 m, tz: 7 s, from: 0 deg}")[0];
  const WavesDescription given =
      groups("{type: jonswap, hs: 4 m, tz: 7 s, gamma: " + std::to_string(std::exp(5.75 - 1.15 * ruled.tp / 2.0)) +
             ", from: 0 deg}")[0];
  EXPECT_NEAR(ruled.tp, given.tp, 1e-5);
}

TEST(wave_periods, only_one_of_tp_and_tz_is_given) {
  EXPECT_TRUE(has(error("{type: jonswap, hs: 2 m, tp: 9 s, tz: 7 s, from: 0 deg}"),
                  "environment.waves.tz: found tz as well as tp, expected one of them"));
  EXPECT_TRUE(has(error("{type: jonswap, hs: 2 m, from: 0 deg}"), "environment.waves.tp: found nothing"));
  EXPECT_TRUE(has(warning("{type: airy, height: 2 m, period: 8 s, tz: 7 s, from: 0 deg}"), "has no effect"));
}

TEST(wave_spectra, of_ochi_and_hubble_have_two_parts) {
  const WavesDescription waves = groups(
      "{type: ochi_hubble, parts: [{hs: 2 m, tp: 13.96 s, lambda: 3}, {hs: 1.5 m, tp: 6.98 s, lambda: 1.4}], "
      "from: 0 deg}")[0];
  EXPECT_DOUBLE_EQ(waves.hs, 2.5);
  EXPECT_DOUBLE_EQ(waves.tp, 13.96);
  EXPECT_DOUBLE_EQ(waves.parts.at(1).lambda, 1.4);
  EXPECT_TRUE(has(error("{type: ochi_hubble, parts: [{hs: 2 m, tp: 14 s, lambda: 3}], from: 0 deg}"), "exactly 2"));
  EXPECT_TRUE(has(error("{type: ochi_hubble, from: 0 deg}"), "environment.waves.parts: found nothing"));
}

TEST(wave_spectra, of_torsethaugen_name_their_model) {
  EXPECT_EQ(groups("{type: torsethaugen, model: full, hs: 4 m, tp: 9 s, from: 0 deg}")[0].model,
            TorsethaugenModel::full);
  EXPECT_TRUE(
      has(error("{type: torsethaugen, hs: 4 m, tp: 9 s, from: 0 deg}"), "environment.waves.model: found nothing"));
}

TEST(wave_files, give_direction_or_leave_it_to_the_model) {
  const std::string swan = testing::sea_file("swan-2d.sp2"), buoy = testing::sea_file("ndbc-density.txt");
  const WavesDescription waves = groups("{type: user, spectrum_file: " + swan + "}")[0];
  EXPECT_TRUE(waves.file_gives_direction);
  EXPECT_EQ(waves.directions.sectors.size(), 36U);
  EXPECT_TRUE(has(error("{type: user, spectrum_file: " + swan + ", from: 20 deg}"),
                  "found '20 deg' as well as the directions of the file"));
  EXPECT_TRUE(has(warning("{type: user, spectrum_file: " + buoy + ", time: 2025-11-03 00:40}"),
                  "no direction is given (from)"));
  EXPECT_TRUE(
      has(error("{type: user, spectrum_file: " + buoy + ", from: 20 deg}"), "environment.waves.time: found 3 times"));
}

TEST(wave_files, of_sea_states_take_the_place_of_height_and_period) {
  const std::string file = ", spectrum_file: " + testing::sea_file("ndbc-standard.txt") + ", time: 2026-06-01 11:40}";
  const WavesDescription waves = groups("{type: jonswap" + file)[0];
  EXPECT_DOUBLE_EQ(waves.hs, 1.8);
  EXPECT_DOUBLE_EQ(waves.tp, 9.0);
  EXPECT_NEAR(waves.from, 262.0 * kDegree, 1e-12);
  EXPECT_TRUE(has(error("{type: jonswap, hs: 2 m" + file), "hs as well as spectrum_file"));
}

TEST(wave_files, of_several_groups_are_each_read) {
  const std::string path = testing::sea_file("swan-1d.spc");
  const WaveGroups two =
      groups("[{type: user, spectrum_file: " + path + "}, {type: user, spectrum_file: " + path + "}]");
  EXPECT_EQ(two.at(1).spectrum.size(), 27U);
  EXPECT_TRUE(has(warning("[{type: user, spectrum_file: missing.spc, from: 0 deg}]"), "does not exist"));
}

TEST(wave_records, shorter_than_the_run_are_reported) {
  const std::string waves = "{type: elevation, elevation_file: " + testing::sea_file("elevation.csv") +
                            ", from: 20 deg, at: {x: 30 m, y: -20 m}}";
  EXPECT_TRUE(has(warning(waves), "the record of 600 s is shorter than the run of 10800 s"));  // of three hours
  const WavesDescription read = groups(waves)[0];
  EXPECT_EQ(read.measured_at, Vec3(30.0, -20.0, 0.0));
  EXPECT_NEAR(read.hs, 1.9797, 1e-4);
  EXPECT_TRUE(has(error("{type: elevation, from: 0 deg}"), "environment.waves.elevation_file: found nothing"));
}

}  // namespace
}  // namespace overbend

// Motions in the files of panel programs.
#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"
#include "seafiles/rao_reader.h"

namespace overbend {
namespace {

using testing::hull_file;
using testing::read_text;
using testing::ScratchFolder;
using testing::with_change;

struct RaoReading {
  std::optional<RaoTable> table;
  std::vector<std::string> errors;
};

RaoReading read_motions(const std::string& file, const RaoSettings& settings = {}) {
  Diagnostics diagnostics;
  RaoReading reading{read_raos(file, settings, 2000.0, diagnostics), {}};
  reading.errors = diagnostics.lines(Severity::error);
  return reading;
}

RaoSettings with_phase(const char* sense) {
  RaoSettings settings;
  settings.values["phase"] = sense;
  return settings;
}

/// Compares with the motions of the barge's centre of gravity. The responses of another point are transferred to it.
void expect_motions(const RaoTable& table, double tolerance) {
  const Vec3 arm = Vec3(0.0, 0.0, 1.5) - table.reference_V;
  for (const nlohmann::json& row : testing::barge_values()["motions"]) {
    const double omega = kTurn / row["period_s"].get<double>();
    const double heading = row["direction_deg"].get<double>() * kDegree;
    const std::size_t h = testing::nearest_index(table.headings, heading);
    const std::size_t w = testing::nearest_index(table.omegas, omega);
    ASSERT_NEAR(table.omegas[w], omega, 1e-4 * omega);
    std::array<std::complex<double>, 6> z{};
    for (std::size_t k = 0; k < 6; ++k) z[k] = table.value(h, w, k);
    z[0] += z[4] * arm.z();
    z[1] -= z[3] * arm.z();
    for (std::size_t k = 0; k < 6; ++k) {
      const auto pair = row["amplitude_lag"][k];
      const double unit = k < 3 ? 1.0 : kDegree;
      const std::complex<double> expected = std::polar(pair[0].get<double>() * unit, -pair[1].get<double>() * kDegree);
      EXPECT_LT(std::abs(z[k] - expected), tolerance * (std::abs(expected) + 0.1 * unit))
          << row["period_s"] << " s, " << row["direction_deg"] << " deg, " << kFreedomNames[k];
    }
  }
}

TEST(rao_listings, motions_of_wamits_output_are_those_of_the_bodys_origin) {
  const RaoReading reading = read_motions(hull_file("wamit-out/barge.out"));
  ASSERT_TRUE(reading.table) << reading.errors.at(0);
  EXPECT_EQ(reading.table->reference_V, Vec3::Zero());
  expect_motions(*reading.table, 4e-4);
  bool said = false;
  for (const Assumption& assumption : reading.table->assumptions) {
    said = said || assumption.text.find("origin of the body's axes") != std::string::npos;
  }
  EXPECT_TRUE(said);
}

TEST(rao_listings, numeric_motions_in_rad_per_s_agree) {
  RaoSettings settings;
  settings.values["frequencies"] = "rad_per_s";
  settings.reference = Vec3(0.0, 0.0, 1.5);
  const RaoReading reading = read_motions(hull_file("wamit-rad-per-s/barge.4"), settings);
  ASSERT_TRUE(reading.table) << reading.errors.at(0);
  expect_motions(*reading.table, 2e-4);
  const RaoReading without = read_motions(hull_file("wamit-rad-per-s/barge.4"));
  EXPECT_FALSE(without.table);
  EXPECT_NE(without.errors.at(0).find("12 values from 0.2513 to 1.571"), std::string::npos) << without.errors.at(0);
  EXPECT_NE(without.errors.at(0).find("waves of 0.099 to 3.9 m length"), std::string::npos) << without.errors.at(0);
}

TEST(rao_listings, motions_of_aqwas_listing_are_those_of_the_centre_of_gravity) {
  const RaoReading reading = read_motions(hull_file("aqwa/barge.LIS"));
  ASSERT_TRUE(reading.table) << reading.errors.at(0);
  EXPECT_EQ(reading.table->reference_V, Vec3(0.0, 0.0, 1.5));
  expect_motions(*reading.table, 6e-3);
}

TEST(rao_listings, hydrostar_needs_the_sense_of_its_phases) {
  const std::string file = hull_file("hydrostar/barge_heave.rao");
  const RaoReading without = read_motions(file);
  EXPECT_FALSE(without.table);
  EXPECT_NE(without.errors.at(0).find("convention.phase: lag or lead; the surge in long waves suggests lag"),
            std::string::npos)
      << without.errors.at(0);
  const RaoReading reading = read_motions(file, with_phase("lag"));
  ASSERT_TRUE(reading.table) << reading.errors.at(0);
  expect_motions(*reading.table, 2e-4);
  EXPECT_EQ(reading.table->reference_V, Vec3(0.0, 0.0, 1.5));
}

TEST(rao_listings, a_missing_file_of_the_six_is_named) {
  const ScratchFolder scratch;
  scratch.copy(hull_file("hydrostar"));
  std::filesystem::remove(scratch.path("barge_roll.rao"));
  const RaoReading reading = read_motions(scratch.path("barge_yaw.rao"), with_phase("lag"));
  EXPECT_NE(reading.errors.at(0).find("barge_roll.rao"), std::string::npos);
  scratch.write("barge_roll.rao", read_text(hull_file("hydrostar/barge_pitch.rao")));
  EXPECT_NE(read_motions(scratch.path("barge_yaw.rao"), with_phase("lag")).errors.at(0).find("COMPONENT 5"),
            std::string::npos);
}

TEST(rao_listings, damaged_motions_get_an_answer) {
  std::mt19937 random(7);
  for (const auto& [folder, file] : {std::pair{"wamit-out", "barge.out"}, std::pair{"aqwa", "barge.LIS"},
                                     std::pair{"hydrostar", "barge_pitch.rao"}}) {
    const ScratchFolder scratch;
    scratch.copy(hull_file(folder));
    const std::string good = read_text(scratch.path(file));
    for (int trial = 0; trial < testing::damage_trials() / 3; ++trial) {
      scratch.write(file, testing::damaged_text(good, random));
      const RaoReading reading = read_motions(scratch.path(file), with_phase("lag"));
      EXPECT_NE(reading.table.has_value(), !reading.errors.empty()) << folder << trial;
      if (!reading.table) continue;
      for (const std::complex<double>& value : reading.table->values) {
        ASSERT_TRUE(std::isfinite(value.real()) && std::isfinite(value.imag())) << folder << trial;
      }
    }
  }
}

}  // namespace
}  // namespace overbend

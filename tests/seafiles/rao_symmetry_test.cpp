// OrcaFlex's statements of symmetry.
#include "seafiles/rao_symmetry.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/constants.h"
#include "seafiles/rao_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using Six = std::array<std::complex<double>, 6>;
const std::complex<double> kI(0.0, 1.0);

/// A raft that moves with the water, symmetric in every way: closed form for any heading.
Six raft(double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {-0.8 * kI * c, -0.8 * kI * s, 0.9, -0.02 * kI * s, 0.02 * kI * c, 0.0};
}

/// As a file of OrcaFlex, amplitudes and lags, with the headings [deg] given.
std::string orcaflex_text(const std::string& symmetry, const std::vector<double>& headings,
                          const std::function<Six(double)>& responses, const std::string& length = "100") {
  std::string text =
      "General: {UnitsSystem: SI}\nVesselTypes:\n  - Name: raft\n    Length: " + length +
      "\n    RAOResponseUnits: radians\n    RAOWaveUnit: amplitude\n    WavesReferredToBy: frequency (rad/s)\n"
      "    RAOPhaseConvention: lags\n    RAOPhaseUnitsConvention: radians\n    RAOPhaseRelativeToConvention: crest\n";
  if (!symmetry.empty()) text += "    Symmetry: " + symmetry + "\n";
  text +=
      "    Draughts:\n      - Name: D\n        DisplacementRAOs:\n          RAOOrigin: [0, 0, 0]\n"
      "          PhaseOrigin: [~, ~, ~]\n          RAOs:\n";
  for (const double heading : headings) {
    text += fmt::format("            - RAODirection: {}\n", heading) +
            "              RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, RAOSwayAmp, RAOSwayPhase, RAOHeaveAmp, "
            "RAOHeavePhase, RAORollAmp, RAORollPhase, RAOPitchAmp, RAOPitchPhase, RAOYawAmp, RAOYawPhase:\n";
    for (const double omega : {0.4, 0.8}) {
      text += fmt::format("                - [{}", omega);
      for (const auto& z : responses(heading * kDegree)) {
        text += fmt::format(", {:.12g}, {:.12g}", std::abs(z), -std::arg(z));
      }
      text += "]\n";
    }
  }
  return text;
}

struct Reading {
  std::optional<RaoTable> table;
  std::vector<std::string> warnings, errors;
};

Reading read(const std::string& text, double vessel_length = 0.0) {
  const testing::WrittenFile file("raft.yml", text);
  RaoSettings settings;
  settings.vessel_length = vessel_length;
  Diagnostics diagnostics;
  Reading reading{read_raos(file.path(), settings, 89.0, diagnostics), {}, {}};
  reading.warnings = diagnostics.lines(Severity::warning);
  reading.errors = diagnostics.lines(Severity::error);
  return reading;
}

std::vector<double> headings(double from, double to, double step) {
  std::vector<double> list;
  for (double h = from; h <= to + 1e-9; h += step) list.push_back(h);
  return list;
}

/// The raft's own responses at all headings, within what linear interpolation misses over `step` [deg].
void expect_raft(const Reading& reading, double step) {
  ASSERT_TRUE(reading.table) << (reading.errors.empty() ? "" : reading.errors[0]);
  const double missed = 1.0 - std::cos(0.5 * step * kDegree) + 1e-9;
  for (double heading = 0.0; heading < 360.0; heading += 7.0) {
    const RaoTable::Response got = reading.table->at(heading * kDegree, 0.6);
    const Six expected = raft(heading * kDegree);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_LT(std::abs(got[k] - expected[k]), missed) << heading << " " << k;
  }
}

TEST(rao_symmetry, every_statement_of_symmetry_gives_the_whole_circle) {
  expect_raft(read(orcaflex_text("None", headings(0.0, 345.0, 15.0), raft)), 15.0);
  expect_raft(read(orcaflex_text("xz plane", headings(0.0, 180.0, 15.0), raft)), 15.0);
  expect_raft(read(orcaflex_text("yz plane", headings(-90.0, 90.0, 15.0), raft)), 15.0);
  expect_raft(read(orcaflex_text("xz and yz planes", headings(0.0, 90.0, 15.0), raft)), 15.0);
  expect_raft(read(orcaflex_text("xz and yz planes", headings(180.0, 270.0, 15.0), raft)), 15.0);
  expect_raft(read(orcaflex_text("circular", {30.0}, raft)), 5.0);
}

TEST(rao_symmetry, a_vessel_said_to_have_none_is_not_mirrored) {
  const Reading reading = read(orcaflex_text("None", headings(0.0, 180.0, 45.0), raft));
  ASSERT_TRUE(reading.table);
  const RaoTable& table = *reading.table;
  EXPECT_FALSE(table.one_sided());
  // A straight line from 180 to 360 deg: at 270 deg the mean of both.
  const RaoTable::Response got = table.at(270.0 * kDegree, 0.4), at_0 = table.at(0.0, 0.4), at_180 = table.at(kPi, 0.4);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_LT(std::abs(got[k] - 0.5 * (at_0[k] + at_180[k])), 1e-12) << k;
  ASSERT_FALSE(reading.warnings.empty());
  EXPECT_NE(reading.warnings[0].find("180 deg apart"), std::string::npos) << reading.warnings[0];
  EXPECT_NE(reading.warnings[0].find("nothing is mirrored"), std::string::npos) << reading.warnings[0];
}

TEST(rao_symmetry, half_a_circle_without_a_statement_is_mirrored_as_an_assumption) {
  const Reading reading = read(orcaflex_text("", headings(0.0, 180.0, 15.0), raft));
  expect_raft(reading, 15.0);
  ASSERT_FALSE(reading.table->assumptions.empty());
  EXPECT_NE(reading.table->assumptions[0].text.find("mirror image"), std::string::npos);
}

TEST(rao_symmetry, points_off_the_planes_of_symmetry_are_rejected) {
  std::string text = orcaflex_text("xz and yz planes", headings(0.0, 90.0, 15.0), raft);
  text.replace(text.find("[0, 0, 0]"), 9, "[5, 0, 0]");
  const Reading reading = read(text);
  EXPECT_FALSE(reading.table);
  EXPECT_NE(reading.errors.at(0).find("off the plane or axis of Symmetry"), std::string::npos);
}

TEST(rao_symmetry, a_vessel_of_another_length_is_warned_of) {
  EXPECT_TRUE(read(orcaflex_text("xz plane", headings(0.0, 180.0, 15.0), raft), 100.0).warnings.empty());
  const Reading reading = read(orcaflex_text("xz plane", headings(0.0, 180.0, 15.0), raft, "103"), 100.0);
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_NE(reading.warnings[0].find("103 m long, the vessel of the model 100 m"), std::string::npos);
}

}  // namespace
}  // namespace overbend

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "seafiles/rao_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using testing::bgl1_raos;
using testing::good_raos;
using testing::WrittenFile;

/// The barge's RAOs of one side as a text data file: rad, leads on the trough, frequency in Hz, pitch bow up.
std::string orcaflex_file() {
  std::string text =
      "%YAML 1.1\n# Type: Model\n---\nGeneral:\n  UnitsSystem: SI\nVesselTypes:\n  - Name: barge\n    Length: 120\n"
      "    RAOResponseUnits: radians\n    RAOWaveUnit: amplitude\n    WavesReferredToBy: frequency (Hz)\n"
      "    RAOPhaseConvention: leads\n    RAOPhaseUnitsConvention: radians\n"
      "    RAOPhaseRelativeToConvention: trough\n    SurgePositive: forward\n    SwayPositive: port\n"
      "    HeavePositive: up\n    RollPositiveStarboard: down\n    PitchPositiveBow: up\n    YawPositiveBow: port\n"
      "    Symmetry: xz plane\n    Draughts:\n      - Name: laying\n        Mass: 19121.6\n        DisplacementRAOs:\n"
      "          RAOOrigin: [60, 0, 6]\n          PhaseOrigin: [~, ~, ~]\n          RAOs:\n";
  const RaoTable& table = bgl1_raos();
  for (std::size_t i = 0; i < table.headings.size() && table.headings[i] < kPi + 1e-9; ++i) {
    text += fmt::format("            - RAODirection: {:.6g}\n", table.headings[i] / kDegree);
    text +=
        "              RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, RAOSwayAmp, RAOSwayPhase, RAOHeaveAmp, "
        "RAOHeavePhase, RAORollAmp, RAORollPhase, RAOPitchAmp, RAOPitchPhase, RAOYawAmp, RAOYawPhase:\n"
        "                - [0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0]\n";
    for (std::size_t j = 0; j < table.omegas.size(); ++j) {
      text += fmt::format("                - [{:.12g}", table.omegas[j] / (2.0 * kPi));
      for (std::size_t k = 0; k < 6; ++k) {
        const std::complex<double> z = (k == 4 ? -1.0 : 1.0) * table.value(i, j, k);
        text +=
            fmt::format(", {:.12g}, {:.12g}", std::abs(z), std::arg(z) + kPi);  // trough half a turn after the crest
      }
      text += "]\n";
    }
  }
  return text;
}

double difference(const RaoTable& a, const RaoTable& b) {
  double worst = 0.0;
  for (double heading = 0.0; heading < 360.0; heading += 11.0) {
    for (double omega = 0.1; omega < 2.2; omega += 0.0437) {
      const RaoTable::Response x = a.at(heading * kDegree, omega), y = b.at(heading * kDegree, omega);
      for (std::size_t k = 0; k < 6; ++k) worst = std::max(worst, std::abs(x[k] - y[k]));
    }
  }
  return worst;
}

/// The first error of a file that must be rejected.
std::string first_error(const std::string& text, const RaoSettings& given = {}) {
  const WrittenFile file("vessel.yml", text);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_raos(file.path(), given, 89.0, diagnostics).has_value());
  const auto lines = diagnostics.lines(Severity::error);
  return lines.empty() ? std::string() : lines.front();
}

std::string with(const std::string& find, const std::string& replace) {
  std::string text = orcaflex_file();
  return text.replace(text.find(find), find.size(), replace);
}

TEST(rao_orcaflex, a_vessel_type_gives_the_same_motions_by_the_settings_it_carries) {
  const WrittenFile file("vessel.yml", orcaflex_file());
  RaoSettings given;
  given.file_origin = Vec3(-60.0, 0.0, -5.182);  // keel at the stern
  given.file_origin_stated = true;
  const RaoTable table = good_raos(file.path(), given);
  EXPECT_TRUE(table.one_sided());
  EXPECT_LT(difference(table, bgl1_raos()), 1e-6);
  EXPECT_LT((table.reference_V - Vec3(0.0, 0.0, 0.818)).norm(), 1e-12);
  EXPECT_EQ(table.wave_origin_V, table.reference_V) << "a phase origin left to its default is the RAO origin";
}

TEST(rao_orcaflex, an_origin_of_its_axes_that_is_not_stated_is_assumed) {
  const WrittenFile file("vessel.yml", orcaflex_file());
  const RaoTable table = good_raos(file.path());
  EXPECT_EQ(table.reference_V, Vec3(60.0, 0.0, 6.0));
  ASSERT_EQ(table.assumptions.size(), 2U);
  EXPECT_NE((table.assumptions[0].text + table.assumptions[1].text).find("origin of these axes is assumed at midship"),
            std::string::npos);
}

TEST(rao_orcaflex, a_phase_origin_of_its_own_is_taken) {
  const WrittenFile file("vessel.yml", with("PhaseOrigin: [~, ~, ~]", "PhaseOrigin: [50, 0, 0]"));
  EXPECT_EQ(good_raos(file.path()).wave_origin_V, Vec3(50.0, 0.0, 0.0));
}

TEST(rao_orcaflex, several_vessel_types_are_chosen_by_name) {
  const std::string text = with("VesselTypes:\n", "VesselTypes:\n  - Name: tug\n    Length: 30\n");
  EXPECT_NE(first_error(text).find("one of tug or barge"), std::string::npos) << first_error(text);
  RaoSettings given;
  given.vessel_type = "barge";
  const WrittenFile file("vessels.yml", text);
  EXPECT_LT(difference(good_raos(file.path(), given), bgl1_raos()), 1e-6);
  given.vessel_type = "ferry";
  EXPECT_NE(first_error(text, given).find("none called 'ferry'"), std::string::npos);
}

TEST(rao_orcaflex, lengths_and_rotations_of_a_file_in_feet_are_converted) {
  const WrittenFile file("vessel.yml", orcaflex_file()), us_file("us.yml", with("UnitsSystem: SI", "UnitsSystem: US"));
  const RaoTable metres = good_raos(file.path()), feet = good_raos(us_file.path());
  ASSERT_EQ(feet.omegas.size(), metres.omegas.size());
  EXPECT_NEAR(std::abs(feet.value(1, 2, 2)), std::abs(metres.value(1, 2, 2)), 1e-12);          // metre per metre
  EXPECT_NEAR(std::abs(feet.value(1, 2, 3)), std::abs(metres.value(1, 2, 3)) / 0.3048, 1e-9);  // per foot of amplitude
  EXPECT_NEAR(std::abs(feet.value(1, 2, 4)), std::abs(metres.value(1, 2, 4)) / 0.3048, 1e-9);
}

TEST(rao_orcaflex, what_is_not_understood_is_rejected) {
  EXPECT_NE(
      first_error(with("leads", "behind")).find("RAOPhaseConvention: found 'behind', expected one of lags or leads"),
      std::string::npos);
  EXPECT_NE(first_error(with("    RAOPhaseConvention: leads\n", "")).find("RAOPhaseConvention"), std::string::npos);
  EXPECT_NE(first_error(with("Symmetry: xz plane", "Symmetry: Circular")).find("Symmetry"), std::string::npos);
  EXPECT_NE(first_error(with("UnitsSystem: SI", "UnitsSystem: Metric")).find("SI, US or User"), std::string::npos);
  EXPECT_NE(first_error(with("[60, 0, 6]", "[60, 0]")).find("[x, y, z] in metres"), std::string::npos);
  EXPECT_NE(first_error(with("RAOYawPhase:", "RAOYawAngle:")).find("six degrees of freedom"), std::string::npos);
  EXPECT_NE(first_error(with("DisplacementRAOs", "LoadRAOs")).find("DisplacementRAOs"), std::string::npos);
  std::string slope = with("RAOWaveUnit: amplitude", "RAOWaveUnit: max wave slope");
  slope.replace(slope.find("RAOResponseUnits: radians"), 25, "RAOResponseUnits: degrees");
  EXPECT_NE(first_error(slope).find("degrees per max wave slope"), std::string::npos);
}

}  // namespace
}  // namespace overbend

#include "seafiles/orcaflex_hull.h"

#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

using testing::barge_source;
using testing::hull_file;
using testing::HullReading;
using testing::read_hull;
using testing::read_text;
using testing::ScratchFolder;
using testing::with_change;

const std::string kFile = "orcaflex-loads/barge.yml";

HullReading read_changed(const std::string& find, const std::string& replacement,
                         HydrodynamicsSource source = barge_source("")) {
  const ScratchFolder scratch;
  source.path = scratch.write("barge.yml", with_change(read_text(hull_file(kFile)), find, replacement));
  return read_hull(source);
}

TEST(orcaflex_hull, load_raos_and_matrices_give_the_barge) {
  const HullReading reading = read_hull(barge_source(hull_file(kFile)));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
  EXPECT_EQ(reading.data->excitation.heading.size(), 8U);  // the other side by symmetry
}

TEST(orcaflex_hull, positive_directions_of_the_file_count) {
  const HullReading good = read_hull(barge_source(hull_file(kFile)));
  const HullReading aft = read_changed("SurgePositive: forward", "SurgePositive: aft");
  ASSERT_TRUE(good.data && aft.data);
  EXPECT_EQ(aft.data->force[0](0), -good.data->force[0](0));
  EXPECT_EQ(aft.data->force[0](2), good.data->force[0](2));
}

TEST(orcaflex_hull, drift_is_read_where_the_file_has_it) {
  const std::string drift =
      "        WaveDrift:\n          RAOOrigin: [0, 0, 1.5]\n          RAOs:\n            - RAODirection: 0\n"
      "              RAOPeriodOrFrequency, RAOSurge, RAOSway, RAOHeave, RAORoll, RAOPitch, RAOYaw:\n"
      "                - [5, 20, 0, 1, 2, 3, 0]\n                - [9, 10, 0, 1, 2, 3, 0]\n"
      "            - RAODirection: 180\n"
      "              RAOPeriodOrFrequency, RAOSurge, RAOSway, RAOHeave, RAORoll, RAOPitch, RAOYaw:\n"
      "                - [5, -20, 0, 1, 2, 3, 0]\n                - [9, -10, 0, 1, 2, 3, 0]\n";
  const std::string place = "        # Stiffness, added mass and damping\n";
  const HullReading reading = read_changed(place, drift + place);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  ASSERT_EQ(reading.data->mean_drift.size(), 4U);
  EXPECT_NEAR(reading.data->mean_drift[reading.data->drift.index(1, 0)](0), 20e3, 1e-6);
  EXPECT_NEAR(reading.data->mean_drift[reading.data->drift.index(0, 1)](0), -10e3, 1e-6);
  EXPECT_EQ(reading.data->mean_drift[0](2), 0.0);
}

TEST(orcaflex_hull, incomplete_vessel_types_are_rejected_with_what_is_missing) {
  const auto error = [](const HullReading& reading) { return reading.errors.empty() ? "" : reading.errors.front(); };
  EXPECT_NE(error(read_changed("FrequencyDependentAddedMassAndDamping:", "Other:"))
                .find("no FrequencyDependentAddedMassAndDamping"),
            std::string::npos);
  EXPECT_NE(error(read_changed("        LoadRAOs:", "        OtherRAOs:")).find("LoadRAOs"), std::string::npos);
  EXPECT_NE(error(read_changed("Symmetry: xz plane", "Symmetry: circular")).find("circular"), std::string::npos);
  EXPECT_NE(error(read_changed("RAOWaveUnit: amplitude", "RAOWaveUnit: wave steepness")).find("per amplitude"),
            std::string::npos);
  EXPECT_NE(error(read_changed("- [25330.58, 0, 0]", "- [25330.58, 0]")).find("HydrostaticStiffnessRy"),
            std::string::npos);
}

TEST(orcaflex_hull, damaged_files_get_an_answer) {
  testing::expect_answers_to_damage(hull_file("orcaflex-loads"), "barge.yml", "barge.yml",
                                    testing::damage_trials() / 3);
}

}  // namespace
}  // namespace overbend

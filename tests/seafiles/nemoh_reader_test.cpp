#include "seafiles/nemoh_reader.h"

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

TEST(nemoh_reader, folder_and_case_file_give_the_barge) {
  for (const char* name : {"nemoh", "nemoh/Nemoh.cal"}) {
    const HullReading reading = read_hull(barge_source(hull_file(name)));
    ASSERT_TRUE(reading.data) << reading.errors.at(0);
    EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
    testing::expect_barge(*reading.data, 2e-4, false);
  }
}

TEST(nemoh_reader, a_zone_that_is_too_short_is_rejected_with_its_line) {
  const HullReading reading = read_hull(barge_source(hull_file("bad/nemoh-short-zone")));
  EXPECT_FALSE(reading.data);
  ASSERT_EQ(reading.errors.size(), 1U);
  for (const char* part : {"RadiationCoefficients.tec:34:", "10 rows before the next zone", "I = 12"}) {
    EXPECT_NE(reading.errors[0].find(part), std::string::npos) << reading.errors[0];
  }
}

TEST(nemoh_reader, rotations_about_another_point_are_moved_from_it) {
  const ScratchFolder scratch;
  scratch.copy(hull_file("nemoh"));
  std::string text = read_text(scratch.path("Nemoh.cal"));
  for (int k = 0; k < 6; ++k) text = with_change(text, "0.0 0.0 1.5", "0.0 0.0 0.0");
  scratch.write("Nemoh.cal", text);
  const HullReading reading = read_hull(barge_source(scratch.path("Nemoh.cal")));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_EQ(reading.data->file_origin_V.value(), Vec3::Zero());
  // Surge moves pitch of the new point: A15' = A15 - 1.5 A11.
  EXPECT_NEAR(reading.data->radiation[0].added_mass(0, 4), -3.6209168e6 - 1.5 * 1.0345476e6, 10.0);
}

TEST(nemoh_reader, missing_files_are_named) {
  const ScratchFolder scratch;
  scratch.copy(hull_file("nemoh"));
  std::filesystem::remove(scratch.path("Mesh/KH.dat"));
  const HullReading reading = read_hull(barge_source(scratch.path("Nemoh.cal")));
  ASSERT_EQ(reading.errors.size(), 1U);
  EXPECT_NE(reading.errors[0].find("KH.dat"), std::string::npos) << reading.errors[0];
  EXPECT_EQ(hydrodynamic_files(scratch.path("Nemoh.cal")).size(), 4U);
}

TEST(nemoh_reader, damaged_files_get_an_answer) {
  for (const char* file : {"Nemoh.cal", "Results/RadiationCoefficients.tec", "Results/ExcitationForce.tec",
                           "Mesh/KH.dat", "Mesh/Hydrostatics.dat"}) {
    testing::expect_answers_to_damage(hull_file("nemoh"), file, "Nemoh.cal", testing::damage_trials() / 3);
  }
}

}  // namespace
}  // namespace overbend

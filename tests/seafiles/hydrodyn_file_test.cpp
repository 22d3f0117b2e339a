#include "seafiles/hydrodyn_file.h"

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

TEST(hydrodyn_file, weight_is_added_and_values_are_moved_from_the_water_line) {
  HydrodynamicsSource source = barge_source(hull_file("hydrodyn/HydroDyn.dat"));
  source.gravity = HydrodynamicsSource().gravity;  // not stated
  const HullReading reading = read_hull(source);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
  EXPECT_EQ(reading.data->file_origin_V.value(), Vec3::Zero());
  for (const char* part : {"-189979 kN m", "1.5 m above the reference point", "9.80665 m/s^2"}) {
    EXPECT_NE(reading.notes().find(part), std::string::npos) << reading.notes();
  }
}

TEST(hydrodyn_file, keys_say_the_same_of_the_wamit_files_themselves) {
  HydrodynamicsSource source = barge_source(hull_file("hydrodyn/barge"));
  source.origin = HullOrigin::waterline;
  source.stiffness = StiffnessContents::hydrostatic_only;
  const HullReading reading = read_hull(source);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
  source.origin = HullOrigin::gravity_centre;
  const HullReading unmoved = read_hull(source);
  ASSERT_TRUE(unmoved.data);
  EXPECT_NEAR(unmoved.data->hydrostatic_stiffness(3, 3), 1338298815.525, 1e-4 * 1338298815.525);
}

TEST(hydrodyn_file, what_it_does_not_support_is_named) {
  const ScratchFolder scratch;
  scratch.copy(hull_file("hydrodyn"));
  const std::string good = read_text(scratch.path("HydroDyn.dat"));
  const auto error = [&](const std::string& find, const std::string& replacement) {
    scratch.write("HydroDyn.dat", with_change(good, find, replacement));
    const HullReading reading = read_hull(barge_source(scratch.path("HydroDyn.dat")));
    return reading.errors.empty() ? std::string() : reading.errors.front();
  };
  EXPECT_NE(error("       1025.0    WtrDens", "       heavy    WtrDens").find("'heavy' for WtrDens"),
            std::string::npos);
  EXPECT_NE(error("\"barge\"          PotFile", "\"missing\"          PotFile").find("missing.1"), std::string::npos);
  EXPECT_NE(error("             0   PtfmCOBxt", "  3  PtfmRefxt - x\n             0   PtfmCOBxt").find("PtfmRefxt"),
            std::string::npos);
  EXPECT_EQ(error("       1025.0    WtrDens", "   \"default\"    WtrDens"), "");
}

TEST(hydrodyn_file, damaged_files_get_an_answer) {
  testing::expect_answers_to_damage(hull_file("hydrodyn"), "HydroDyn.dat", "HydroDyn.dat",
                                    testing::damage_trials() / 3);
}

}  // namespace
}  // namespace overbend

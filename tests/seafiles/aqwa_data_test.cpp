#include "seafiles/aqwa_data.h"

#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

using testing::barge_source;
using testing::hull_file;
using testing::HullReading;
using testing::read_hull;

TEST(aqwa_data, a_listing_gives_the_matrices_of_five_digits_and_forces_of_three) {
  const HullReading reading = read_hull(barge_source(hull_file("aqwa/barge.LIS")));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 6e-3, false);
  EXPECT_NEAR(reading.data->radiation[0].added_mass(0, 4), -3.6209e6, 1.0);  // not -3.62e6 of the other table
  EXPECT_EQ(reading.data->gravity, 9.80665);
}

TEST(aqwa_data, a_database_gives_seven_digits) {
  const HullReading reading = read_hull(barge_source(hull_file("aqwa/barge.AH1")));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 1e-6, false);
}

TEST(aqwa_data, a_listing_that_ends_early_is_rejected_with_its_line) {
  const HullReading reading = read_hull(barge_source(hull_file("bad/aqwa-cut.LIS")));
  EXPECT_FALSE(reading.data);
  ASSERT_EQ(reading.errors.size(), 1U);
  for (const char* part : {"aqwa-cut.LIS:678:", "damping table", "the file ends there", "12 values"}) {
    EXPECT_NE(reading.errors[0].find(part), std::string::npos) << reading.errors[0];
  }
}

TEST(aqwa_data, another_mass_or_centre_of_gravity_than_the_models_is_reported) {
  HydrodynamicsSource source = barge_source(hull_file("aqwa/barge.AH1"));
  source.mass = 10000e3;
  EXPECT_NE(read_hull(source).warnings.at(0).find("a mass of 12915 t"), std::string::npos);
  source = barge_source(hull_file("aqwa/barge.AH1"));
  source.origin_V = Vec3(3.0, 0.0, 1.5);
  EXPECT_NE(read_hull(source).errors.at(0).find("convention.file_origin"), std::string::npos);
  source.file_origin = Vec3(3.0, 0.0, 0.0);
  const HullReading moved = read_hull(source);
  ASSERT_TRUE(moved.data) << moved.errors.at(0);
  testing::expect_barge(*moved.data, 1e-6, false);
}

TEST(aqwa_data, a_structure_that_is_not_there_is_named) {
  HydrodynamicsSource source = barge_source(hull_file("aqwa/barge.LIS"));
  source.body = 2;
  EXPECT_NE(read_hull(source).errors.at(0).find("no body 2"), std::string::npos);
}

TEST(aqwa_data, damaged_files_get_an_answer) {
  testing::expect_answers_to_damage(hull_file("aqwa"), "barge.LIS", "barge.LIS", testing::damage_trials());
  testing::expect_answers_to_damage(hull_file("aqwa"), "barge.AH1", "barge.AH1", testing::damage_trials());
}

}  // namespace
}  // namespace overbend

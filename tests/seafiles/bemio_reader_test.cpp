#include "seafiles/bemio_reader.h"

#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

using testing::barge_source;
using testing::hull_file;
using testing::HullReading;
using testing::read_hull;
using testing::ScratchFolder;

TEST(bemio_reader, values_over_density_and_frequency_give_the_barge) {
  const HullReading reading = read_hull(barge_source(hull_file("bemio/barge.h5")));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
}

TEST(bemio_reader, contents_decide_whatever_the_ending) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("barge.nc", testing::read_text(hull_file("bemio/barge.h5")));
  EXPECT_TRUE(is_bemio(file));
  EXPECT_TRUE(read_hull(barge_source(file)).data);
}

TEST(bemio_reader, a_body_that_is_not_there_is_named) {
  HydrodynamicsSource source = barge_source(hull_file("bemio/barge.h5"));
  source.body = 2;
  EXPECT_NE(read_hull(source).errors.at(0).find("1 (barge)"), std::string::npos) << read_hull(source).errors.at(0);
}

TEST(bemio_reader, damaged_files_get_an_answer) {
  testing::expect_answers_to_damage(hull_file("bemio"), "barge.h5", "barge.h5", testing::damage_trials() / 3);
}

}  // namespace
}  // namespace overbend

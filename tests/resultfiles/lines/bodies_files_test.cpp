#include "resultfiles/lines/bodies_files.h"

#include <gtest/gtest.h>

#include <limits>

#include "report/synthetic_moorings.h"
#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

StaticResults with_bodies() {
  StaticResults results = testing::synthetic_lines();
  BodyResult& vessel = results.bodies.emplace_back();
  vessel.name = "vessel";
  vessel.floats = true;
  vessel.surge = 1.0 / 3.0;
  BodyResult& tug = results.bodies.emplace_back();
  tug.name = "tug";
  tug.place = Vec3(260.0, -1.0 / 7.0, 0.0);
  tug.heading = 1.5;
  tug.force = Vec3(-3e5, 2.0, 1.0);
  tug.moment = Vec3(1.0, 2.0, 1.0 / 3.0);
  return results;
}

TEST(bodies_files, at_rest_come_back_bit_for_bit) {
  const testing::TemporaryFolder folder;
  const StaticResults results = with_bodies();
  Description description;
  description.source_text = "overbend: 1";
  write_static_files(results, description, folder.path());
  const std::vector<BodyResult> read = read_static_results(folder.path() / "results.h5").results.bodies;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_TRUE(read[0].floats);
  EXPECT_EQ(read[0].surge, results.bodies[0].surge);
  EXPECT_FALSE(read[1].floats);
  EXPECT_EQ(read[1].name, "tug");
  EXPECT_EQ(read[1].place, results.bodies[1].place);
  EXPECT_EQ(read[1].heading, results.bodies[1].heading);
  EXPECT_EQ(read[1].force, results.bodies[1].force);
  EXPECT_EQ(read[1].moment, results.bodies[1].moment);
}

TEST(bodies_files, over_time_come_back_bit_for_bit) {
  const testing::TemporaryFolder folder;
  BodyDynamics tug;
  tug.name = "tug";
  tug.surge = {-1.0 / 3.0, 2.0, 0.1, 0.7};
  tug.pull = {1.0, 2.0, 1.5, 0.25};
  {
    Hdf5Writer file(folder.path() / "results.h5");
    file.group("/dynamic", "A run");
    write_bodies_in_time(file, {tug});
    file.close();
  }
  const std::vector<BodyDynamics> read = read_bodies_in_time(Hdf5Reader(folder.path() / "results.h5"));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].name, "tug");
  EXPECT_EQ(read[0].surge.min, tug.surge.min);
  EXPECT_EQ(read[0].pull.std, tug.pull.std);
}

TEST(bodies_files, stand_in_the_summary_by_list_and_by_object) {
  const Json summary = Json::parse(static_summary(with_bodies()));
  EXPECT_EQ(summary["static"]["bodies"][1]["force"]["x"], -3e5);
  EXPECT_EQ(summary["objects"]["bodies"]["vessel"]["static"]["surge"], 1.0 / 3.0);
  EXPECT_EQ(summary["objects"]["bodies"]["tug"]["static"]["heading"], 1.5);
}

TEST(bodies_files, reject_what_is_no_number) {
  StaticResults results = with_bodies();
  results.bodies[1].moment.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(require_finite(results.bodies), std::runtime_error);
}

}  // namespace
}  // namespace overbend

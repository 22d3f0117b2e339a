#include "statics/moored/anchor_move.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "moorings/mooring_fixtures.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::rest_of_hull;

/// The eight wires with the pull of a pipe; the port bow anchor goes 600 m ahead.
Description shifted() {
  Description d = eight_line_barge();
  d.vessel.loads = {vessel_load("pipe", {-60, 0, 0}, {-205.5e3, 0, 0})};
  d.has_pipe = false;
  d.operation.type = OperationType::anchor_move;
  d.operation.anchor.line = "P1";
  d.operation.anchor.to = std::array{1557.0, 432.0};
  d.operation.anchor.test_tension = 600e3;
  return d;
}

TEST(anchor_move, goes_through_its_stages_with_the_tensions_asked_for) {
  const MooringResults results = rest_of_hull(shifted());
  ASSERT_EQ(results.stages.size(), 5U);
  const double before = results.rest.moorings[4].fairlead_tension;
  const double tension[] = {50e3, 0.0, 50e3, before, 600e3};
  for (std::size_t i = 0; i < 5; ++i) {
    const MooringLineResult& line = results.stages[i].moorings[4];
    ASSERT_EQ(line.name, "P1");
    EXPECT_EQ(line.parted, i == 1);
    EXPECT_NEAR(line.fairlead_tension, tension[i], 1e-6 * tension[i]) << results.stages[i].name;
    EXPECT_LT(results.stages[i].residual, 1e-7);
  }
  EXPECT_NEAR(results.stages[4].moorings[4].anchor_W.x(), 1557.0, 1e-9);
  EXPECT_NEAR(results.stages[4].moorings[4].anchor_W.z(), -89.0, 1e-9);
}

TEST(anchor_move, without_its_line_is_the_rest_of_the_other_seven) {
  const Description d = shifted();
  const MooringResults moved = rest_of_hull(d);
  Description parted = d;
  parted.operation = {};
  parted.operation.type = OperationType::moored;
  parted.operation.stages = {{"parted", {}, {"P1"}}};
  const MooringResults seven = rest_of_hull(parted);
  EXPECT_NEAR(moved.stages[1].vessel.surge, seven.stages[0].vessel.surge, 1e-6);
  EXPECT_NEAR(moved.stages[1].vessel.sway, seven.stages[0].vessel.sway, 1e-6);
  EXPECT_NEAR(moved.stages[1].vessel.yaw, seven.stages[0].vessel.yaw, 1e-8);
}

TEST(anchor_move, back_to_the_same_place_changes_nothing) {
  Description d = shifted();
  d.operation.anchor.test_tension.reset();
  d.operation.anchor.to.reset();
  d.operation.anchor.bearing = *d.moorings->lines[4].azimuth - d.vessel.heading;
  d.operation.anchor.anchor_distance = d.moorings->lines[4].anchor_distance;
  const MooringResults results = rest_of_hull(d);
  ASSERT_EQ(results.stages.size(), 4U);
  EXPECT_NEAR(results.stages[3].vessel.surge, results.rest.vessel.surge, 1e-6);
  EXPECT_NEAR(results.stages[3].vessel.yaw, results.rest.vessel.yaw, 1e-8);
  EXPECT_NEAR(results.winches[4].after, results.winches[4].before, 1e-5);
}

}  // namespace
}  // namespace overbend

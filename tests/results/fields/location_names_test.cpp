#include "results/fields/location_names.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace overbend {
namespace {

TEST(places, midship_is_where_the_mooring_lines_hold_it) {
  StaticResults results;
  EXPECT_EQ(midship(results), Vec3::Zero());
  // Drawn with the bow to the north; 2 m ahead, 1 m to port, turned to port by 0.1 rad.
  results.moorings.emplace();
  results.moorings->rest.vessel.surge = 2.0;
  results.moorings->rest.vessel.sway = 1.0;
  results.moorings->rest.vessel.heave = -0.02;
  results.moorings->rest.vessel.yaw = 0.1;
  results.R_WV = Eigen::AngleAxisd(0.5 * std::numbers::pi + 0.1, Vec3::UnitZ()).toRotationMatrix();
  EXPECT_LT((midship(results) - Vec3(-1.0, 2.0, -0.02)).norm(), 1e-12);
}

}  // namespace
}  // namespace overbend

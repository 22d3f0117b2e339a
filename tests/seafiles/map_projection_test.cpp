#include "seafiles/map_projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

TEST(map_projection, gives_the_places_of_the_local_tangent_plane) {
  struct Place {
    double lat, lon, east, north;
  };
  for (const Place& place : {Place{58.2625, 3.14166666666667, 978.325, 1392.398},
                             Place{58.23333333333333, 3.08333333333333, -2447.821, -1855.608},
                             Place{58.2958333333333, 3.1666666666667, 2443.515, 5105.784}}) {
    const PlanPoint point =
        tangent_plane_point(place.lat * kDegree, place.lon * kDegree, 58.25 * kDegree, 3.125 * kDegree);
    EXPECT_NEAR(point.east, place.east, 1.0);
    EXPECT_NEAR(point.north, place.north, 1.0);
  }
}

TEST(map_projection, turns_depths_to_the_north_of_the_model) {
  // the model's north points to the map's east
  Bathymetry depths{{10.0, 0.0}, {0.0, 10.0}, {5.0, 6.0}, 2, 1};
  turn_depths(depths, 90.0 * kDegree);
  EXPECT_NEAR(depths.east[0], 0.0, 1e-12);
  EXPECT_NEAR(depths.north[0], 10.0, 1e-12);
  EXPECT_NEAR(depths.east[1], -10.0, 1e-12);
  EXPECT_EQ(depths.columns, 0);
}

}  // namespace
}  // namespace overbend

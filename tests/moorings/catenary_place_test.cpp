#include <gtest/gtest.h>

#include "moorings/catenary.h"

namespace overbend {
namespace {

/// A rope with a clump, and chain behind it; out of the water at the fairlead.
CatenaryLine rope_and_chain() {
  CatenaryLine line;
  line.pieces = {{60.0, 300.0, 45.0, 6e7, 0.6}, {200.0, 300.0, 45.0, 6e7, 0.6}, {650.0, 1200.0, 1000.0, 4e8, 0.3}};
  CatenaryPoint clump;
  clump.behind = 0;
  clump.pull_up = -20e3;
  line.points = {clump};
  return line;
}

CatenarySite site() {
  CatenarySite place;
  place.fairlead_z = 4.0;
  place.anchor_z = place.bed_z = -120.0;
  return place;
}

double compute_end_tension(const CatenaryPlace& catenary_place, double EA) {
  return EA * (std::hypot(catenary_place.along, catenary_place.upwards) - 1.0);
}

TEST(catenary_place, goes_from_the_fairlead_to_the_anchor) {
  const CatenaryLine line = rope_and_chain();
  const double distance = 896.0;
  const CatenarySolution found = solve_catenary(line, site(), distance);
  ASSERT_EQ(found.error, CatenaryError::none);
  const CatenaryPlace top = catenary_place(line, found, 0.0), end = catenary_place(line, found, line.length());
  EXPECT_NEAR(top.x, 0.0, 1e-9);
  EXPECT_NEAR(top.z, 4.0, 1e-9);
  EXPECT_NEAR(compute_end_tension(top, 6e7), found.tension(), 1e-6 * found.tension());
  EXPECT_NEAR(end.x, distance, 1e-6);
  EXPECT_NEAR(end.z, -120.0, 1e-6);
  EXPECT_TRUE(end.lies);
  // The tension that friction leaves at the anchor is that of the solution.
  EXPECT_NEAR(compute_end_tension(end, 4e8), found.anchor_pull, 1e-4 * found.pull);
  EXPECT_GT(found.anchor_pull, 0.1 * found.pull);
}

TEST(catenary_place, has_the_derivatives_of_its_places) {
  const CatenaryLine line = rope_and_chain();
  const CatenarySolution found = solve_catenary(line, site(), 896.0);
  const double step = 1e-3;
  for (double s = 5.0; s < line.length() - 1.0; s += 7.3) {
    const CatenaryPlace at_place = catenary_place(line, found, s), before = catenary_place(line, found, s - step),
                        after = catenary_place(line, found, s + step);
    EXPECT_NEAR((after.x - before.x) / (2.0 * step), at_place.along, 2e-5) << s;
    EXPECT_NEAR((after.z - before.z) / (2.0 * step), at_place.upwards, 2e-5) << s;
  }
}

TEST(catenary_place, lies_unstretched_where_friction_has_taken_the_whole_tension) {
  CatenaryLine line = rope_and_chain();
  for (CatenaryPiece& piece : line.pieces) piece.friction = 3.0;
  const CatenarySolution found = solve_catenary(line, site(), 880.0);
  ASSERT_LT(found.anchor_pull, 1e-3);
  EXPECT_DOUBLE_EQ(catenary_place(line, found, line.length()).along, 1.0);
  EXPECT_NEAR(catenary_place(line, found, line.length()).x, 880.0, 1e-6);
}

}  // namespace
}  // namespace overbend

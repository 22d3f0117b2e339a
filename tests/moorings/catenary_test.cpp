#include "moorings/catenary.h"

#include <gtest/gtest.h>

#include "moorings/mooring_fixtures.h"
#include "support/allocation_count.h"

namespace overbend {
namespace {

CatenaryLine plain_line(double length, double weight, double EA, double friction = 0.0) {
  CatenaryLine line;
  line.pieces = {{length, weight, weight, EA, friction}};
  return line;
}

/// Deep under water, the anchor at `bed_below` over the bed.
CatenarySite deep_site(double rise, double bed_below = 0.0) {
  CatenarySite site;
  site.anchor_z = -1000.0;
  site.fairlead_z = site.anchor_z + rise;
  site.bed_z = site.anchor_z - bed_below;
  return site;
}

struct MoorPyRow {
  double X, Z, L, EA, w, friction, bed_below;
  double anchor_pull, anchor_rise, pull, sink, on_bed;
};

// NREL/MoorPy, tests/test_catenary.py; the sixth row as the formulas give it (MoorPy falls back on an approximation).
const MoorPyRow kMoorPy[] = {
    {400, 200, 500, 7.51e12, 800, 5.0, 0, 0, 0, 96643.43501616, 237751.75997440, 202.810300030},
    {400, 200, 500, 7.51e12, 800, 0.0, 0, 96643.42815934, 0, 96643.42815934, 237751.75535996, 202.810305800},
    {400, 200, 500, 7.51e12, 800, 0.1, 0, 80418.60434855, 0, 96643.42877137, 237751.75577184, 202.810305285},
    {400, 200, 500, 7.51e12, 200, 0.0, 372.7, 43694.58098925, -22365.59935022, 43694.58098925, 77634.40064978, 0},
    {246.22420940032947, 263.55766330843164, 360.62566262396927, 7e8, 3.08735, 0, 0, 71116.8, 75567.3, 71116.8, 76680.6,
     0},
    {246.22420940032947, 263.55766330843164, 360.63566262396927, 7e8, 3.08735, 0, 0, 58377.24, 61931.00, 58377.24,
     63044.41, 0},
    {246.22420940032947, 263.55766330843164, 360.64566262396927, 7e8, 3.08735, 0, 0, 46077.1, 48765.2, 46077.1, 49878.6,
     0},
    {119.3237383002058, 52.49668849178113, 130.36140355177318, 7e8, 34.91060469991227, 0, 0, 72694.145, 29715.173,
     72694.145, 34266.168, 0},
};

TEST(catenary, is_that_of_moorpy) {
  for (const MoorPyRow& row : kMoorPy) {
    const CatenarySolution found =
        solve_catenary(plain_line(row.L, row.w, row.EA, row.friction), deep_site(row.Z, row.bed_below), row.X);
    ASSERT_EQ(found.error, CatenaryError::none);
    const double tolerance = 1e-5 * row.pull;
    EXPECT_NEAR(found.pull, row.pull, tolerance);
    EXPECT_NEAR(found.sink, row.sink, tolerance);
    EXPECT_NEAR(found.anchor_pull, row.anchor_pull, tolerance);
    EXPECT_NEAR(found.anchor_uplift, row.anchor_rise, tolerance);
    EXPECT_NEAR(found.trace.on_bed, row.on_bed, 1e-5 * row.L);
  }
}

TEST(catenary, gives_the_published_tensions_of_three_floating_turbines) {
  struct Deck {
    double X, Z, L, w, EA, tension;
  };
  // ITI barge, OC4 semisubmersible, OC3 spar: public decks, closed form.
  for (const Deck& deck : {Deck{397.150, 146, 473.312, 1227.147, 5.89e8, 274.224e3},
                           Deck{796.732, 186, 835.35, 1065.261, 7.536e8, 1105.373e3},
                           Deck{848.67, 250, 902.2, 698.094, 3.84243e8, 911.088e3}}) {
    const CatenarySolution found = solve_catenary(plain_line(deck.L, deck.w, deck.EA), deep_site(deck.Z), deck.X);
    EXPECT_NEAR(found.tension(), deck.tension, 1e-4 * deck.tension);
  }
}

TEST(catenary, follows_the_pull_curve_of_a_barge_wire) {
  // 64 mm wire: 16.342 kg/m less its water, six figures of the table for a tension of 300 kN at 1,000 m.
  const CatenaryLine line = plain_line(1007.339, barge_wire_submerged(), 4.04e10 * 0.064 * 0.064);
  const double rows[][3] = {{990, 72.49, 85.32},    {995, 135.25, 148.09},  {998, 209.70, 222.53},
                            {1000, 287.17, 299.99}, {1002, 395.70, 408.51}, {1004, 540.48, 553.29},
                            {1006, 721.72, 734.51}};
  for (const auto& row : rows) {
    const CatenarySolution found = solve_catenary(line, deep_site(92.0), row[0]);
    EXPECT_NEAR(found.pull / 1e3, row[1], 1e-4 * row[1]) << row[0];
    EXPECT_NEAR(found.tension() / 1e3, row[2], 1e-4 * row[2]) << row[0];
  }
}

/// Stiffness against central differences.
void expect_stiffness(const CatenaryLine& line, const CatenarySite& site, double distance) {
  const double step = 1e-3;
  const CatenarySolution catenary_solution = solve_catenary(line, site, distance);
  ASSERT_EQ(catenary_solution.error, CatenaryError::none);
  const double scale = catenary_solution.stiffness.cwiseAbs().maxCoeff();
  const auto compare = [&](const CatenarySolution& more, const CatenarySolution& less, const Eigen::Vector2d& slope) {
    EXPECT_NEAR((more.pull - less.pull) / (2.0 * step), slope[0], 1e-4 * scale);
    EXPECT_NEAR((more.sink - less.sink) / (2.0 * step), slope[1], 1e-4 * scale);
  };
  compare(solve_catenary(line, site, distance + step), solve_catenary(line, site, distance - step),
          catenary_solution.stiffness.col(0));
  CatenarySite higher = site, lower = site;
  higher.fairlead_z += step;
  lower.fairlead_z -= step;
  compare(solve_catenary(line, higher, distance), solve_catenary(line, lower, distance),
          catenary_solution.stiffness.col(1));
  CatenaryLine longer = line, shorter = line;
  longer.pieces[0].length += step;
  shorter.pieces[0].length -= step;
  compare(solve_catenary(longer, site, distance), solve_catenary(shorter, site, distance), catenary_solution.by_length);
}

/// Fairlead 3.8 m above the water, 89 m deep.
CatenarySite barge_site() {
  CatenarySite site;
  site.fairlead_z = 3.8;
  site.anchor_z = site.bed_z = -89.0;
  return site;
}

CatenaryLine buoyed_line() {
  CatenaryLine line;
  line.pieces = {{700.0, 170.0, 148.0, 190e6, 0.6}, {300.0, 170.0, 148.0, 190e6, 0.6}};
  line.points = {{0, 20e3, 30e3, 2.0, 0.0, BuoyShape::sphere}};
  return line;
}

TEST(catenary, has_the_stiffness_of_its_differences) {
  expect_stiffness(plain_line(500, 800, 7.51e9, 0.1), deep_site(200), 400);
  expect_stiffness(plain_line(500, 200, 7.51e9), deep_site(200, 372.7), 400);
  CatenaryLine wire = plain_line(1000, 148, 190e6);
  wire.pieces[0].weight_in_air = 170;
  for (const double distance : {950.0, 990.0, 994.0, 1002.0}) expect_stiffness(wire, barge_site(), distance);
  for (const double distance : {990.0, 995.0, 998.0}) expect_stiffness(buoyed_line(), barge_site(), distance);
}

TEST(catenary, a_buoy_lifts_the_line_from_the_bed_and_its_weight_lies_again) {
  const CatenarySolution found = solve_catenary(buoyed_line(), barge_site(), 990.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  EXPECT_EQ(found.trace.span_count, 2);
  EXPECT_TRUE(found.trace.ends_on_bed);
  double highest_behind = -1e9;
  for (const Eigen::Vector2d& point : catenary_shape(buoyed_line(), found, 20)) {
    EXPECT_GE(point.y(), -89.0 - 1e-6);
    if (point.x() > found.trace.touchdown_x) highest_behind = std::max(highest_behind, point.y());
  }
  EXPECT_GT(highest_behind, -88.0);
  // The arch is suspended from the buoy: its weight is the buoy's lift.
  const CatenarySpan& arch = found.trace.spans[1];
  const double lifted = (700.0 - arch.from.into.v) + arch.to.into.v;
  EXPECT_NEAR(148.0 * lifted, 20e3, 1.0);
  // Friction of what lies before and behind.
  EXPECT_LT(found.anchor_pull, found.pull - 0.6 * 148.0 * 100.0);
}

TEST(catenary, friction_that_holds_the_line_leaves_the_buoy_upright) {
  const CatenarySolution found = solve_catenary(buoyed_line(), barge_site(), 960.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  EXPECT_NEAR(found.anchor_pull, 0.0, 1.0);
}

TEST(catenary, a_heavy_clump_holds_down_what_lies_behind) {
  CatenaryLine line = buoyed_line();
  line.points[0].pull_up = -50e3;
  line.points[0].buoyancy = 0.0;
  const CatenarySolution found = solve_catenary(line, barge_site(), 998.0);
  const CatenarySolution without = solve_catenary(plain_line(1000, 148, 190e6, 0.6), barge_site(), 998.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  EXPECT_GT(found.trace.on_bed, without.trace.on_bed + 50.0);
  EXPECT_GT(found.stiffness(0, 0), without.stiffness(0, 0));
}

TEST(catenary, a_clump_on_a_tether_is_suspended_only_where_the_line_is_higher_than_the_tether_is_long) {
  CatenaryLine line = buoyed_line();
  line.pieces[0].length = 150.0;
  line.pieces[1].length = 850.0;
  line.points = {{0, -45e3, 0.0, 0.0, 0.0, BuoyShape::sphere}};
  CatenaryLine tethered = line, bare = line;
  tethered.points[0].tether = 30.0;
  bare.points.clear();
  const auto sample = [](const CatenaryLine& catenary_line, double distance) {
    return solve_catenary(catenary_line, barge_site(), distance);
  };
  for (const double distance : {970.0, 980.0}) {  // it lies under the line
    EXPECT_NEAR(sample(tethered, distance).pull, sample(bare, distance).pull, 1e-6 * sample(bare, distance).pull);
    EXPECT_GT(sample(line, distance).pull, 1.05 * sample(bare, distance).pull);
  }
  const CatenarySolution taut = sample(tethered, 1004.0);  // the line is 30 m and more above the bed there
  ASSERT_GT(catenary_place(line, sample(line, 1004.0), 150.0).z, -59.0 + 0.1);
  EXPECT_NEAR(taut.pull, sample(line, 1004.0).pull, 1e-9 * taut.pull);
  for (const double distance : {970.0, 990.0, 1000.0, 1004.0}) expect_stiffness(tethered, barge_site(), distance);
}

TEST(catenary, one_line_is_the_same_in_pieces) {
  const CatenarySolution whole = solve_catenary(plain_line(1000, 148, 190e6, 0.3), barge_site(), 990.0);
  CatenaryLine line;
  for (const double length : {300.0, 250.0, 450.0}) line.pieces.push_back({length, 148, 148, 190e6, 0.3});
  const CatenarySolution parts = solve_catenary(line, barge_site(), 990.0);
  EXPECT_NEAR(parts.pull, whole.pull, 1e-8 * whole.pull);
  EXPECT_NEAR(parts.sink, whole.sink, 1e-8 * whole.pull);
  EXPECT_NEAR(parts.anchor_pull, whole.anchor_pull, 1e-8 * whole.pull);
}

TEST(catenary, a_line_between_raised_ends_may_lie_in_its_middle) {
  // Mirrored: the bed part of a symmetrical line lies in its middle, each half like a line to an anchor there.
  CatenarySite site;
  site.fairlead_z = -40.0;
  site.anchor_z = -40.0;
  site.bed_z = -89.0;
  const CatenarySolution found = solve_catenary(plain_line(400, 148, 190e6), site, 370.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  EXPECT_GT(found.trace.on_bed, 10.0);
  site.anchor_z = -89.0;
  const CatenarySolution half = solve_catenary(plain_line(200, 148, 190e6), site, 185.0);
  EXPECT_NEAR(found.pull, half.pull, 1e-7 * half.pull);
  EXPECT_NEAR(found.sink, half.sink, 1e-7 * half.sink);
  EXPECT_NEAR(found.anchor_uplift, -half.sink, 1e-7 * half.sink);
}

TEST(catenary, a_buoyant_line_rises_from_its_anchor) {
  CatenarySite site = barge_site();
  site.fairlead_z = -60.0;
  const CatenarySolution found = solve_catenary(plain_line(258, -30, 5e7), site, 250.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  // Upside down it is a heavy line.
  const CatenarySolution heavy = solve_catenary(plain_line(258, 30, 5e7), deep_site(-29.0, 900.0), 250.0);
  EXPECT_NEAR(found.pull, heavy.pull, 1e-7 * heavy.pull);
  EXPECT_NEAR(found.sink, -heavy.sink, 1e-7 * heavy.pull);
}

TEST(catenary, a_slack_line_is_suspended_from_its_fairlead) {
  const CatenarySolution found = solve_catenary(plain_line(1000, 148, 190e6), barge_site(), 500.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  EXPECT_TRUE(found.slack);
  EXPECT_EQ(found.pull, 0.0);
  EXPECT_NEAR(found.sink, 148.0 * 92.8, 2.0);
}

TEST(catenary, says_what_cannot_be) {
  EXPECT_EQ(solve_catenary(plain_line(500, 148, 190e6), barge_site(), 990.0).error, CatenaryError::too_short);
  CatenarySite below = barge_site();
  below.fairlead_z = -90.0;
  CatenarySite shallow = barge_site();
  shallow.fairlead_z = -5.0;
  CatenaryLine floating = plain_line(300, -30, 5e7);
  floating.pieces[0].weight_in_air = 40.0;
  EXPECT_EQ(solve_catenary(floating, shallow, 250.0).error, CatenaryError::no_shape);
  EXPECT_EQ(solve_catenary(plain_line(1000, 148, 190e6), below, 990.0).error, CatenaryError::below_bed);
}

TEST(catenary, on_a_falling_bed_weight_helps_to_hold_the_line) {
  CatenarySite slope = barge_site();
  slope.bed_descent = std::tan(0.05);  // down towards the anchor
  slope.anchor_z = slope.bed_z - slope.bed_descent * 990.0;
  const CatenarySolution found = solve_catenary(plain_line(1003, 148, 190e6), slope, 990.0);
  ASSERT_EQ(found.error, CatenaryError::none);
  ASSERT_TRUE(found.trace.ends_on_bed);
  // Along the bed the tension falls by the weight of the height.
  const double at_touchdown = std::hypot(found.pull, found.pull * slope.bed_descent);
  const double at_anchor = std::hypot(found.trace.end.pull.v, found.trace.end.sink.v);
  EXPECT_NEAR(at_touchdown - at_anchor, 148.0 * found.trace.on_bed * std::sin(0.05), 1.0);
  EXPECT_NEAR(found.anchor_tension(), at_anchor, 1e-9 * at_anchor);  // along the line, not its horizontal part
  EXPECT_EQ(found.anchor_uplift, 0.0);
}

TEST(catenary, a_taut_line_on_a_sloping_bed_has_a_shape_for_every_pull) {
  // If its last metres just lift, the end and what lies before it are on the same bed.
  CatenaryLine line;
  line.pieces = {{155.2993, 255.01, 222.08, 2.633e8, 0.6}, {391.9959, 255.01, 222.08, 2.633e8, 0.6}};
  line.points = {{0, -6918.84, 0.0, 2.0, 0.0, BuoyShape::sphere}};
  CatenarySite site;
  site.fairlead_z = 2.039;
  site.anchor_z = -96.592;
  site.bed_z = -102.489;
  site.bed_descent = -0.010908;
  double last = 0.0;
  for (double pull = 2e5; pull < 6e5; pull *= 1.0007) {
    const CatenaryGeometry trace = compute_catenary_geometry(line, site, pull, pull);
    ASSERT_EQ(trace.error, GeometryError::none) << pull;
    EXPECT_GT(trace.reach.v, last);
    last = trace.reach.v;
  }
}

TEST(catenary, lengths_give_the_wanted_pull_and_tension) {
  CatenaryLine line = plain_line(0.0, 148, 190e6);
  line.pieces[0].weight_in_air = 170;
  const CatenarySolution found = set_length_for_tension(line, barge_site(), 990.0, 300e3);
  EXPECT_NEAR(line.pieces[0].length, 997.990755253, 1e-6);  // collocation, reference case MO1 line D
  EXPECT_NEAR(found.pull, 286203.28337, 0.01);
  line.pieces[0].length = 0.0;
  set_length_for_pull(line, barge_site(), 990.0, found.pull);
  EXPECT_NEAR(line.pieces[0].length, 997.990755253, 1e-6);
}

TEST(catenary, needs_no_memory_from_the_heap) {
  const CatenaryLine line = buoyed_line();
  const CatenarySite site = barge_site();
  const CatenarySolution near = solve_catenary(line, site, 990.0);
  const long before = testing::allocation_count();
  const CatenarySolution found = solve_catenary(line, site, 990.1, &near);
  EXPECT_EQ(testing::allocation_count(), before);
  EXPECT_GT(found.pull, near.pull);
}

}  // namespace
}  // namespace overbend

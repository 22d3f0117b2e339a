#include "system/find_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;
using testing::TimedLay;

/// A line of 100 m, a station every metre.
struct Profile {
  std::vector<double> s, moment, vertical;

  template <class Moment>
  explicit Profile(Moment moment_at) {
    for (int i = 0; i <= 100; ++i) {
      s.push_back(i);
      vertical.push_back(moment_at(static_cast<double>(i)));
      moment.push_back(std::abs(vertical.back()));
    }
  }
  BendingProfile view() const { return {s, moment, vertical}; }
};

TEST(find_regions, the_overbend_ends_where_the_pipe_first_sags_below_its_last_support) {
  const Profile line([](double s) { return s < 70.0 ? 1.0 : -1.0; });
  const Regions regions = find_regions(line.view(), 20.0, 80.0, true);
  EXPECT_EQ(regions.inflection, 69.0);
  EXPECT_EQ(regions.of(19.0), Region::seabed);
  EXPECT_EQ(regions.of(20.0), Region::sagbend);
  EXPECT_EQ(regions.of(69.0), Region::sagbend);
  EXPECT_EQ(regions.of(75.0), Region::overbend);  // hangs free and still hogs
  EXPECT_EQ(regions.code_check_region(75.0), CheckRegion::tip);
  EXPECT_EQ(regions.code_check_region(80.0), CheckRegion::overbend);
  EXPECT_EQ(regions.of(100.0), Region::overbend);
}

TEST(find_regions, a_pipe_that_hogs_down_to_the_bed_has_its_sagbend_there) {
  const Profile line([](double s) { return s < 10.0 ? 1.0 : -1.0; });
  const Regions regions = find_regions(line.view(), 20.0, 80.0, true);
  EXPECT_EQ(regions.of(20.0), Region::sagbend);
  EXPECT_EQ(regions.of(21.0), Region::overbend);
}

TEST(find_regions, the_tower_ends_where_the_moment_of_a_clamped_guide_has_died_away) {
  const auto sagging = [](double s) { return 1e-4 * (100.0 - s) * s; };
  for (const double clamp : {-5.0, 5.0}) {  // held too flat and too steep
    const Profile line([&](double s) { return sagging(s) + clamp * std::exp((s - 100.0) / 5.0); });
    const Regions regions = find_regions(line.view(), 20.0, std::nullopt, true);
    EXPECT_EQ(regions.of(100.0), Region::tower);
    EXPECT_NEAR(regions.inflection, 80.0, 12.0);  // a few of the 5 m over which the clamp's moment dies away
    EXPECT_EQ(regions.of(50.0), Region::sagbend);
  }
  const Profile free([&](double s) { return sagging(s); });
  EXPECT_EQ(find_regions(free.view(), 20.0, std::nullopt, false).of(100.0), Region::sagbend);
}

void expect_one_story(const StaticResults& r) {
  double upper = 0.0, sagbend = 0.0;
  for (const Station& station : r.stations) {
    if (station.region == Region::overbend || station.region == Region::tower)
      upper = std::max(upper, station.von_mises);
    if (station.region == Region::sagbend) sagbend = std::max(sagbend, station.von_mises);
  }
  const RegionResult* top = r.overbend ? &*r.overbend : r.tower ? &*r.tower : nullptr;
  EXPECT_DOUBLE_EQ(upper, top == nullptr ? 0.0 : top->von_mises.value);
  EXPECT_DOUBLE_EQ(sagbend, r.sagbend.von_mises.value);
}

TEST(find_regions, stations_extremes_and_checks_agree) {
  const StaticResults& r = solved_case("S16-T300").results;
  expect_one_story(r);
  bool tip = false;
  for (const Station& station : r.stations) {
    if (station.s < r.departure_s && station.s > r.inflection_s) {
      tip = true;
      EXPECT_EQ(station.region, Region::overbend) << station.s;
      EXPECT_LE(station.vertical_moment, 0.0) << station.s;
    }
  }
  EXPECT_TRUE(tip);
  for (const CheckRow& row : r.checks.rows) {
    if (row.region == CheckRegion::line || row.status == CheckStatus::not_done) continue;
    if (row.region == CheckRegion::tip && row.s == r.departure_s) continue;     // where it begins
    if (row.region == CheckRegion::seabed && row.s == r.touchdown.s) continue;  // where it ends
    EXPECT_EQ(row.region, regions(r).code_check_region(row.s)) << row.id;
  }
  expect_one_story(solved_case("J12-D400-T560").results);
  EXPECT_FALSE(solved_case("J12-D400-T560").results.tower);
}

/// A J-lay in a tower that holds it far from its natural angle.
Description clamped() {
  Description d = solved_case("J12-D400-T560").description;
  d.tensioner.guide = Guide::clamped;
  d.tensioner.incline = 40.0 * std::numbers::pi / 180.0;
  return d;
}

TEST(find_regions, the_moment_at_a_clamped_guide_of_a_j_lay_is_the_towers) {
  const TimedLay c(clamped());
  const StaticResults& r = c.statics;
  expect_one_story(r);
  ASSERT_TRUE(r.tower);
  EXPECT_DOUBLE_EQ(r.tower->bending_moment.s, r.total_length);
  EXPECT_DOUBLE_EQ(r.tower->bending_moment.value, r.stations.back().bending_moment);
  EXPECT_GT(r.tower->bending_moment.value, 2.0 * r.sagbend.bending_moment.value);
  // Along a frictionless rod N + M^2/(2 EI) + hanging weight is constant: all that the sagbend knows of the guide is
  // the tension that its moment adds.
  const StaticResults& pinned = solved_case("J12-D400-T560").results;
  const double added = 0.5 * std::pow(r.tower->bending_moment.value, 2) / r.sections[0].EI;
  EXPECT_NEAR(r.bottom_tension - pinned.bottom_tension, added, 0.02 * added);
  EXPECT_LT(r.sagbend.bending_moment.value, pinned.sagbend.bending_moment.value);
  const auto of_tower = [](const CheckRow& row) { return row.region == CheckRegion::tower; };
  EXPECT_TRUE(std::any_of(r.checks.rows.begin(), r.checks.rows.end(), of_tower));
}

TEST(find_regions, a_run_at_rest_has_the_regions_of_statics) {
  for (const bool j_lay : {true, false}) {
    Description d = j_lay ? clamped() : testing::workable();
    d.vessel.motion = VesselMotion::fixed;
    d.environment.waves.front() = {};
    d.dynamics = DynamicSettings{};
    d.dynamics->duration = d.dynamics->build_up = 1.0;
    const TimedLay c(d);
    testing::EmptySink sink;
    const DynamicResults r = c.results(sink);
    const DynamicRegion& upper = j_lay ? r.tower : r.overbend;
    const RegionResult& before = j_lay ? c.statics.tower.value() : c.statics.overbend.value();
    // Both recover from the same shape, dynamics at the nodes alone.
    EXPECT_NEAR(upper.bending_moment.over_time.max, before.bending_moment.value, 0.03 * before.bending_moment.value);
    EXPECT_NEAR(r.sagbend.bending_moment.over_time.max, c.statics.sagbend.bending_moment.value,
                0.02 * c.statics.sagbend.bending_moment.value);
    EXPECT_NEAR(r.min_effective_tension.over_time.min, c.statics.min_effective_tension.value, 1e3);
  }
}

}  // namespace
}  // namespace overbend

#include "moorings/anchor_plan.h"

#include <gtest/gtest.h>

#include <set>

#include "moorings/bgl1_spread.h"

namespace overbend {
namespace {

/// The barge east along its route by joints of 12 m; every line useful between the same lengths.
struct Route : MooredCase {
  std::vector<LineUsefulRange> useful;
  AnchorRoute route{Vec3(12.0, 0.0, 0.0), 200};

  explicit Route(const UsefulRange& range) : MooredCase(moored_case(bgl1_barge())) {
    std::vector<CatenarySolution> drawn;
    hull_forces(spread, hull, HullOffset::Zero(), drawn);
    for (const CatenarySolution& line : drawn) useful.push_back({range, line.pull});
  }
  AnchorSchedule plan() const { return plan_anchors(spread, hull.axes_WD, useful, route); }
};

UsefulRange between(double min_value, double max_value) {
  UsefulRange range;
  range.min_length = min_value;
  range.max_length = max_value;
  return range;
}

TEST(anchor_plan, keeps_every_line_in_its_useful_range_on_the_whole_route) {
  Route route(between(500.0, 1400.0));
  const AnchorSchedule schedule = route.plan();
  ASSERT_FALSE(schedule.error) << *schedule.error;
  ASSERT_FALSE(schedule.shifts.empty());
  std::set<int> joints;
  for (const AnchorMove& shift : schedule.shifts) {
    EXPECT_TRUE(joints.insert(shift.joint).second) << "two anchors up at joint " << shift.joint;
    EXPECT_GT(shift.to_W.x(), shift.from_W.x());
    EXPECT_NEAR(shift.to_W.z(), -89.0, 1e-9);
  }
  auto next = schedule.shifts.begin();
  MooringSpread mooring_spread = route.spread;
  for (int laid = 0; laid <= route.route.joints; ++laid) {
    for (std::size_t i = 0; i < mooring_spread.lines.size(); ++i) {
      const Vec3 fairlead =
          route.hull.axes_WD * mooring_spread.lines[i].fairlead_V + static_cast<double>(laid) * route.route.step_W;
      double length = 0.0;
      EXPECT_EQ(find_exceeded_bound(mooring_spread, mooring_spread.lines[i], route.useful[i], 0.0, fairlead, length),
                nullptr)
          << laid << " " << i;
    }
    for (; next != schedule.shifts.end() && next->joint == laid + 1; ++next)
      mooring_spread.lines[next->line].anchor_W = next->to_W;
  }
  EXPECT_EQ(next, schedule.shifts.end());
}

/// A bow line with its pull kept: its part on the bed becomes shorter, and stretches less.
TEST(anchor_plan, moves_an_anchor_when_its_line_has_become_as_short_as_it_may) {
  Route route({});
  const double stretch = route.useful[0].pull / (4.04e10 * 0.064 * 0.064);
  const double excess = route.spread.lines[0].line.length() - 1000.0;  // over the distance, at 1000 m
  route.useful[0].range = between(705.0 + excess + 295.0 * stretch, 1400.0);
  const AnchorSchedule schedule = route.plan();
  ASSERT_FALSE(schedule.error) << *schedule.error;
  ASSERT_FALSE(schedule.shifts.empty());
  const AnchorMove& first = schedule.shifts.front();
  // Abreast by 1000 sin 25 deg, 705 m away in all: ahead by 564.3 m, after 906.3 - 564.3 m.
  EXPECT_EQ(first.joint, static_cast<int>((906.3 - 564.3) / 12.0) + 1);
  EXPECT_STREQ(first.reason, "least length");
  EXPECT_EQ(first.line, 0U);
  EXPECT_LE(first.length, 1400.0);
  EXPECT_GT(first.length, 1400.0 - 12.0);  // another joint ahead it would be longer than it may
}

TEST(anchor_plan, moves_an_anchor_when_its_line_leaves_its_sector) {
  Route route({});
  UsefulRange sector;
  sector.sector = 0.35;
  sector.max_length = 1300.0;
  route.useful[1].range = sector;
  const AnchorSchedule schedule = route.plan();
  ASSERT_FALSE(schedule.error) << *schedule.error;
  ASSERT_FALSE(schedule.shifts.empty());
  EXPECT_STREQ(schedule.shifts.front().reason, "sector");
  // Abreast by 1000 sin 65 deg, from 65 deg to 65 deg + 0.35.
  const double abreast = 1000.0 * std::sin(65.0 / 57.29577951308232);
  const double ahead = abreast / std::tan(65.0 / 57.29577951308232 + 0.35);
  EXPECT_EQ(schedule.shifts.front().joint,
            static_cast<int>((1000.0 * std::cos(65.0 / 57.29577951308232) - ahead) / 12.0) + 1);
}

TEST(anchor_plan, says_which_line_has_no_place_of_use) {
  Route route({});
  route.useful[3].range = between(1100.0, 1400.0);
  const AnchorSchedule schedule = route.plan();
  ASSERT_TRUE(schedule.error);
  EXPECT_NE(schedule.error->find("outside its useful range in the nominal position"), std::string::npos);
}

}  // namespace
}  // namespace overbend

#include "moorings/anchor_plan.h"

#include <gtest/gtest.h>

#include <set>

#include "moorings/bgl1_spread.h"

namespace overbend {
namespace {

/// The barge east along its route by joints of 12 m; every line useful between the same lengths.
struct Route : MooredCase {
  std::vector<UsefulLine> useful;
  AnchorRoute route{Vec3(12.0, 0.0, 0.0), 200};

  explicit Route(const UsefulRange& range) : MooredCase(moored_case(bgl1_barge())) {
    std::vector<CatenarySolution> drawn;
    hull_forces(spread, hull, HullOffset::Zero(), drawn);
    for (const CatenarySolution& line : drawn) useful.push_back({range, line.pull});
  }
  AnchorSchedule plan() const { return plan_anchors(spread, hull.axes_WD, useful, route); }
};

UsefulRange between(double least, double most) {
  UsefulRange range;
  range.least_length = least;
  range.most_length = most;
  return range;
}

TEST(anchor_plan, keeps_every_line_in_its_useful_range_on_the_whole_route) {
  Route at(between(500.0, 1400.0));
  const AnchorSchedule schedule = at.plan();
  ASSERT_FALSE(schedule.fault) << *schedule.fault;
  ASSERT_FALSE(schedule.shifts.empty());
  std::set<int> joints;
  for (const AnchorShift& shift : schedule.shifts) {
    EXPECT_TRUE(joints.insert(shift.joint).second) << "two anchors up at joint " << shift.joint;
    EXPECT_GT(shift.to_W.x(), shift.from_W.x());
    EXPECT_NEAR(shift.to_W.z(), -89.0, 1e-9);
  }
  auto next = schedule.shifts.begin();
  MooringSpread now = at.spread;
  for (int laid = 0; laid <= at.route.joints; ++laid) {
    for (std::size_t i = 0; i < now.lines.size(); ++i) {
      const Vec3 fairlead = at.hull.axes_WD * now.lines[i].fairlead_V + static_cast<double>(laid) * at.route.step_W;
      double length = 0.0;
      EXPECT_EQ(useless(now, now.lines[i], at.useful[i], 0.0, fairlead, length), nullptr) << laid << " " << i;
    }
    for (; next != schedule.shifts.end() && next->joint == laid + 1; ++next)
      now.lines[next->line].anchor_W = next->to_W;
  }
  EXPECT_EQ(next, schedule.shifts.end());
}

/// Of a bow line with its pull kept: what of it lies becomes shorter, and stretches less.
TEST(anchor_plan, moves_an_anchor_when_its_line_has_become_as_short_as_it_may) {
  Route at({});
  const double stretch = at.useful[0].pull / (4.04e10 * 0.064 * 0.064);
  const double excess = at.spread.lines[0].line.length() - 1000.0;  // over the distance, at 1000 m
  at.useful[0].range = between(705.0 + excess + 295.0 * stretch, 1400.0);
  const AnchorSchedule schedule = at.plan();
  ASSERT_FALSE(schedule.fault) << *schedule.fault;
  ASSERT_FALSE(schedule.shifts.empty());
  const AnchorShift& first = schedule.shifts.front();
  // Abreast by 1000 sin 25 deg, 705 m away in all: ahead by 564.3 m, after 906.3 - 564.3 m.
  EXPECT_EQ(first.joint, static_cast<int>((906.3 - 564.3) / 12.0) + 1);
  EXPECT_STREQ(first.reason, "least length");
  EXPECT_EQ(first.line, 0U);
  EXPECT_LE(first.length, 1400.0);
  EXPECT_GT(first.length, 1400.0 - 12.0);  // another joint ahead it would be longer than it may
}

TEST(anchor_plan, moves_an_anchor_when_its_line_leaves_its_sector) {
  Route at({});
  UsefulRange sector;
  sector.sector = 0.35;
  sector.most_length = 1300.0;
  at.useful[1].range = sector;
  const AnchorSchedule schedule = at.plan();
  ASSERT_FALSE(schedule.fault) << *schedule.fault;
  ASSERT_FALSE(schedule.shifts.empty());
  EXPECT_STREQ(schedule.shifts.front().reason, "sector");
  // Abreast by 1000 sin 65 deg, from 65 deg to 65 deg + 0.35.
  const double abreast = 1000.0 * std::sin(65.0 / 57.29577951308232);
  const double ahead = abreast / std::tan(65.0 / 57.29577951308232 + 0.35);
  EXPECT_EQ(schedule.shifts.front().joint,
            static_cast<int>((1000.0 * std::cos(65.0 / 57.29577951308232) - ahead) / 12.0) + 1);
}

TEST(anchor_plan, says_which_line_has_no_place_of_use) {
  Route at({});
  at.useful[3].range = between(1100.0, 1400.0);
  const AnchorSchedule schedule = at.plan();
  ASSERT_TRUE(schedule.fault);
  EXPECT_NE(schedule.fault->find("not in its useful range as drawn"), std::string::npos);
}

}  // namespace
}  // namespace overbend

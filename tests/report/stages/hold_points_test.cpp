#include "report/stages/hold_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/stages/stage_labels.h"
#include "report/synthetic_operation.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

using testing::synthetic_abandonment;

const HoldPoint* named(const std::vector<HoldPoint>& points, const std::string& what) {
  const auto sample =
      std::find_if(points.begin(), points.end(), [&](const HoldPoint& hold_point) { return hold_point.what == what; });
  return sample == points.end() ? nullptr : &*sample;
}

TEST(hold_points, are_where_the_head_crosses_between_two_stages) {
  OperationResults results = synthetic_abandonment();
  const std::vector<HoldPoint> points = hold_points(results);
  const HoldPoint* water = named(points, "the head goes under water");
  ASSERT_NE(water, nullptr);
  const StageResult &before = results.stages[water->stage - 1], &after = results.stages[water->stage];
  EXPECT_GT(before.lay->head->p_W.z(), 0.0);
  EXPECT_LT(after.lay->head->p_W.z(), 0.0);
  // Linear between the two: at the reported length out, the interpolated height of the head is zero.
  const double share = (*water->out - *before.stage.cable_out) / (*after.stage.cable_out - *before.stage.cable_out);
  EXPECT_NEAR((1.0 - share) * before.lay->head->p_W.z() + share * after.lay->head->p_W.z(), 0.0, 1e-9);
}

TEST(hold_points, of_abandonment_read_backwards_are_those_of_recovery) {
  OperationResults results = synthetic_abandonment();
  results.stages.pop_back();
  const std::vector<HoldPoint> down = hold_points(results);
  std::reverse(results.stages.begin(), results.stages.end());
  const std::vector<HoldPoint> up = hold_points(results);
  const std::pair<const char*, const char*> pairs[] = {
      {"the head leaves the last roller", "the head comes onto the last roller"},
      {"the head leaves the stinger tip", "the head comes to the stinger tip"},
      {"the head goes under water", "the head comes out of the water"}};
  for (const auto& [out, back] : pairs) {
    const HoldPoint *hold_point = named(down, out), *again = named(up, back);
    ASSERT_TRUE(hold_point != nullptr && again != nullptr) << out;
    EXPECT_NEAR(*hold_point->out, *again->out, 1e-9) << out;
    EXPECT_EQ(hold_point->stage + again->stage, results.stages.size()) << out;
  }
}

TEST(hold_points, follow_each_other_as_the_head_goes) {
  const std::vector<HoldPoint> points = hold_points(synthetic_abandonment());
  double out = 0.0;
  for (const HoldPoint& point : points) {
    if (point.what.starts_with("highest")) continue;
    EXPECT_GE(*point.out, out) << point.what;
    out = *point.out;
  }
  EXPECT_GE(points.size(), 4u);
}

TEST(hold_points, know_nothing_of_rollers_where_there_are_none) {
  OperationResults results = synthetic_abandonment();
  for (StageResult& stage : results.stages) {
    if (stage.lay) stage.lay->supports.clear();
  }
  for (const HoldPoint& point : hold_points(results)) {
    EXPECT_EQ(point.what.find("roller"), std::string::npos);
    EXPECT_EQ(point.what.find("stinger"), std::string::npos);
  }
}

TEST(hold_points, hardest_stage_is_that_of_the_largest_check_or_cable) {
  OperationResults results = synthetic_abandonment();
  CheckRow cable;
  cable.id = "cable_load";
  cable.name = "Cable, breaking load over safety factor";
  cable.status = CheckStatus::exceeded;
  cable.utilisation = 7.5;
  results.stages[2].lay->checks.rows.push_back(cable);
  EXPECT_EQ(find_governing_stage_index(results), 2u);
  EXPECT_NE(find_max_utilisation(results.stages[2])->what.find("cable"), std::string::npos);
  results.stages[4].lay->checks.rows.front().governing = true;
  results.stages[4].lay->checks.rows.front().status = CheckStatus::exceeded;
  results.stages[4].lay->checks.rows.front().utilisation = 8.0;
  EXPECT_EQ(find_governing_stage_index(results), 4u);
}

}  // namespace
}  // namespace overbend

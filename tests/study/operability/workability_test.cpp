#include "study/operability/workability.h"

#include <gtest/gtest.h>

#include "base/constants.h"

namespace overbend {
namespace {

StudyInput axis(const std::string& key, std::vector<double> values) {
  StudyInput input;
  input.key = key;
  input.values = std::move(values);
  return input;
}

/// Headings 0, 90 and 180 deg, periods 6 and 10 s.
OperabilityResults chart() {
  OperabilityResults results;
  results.over = "environment.waves.hs";
  results.axes = {axis("environment.waves.from", {0.0, 90.0 * kDegree, 180.0 * kDegree}),
                  axis("environment.waves.tp", {6.0, 10.0})};
  for (const double limit : {3.0, 1.0, 2.0, 0.0, 4.0, 4.0}) {
    OperabilityCell cell;
    if (limit > 0.0) cell.limit = limit;
    cell.beyond = limit == 4.0;
    results.cells.push_back(cell);
  }
  return results;
}

ScatterDiagram diagram(std::vector<ScatterDiagram::Sea> seas) {
  for (ScatterDiagram::Sea& sea : seas) sea.hs_width = 1.0;
  return {std::move(seas)};
}

Workability of(const ScatterDiagram& seas, const OperabilityResults& limits, double factor = 1.0) {
  return std::get<Workability>(workability(seas, limits, factor));
}

}  // namespace

TEST(workability, is_what_a_small_diagram_gives_by_hand) {
  // From 0 deg the limits are 3 m at 6 s, 2 m at 8 s and 1 m at 10 s.
  const Workability w = of(diagram({{0.5, 6.0, 0.0, {0.30}},             // all of 0 to 1 m
                                    {2.5, 6.0, 0.0, {0.20}},             // all of 2 to 3 m
                                    {1.5, 8.0, 10.0 * kDegree, {0.10}},  // all of 1 to 2 m
                                    {1.5, 9.0, 0.0, {0.20}},             // half: the limit is 1.5 m
                                    {2.5, 9.0, 0.0, {0.05}},             // none
                                    {0.5, 12.0, 0.0, {0.15}}}),          // outside
                           chart());
  ASSERT_EQ(w.months.size(), 1U);
  EXPECT_NEAR(w.year, 0.30 + 0.20 + 0.10 + 0.10, 1e-12);
  EXPECT_DOUBLE_EQ(w.months[0], w.year);
  EXPECT_NEAR(w.outside, 0.15, 1e-12);
}

TEST(workability, takes_the_nearest_heading_round_the_circle) {
  // 350 deg is nearest to 0 deg (3 m), 100 deg to 90 deg (2 m at 6 s).
  EXPECT_NEAR(of(diagram({{2.5, 6.0, 350.0 * kDegree, {1.0}}}), chart()).year, 1.0, 1e-12);
  EXPECT_NEAR(of(diagram({{2.5, 6.0, 100.0 * kDegree, {1.0}}}), chart()).year, 0.0, 1e-12);
}

TEST(workability, without_directions_the_lowest_heading_holds) {
  EXPECT_NEAR(of(diagram({{1.5, 6.0, std::nullopt, {1.0}}}), chart()).year, 1.0, 1e-12);
  EXPECT_NEAR(of(diagram({{2.5, 6.0, std::nullopt, {1.0}}}), chart()).year, 0.0, 1e-12);
}

TEST(workability, a_limit_below_the_least_height_is_nought) {
  // From 90 deg: 2 m at 6 s, none at 10 s; 1 m at 8 s.
  EXPECT_NEAR(of(diagram({{0.5, 10.0, 90.0 * kDegree, {1.0}}}), chart()).year, 0.0, 1e-12);
  EXPECT_NEAR(of(diagram({{0.5, 8.0, 90.0 * kDegree, {0.5}}, {1.5, 8.0, 90.0 * kDegree, {0.5}}}), chart()).year, 0.5,
              1e-12);
}

TEST(workability, heights_above_those_tried_are_outside) {
  const Workability w = of(diagram({{3.5, 7.0, 180.0 * kDegree, {0.6}}, {4.5, 7.0, 180.0 * kDegree, {0.4}}}), chart());
  EXPECT_NEAR(w.year, 0.6, 1e-12);
  EXPECT_NEAR(w.outside, 0.4, 1e-12);
}

TEST(workability, what_the_diagram_lacks_and_what_is_not_decided_is_outside) {
  OperabilityResults limits = chart();
  limits.cells[2].decided = false;
  const Workability w = of(diagram({{0.5, 6.0, 0.0, {0.5}}, {0.5, 6.0, 90.0 * kDegree, {0.3}}}), limits);
  EXPECT_NEAR(w.year, 0.5, 1e-12);
  EXPECT_NEAR(w.outside, 0.5, 1e-12);
}

TEST(workability, months_weigh_by_their_days) {
  std::vector<double> january(12, 0.0), rest(12, 1.0);
  january[0] = 1.0;
  rest[0] = 0.0;
  const Workability w = of(diagram({{0.5, 6.0, 0.0, january}, {9.5, 6.0, 0.0, rest}}), chart());
  EXPECT_NEAR(w.months[0], 1.0, 1e-12);
  EXPECT_NEAR(w.months[1], 0.0, 1e-12);
  EXPECT_NEAR(w.year, 31.0 / 365.25, 1e-12);
}

TEST(workability, the_alpha_factor_lowers_every_limit) {
  // 0.75 times 2 m at 8 s.
  EXPECT_NEAR(of(diagram({{1.5, 8.0, 0.0, {1.0}}}), chart(), 0.75).year, 0.5, 1e-12);
}

TEST(workability, says_which_axis_it_cannot_use) {
  OperabilityResults limits = chart();
  limits.axes[1].key = "tensioner.tension";
  EXPECT_NE(std::get<std::string>(workability(diagram({}), limits)).find("tensioner.tension"), std::string::npos);
  limits = chart();
  limits.over = "tensioner.tension";
  EXPECT_TRUE(std::holds_alternative<std::string>(workability(diagram({}), limits)));
}

}  // namespace overbend

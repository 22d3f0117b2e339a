/// Whole dynamic analyses of a hull on its mooring lines, without a pipe.
#include "recording/recorder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "recording/run_dynamics.h"
#include "support/memory_sink.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::MemorySink;

DynamicOutcome run(
    const testing::SolvedHull& hull, DynamicSink& sink, const DynamicCheckpoint* from = nullptr,
    const std::function<DynamicControl(const DynamicProgress&)>& control = [](const DynamicProgress&) {
      return DynamicControl::go_on;
    }) {
  StaticResults statics;
  statics.moorings = hull.rest.moorings;
  return run_dynamics(hull.model, hull.start(), statics, dynamic_options(hull.model), sink, from, control);
}

Description in_a_sea() {
  return testing::coarse_example("moored-barge", 20.0, 10.0);
}

TEST(recorder, keeps_the_largest_and_smallest_of_what_its_rows_show) {
  const testing::SolvedHull hull(in_a_sea());
  MemorySink sink;
  const DynamicResults r = run(hull, sink).results.value();
  ASSERT_EQ(r.moorings.size(), 8U);
  ASSERT_TRUE(r.vessel);
  EXPECT_DOUBLE_EQ(r.duration, 20.0);
  EXPECT_GT(r.run.real_time_ratio, 0.0);
  const std::vector<double> time = sink.column("time");
  const auto first = std::lower_bound(time.begin(), time.end(), 0.25) - time.begin();
  const auto expect_within = [&](const std::string& name, const SummaryStatistics& spread) {
    const std::vector<double> values = sink.column(name);
    ASSERT_EQ(values.size(), time.size()) << name;
    const auto [min_value, max_value] = std::minmax_element(values.begin() + first, values.end());
    EXPECT_LE(spread.min, *min_value) << name;
    EXPECT_GE(spread.max, *max_value) << name;
    EXPECT_LT(*max_value - *min_value, 1.3 * (spread.max - spread.min)) << name;
    EXPECT_GT(*max_value - *min_value, 0.5 * (spread.max - spread.min)) << name;
  };
  expect_within("vessel/heave", r.vessel->heave.whole);
  expect_within("vessel/pitch", r.vessel->pitch.whole);
  expect_within("mooring/port bow/fairlead_tension", r.moorings.front().fairlead_tension.whole);
  const std::vector<double> elevation = sink.column("elevation");
  EXPECT_GT(*std::max_element(elevation.begin(), elevation.end()), 0.3);  // of a significant height of 1.5 m
  // Pose, then the points of all lines.
  EXPECT_EQ(sink.snapshots.front().size(), 12U + 4U * 8U * r.moorings.front().points.size());
}

TEST(recorder, a_run_taken_up_at_a_checkpoint_gives_the_same_bits) {
  const testing::SolvedHull hull(in_a_sea());
  MemorySink whole, first, second;
  const DynamicResults expected = run(hull, whole).results.value();
  const DynamicOutcome stopped = run(hull, first, nullptr, [](const DynamicProgress& dynamic_progress) {
    return dynamic_progress.time >= 8.0 ? DynamicControl::stop : DynamicControl::go_on;
  });
  ASSERT_TRUE(stopped.stopped);
  EXPECT_TRUE(stopped.results);  // so far
  ASSERT_EQ(first.checkpoints.size(), 1U);
  const DynamicResults got = run(hull, second, &first.checkpoints.front()).results.value();
  EXPECT_EQ(got.energy.error, expected.energy.error);
  EXPECT_EQ(got.run.steps, expected.run.steps);
  EXPECT_EQ(got.run.newton_iterations, expected.run.newton_iterations);
  EXPECT_EQ(got.vessel->offset.whole.std, expected.vessel->offset.whole.std);
  EXPECT_EQ(got.moorings[3].fairlead_tension.whole.max, expected.moorings[3].fairlead_tension.whole.max);
  std::vector<std::vector<double>> rows = first.rows;
  rows.insert(rows.end(), second.rows.begin(), second.rows.end());
  EXPECT_EQ(rows, whole.rows);
}

TEST(recorder, counts_quasi_static_lines_as_those_of_elements) {
  Description d = in_a_sea();
  d.moorings->model = MooringModel::quasi_static;
  const testing::SolvedHull hull(d);
  MemorySink sink;
  const DynamicResults r = run(hull, sink).results.value();
  ASSERT_EQ(r.moorings.size(), 8U);
  EXPECT_GT(r.moorings.front().fairlead_tension.whole.max, 1.001 * r.moorings.front().fairlead_tension.whole.min);
  EXPECT_GT(r.moorings.front().min_on_seabed, 300.0);
  EXPECT_EQ(sink.snapshots.front().size(), 12U);
}

TEST(recorder, warns_of_a_line_that_parts) {
  Description d = in_a_sea();
  d.moorings->lines[2].fails_at = 5.0;
  const testing::SolvedHull hull(d);
  MemorySink sink;
  const DynamicResults r = run(hull, sink).results.value();
  EXPECT_NEAR(r.moorings[2].parted_at.value_or(0.0), 5.0, 0.125);  // reported at the end of the step
  EXPECT_TRUE(std::ranges::any_of(messages(r.findings), [](const std::string& warning) {
    return warning.find("\"port aft breast\" parted at its fairlead at t = 5.0 s") != std::string::npos;
  }));
}

TEST(recorder, follows_a_pull_ahead_and_warns_where_the_run_ends_before_it) {
  Description d = in_a_sea();
  d.moorings->model = MooringModel::quasi_static;
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = 3.0;
  d.operation.start = 4.0;
  const testing::SolvedHull hull(d);
  MemorySink sink;
  const DynamicResults r = run(hull, sink).results.value();
  const std::vector<double> advance = sink.column("operation/advance");
  EXPECT_EQ(advance.front(), 0.0);
  EXPECT_GT(advance.back(), 0.3);
  EXPECT_TRUE(sink.column("tensioner/paid_out").empty());
  ASSERT_EQ(r.assumptions.size(), 1U);
  EXPECT_NE(r.assumptions.front().text.find("is pulled 3.00 m ahead in one move from t = 4 s on."), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(messages(r.findings), [](const std::string& warning) {
    return warning.find("too short for the operation") != std::string::npos;
  }));
}

}  // namespace
}  // namespace overbend

#include "report/mooring_verdict.h"

#include <gtest/gtest.h>

#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::synthetic_lines;
using testing::synthetic_moorings;
using testing::synthetic_stages;

TEST(mooring_verdict, takes_the_largest_of_rest_and_stages_and_leaves_out_parted_lines) {
  MooringResults results = synthetic_stages();
  results.stages[2].moorings[6].utilisation = 3.0;  // parted: of no meaning
  results.stages[2].moorings[5].utilisation = 0.7;
  const std::vector<UtilisationBar> bars = mooring_bars(results, {});
  ASSERT_EQ(bars.size(), 2u);
  EXPECT_DOUBLE_EQ(bars[0].utilisation, 0.7);
  EXPECT_NE(bars[0].what.find("starboard aft breast, the same"), std::string::npos) << bars[0].what;
}

TEST(mooring_verdict, has_a_bar_for_the_working_load_where_the_model_gives_one) {
  const std::vector<UtilisationBar> bars = mooring_bars(synthetic_moorings(), 693.2e3);
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_NEAR(bars[1].utilisation, 0.5, 1e-12);
}

TEST(mooring_verdict, is_exceeded_reserved_or_without_objection) {
  const std::vector<UtilisationBar> bars = mooring_bars(synthetic_moorings(), {});
  EXPECT_EQ(load_verdict(bars, {}).words, "NO LOAD EXCEEDED");
  EXPECT_EQ(load_verdict(bars, weighed({"static: mooring line \"a\" is slack: it holds nothing."})).kind,
            VerdictKind::reserved);
  const std::vector<UtilisationBar> over = mooring_bars(synthetic_moorings(), 300e3);
  EXPECT_EQ(load_verdict(over, {}).kind, VerdictKind::exceeded);
  EXPECT_NE(load_verdict(over, {}).words.find("EXCEEDED 1.16, port bow"), std::string::npos)
      << load_verdict(over, {}).words;
}

TEST(mooring_verdict, claims_nothing_of_lines_whose_strength_is_not_known) {
  EXPECT_TRUE(line_bars(synthetic_lines(true)).empty());
  EXPECT_EQ(load_verdict({}, {}).kind, VerdictKind::open);
}

TEST(mooring_verdict, of_lines_in_a_run_is_that_of_the_largest_tension_over_time) {
  LinesResults results = synthetic_lines(true);
  results.lines[0].utilisation = 0.51;  // at rest, 51 kN
  const std::vector<UtilisationBar> bars = line_bars(results);
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_NEAR(bars[0].utilisation, 0.663, 1e-12);
}

/// A weak end that hardly pulls at rest governs in time.
TEST(mooring_verdict, of_lines_in_a_run_is_that_of_the_segment_used_most_over_time) {
  LinesResults results = synthetic_lines(true);
  results.lines[0].utilisation = 0.51;
  results.lines[0].utilisation_in_time = 1.06;
  const std::vector<UtilisationBar> bars = line_bars(results);
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_NEAR(bars[0].utilisation, 1.06, 1e-12);
  EXPECT_EQ(load_verdict(bars, {}).kind, VerdictKind::exceeded);
}

}  // namespace
}  // namespace overbend

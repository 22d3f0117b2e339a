#include "study/run/early_termination.h"

#include <gtest/gtest.h>

#include "app/program.h"
#include "modelfile/study_file/study_reader.h"
#include "study/cases/case_evaluation.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;
using testing::workable;

/// A sea in which all checks are passed but that of a tension which the waves exceed.
Description with_tension_limit(double limit) {
  Description d = workable();
  d.checks.limits.tension = limit;
  return d;
}

/// Welds with a budget that the first cycles of any sea use up.
FatigueDescription tired() {
  FatigueDescription fatigue;
  fatigue.spots = {{"cap", false, FatigueCurve::d, {}, {}}};
  fatigue.weld_time = 300.0;
  fatigue.move_time = 60.0;
  fatigue.budget = 1e-9;
  return fatigue;
}

}  // namespace

TEST(exceeded_early, a_run_ends_where_a_check_is_exceeded_and_the_whole_run_exceeds_it_too) {
  EmptySink none;
  const DynamicResults free = TimedLay(workable()).results(none);
  const double top = free.top_tension.max, at_rest = TimedLay(workable()).statics.top_tension;
  ASSERT_GT(top, at_rest);
  const TimedLay c(with_tension_limit(0.5 * (top + at_rest)));
  const DynamicResults whole = c.results(none);
  EXPECT_EQ(find_governing_check(whole.checks)->id, "tensioner_load");
  EXPECT_EQ(find_governing_check(whole.checks)->status, CheckStatus::exceeded);

  EarlyTermination exceeded(c.model, c.statics, 0.5);
  double last = 0.0;
  DynamicOutcome outcome = c.run(none, dynamic_options(c.model), nullptr, [&](const DynamicProgress& dynamic_progress) {
    last = dynamic_progress.time;
    return exceeded(dynamic_progress) ? DynamicControl::stop : DynamicControl::go_on;
  });
  ASSERT_TRUE(outcome.stopped && outcome.results);
  EXPECT_LT(last, whole.duration);
  fill_checks(c.model, c.statics, *outcome.results);
  const CheckRow* worst = find_governing_check(outcome.results->checks);
  EXPECT_EQ(worst->id, "tensioner_load");
  EXPECT_GT(worst->utilisation, 1.0);
  EXPECT_LE(worst->utilisation, find_governing_check(whole.checks)->utilisation);
}

TEST(exceeded_early, a_run_that_passes_goes_to_its_end_and_gives_the_same_bits) {
  const TimedLay c(workable());
  MemorySink plain, watched;
  const DynamicOptions options = dynamic_options(c.model);
  const DynamicOutcome alone = c.run(plain, options);
  EarlyTermination exceeded(c.model, c.statics, 1.0);
  const DynamicOutcome looked_at = c.run(watched, options, nullptr, [&](const DynamicProgress& dynamic_progress) {
    EXPECT_FALSE(exceeded(dynamic_progress));
    return DynamicControl::go_on;
  });
  EXPECT_FALSE(looked_at.stopped);
  EXPECT_EQ(plain.rows, watched.rows);
  EXPECT_EQ(alone.results->top_tension.max, looked_at.results->top_tension.max);
}

TEST(exceeded_early, fatigue_which_may_fall_again_ends_no_run) {
  Description d = workable();
  d.fatigue = tired();
  const TimedLay c(d);
  EmptySink none;
  EarlyTermination exceeded(c.model, c.statics, 1.0);
  int looks_at_tired_welds = 0;
  const DynamicOutcome outcome =
      c.run(none, dynamic_options(c.model), nullptr, [&](const DynamicProgress& dynamic_progress) {
        EXPECT_FALSE(exceeded(dynamic_progress));
        if (dynamic_progress.time > 1.0) {
          const CheckTable table = check_dynamics(c.model, c.statics, dynamic_progress.so_far());
          const CheckRow* worst = find_governing_check(table);
          looks_at_tired_welds += worst->id == "fatigue" && worst->status == CheckStatus::exceeded ? 1 : 0;
        }
        return DynamicControl::go_on;
      });
  EXPECT_FALSE(outcome.stopped);
  EXPECT_GT(looks_at_tired_welds, 0);
}

TEST(exceeded_early, fatigue_is_left_out_of_the_verdict_of_a_run_that_ended_early) {
  StudyReading reading = read_study_text("overbend_study: 1\nbase: " OVERBEND_SOURCE_DIR
                                         "/examples/bgl1.yaml\nanalysis: dynamic\nseeds: 1\n",
                                         "study.yaml");
  ASSERT_TRUE(reading.study);
  Description d = with_tension_limit(1e3);  // exceeded from the beginning
  d.fatigue = tired();
  const CaseBase base(d, *reading.study);
  CaseWarmStart neighbour;
  neighbour.prepared = std::get<std::shared_ptr<const PreparedCase>>(prepare_case(d));
  const testing::Scratch scratch;
  CaseEvaluationOptions conduct;
  conduct.folder = scratch.file("whole");
  const CaseResult whole = evaluate_case(base, {}, neighbour, conduct);
  ASSERT_EQ(whole.ending, RunStatus::done) << whole.why;
  EXPECT_EQ(whole.governing, "Fatigue of welds on their way");
  conduct.folder = scratch.file("early");
  conduct.until_exceeded = true;
  const CaseResult early = evaluate_case(base, {}, neighbour, conduct);
  ASSERT_EQ(early.ending, RunStatus::done) << early.why;
  EXPECT_EQ(early.verdict, VerdictKind::exceeded);
  EXPECT_EQ(early.governing, "Tension at the tensioner");
}

}  // namespace overbend

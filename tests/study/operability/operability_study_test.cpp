#include "study/operability/operability_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "app/program.h"
#include "modelfile/study_file/study_reader.h"
#include "modelfile/yaml/moved_text.h"
#include "study/operability/trial_record.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::Scratch;

constexpr const char* kTensions = R"(overbend_study: 1
base: BASE
analysis: static
axes:
  - {key: environment.water_depth, values: [60 m, 66.8 m]}
  - {key: tensioner.tension, from: 240 kN, to: 320 kN, steps: 2}
operability:
  over: tensioner.tension
  resolution: 10 kN
  criterion:
    - {result: static.bottom_tension, at_most: 210 kN}
)";

/// BGL-1, whose pipe may lie over the side of its stinger in a current, and yields in shallow water.
std::string accepting_model() {
  static const Scratch folder;
  const std::string bgl1 = std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml";
  return folder.write("bgl1.yaml", moved_text(testing::file_text(bgl1), bgl1, folder.file("")) +
                                       "\nchecks: {accepted_findings: [pipe-off-rollers, yield-with-linear-steel]}\n");
}

CaseBase read_case_base(std::string text) {
  text.replace(text.find("BASE"), 4, accepting_model());
  StudyReading reading = read_study_text(text, "study.yaml");
  EXPECT_FALSE(reading.diagnostics.has_errors()) << reading.diagnostics.lines(Severity::error).front();
  return {std::move(*reading.base), std::move(*reading.study)};
}

CaseResult answered(RunStatus ending, bool passed, double utilisation) {
  CaseResult answer;
  answer.ending = ending;
  answer.why = "why";
  answer.verdict = passed ? VerdictKind::passed : VerdictKind::exceeded;
  answer.utilisation = utilisation;
  answer.governing = "Roller force";
  answer.summary = {{"static", {{"bottom_tension", 90e3}}}};
  return answer;
}

}  // namespace

TEST(operability_study, values_tried_are_steps_from_the_least_and_the_largest) {
  EXPECT_EQ(searched_values(1.0, 2.0, 0.25), (std::vector<double>{1.0, 1.25, 1.5, 1.75, 2.0}));
  EXPECT_EQ(searched_values(1.0, 1.8, 0.25), (std::vector<double>{1.0, 1.25, 1.5, 1.75, 1.8}));
  EXPECT_EQ(searched_values(0.1, 0.4, 0.1).size(), 4U);
  EXPECT_EQ(searched_values(1.0, 1.0, 0.25), (std::vector<double>{1.0}));
}

TEST(operability_study, a_question_sets_every_axis_and_the_value) {
  const CaseBase base = read_case_base(kTensions);
  const OperabilityPlan plan(base.study());
  EXPECT_EQ(plan.cells(), 2U);
  EXPECT_EQ(plan.grid().values, 9U);
  const CaseInput question = plan.question(1, 3, 0);
  EXPECT_EQ(question.keys,
            (std::vector<KeySetting>{{"environment.water_depth", "66.8 m"}, {"tensioner.tension", "270 kN"}}));
  EXPECT_FALSE(question.seed);
}

TEST(operability_study, an_answer_is_held_against_the_checks_and_the_conditions) {
  OperabilityDescription wanted;
  EXPECT_EQ(judged_trial(answered(RunStatus::done, true, 0.8), wanted, false).end, TrialStatus::passed);
  EXPECT_EQ(judged_trial(answered(RunStatus::done, false, 1.2), wanted, false).end, TrialStatus::exceeded);
  CaseResult unjudged = answered(RunStatus::done, true, 0.0);
  unjudged.governing.clear();
  EXPECT_EQ(judged_trial(unjudged, wanted, false).end, TrialStatus::open);
  wanted.criterion = {{"static.bottom_tension", "N", SeekRelation::at_most, 80e3}};
  const TrialResult over = judged_trial(answered(RunStatus::done, true, 0.8), wanted, false);
  EXPECT_EQ(over.end, TrialStatus::exceeded);
  EXPECT_DOUBLE_EQ(*over.utilisation, 90.0 / 80.0);
  EXPECT_EQ(over.governing, "static.bottom_tension at most 80 kN");
  wanted.criterion[0].relation = SeekRelation::at_least;
  const TrialResult under = judged_trial(answered(RunStatus::done, true, 0.95), wanted, false);
  EXPECT_EQ(under.end, TrialStatus::passed);
  EXPECT_EQ(under.governing, "Roller force");
  wanted.checks = false;
  EXPECT_DOUBLE_EQ(*judged_trial(answered(RunStatus::done, false, 1.2), wanted, false).utilisation, 80.0 / 90.0);
  wanted.criterion[0].result = "static.nothing_of_the_kind";
  EXPECT_EQ(judged_trial(answered(RunStatus::done, true, 0.8), wanted, false).end, TrialStatus::open);
}

TEST(operability_study, a_serious_finding_ends_the_range_like_an_exceeded_check) {
  const OperabilityDescription wanted;
  CaseResult answer = answered(RunStatus::done, true, 0.8);
  answer.findings = {{FindingCode::unusual_input, "lay.yaml:3: vessel: is long"},
                     {FindingCode::pipe_off_rollers, "the pipe left 'stinger 8'"}};
  const TrialResult result = judged_trial(answer, wanted, false);
  EXPECT_EQ(result.end, TrialStatus::exceeded);
  EXPECT_EQ(result.governing, "pipe-off-rollers");
  EXPECT_DOUBLE_EQ(result.utilisation.value(), 0.8);
  accept(answer.findings, {"pipe-off-rollers"});
  EXPECT_EQ(judged_trial(answer, wanted, false).end, TrialStatus::passed);
}

TEST(operability_study, what_has_no_solution_has_not_passed_and_what_failed_is_open) {
  const OperabilityDescription wanted;
  const TrialResult none = judged_trial(answered(RunStatus::no_solution, true, 0.0), wanted, false);
  EXPECT_EQ(none.end, TrialStatus::no_solution);
  EXPECT_EQ(none.governing, "why");
  EXPECT_EQ(judged_trial(answered(RunStatus::wrong_input, true, 0.0), wanted, false).end, TrialStatus::no_solution);
  EXPECT_EQ(judged_trial(answered(RunStatus::wrong_input, true, 0.0), wanted, true).end, TrialStatus::open);
  EXPECT_EQ(judged_trial(answered(RunStatus::interrupted, true, 0.0), wanted, false).end, TrialStatus::open);
  EXPECT_EQ(judged_trial(answered(RunStatus::error, true, 0.0), wanted, false).end, TrialStatus::open);
}

TEST(operability_study, finds_the_largest_tension_that_the_anchor_holds) {
  // Bottom tension rises with the tension at the tensioner one by one, so every cell is checked by all its values.
  const CaseBase base = read_case_base(kTensions);
  const OperabilityPlan plan(base.study());
  const Scratch scratch;
  const OperabilityResults results = run_operability(base, {.folder = scratch.file("study"), .threads = 2});
  ASSERT_EQ(results.cells.size(), 2U);
  for (std::size_t cell = 0; cell < 2; ++cell) {
    ASSERT_TRUE(results.cells[cell].decided) << results.cells[cell].reason;
    std::optional<double> max_value;
    CaseWarmStart neighbour;
    for (std::size_t value = 0; value < plan.values().size(); ++value) {
      const CaseResult answer = evaluate_case(base, plan.question(cell, value, 0), neighbour, {});
      ASSERT_EQ(answer.ending, RunStatus::done) << answer.why;
      if (answer.summary["static"]["bottom_tension"] <= 210e3) max_value = plan.values()[value];
    }
    EXPECT_EQ(results.cells[cell].limit, max_value);
    EXPECT_LE(results.cells[cell].runs, 5);
  }
}

TEST(operability_study, a_search_that_was_interrupted_goes_on_with_the_same_questions) {
  const CaseBase base = read_case_base(kTensions);
  const Scratch scratch;
  OperabilityOptions conduct;
  conduct.folder = scratch.file("study");
  conduct.threads = 1;
  int run = 0, known = 0;
  conduct.on_trial = [&](const TrialReport& trial) { ++(trial.known ? known : run); };
  conduct.stop = [&] { return run >= 2; };
  const OperabilityResults begun = run_operability(base, conduct);
  EXPECT_FALSE(begun.cells[0].decided && begun.cells[1].decided);
  conduct.stop = {};
  const OperabilityResults all = run_operability(base, conduct);
  EXPECT_EQ(known, 2);
  EXPECT_EQ(run, all.runs);
  conduct.gather = true;
  run = known = 0;
  const OperabilityResults again = run_operability(base, conduct);
  EXPECT_EQ(run, 0);
  EXPECT_EQ(known, all.runs);
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    EXPECT_EQ(again.cells[i].limit, all.cells[i].limit);
    EXPECT_EQ(again.cells[i].above, all.cells[i].above);
  }
  EXPECT_EQ(again.wall_time, all.wall_time);
}

TEST(operability_study, tasks_share_the_chains_and_are_gathered) {
  const CaseBase base = read_case_base(kTensions);
  const Scratch scratch;
  for (const std::size_t task : {std::size_t{0}, std::size_t{1}}) {
    std::set<std::size_t> cells;
    OperabilityOptions conduct{.folder = scratch.file("study"), .threads = 1, .task = task, .tasks = 2};
    conduct.on_trial = [&](const TrialReport& trial) {
      if (!trial.known) cells.insert(trial.cell);
    };
    const OperabilityResults part = run_operability(base, conduct);
    EXPECT_EQ(cells, std::set<std::size_t>{task});
    EXPECT_EQ(part.cells[1].decided, task == 1);
  }
  const OperabilityResults all = run_operability(base, {.folder = scratch.file("study"), .gather = true});
  const OperabilityResults alone = run_operability(base, {.folder = scratch.file("other")});
  for (std::size_t i = 0; i < all.cells.size(); ++i) EXPECT_EQ(all.cells[i].limit, alone.cells[i].limit);
}

TEST(operability_study, what_a_search_for_limits_passes_over_is_reported) {
  const Scratch scratch;
  const auto remarks = [&](const std::string& more, const std::string& tensions) {
    std::string text = kTensions;
    const std::string axis = "from: 240 kN, to: 320 kN, steps: 2";
    text.replace(text.find(axis), axis.size(), "values: [" + tensions + "]");
    return run_operability(read_case_base(text + more), {.folder = scratch.file("study"), .gather = true}).remarks;
  };
  const auto prescribed = [](const std::vector<std::string>& lines, const std::string& message) {
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(message) != std::string::npos; });
  };
  const std::vector<std::string> all = remarks("gather: [static.lay_back]\n", "240 kN, 255 kN, 270 kN, 320 kN");
  EXPECT_TRUE(prescribed(all, "gather is ignored"));
  EXPECT_TRUE(prescribed(all, "255 kN is ignored"));  // 270 kN is a step of the resolution
  EXPECT_FALSE(prescribed(remarks("", "240 kN, 270 kN, 320 kN"), "ignored"));
}

TEST(trial_record, is_read_for_its_own_question_alone) {
  const Scratch scratch;
  const CaseInput question{{{"environment.waves.hs", "1.5 m"}}, 3};
  const TrialRecord record{{TrialStatus::exceeded, 1.25, "Roller force", ""}, 12.5};
  write_trial(record, question, scratch.file("trial"));
  const auto read = read_trial(scratch.file("trial"), question);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->result.end, TrialStatus::exceeded);
  EXPECT_EQ(read->result.utilisation, 1.25);
  EXPECT_EQ(read->result.governing, "Roller force");
  EXPECT_EQ(read->wall_time, 12.5);
  EXPECT_FALSE(read_trial(scratch.file("trial"), {{{"environment.waves.hs", "2 m"}}, 3}));
  EXPECT_FALSE(read_trial(scratch.file("trial"), {question.keys, 4}));
  EXPECT_FALSE(read_trial(scratch.file("none"), question));
  scratch.write("trial/trial.json", "{");
  EXPECT_FALSE(read_trial(scratch.file("trial"), question));
}

}  // namespace overbend

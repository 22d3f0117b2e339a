// Studies of a lift: their cases are all stages, their results those of the stages.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/program.h"
#include "modelfile/study_file/study_reader.h"
#include "resultfiles/summary/named_results.h"
#include "study/campaign/study_execution.h"
#include "study/stages/lift.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::Scratch;

StudyReading read_test_study(const Scratch& scratch, const std::string& text) {
  scratch.write("lift.yaml", testing::file_text(OVERBEND_SOURCE_DIR "/validation/lift_cases/DL8-one.yaml"));
  return read_study_text("overbend_study: 1\nbase: lift.yaml\n" + text, scratch.file("study.yaml"));
}

class Quiet : public StudyObserver {
 public:
  bool stop() override { return false; }
};

TEST(lift_study, gathers_the_largest_of_all_stages_where_nothing_else_is_said) {
  const Scratch scratch;
  StudyReading reading =
      read_test_study(scratch, "axes: [{key: 'operation.stages[half way].lengths.davit 1', values: [14 m, 14.7 m]}]\n");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  const CaseBase base(std::move(reading.base.value()), std::move(reading.study.value()));
  EXPECT_EQ(base.study().analysis, StudyAnalysis::operation);
  const StudyCases cases(base.study());
  open_study(base, cases, scratch.file("out"));
  Quiet watch;
  run_study_cases(base, cases, scratch.file("out"), {1, false}, watch);
  const StudyResults results = study_so_far(scratch.file("out"));
  const auto column = [&](const std::string& name) {
    const auto found = std::ranges::find(results.outputs, name, &StudyOutput::name);
    EXPECT_NE(found, results.outputs.end()) << name;
    return static_cast<std::size_t>(found - results.outputs.begin());
  };
  const OperationResults direct = solve_lift(base.model(), {});
  double moment = 0.0, tension = 0.0;
  for (const StageResult& stage : direct.stages) {
    moment = std::max(moment, stage.lay->lift->lines[0].bending.value);
    tension = std::max(tension, stage.lay->lift->davits[0].tension_upper);
  }
  const StudyCase& same = results.cases.at(1);  // 14.7 m is what the model has
  EXPECT_DOUBLE_EQ(same.values.at(column("max(operation.stages[*].lines[*].largest_bending_moment.value)")).value(),
                   moment);
  EXPECT_DOUBLE_EQ(same.values.at(column("max(operation.stages[*].davits[*].tension_upper)")).value(), tension);
}

TEST(lift_study, takes_names_of_stages_lines_and_davits) {
  const Scratch scratch;
  const std::string axes = "axes: [{key: environment.water_depth, values: [19 m, 20 m]}]\n";
  EXPECT_TRUE(read_test_study(scratch, axes + "gather: ['operation.stages[half way].davits[davit 1].tension_upper']\n")
                  .diagnostics.lines(Severity::error)
                  .empty());
  EXPECT_FALSE(read_test_study(scratch, axes + "gather: ['operation.stages[half way].davits[davit 1].tenson']\n")
                   .diagnostics.lines(Severity::error)
                   .empty());
}

TEST(lift_study, of_a_pull_gathers_the_largest_of_its_stages) {
  const Scratch scratch;
  scratch.write("pull.yaml", testing::file_text(OVERBEND_SOURCE_DIR "/validation/operation_cases/SP12.yaml"));
  StudyReading reading = read_study_text(
      "overbend_study: 1\nbase: pull.yaml\naxes: [{key: environment.seabed.friction.axial, values: ['0.40', "
      "'0.45']}]\n",
      scratch.file("study.yaml"));
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  const CaseBase base(std::move(reading.base.value()), std::move(reading.study.value()));
  const StudyCases cases(base.study());
  open_study(base, cases, scratch.file("out"));
  Quiet watch;
  run_study_cases(base, cases, scratch.file("out"), {2, false}, watch);
  const StudyResults results = study_so_far(scratch.file("out"));
  ASSERT_EQ(results.outputs.front().name, "max(operation.stages[*].tension.winch)");
  // SP12, last stage, known to 0.2 %. The pipe lies on the bed there, the cable does not: friction of the cable would
  // change nothing.
  EXPECT_NEAR(results.cases.at(1).values.front().value(), 473970.448, 0.002 * 473970.448);
  EXPECT_LT(results.cases.at(0).values.front().value(), 0.95 * results.cases.at(1).values.front().value());
}

}  // namespace
}  // namespace overbend

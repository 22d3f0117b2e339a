// Studies of a small lay into a folder.
#include "study/campaign/study_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "app/program.h"
#include "app/small_lay.h"
#include "base/json.h"
#include "modelfile/study_file/study_reader.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_execution.h"

namespace overbend {
namespace {

using testing::Scratch;

constexpr const char* kTensions =
    "axes:\n"
    "  - {key: tensioner.tension, from: 260 kN, to: 340 kN, steps: 5}\n"
    "  - {key: environment.water_depth, values: [19.5 m, 20 m, 20.5 m]}\n"
    "gather: [static.top_tension, static.lay_back, static.sagbend.max_von_mises, checks.governing]\n";

/// A study with the folder of its files.
struct Tried {
  Scratch scratch;
  std::optional<CaseBase> base;
  std::optional<StudyCases> cases;

  explicit Tried(const std::string& text, const std::string& model = testing::kSmallLay) {
    scratch.write("lay.yaml", model);
    StudyReading reading = read_study_text("overbend_study: 1\nbase: lay.yaml\n" + text, scratch.file("study.yaml"));
    for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
    base.emplace(std::move(reading.base.value()), std::move(reading.study.value()));
    cases.emplace(base->study());
  }
  std::filesystem::path folder() const { return scratch.file("out"); }
};

/// Stops after some cases.
class StopAfter : public StudyObserver {
 public:
  explicit StopAfter(int cases) : left_(cases) {}
  bool stop() override { return left_ <= 0; }
  void ended(const StudyCase&) override { --left_; }

 private:
  std::atomic<int> left_;
};

StudyTally run(const Tried& tried, int threads = 2, int at_most = 1000000, bool retry = false) {
  StopAfter watch(at_most);
  open_study(*tried.base, *tried.cases, tried.folder());
  return run_study_cases(*tried.base, *tried.cases, tried.folder(), {threads, retry}, watch);
}

/// All numbers that a study gave, row by row.
std::vector<std::vector<std::optional<double>>> collect_values(const StudyResults& results) {
  std::vector<std::vector<std::optional<double>>> rows;
  for (const StudyCase& study_case : results.cases) rows.push_back(study_case.values);
  return rows;
}

TEST(study_runner, serious_findings_of_cases_are_reported_though_their_checks_pass) {
  // Put into its record, since no small lay has such a warning.
  const Tried tried("axes: [{key: tensioner.tension, values: [280 kN, 300 kN]}]\n");
  run(tried);
  StudyCase study_case = recorded_case(*tried.cases, study_outputs(*tried.base), tried.folder(), 1);
  study_case.findings = {
      Finding{FindingCode::pipe_off_rollers, "the pipe has left 'stinger 2' over the side"}.on("stinger 2")};
  write_case_record(study_case, tried.cases->inputs(), study_outputs(*tried.base), tried.folder(), {});
  const StudyResults results = study_so_far(tried.folder());
  EXPECT_TRUE(std::ranges::any_of(messages(results.findings), [](const std::string& warning) {
    return warning.starts_with("1 of 2 solved cases: the pipe has left 'stinger 2'");
  }));
}

TEST(study_runner, statics_agree_with_those_solved_from_nothing) {
  const Tried tried(kTensions);
  const StudyTally tally = run(tried);
  EXPECT_EQ(tally.done, 15U);
  EXPECT_EQ(tally.failed, 0U);
  const StudyResults results = read_study(tried.folder());
  for (const StudyCase& study_case : results.cases) {
    CaseWarmStart nothing;
    const CaseResult cold = evaluate_case(*tried.base, tried.cases->question(study_case.number), nothing, {});
    ASSERT_EQ(cold.ending, RunStatus::done) << cold.why;
    const Json& statics = cold.summary["static"];
    // The meshes of both differ, and so do their results by the errors of these: a fortieth of the elements of 4 m at
    // touchdown, 0.2 % of a stress.
    EXPECT_NEAR(study_case.values[0].value(), statics["top_tension"].get<double>(), 1.0);
    EXPECT_NEAR(study_case.values[1].value(), statics["lay_back"].get<double>(), 0.1);
    const double stress = statics["sagbend"]["max_von_mises"];
    EXPECT_NEAR(study_case.values[2].value(), stress, 0.002 * stress);
    EXPECT_EQ(study_case.verdict, cold.verdict);
    EXPECT_EQ(study_case.texts[3], study_case.governing);
  }
}

// Across the current this lay has equilibria with a side roller that bears and without, 90 MPa apart.
TEST(study_runner, a_lay_in_a_current_is_the_one_that_statics_find_by_themselves) {
  const Scratch scratch;
  StudyReading reading = read_study_text("overbend_study: 1\nbase: " OVERBEND_SOURCE_DIR
                                         "/examples/bgl1.yaml\n"
                                         "axes: [{key: environment.water_depth, values: [84 m]},\n"
                                         "  {key: tensioner.tension, values: [245 kN, 250 kN, 255 kN]}]\n"
                                         "gather: [static.overbend.max_von_mises, static.lay_back]\n",
                                         scratch.file("study.yaml"));
  ASSERT_TRUE(reading.study);
  const CaseBase base(std::move(*reading.base), std::move(*reading.study));
  const StudyCases cases(base.study());
  StopAfter watch(100);
  open_study(base, cases, scratch.file("out"));
  run_study_cases(base, cases, scratch.file("out"), {1, false}, watch);
  for (const StudyCase& study_case : read_study(scratch.file("out")).cases) {
    CaseWarmStart nothing;
    const CaseResult alone = evaluate_case(base, cases.question(study_case.number), nothing, {});
    ASSERT_EQ(alone.ending, RunStatus::done);
    EXPECT_DOUBLE_EQ(study_case.values[0].value(), alone.summary["static"]["overbend"]["max_von_mises"].get<double>());
    EXPECT_DOUBLE_EQ(study_case.values[1].value(), alone.summary["static"]["lay_back"].get<double>());
  }
}

TEST(study_runner, results_depend_neither_on_threads_nor_on_interruptions) {
  const Tried tried(kTensions), two(kTensions), broken(kTensions);
  run(tried, 1);
  run(two, 2);
  EXPECT_TRUE(run(broken, 2, 4).interrupted);
  const StudyTally rest = run(broken, 1);
  EXPECT_GE(rest.before, 4U);
  EXPECT_EQ(rest.before + rest.done, 15U);
  const auto expected = collect_values(read_study(tried.folder()));
  EXPECT_EQ(collect_values(read_study(two.folder())), expected);
  EXPECT_EQ(collect_values(read_study(broken.folder())), expected);
}

TEST(study_runner, finished_cases_are_never_run_again) {
  const Tried tried(kTensions);
  run(tried);
  const StudyTally again = run(tried);
  EXPECT_EQ(again.before, 15U);
  EXPECT_EQ(again.done, 0U);
}

TEST(study_runner, a_bad_case_fails_alone_with_its_reason) {
  const Tried tried("axes: [{key: tensioner.tension, values: [300 kN, 5 kN, 310 kN]}]\n");
  const StudyTally tally = run(tried);
  EXPECT_EQ(tally.done, 2U);
  EXPECT_EQ(tally.failed, 1U);
  const StudyResults results = gather_study(tried.folder());
  EXPECT_EQ(results.cases[1].state, StudyCaseState::failed);
  EXPECT_NE(results.cases[1].reason.find("tension"), std::string::npos) << results.cases[1].reason;
  EXPECT_EQ(run(tried, 1).before, 3U);
  EXPECT_EQ(run(tried, 1, 100, true).failed, 1U);
}

TEST(study_runner, a_folder_of_another_study_is_rejected_and_says_what_differs) {
  const Tried tried(kTensions);
  run(tried, 1, 0);
  const Tried second_tried("axes: [{key: tensioner.tension, values: [300 kN]}]\n");
  try {
    open_study(*second_tried.base, *second_tried.cases, tried.folder());
    FAIL() << "accepted";
  } catch (const UnusableFolder& error) {
    EXPECT_NE(std::string(error.what()).find("another study file"), std::string::npos) << error.what();
  }
  const Tried deeper(kTensions, testing::with(testing::kSmallLay, "title: small lay", "title: another"));
  try {
    open_study(*deeper.base, *deeper.cases, tried.folder());
    FAIL() << "accepted";
  } catch (const UnusableFolder& error) {
    EXPECT_NE(std::string(error.what()).find("base model"), std::string::npos) << error.what();
  }
}

TEST(study_runner, tasks_share_the_cases_among_them) {
  const Tried tried(kTensions);
  open_study(*tried.base, *tried.cases, tried.folder());
  StopAfter watch(1000);
  StudyRunOptions options{1};
  options.tasks = 4;
  std::size_t done = 0;
  for (options.task = 0; options.task < 4; ++options.task) {
    done += run_study_cases(*tried.base, *tried.cases, tried.folder(), options, watch).done;
  }
  EXPECT_EQ(done, 15U);
  EXPECT_EQ(read_study(tried.folder()).cases[14].state, StudyCaseState::done);
}

TEST(study_runner, a_case_at_work_in_another_process_is_left_to_it) {
  const Tried tried(kTensions);
  open_study(*tried.base, *tried.cases, tried.folder());
  std::filesystem::create_directories(tried.folder() / case_folder(3));
  tried.scratch.write("out/" + case_folder(3) + "/claim.0", "");  // made this instant
  const StudyTally tally = run(tried);
  EXPECT_EQ(tally.elsewhere, 1U);
  EXPECT_EQ(tally.done, 14U);
}

TEST(study_runner, a_damaged_record_is_run_again) {
  const Tried tried(kTensions);
  run(tried);
  tried.scratch.write("out/" + case_folder(5) + "/case.json", "{\"state\": \"do");
  EXPECT_EQ(run(tried).done, 1U);
}

TEST(study_runner, seeds_share_their_statics_and_leave_records_alone) {
  const Tried tried(
      "analysis: dynamic\nduration: 4 s\nseeds: 2\n"
      "axes: [{key: tensioner.tension, values: [300 kN]}]\n"
      "gather: [dynamic.top_tension.max, dynamic.overbend.max_von_mises, static.top_tension]\n");
  const StudyTally tally = run(tried);
  ASSERT_EQ(tally.done, 2U);
  const StudyResults results = read_study(tried.folder());
  EXPECT_EQ(results.cases[0].seed, 1U);
  EXPECT_EQ(results.cases[1].group, 0U);
  EXPECT_EQ(results.cases[0].values[2], results.cases[1].values[2]);
  EXPECT_NE(results.cases[0].values[0], results.cases[1].values[0]);
  EXPECT_GT(results.cases[0].values[1].value(), 1e6);
  EXPECT_FALSE(std::filesystem::exists(tried.folder() / results.cases[0].folder / "results.h5"));
}

TEST(study_runner, records_keep_the_peaks_of_histories_for_extremes_over_seeds) {
  const std::string text =
      "analysis: dynamic\nduration: 8 s\nseeds: 2\n"
      "axes: [{key: tensioner.tension, values: [300 kN]}]\ngather: [dynamic.top_tension.max]\n";
  const Tried records(text), files(text + "keep: true\n");
  ASSERT_EQ(run(records).done, 2U);
  ASSERT_EQ(run(files).done, 2U);
  const StudyResults results = gather_study(records.folder());
  ASSERT_EQ(results.extremes.size(), 1U);
  EXPECT_EQ(results.extremes[0].runs, 2);
  EXPECT_TRUE(std::filesystem::exists(records.folder() / "report.html"));
  const Hdf5Reader file(records.folder() / "study.h5");
  EXPECT_EQ(file.doubles("/extremes/worst"), std::vector<double>{results.extremes[0].worst});
  EXPECT_TRUE(std::isnan(file.doubles("/extremes/gumbel").front())) << "two runs are too few";
  const auto kept = recorded_peaks(records.folder(), results.cases[1]);
  const auto whole = recorded_peaks(files.folder(), results.cases[1]);
  ASSERT_FALSE(kept.empty());
  ASSERT_EQ(kept.size(), whole.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].name, whole[i].name);
    ASSERT_EQ(kept[i].record.peaks.size(), whole[i].record.peaks.size()) << kept[i].name;
    for (std::size_t k = 0; k < kept[i].record.peaks.size(); ++k) {  // records have six digits
      EXPECT_NEAR(kept[i].record.peaks[k], whole[i].record.peaks[k], 1e-5 * std::abs(whole[i].record.peaks[k]));
    }
  }
}

TEST(study_runner, tables_have_a_row_for_every_case) {
  const Tried tried(kTensions);
  run(tried);
  const StudyResults results = gather_study(tried.folder());
  const std::string csv = tried.scratch.read("out/study.csv");
  EXPECT_TRUE(
      csv.starts_with("case,folder,tensioner.tension [kN],environment.water_depth [m],"
                      "static.top_tension [kN],static.lay_back [m],static.sagbend.max_von_mises [MPa],"
                      "checks.governing,checks,governing check,utilisation,state,reason,wall time [s]\r\n"))
      << csv.substr(0, 300);
  EXPECT_NE(csv.find("\r\n4,cases/0000/000000004,280,20,"), std::string::npos) << csv.substr(0, 900);
  EXPECT_TRUE(std::filesystem::exists(tried.folder() / "study.xlsx"));
  const Hdf5Reader file(tried.folder() / "study.h5");
  EXPECT_EQ(file.doubles("/inputs/tensioner.tension").at(4), 280e3);
  EXPECT_EQ(file.doubles("/outputs/static.lay_back").at(4), results.cases[4].values[1].value());
  const Json summary = read_json(tried.scratch.read("out/summary.json"));
  EXPECT_EQ(summary["study"]["done"], 15);
}

TEST(study_runner, a_case_alone_leaves_all_its_files) {
  const Tried tried(kTensions);
  open_study(*tried.base, *tried.cases, tried.folder());
  const StudyCase study_case = run_study_case(*tried.base, *tried.cases, tried.folder(), 7, [] { return false; });
  EXPECT_EQ(study_case.state, StudyCaseState::done);
  for (const char* file : {"summary.json", "report.html", "pipe.csv", "case.json"}) {
    EXPECT_TRUE(std::filesystem::exists(tried.folder() / study_case.folder / file)) << file;
  }
  EXPECT_EQ(run(tried).done, 14U);
}

TEST(study_runner, a_case_that_fails_alone_keeps_the_result_that_the_study_found) {
  const Tried tried("axes: [{key: tensioner.tension, values: [300 kN, 5 kN]}]\ngather: [static.lay_back]\n");
  open_study(*tried.base, *tried.cases, tried.folder());
  StudyCase solved = tried.cases->at(1);  // as if the case next to it had led to a solution
  solved.state = StudyCaseState::done;
  solved.values = {123.0};
  solved.verdict = VerdictKind::passed;
  write_case_record(solved, tried.cases->inputs(), study_outputs(*tried.base), tried.folder());
  const std::string record = "out/" + solved.folder + "/case.json", before = tried.scratch.read(record);
  const StudyCase alone = run_study_case(*tried.base, *tried.cases, tried.folder(), 1, [] { return false; });
  EXPECT_EQ(alone.state, StudyCaseState::failed);
  EXPECT_NE(alone.reason.find("tension"), std::string::npos) << alone.reason;
  EXPECT_NE(alone.reason.find("its record is kept"), std::string::npos) << alone.reason;
  EXPECT_EQ(tried.scratch.read(record), before);
  EXPECT_EQ(read_study(tried.folder()).cases[1].values[0], 123.0);
}

TEST(study_runner, a_goal_seek_in_every_case_gathers_its_answer) {
  const Tried tried(
      "analysis: seek\naxes: [{key: environment.water_depth, values: [19.5 m, 20.5 m]}]\n"
      "gather: [seek.answer, static.bottom_tension]\n",
      testing::kSmallLay +
          "seek: {vary: {key: tensioner.tension, from: 250 kN, to: 400 kN}, "
          "until: {result: static.bottom_tension, equals: 270 kN}}\n");
  ASSERT_EQ(run(tried).done, 2U);
  const StudyResults results = read_study(tried.folder());
  EXPECT_EQ(results.outputs[0].unit, "N");
  for (const StudyCase& study_case : results.cases) EXPECT_NEAR(study_case.values[1].value(), 270e3, 1.0);
  // The deeper pipe hangs with one metre more of its weight in water, 1.1 kN/m: H = T - w d in still water.
  const double more = results.cases[1].values[0].value() - results.cases[0].values[0].value();
  EXPECT_GT(more, 500.0);
  EXPECT_LT(more, 2000.0);
}

TEST(study_runner, a_goal_seek_in_every_case_gathers_what_it_reports_on_itself) {
  const Tried tried(
      "analysis: seek\naxes: [{key: environment.water_depth, values: [19.5 m, 20.5 m]}]\n"
      "gather: [seek.slope, seek.residual, seek.evaluations]\n",
      testing::kSmallLay +
          "seek: {vary: {key: tensioner.tension, from: 250 kN, to: 400 kN}, "
          "until: {result: static.sagbend.max_bending_stress, equals: 100 MPa}}\n");
  ASSERT_EQ(run(tried).done, 2U) << read_study(tried.folder()).cases[0].reason;
  const StudyResults results = read_study(tried.folder());
  EXPECT_EQ(results.outputs[0].unit, "N/m^2/N");
  for (const StudyCase& study_case : results.cases) {
    EXPECT_LT(study_case.values[0].value(), 0.0);  // more tension bends the sagbend less
    EXPECT_LT(study_case.values[1].value(), 1e-6);
    EXPECT_GT(study_case.values[2].value(), 2.0);
  }
}

const std::string kAbandoned =
    "operation:\n"
    "  type: abandonment\n"
    "  head: {length: 3 m, weight_in_air: 20 kN, weight_submerged: 16 kN}\n"
    "  cable: {diameter: 76 mm, weight_in_air: 240 N/m, weight_submerged: 205 N/m, "
    "axial_stiffness: 2.7e5 kN, breaking_load: 4200 kN}\n"
    "  stages: [{cable_out: 20 m, tension: 300 kN}, {cable_out: 30 m, tension: 300 kN}]\n";

TEST(study_runner, serious_findings_of_the_stages_of_an_operation_are_reported) {
  const std::string yields = testing::with(testing::kSmallLay, "yield_stress: 414 MPa", "yield_stress: 20 MPa");
  const Tried tried("analysis: operation\naxes: [{key: environment.water_depth, values: [20 m]}]\n",
                    yields + kAbandoned);
  ASSERT_EQ(run(tried).done, 1U);
  const StudyResults results = study_so_far(tried.folder());
  EXPECT_TRUE(std::ranges::any_of(messages(results.findings), [](const std::string& warning) {
    return warning.find("exceeds the yield stress of") != std::string::npos;
  }));
}

TEST(study_runner, an_operation_gathers_its_worst_stage) {
  const std::string model = testing::kSmallLay + kAbandoned;
  const Tried tried(
      "analysis: operation\naxes: [{key: environment.water_depth, values: [20 m, 20.5 m]}]\n"
      "gather: [static.top_tension, \"max(operation.stages[*].sagbend.max_von_mises)\", checks.governing, "
      "static.sagbend.max_von_mises]\n",
      model);
  ASSERT_EQ(run(tried).done, 2U) << read_study(tried.folder()).cases[0].reason;
  const StudyResults results = read_study(tried.folder());
  for (const StudyCase& study_case : results.cases) {
    EXPECT_GT(study_case.values[1].value(), 1e6);
    EXPECT_LE(study_case.values[3].value(), study_case.values[1].value());
    EXPECT_EQ(study_case.texts[2], study_case.governing);
  }
}

TEST(study_runner, kept_cases_have_the_files_of_the_command_and_its_numbers) {
  const Tried tried(
      "keep: true\naxes: [{key: tensioner.tension, values: [300 kN, 310 kN]}]\n"
      "gather: [static.lay_back]\n");
  ASSERT_EQ(run(tried).done, 2U);
  const StudyResults results = read_study(tried.folder());
  for (const StudyCase& study_case : results.cases) {
    const Json summary = read_json(tried.scratch.read("out/" + study_case.folder + "/summary.json"));
    EXPECT_EQ(summary["static"]["lay_back"].get<double>(), study_case.values[0].value());
    EXPECT_TRUE(std::filesystem::exists(tried.folder() / study_case.folder / "results.h5"));
    EXPECT_TRUE(std::filesystem::exists(tried.folder() / study_case.folder / "case.json"));
  }
}

/// Counts how often it is held, in the place of the process's own lock while it lives.
class CountedLock : public FileLock {
 public:
  CountedLock() { set_hdf5_lock(*this); }
  ~CountedLock() override { set_hdf5_lock(before_); }
  CountedLock(const CountedLock&) = delete;
  CountedLock& operator=(const CountedLock&) = delete;
  void lock() override {
    FileLock::lock();
    ++held;
  }
  int held = 0;

 private:
  FileLock& before_ = hdf5_lock();
};

TEST(study_runner, the_lock_of_hdf5_is_held_while_files_are_written) {
  const Tried tried("keep: true\naxes: [{key: tensioner.tension, values: [300 kN, 310 kN]}]\n");
  const CountedLock lock;
  StopAfter watch(1000);
  ASSERT_EQ(execute_study(*tried.base, tried.folder(), {}, watch).ending, RunStatus::done);
  EXPECT_EQ(lock.held, 3) << "for each case and for the tables";
}

TEST(study_runner, what_there_is_so_far_is_read_without_writing_tables) {
  const Tried tried(kTensions);
  run(tried, 1, 4);
  const StudyResults results = study_so_far(tried.folder());
  EXPECT_EQ(std::ranges::count(results.cases, StudyCaseState::done, &StudyCase::state), 4);
  EXPECT_FALSE(std::filesystem::exists(tried.folder() / "study.csv"));
}

}  // namespace
}  // namespace overbend

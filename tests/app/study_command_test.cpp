/// The command `study`: exit codes, killed studies, single cases.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "base/json.h"
#include "child_program.h"
#include "program.h"
#include "small_lay.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::run_program;
using testing::Scratch;
namespace fs = std::filesystem;

/// Writes lay.yaml and study.yaml; the path of the latter.
std::string study_in(const Scratch& scratch, const std::string& text) {
  scratch.write("lay.yaml", kSmallLay);
  return scratch.write("study.yaml", "overbend_study: 1\nbase: lay.yaml\n" + text);
}

const std::string kTwo = "axes: [{key: tensioner.tension, values: [290 kN, 300 kN]}]\n";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t records_in(const fs::path& folder) {
  std::size_t count = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    count += entry->path().filename() == "case.json" ? 1 : 0;
  }
  return count;
}

TEST(study_command, writes_a_table_and_says_how_many_cases_there_are) {
  const Scratch scratch;
  const std::string study = study_in(scratch, kTwo);
  const auto done = run_program("study " + study + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(has(done.out, "2 cases, analysis: static")) << done.out;
  EXPECT_TRUE(has(done.out, "static.lay_back")) << done.out;
  EXPECT_TRUE(fs::exists(scratch.file("out/study.csv")));
  EXPECT_TRUE(fs::is_empty(scratch.file("out/workers")));
  EXPECT_FALSE(fs::exists(scratch.file("out/cases/0000/000000000/claim.0")));
}

TEST(study_command, ends_with_2_on_wrong_input_and_3_where_no_case_has_a_solution) {
  const Scratch scratch;
  EXPECT_EQ(run_program("study " + study_in(scratch, "axes: []\n")).code, 2);
  EXPECT_EQ(run_program("study " + study_in(scratch, kTwo) + " --tasks 2/2").code, 2);
  const auto none = run_program("study " + study_in(scratch, "axes: [{key: tensioner.tension, values: [5 kN]}]\n") +
                                " -o " + scratch.file("none"));
  EXPECT_EQ(none.code, 3);
  EXPECT_TRUE(has(none.out, "--case 0")) << none.out;
}

TEST(study_command, ends_with_4_when_strict_and_a_case_exceeds_a_check) {
  const Scratch scratch;
  const std::string study = study_in(scratch, "axes: [{key: pipe.steel.yield_stress, values: [414 MPa, 60 MPa]}]\n");
  EXPECT_EQ(run_program("study " + study + " -o " + scratch.file("out")).code, 0);
  EXPECT_EQ(run_program("study " + study + " -o " + scratch.file("out") + " --strict").code, 4);
}

TEST(study_command, judges_a_moored_vessel_by_its_lines) {
  const Scratch scratch;
  const std::string study = scratch.write(
      "study.yaml", "overbend_study: 1\nbase: " + testing::example("moored-barge.yaml") +
                        "\naxes: [{key: \"environment.current[0].speed\", values: [0.4 m/s, 0.5 m/s]}]\n");
  const auto done = run_program("study " + study + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err << done.out;
  EXPECT_TRUE(has(done.out, "2 of 2 cases solved: 2 passed")) << done.out;
  EXPECT_TRUE(has(scratch.read("out/study.csv"), ",passed,")) << scratch.read("out/study.csv");
}

TEST(study_command, a_dry_run_lists_the_cases_and_writes_nothing) {
  const Scratch scratch;
  const auto dry = run_program("study " + study_in(scratch, kTwo) + " --dry-run -o " + scratch.file("out"));
  ASSERT_EQ(dry.code, 0) << dry.err;
  EXPECT_TRUE(has(dry.out, "case 1: tensioner.tension = 300 kN")) << dry.out;
  EXPECT_TRUE(has(dry.out, "for all on")) << dry.out;
  EXPECT_FALSE(fs::exists(scratch.file("out")));
}

TEST(study_command, a_dry_run_needs_no_folder_for_temporary_files) {
  const Scratch scratch;
  const auto dry = run_program("study " + study_in(scratch, kTwo) + " --dry-run", "TMPDIR=/no/such/folder ");
  EXPECT_EQ(dry.code, 0) << dry.err;
  EXPECT_TRUE(has(dry.out, "for all on")) << dry.out;
}

TEST(study_command, the_command_printed_for_a_failed_case_runs_it_alone) {
  const Scratch scratch;
  const std::string study = study_in(scratch, kTwo);
  const auto alone = run_program("study " + study + " -o " + scratch.file("out") + " --case 1");
  ASSERT_EQ(alone.code, 0) << alone.err;
  EXPECT_TRUE(fs::exists(scratch.file("out/cases/0000/000000001/report.html")));
  EXPECT_EQ(run_program("study " + study + " -o " + scratch.file("out") + " --case 2").code, 2);
}

TEST(study_command, tasks_leave_the_table_to_gather) {
  const Scratch scratch;
  const std::string study = study_in(scratch, kTwo), out = " -o " + scratch.file("out");
  ASSERT_EQ(run_program("study " + study + out + " --tasks 1/2").code, 0);
  EXPECT_FALSE(fs::exists(scratch.file("out/study.csv")));
  const auto part = run_program("study " + scratch.file("out") + " --gather");
  EXPECT_EQ(part.code, 0) << part.err;
  EXPECT_TRUE(has(part.out, "1 not run yet")) << part.out;
  ASSERT_EQ(run_program("study " + study + out + " --tasks 0/2").code, 0);
  EXPECT_EQ(run_program("study " + scratch.file("out") + " --gather").code, 0);
  EXPECT_EQ(read_json(scratch.read("out/summary.json"))["status"], "completed");
}

TEST(study_command, killed_at_any_instant_it_goes_on_and_gives_the_same_table) {
  const std::string many =
      "axes: [{key: tensioner.tension, from: 260 kN, to: 340 kN, steps: 161}]\n"
      "gather: [static.top_tension, static.lay_back]\n";
  const Scratch whole, killed;
  const std::string study = study_in(killed, many);
  ASSERT_EQ(run_program("study " + study_in(whole, many) + " -o " + whole.file("out")).code, 0);
  for (const std::size_t wanted : {10U, 50U}) {
    testing::ChildProgram child(killed.file("."), {"study", study, "-o", "out", "--threads", "2"});
    while (records_in(killed.file("out")) < wanted) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    // its destructor kills it
  }
  const std::size_t finished = records_in(killed.file("out"));
  ASSERT_LT(finished, 161U);
  const auto rest = run_program("study " + study + " -o " + killed.file("out"));
  ASSERT_EQ(rest.code, 0) << rest.err;
  EXPECT_TRUE(has(rest.err, std::to_string(161 - finished) + " cases run")) << rest.err;
  const auto without_times = [](const std::string& table) {
    std::string text;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) text += line.substr(0, line.find_last_of(',')) + "\n";
    return text;
  };
  EXPECT_EQ(without_times(killed.read("out/study.csv")), without_times(whole.read("out/study.csv")));
}

TEST(study_command, a_killed_dynamic_case_goes_on_from_its_checkpoint) {
  const Scratch scratch;
  const std::string study = study_in(scratch,
                                     "analysis: dynamic\nduration: 40 s\nseeds: [3]\n"
                                     "gather: [dynamic.top_tension.max, dynamic.top_tension.std]\n");
  const fs::path place = scratch.file("out/cases/0000/000000000");
  testing::ChildProgram child(scratch.file("."), {"study", study, "-o", "out", "--checkpoint", "0"});
  ASSERT_TRUE(child.signal_after(place, 10.0, SIGKILL));
  child.end();
  EXPECT_EQ(records_in(scratch.file("out")), 0U);
  EXPECT_GE(RunStore::find(place).value().time, 10.0);
  ASSERT_EQ(run_program("study " + study + " -o " + scratch.file("out")).code, 0);
  ASSERT_EQ(run_program("study " + study + " -o " + scratch.file("whole")).code, 0);
  const auto outputs = [&](const std::string& folder) {
    return read_json(scratch.read(folder + "/cases/0000/000000000/case.json"))["outputs"];
  };
  EXPECT_EQ(outputs("out"), outputs("whole"));
}

TEST(study_command, ctrl_c_ends_at_a_checkpoint_with_130) {
  const Scratch scratch;
  const std::string study = study_in(scratch, "analysis: dynamic\nduration: 100000 s\nseeds: [3]\n");
  testing::ChildProgram child(scratch.file("."), {"study", study, "-o", "out", "--checkpoint", "0"});
  ASSERT_TRUE(child.signal_after(scratch.file("out/cases/0000/000000000"), 0.0, SIGINT));
  EXPECT_EQ(child.end(), 130);
}

}  // namespace
}  // namespace overbend

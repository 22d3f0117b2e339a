/// `overbend study` of limits, here and by a Slurm that is a script of ours.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/program.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::run_program;
using testing::Scratch;

/// Largest tension that the anchor holds, at two depths.
std::string anchor_study(const Scratch& scratch) {
  return scratch.write("anchor.yaml", "overbend_study: 1\nbase: " + testing::example("first-model.yaml") + R"(
axes:
  - {key: environment.water_depth, values: [38 m, 40 m]}
  - {key: tensioner.tension, from: 280 kN, to: 320 kN, steps: 2}
operability:
  over: tensioner.tension
  resolution: 10 kN
  criterion:
    - {result: static.bottom_tension, at_most: 258.5 kN}
)");
}

/// Runs the tasks of an array one after the other, all but the first of those it is given first.
void write_slurm(const Scratch& scratch) {
  const auto program = [&](const std::string& name, const std::string& text) {
    fs::permissions(scratch.write(name, "#!/bin/sh\n" + text), fs::perms::owner_all);
  };
  program("scontrol", "exit 1\n");
  program("squeue", "exit 0\n");
  program("sbatch", R"(for word; do
  case "$word" in
    --array=*) array=${word#--array=};;
    --*) ;;
    *) break;;
  esac
  shift
done
[ "$array" = 0-1 ] && array=1
SLURM_ARRAY_TASK_ID=$array
export SLURM_ARRAY_TASK_ID
/bin/sh "$@" >/dev/null 2>&1
echo 17
)");
}

}  // namespace

TEST(operability_command, finds_limits_and_writes_them) {
  const Scratch scratch;
  const std::string study = anchor_study(scratch), out = scratch.file("out");
  const auto run = run_program("study " + study + " -o " + out);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("Limiting tensioner.tension"), std::string::npos) << run.out;
  const std::string csv = scratch.read("out/operability.csv");
  EXPECT_NE(csv.find("environment.water_depth [m],largest tensioner.tension [kN]"), std::string::npos) << csv;
  EXPECT_NE(csv.find("static.bottom_tension at most 258.5 kN"), std::string::npos) << csv;
  for (const char* file : {"study.xlsx", "study.h5", "summary.json", "operability.json"}) {
    EXPECT_TRUE(fs::exists(scratch.file("out") + "/" + file)) << file;
  }
  const auto again = run_program("study " + study + " -o " + out);
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(again.err.find("passed"), std::string::npos) << "runs nothing again: " << again.err;
  EXPECT_EQ(scratch.read("out/operability.csv"), csv);
}

TEST(operability_command, a_dry_run_counts_limits_and_searches_not_cases) {
  const Scratch scratch;
  const auto dry = run_program("study " + anchor_study(scratch) + " --dry-run -o " + scratch.file("out"));
  ASSERT_EQ(dry.code, 0) << dry.err;
  EXPECT_NE(dry.out.find("2 limits to search (2 values of environment.water_depth), analysis: static"),
            std::string::npos)
      << dry.out;
  EXPECT_NE(dry.out.find("each limit is one of 5 values of tensioner.tension from 280 kN to 320 kN"), std::string::npos)
      << dry.out;
  // a bisection of five values tries three of them, statics without seeds
  EXPECT_NE(dry.out.find("for about 6 analyses on"), std::string::npos) << dry.out;
  EXPECT_EQ(dry.out.find("case"), std::string::npos) << dry.out;
  EXPECT_FALSE(fs::exists(scratch.file("out")));
}

TEST(operability_command, rows_of_a_chart_run_on_slurm_are_resubmitted_and_gathered) {
  const Scratch scratch;
  write_slurm(scratch);
  const std::string study = anchor_study(scratch), out = scratch.file("out");
  const std::string path = "PATH=" + scratch.file("") + ":$PATH ";
  const auto sent = run_program("study " + study + " -o " + out + " --on slurm --cases-per-task 1", path);
  ASSERT_EQ(sent.code, 0) << sent.err;
  EXPECT_NE(sent.out.find("Job 17: 2 of 2 tasks"), std::string::npos) << sent.out;
  const auto seen = run_program("study " + study + " -o " + out + " --watch", path);
  EXPECT_NE(seen.out.find("1 of 2 done"), std::string::npos) << seen.out;
  ASSERT_EQ(run_program("study " + study + " -o " + out + " --resubmit", path).code, 0);
  EXPECT_NE(run_program("study " + study + " -o " + out + " --watch", path).out.find("2 of 2 done"), std::string::npos);
  ASSERT_EQ(run_program("study " + out + " --gather").code, 0);
  ASSERT_EQ(run_program("study " + study + " -o " + scratch.file("here")).code, 0);
  EXPECT_EQ(scratch.read("out/operability.csv"), scratch.read("here/operability.csv"));
  const auto none = run_program("study " + study + " -o " + out + " --resubmit", path);
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("every case is finished"), std::string::npos) << none.err;
}

TEST(operability_command, says_that_there_is_no_slurm) {
  const Scratch scratch;
  fs::create_directory(scratch.file("empty"));
  const auto run = run_program("study " + anchor_study(scratch) + " -o " + scratch.file("out") + " --on slurm",
                               "PATH=" + scratch.file("empty") + " ");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("sbatch is not on the PATH"), std::string::npos) << run.err;
}

}  // namespace overbend

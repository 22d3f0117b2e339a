#include "study/cluster/slurm.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/program.h"
#include "platform/process.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::Scratch;

/// A folder of programs of Slurm that are scripts of ours, before all others on the PATH.
class FakeSlurm {
 public:
  FakeSlurm() : before_(std::getenv("PATH")) { ::setenv("PATH", (scratch_.file("") + ":" + before_).c_str(), 1); }
  ~FakeSlurm() { ::setenv("PATH", before_.c_str(), 1); }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  void program(const std::string& name, const std::string& text) const {
    fs::permissions(scratch_.write(name, "#!/bin/sh\n" + text), fs::perms::owner_all);
  }
  /// Keeps its arguments, a line each.
  void sbatch_answers(const std::string& answer) const {
    program("sbatch", "printf '%s\\n' \"$@\" > '" + scratch_.file("asked") + "'\n" + answer);
  }
  std::string asked() const { return scratch_.read("asked"); }
  SlurmStudy study() const {
    return {"/opt/over bend/bin/overbend", "/home/o'neil/a study.yaml", scratch_.file("out")};
  }

 private:
  std::string before_;
  Scratch scratch_;
};

std::vector<std::size_t> upto(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

}  // namespace

TEST(slurm, a_task_runs_its_cases_of_the_study) {
  // The script is run with echo in the place of the program.
  const Scratch scratch;
  const std::string script = scratch.write("job.sh", slurm_script({"/bin/echo", "/home/o'neil/a study.yaml", "/d $x"}));
  const auto prescribed = overbend::run_program({"env", "SLURM_ARRAY_TASK_ID=3", "sh", script, "8", "--retry-failed"});
  ASSERT_TRUE(prescribed);
  EXPECT_EQ(prescribed->out, "study /home/o'neil/a study.yaml -o /d $x --threads 1 --tasks 3/8 --retry-failed\n");
}

TEST(slurm, cases_are_divided_among_tasks) {
  EXPECT_EQ(task_count(100, 10, 1001), 10U);
  EXPECT_EQ(task_count(101, 10, 1001), 11U);
  EXPECT_EQ(task_count(100000, 10, 1001), 1001U);
  EXPECT_EQ(task_count(0, 10, 1001), 1U);
  EXPECT_EQ(find_tasks({0, 4, 8, 9}, 4), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(array_argument({0, 1, 2, 3, 7, 9, 10}, 0), "0-3,7,9-10");
  EXPECT_EQ(array_argument({5}, 20), "5%20");
}

TEST(slurm, submits_an_array_and_remembers_it) {
  const FakeSlurm slurm;
  slurm.program("scontrol", "echo 'MaxArraySize            = 11'");
  slurm.program("squeue", "exit 1");
  slurm.sbatch_answers("echo '4711;north'");
  const SlurmJob job = submit_to_slurm(slurm.study(), {"long; rm -rf", "1:00:00", 5, 4}, 1000, upto(1000));
  EXPECT_EQ(job.id, "4711");
  EXPECT_EQ(job.count, 11U);
  const std::string asked = slurm.asked();
  EXPECT_NE(asked.find("--array=0-10%4\n"), std::string::npos) << asked;
  EXPECT_NE(asked.find("--partition=long; rm -rf\n"), std::string::npos);
  EXPECT_NE(asked.find("--time=1:00:00\n"), std::string::npos);
  const std::vector<SlurmJob> jobs = slurm_jobs(slurm.study().folder);
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs[0].id, "4711");
  EXPECT_EQ(jobs[0].tasks, upto(11));
  EXPECT_TRUE(fs::exists(slurm.study().folder / "slurm" / "job.sh"));
}

TEST(slurm, submits_again_what_is_open_and_not_in_the_queue) {
  const FakeSlurm slurm;
  slurm.program("scontrol", "exit 1");
  slurm.program("squeue", "echo '2 RUNNING'; echo '3 PENDING'");
  slurm.sbatch_answers("echo 1");
  submit_to_slurm(slurm.study(), {"", "", 10, 0}, 60, upto(60));
  slurm.sbatch_answers("echo 2");
  // Cases 1, 2, 7 and 9 belong to tasks 1, 2, 1 and 3 of 6.
  const SlurmJob again = submit_to_slurm(slurm.study(), {"", "", 99, 0}, 60, {1, 2, 7, 9}, {"--retry-failed"});
  EXPECT_EQ(again.count, 6U);
  EXPECT_EQ(again.tasks, (std::vector<std::size_t>{1}));
  EXPECT_NE(slurm.asked().find("\n6\n--retry-failed\n"), std::string::npos) << slurm.asked();
  EXPECT_EQ(slurm_jobs(slurm.study().folder).size(), 2U);
  EXPECT_THROW(submit_to_slurm(slurm.study(), {}, 60, {2, 3}), SlurmError);
}

TEST(slurm, says_what_it_rejects_and_remembers_nothing) {
  const FakeSlurm slurm;
  slurm.program("scontrol", "exit 1");
  slurm.sbatch_answers("echo 'invalid partition specified: x' >&2; exit 1");
  try {
    submit_to_slurm(slurm.study(), {}, 4, upto(4));
    FAIL();
  } catch (const SlurmError& error) {
    EXPECT_NE(std::string(error.what()).find("invalid partition specified: x"), std::string::npos);
  }
  EXPECT_TRUE(slurm_jobs(slurm.study().folder).empty());
  slurm.sbatch_answers("echo 'no number'");
  EXPECT_THROW(submit_to_slurm(slurm.study(), {}, 4, upto(4)), SlurmError);
}

TEST(slurm, queue_reports_the_states_of_tasks_that_are_there) {
  const FakeSlurm slurm;
  slurm.program("squeue",
                "case \"$3\" in --jobs=1) echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1;;\n"
                "*) echo '0 RUNNING'; echo '5 PENDING'; echo '6 COMPLETING';; esac");
  const auto queue = slurm_queue({{"1", 8, {0}}, {"2", 8, {0, 5, 6}}});
  ASSERT_TRUE(queue);
  EXPECT_EQ(*queue, (std::map<std::size_t, std::string>{{0, "RUNNING"}, {5, "PENDING"}}));
  slurm.program("squeue", "echo 'cannot reach the controller' >&2; exit 1");
  EXPECT_FALSE(slurm_queue({{"1", 8, {0}}}));
}

}  // namespace overbend

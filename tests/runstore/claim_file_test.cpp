#include "runstore/claim_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "app/program.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Files left by a process that claims the task in a folder and is killed.
void claim_and_die(const fs::path& folder) {
  const pid_t id = fork();
  if (id == 0) {
    const WorkerFile worker(folder / "workers");
    worker.claim(folder / "task");
    _exit(0);  // no destructor runs: as if killed
  }
  waitpid(id, nullptr, 0);
}

TEST(claim_file, a_task_is_claimed_once) {
  const testing::Scratch scratch;
  const WorkerFile worker(scratch.file("workers"));
  EXPECT_TRUE(worker.claim(scratch.file("task")));
  EXPECT_FALSE(worker.claim(scratch.file("task")));
  release_claims(scratch.file("task"));
  EXPECT_TRUE(worker.claim(scratch.file("task")));
}

TEST(claim_file, a_claim_is_whole_from_its_first_instant) {
  const testing::Scratch scratch;
  const WorkerFile worker(scratch.file("workers"));
  ASSERT_TRUE(worker.claim(scratch.file("task")));
  // Another name of a file that was finished before: at no time was there a claim without the name of its worker.
  EXPECT_TRUE(fs::equivalent(scratch.file("task.0"), fs::path(scratch.file("workers")) / worker.name()));
  EXPECT_EQ(scratch.read("task.0"), worker.name() + "\n");
}

TEST(claim_file, a_claim_of_a_worker_whose_own_file_is_gone_is_made_all_the_same) {
  const testing::Scratch scratch;
  const WorkerFile worker(scratch.file("workers"));
  fs::remove(fs::path(scratch.file("workers")) / worker.name());
  EXPECT_TRUE(worker.claim(scratch.file("task")));
  EXPECT_FALSE(worker.claim(scratch.file("task")));
  EXPECT_EQ(scratch.read("task.0"), worker.name() + "\n");
}

TEST(claim_file, the_claim_of_a_dead_process_is_taken_over_once) {
  const testing::Scratch scratch;
  claim_and_die(scratch.file(""));
  ASSERT_TRUE(fs::exists(scratch.file("task.0")));
  const WorkerFile worker(scratch.file("workers"));
  EXPECT_TRUE(worker.claim(scratch.file("task")));
  EXPECT_TRUE(fs::exists(scratch.file("task.1")));
  EXPECT_FALSE(worker.claim(scratch.file("task")));
  release_claims(scratch.file("task"));
  EXPECT_FALSE(fs::exists(scratch.file("task.0")));
}

TEST(claim_file, a_worker_of_another_machine_lives_as_long_as_its_file_is_touched) {
  const testing::Scratch scratch;
  const WorkerFile worker(scratch.file("workers"));
  scratch.write("workers/other.1.1", "other.1.1\n");
  scratch.write("task.0", "other.1.1\n");
  EXPECT_FALSE(worker.claim(scratch.file("task")));
  fs::last_write_time(scratch.file("workers/other.1.1"), fs::file_time_type::clock::now() - std::chrono::minutes(10));
  EXPECT_TRUE(worker.claim(scratch.file("task")));
}

TEST(claim_file, a_claim_that_was_never_written_is_dead_when_it_is_old) {
  const testing::Scratch scratch;
  const WorkerFile worker(scratch.file("workers"));
  scratch.write("task.0", "");
  EXPECT_FALSE(worker.claim(scratch.file("task")));
  fs::last_write_time(scratch.file("task.0"), fs::file_time_type::clock::now() - std::chrono::minutes(10));
  EXPECT_TRUE(worker.claim(scratch.file("task")));
}

TEST(claim_file, a_worker_goes_with_its_process) {
  const testing::Scratch scratch;
  { const WorkerFile worker(scratch.file("workers")); }
  EXPECT_TRUE(fs::is_empty(scratch.file("workers")));
}

}  // namespace
}  // namespace overbend

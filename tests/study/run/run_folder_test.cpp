#include "study/run/run_folder.h"

#include <gtest/gtest.h>

#include <thread>

#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::TemporaryFolder;

TEST(run_folder, the_record_comes_back_as_it_was_written) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_record(folder.path()));
  RunRecord record;
  record.kind = "seeds";
  record.seeds = {3, 9007199254740993ULL};
  record.state = RunState::cancelled;
  record.note = "for the client";
  record.duration = 600.0;
  write_record(record, folder.path());
  const std::optional<RunRecord> read = read_record(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->seeds, record.seeds);
  EXPECT_EQ(read->state, RunState::cancelled);
  EXPECT_EQ(read->note, record.note);
  EXPECT_EQ(read->duration, 600.0);
}

TEST(run_folder, results_are_finished_for_their_own_input_alone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(is_finished(folder.path(), "model"));
  mark_finished(folder.path(), "dynamic", "a lay", "model");
  EXPECT_TRUE(is_finished(folder.path(), "model"));
  EXPECT_THROW(is_finished(folder.path(), "another model"), std::runtime_error);
  mark_unfinished(folder.path());
  EXPECT_FALSE(is_finished(folder.path(), "another model"));
}

TEST(run_folder, what_the_user_wrote_outlives_a_new_run) {
  const TemporaryFolder folder;
  change_record(folder.path(), [](RunRecord& record) { record.name = "limit"; });
  mark_finished(folder.path(), "dynamic", "a lay", "model");
  mark_unfinished(folder.path());
  EXPECT_EQ(read_record(folder.path())->name, "limit");
}

TEST(run_folder, threads_that_change_a_record_at_once_lose_nothing) {
  const TemporaryFolder folder;
  constexpr int kChanges = 200;
  const auto count = [&](double RunRecord::*member) {
    for (int i = 0; i < kChanges; ++i) change_record(folder.path(), [&](RunRecord& record) { record.*member += 1.0; });
  };
  std::thread second(count, &RunRecord::duration);
  count(&RunRecord::progress);
  second.join();
  const std::optional<RunRecord> read = read_record(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->duration, kChanges);
  EXPECT_EQ(read->progress, kChanges);
}

TEST(run_folder, a_file_that_only_looks_like_a_record_is_none) {
  const TemporaryFolder folder;
  testing::write_file(folder / "run.json", "{\"seeds\": \"many\"}");
  EXPECT_FALSE(read_record(folder.path()));
  EXPECT_FALSE(is_finished(folder.path(), "model"));
  testing::write_file(folder / "run.json", "no JSON");
  EXPECT_FALSE(read_record(folder.path()));
}

}  // namespace
}  // namespace overbend

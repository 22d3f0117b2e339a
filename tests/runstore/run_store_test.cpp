#include "runstore/run_store.h"

#include <gtest/gtest.h>

#include "support/stored_run.h"

namespace overbend {
namespace {

using namespace testing::stored_run;
using testing::TemporaryFolder;

TEST(run_store, gives_back_what_it_was_given) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder / "a/b", kModel, kSeed);
  store.begin(columns(), {kStations, 0});
  give(store, 0, 57);
  expect_run(store, 57);
  give(store, 57, 83);
  expect_run(store, 83);
}

TEST(run_store, takes_up_at_the_checkpoint_and_drops_what_came_after) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  EXPECT_EQ(RunStore::find(folder.path()).value().time, 50.0);
  EXPECT_EQ(RunStore::find(folder.path()).value().error, "");
  EXPECT_FALSE(RunStore::find(folder.path()).value().active);
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  ASSERT_TRUE(run);
  EXPECT_TRUE(RunStore::find(folder.path()).value().active);  // another process writes it
  expect_run(run->store, 100);
  ASSERT_EQ(run->state.arrays.size(), 2U);
  EXPECT_EQ(run->state.time, 50.0);
  EXPECT_EQ(run->state.arrays[0].name, "q");
  EXPECT_EQ(run->state.arrays[0].values, state(100).arrays[0].values);
  EXPECT_TRUE(std::signbit(run->state.arrays[0].values[1]));
  EXPECT_TRUE(run->state.arrays[1].values.empty());
  run->store.begin(columns(), {kStations, 0});
  give(run->store, 100, 200);
  expect_run(run->store, 200);
}

TEST(run_store, has_nothing_to_take_up_before_the_first_checkpoint) {
  const TemporaryFolder folder;
  EXPECT_FALSE(RunStore::find(folder.path()));
  EXPECT_FALSE(RunStore::resume(folder.path(), kModel, kSeed));
  {
    RunStore store = RunStore::create(folder.path(), kModel, kSeed);
    store.begin(columns(), {kStations, 0});
    give(store, 0, 10);
  }
  EXPECT_FALSE(RunStore::find(folder.path()));
  EXPECT_FALSE(RunStore::resume(folder.path(), kModel, kSeed));
}

TEST(run_store, rejects_other_histories_than_it_holds) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunStore store = std::move(RunStore::resume(folder.path(), kModel, kSeed).value().store);
  EXPECT_THROW(store.begin({columns()[0], columns()[1]}, {kStations, 0}), std::runtime_error);
  EXPECT_THROW(store.begin(columns(), {kStations + 1, 0}), std::runtime_error);
  EXPECT_NO_THROW(store.begin(columns(), {kStations, 0}));
}

TEST(run_store, is_held_by_one_at_a_time) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  EXPECT_NE(find_run_error(folder.path()).find("another run is active"), std::string::npos);
  EXPECT_THROW(RunStore::create(folder.path(), kModel, kSeed), std::runtime_error);
  run.reset();
  EXPECT_EQ(find_run_error(folder.path()), "");
}

TEST(run_store, begins_anew_over_an_older_run) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  EXPECT_FALSE(RunStore::find(folder.path()));
  store.begin(columns(), {kStations, 0});
  EXPECT_EQ(store.rows() + store.snapshots() + store.impacts(), 0);
  EXPECT_TRUE(store.column(1).empty());
}

TEST(run_store, leaves_nothing_when_removed_but_the_files_of_others) {
  const TemporaryFolder folder;
  RunStore::create(folder / "new", kModel, kSeed).remove();
  EXPECT_FALSE(fs::exists(folder / "new"));
  testing::write_file(folder / "notes.txt", "mine");
  stop_a_run(folder.path());
  RunStore::resume(folder.path(), kModel, kSeed).value().store.remove();
  EXPECT_FALSE(fs::exists(folder / ".run"));
  EXPECT_TRUE(fs::exists(folder / "notes.txt"));
}

TEST(run_store, says_why_it_can_not_write) {
  const TemporaryFolder folder;
  testing::write_file(folder / "file", "mine");
  try {
    RunStore::create(folder / "file/results", kModel, kSeed);
    ADD_FAILURE() << "a folder inside a file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be written: Not a directory"), std::string::npos);
  }
  EXPECT_EQ(testing::file_text(folder / "file"), "mine");
}

TEST(run_store, takes_nothing_in_before_it_has_begun_and_no_row_of_another_size) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  const std::vector<double> two(2);
  EXPECT_THROW(store.row(two), std::logic_error);
  EXPECT_THROW(store.impact(impact(0)), std::logic_error);
  EXPECT_THROW(store.checkpoint(state(0)), std::logic_error);
  store.begin(columns(), {kStations, 0});
  EXPECT_THROW(store.row(two), std::logic_error);
  EXPECT_THROW(store.snapshot(0.0, two), std::logic_error);
}

TEST(run_store, reads_columns_alike_however_many_fit_its_memory) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  const std::size_t width = 40, length = 300'000;  // 12 million numbers: three times what is kept
  std::vector<HistoryColumn> many(width, columns()[1]);
  store.begin(many, {0, 0});
  std::vector<double> values(width);
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t c = 0; c < width; ++c) values[c] = static_cast<double>(c * length + i);
    store.row(values);
  }
  for (const std::size_t c : {0U, 1U, 12U, 13U, 14U, 39U, 2U}) {
    const std::vector<double> column = store.column(c);
    ASSERT_EQ(column.size(), length);
    for (std::size_t i = 0; i < length; i += 997) ASSERT_EQ(column[i], static_cast<double>(c * length + i));
  }
}

/// Address space of this process in pages.
std::size_t pages() {
  std::ifstream file("/proc/self/statm");
  std::size_t count = 0;
  file >> count;
  return count;
}

TEST(run_store, does_not_grow_in_memory_with_a_million_rows) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  store.begin(columns(), {kStations, 0});
  give(store, 0, 1000);
  const std::size_t before = pages();
  give(store, 1000, 1'001'000);
  EXPECT_EQ(store.rows(), 1'001'000);
  // 60 MB have been handed over; the 1 MB (256 pages) is for what the test and its libraries need themselves.
  EXPECT_LE(pages(), before + 256);
}

TEST(run_store, derived_columns_follow_the_recorded_ones) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  store.begin(columns(), {kStations, 0});
  give(store, 0, 40);
  std::vector<double> halves = store.column(1);
  for (double& value : halves) value *= 0.5;
  store.derive({"half", "N", "Half the tension"}, halves);
  ASSERT_EQ(store.columns().size(), columns().size() + 1);
  EXPECT_EQ(store.columns().back().name, "half");
  EXPECT_EQ(store.column(columns().size()), halves);
  expect_rows(store, 40);
  EXPECT_THROW(store.column(columns().size() + 1), std::out_of_range);
}

TEST(run_store, points_of_mooring_lines_belong_to_a_snapshot) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  store.begin(columns(), {kStations, 2});
  EXPECT_EQ(store.snapshot_size(), 1 + 5 * kStations + 12 + 4 * 2);
  const std::vector<double> values(5 * kStations + 12 + 4 * 2, 7.0);
  store.snapshot(1.0, values);
  store.checkpoint(state(0));
  EXPECT_EQ(store.snapshots(), 1);
  EXPECT_EQ(store.snapshot_block(0, 1).back(), 7.0);
  EXPECT_THROW(store.begin(columns(), {kStations, 0}), std::runtime_error);
}

}  // namespace
}  // namespace overbend

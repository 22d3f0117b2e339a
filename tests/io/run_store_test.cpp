#include "io/run_store.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "io/append_file.h"
#include "io/checkpoint_file.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

const std::string kModel = "title: a model\n";
constexpr std::uint64_t kSeed = 0xfedcba9876543210ULL;
constexpr int kStations = 3;

const std::vector<HistoryColumn>& columns() {
  static const std::vector<HistoryColumn> all = {{"time", "s", "Time", false, false},
                                                 {"top_tension", "N", "Tension", true, true},
                                                 {"support/box 8/reaction", "N", "Reaction", true, false}};
  return all;
}

void give_row(RunStore& store, int i) {
  const std::vector<double> values = {0.5 * i, std::sin(i), 1e3 / (1 + i)};
  store.row(values);
}

void give_snapshot(RunStore& store, int i) {
  std::vector<double> values(5 * kStations + 12);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = i + 0.01 * static_cast<double>(k);
  store.snapshot(0.5 * i, values);
}

Impact impact(int i) {
  return {i, 0.25 * i, 0.1, 1e5 + i, 0.02, 900.0, 1e-4, 2e6};
}

DynamicCheckpoint state(int i) {
  return {0.5 * i, {{"q", {1.0 / 3.0, -0.0, std::numeric_limits<double>::denorm_min(), 1.0 * i}}, {"none", {}}}};
}

/// Rows, snapshots and impacts number `from` to `to`.
void give(RunStore& store, int from, int to) {
  for (int i = from; i < to; ++i) {
    give_row(store, i);
    if (i % 10 == 0) give_snapshot(store, i);
    if (i % 5 == 0) store.impact(impact(i));
  }
}

/// A run that has come to row 100 and was stopped at 130.
void stop_a_run(const fs::path& folder) {
  RunStore store = RunStore::create(folder, kModel, kSeed);
  store.begin(columns(), kStations);
  give(store, 0, 100);
  store.checkpoint(state(100));
  give(store, 100, 130);
}

void expect_rows(const RunStore& store, int count) {
  ASSERT_EQ(store.rows(), count);
  const std::vector<double> time = store.column(0), tension = store.column(1), reaction = store.column(2);
  ASSERT_EQ(time.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ASSERT_EQ(time[k], 0.5 * i);
    ASSERT_EQ(tension[k], std::sin(i));
    ASSERT_EQ(reaction[k], 1e3 / (1 + i));
  }
}

void expect_run(const RunStore& store, int rows) {
  expect_rows(store, rows);
  ASSERT_EQ(store.snapshots(), (rows + 9) / 10);
  ASSERT_EQ(store.impacts(), (rows + 4) / 5);
  const std::vector<Impact> impacts = store.impact_block(1, store.impacts() - 1);
  EXPECT_EQ(impacts.back().roller, 5 * (store.impacts() - 1));
  EXPECT_EQ(impacts.front().peak_force, 1e5 + 5);
  EXPECT_EQ(impacts.front().line_load, 2e6);
  const std::vector<double> block = store.snapshot_block(1, 2);
  ASSERT_EQ(block.size(), 2U * static_cast<std::size_t>(store.snapshot_size()));
  EXPECT_EQ(block[0], 5.0);
  EXPECT_EQ(block[1], 10.0);
  EXPECT_EQ(block.back(), 20.0 + 0.01 * (5 * kStations + 11));
}

/// What resuming throws.
std::string fault_of(const fs::path& folder, const std::string& model = kModel, std::uint64_t seed = kSeed) {
  try {
    RunStore::resume(folder, model, seed);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "";
}

void append_garbage(const fs::path& file) {
  std::ofstream(file, std::ios::binary | std::ios::app) << "half a ro";
}

TEST(run_store, gives_back_what_it_was_given) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder / "a/b", kModel, kSeed);
  store.begin(columns(), kStations);
  give(store, 0, 57);
  expect_run(store, 57);
  give(store, 57, 83);
  expect_run(store, 83);
}

TEST(run_store, takes_up_at_the_checkpoint_and_drops_what_came_after) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  EXPECT_EQ(RunStore::find(folder.path()).value().time, 50.0);
  EXPECT_EQ(RunStore::find(folder.path()).value().fault, "");
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  ASSERT_TRUE(run);
  expect_run(run->store, 100);
  ASSERT_EQ(run->state.arrays.size(), 2U);
  EXPECT_EQ(run->state.time, 50.0);
  EXPECT_EQ(run->state.arrays[0].name, "q");
  EXPECT_EQ(run->state.arrays[0].values, state(100).arrays[0].values);
  EXPECT_TRUE(std::signbit(run->state.arrays[0].values[1]));
  EXPECT_TRUE(run->state.arrays[1].values.empty());
  run->store.begin(columns(), kStations);
  give(run->store, 100, 200);
  expect_run(run->store, 200);
}

TEST(run_store, has_nothing_to_take_up_before_the_first_checkpoint) {
  const TemporaryFolder folder;
  EXPECT_FALSE(RunStore::find(folder.path()));
  EXPECT_FALSE(RunStore::resume(folder.path(), kModel, kSeed));
  {
    RunStore store = RunStore::create(folder.path(), kModel, kSeed);
    store.begin(columns(), kStations);
    give(store, 0, 10);
  }
  EXPECT_FALSE(RunStore::find(folder.path()));
  EXPECT_FALSE(RunStore::resume(folder.path(), kModel, kSeed));
}

TEST(run_store, outlives_a_process_that_dies_without_a_word) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    RunStore store = RunStore::create(folder.path(), kModel, kSeed);
    store.begin(columns(), kStations);
    give(store, 0, 100);
    store.checkpoint(state(100));
    give(store, 100, 100'000);  // past the buffers
    _exit(0);                   // no destructor runs, no buffer is flushed
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_GT(fs::file_size(folder / ".run/rows"), 100 * columns().size() * sizeof(double));
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  ASSERT_TRUE(run);
  expect_run(run->store, 100);
}

/// Runs on for ever, with a checkpoint every 20 rows.
[[noreturn]] void run_on(const fs::path& folder) {
  std::optional<ResumedRun> run = RunStore::resume(folder, kModel, kSeed);
  RunStore store = run ? std::move(run->store) : RunStore::create(folder, kModel, kSeed);
  store.begin(columns(), kStations);
  for (int i = static_cast<int>(store.rows());; i += 20) {
    give(store, i, i + 20);
    store.checkpoint(state(i + 20));
  }
}

double stored_time(const fs::path& folder) {
  const std::optional<StoredRun> run = RunStore::find(folder);
  return run ? run->time : 0.0;
}

TEST(run_store, outlives_being_killed_again_and_again) {
  const TemporaryFolder folder;
  for (int round = 0; round < 10; ++round) {
    const double before = stored_time(folder.path());
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) run_on(folder.path());
    while (stored_time(folder.path()) < before + 100.0) {
      ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0);  // still at work
      usleep(100);                                     // and killed wherever it is by then
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
    ASSERT_TRUE(run);
    expect_run(run->store, static_cast<int>(2.0 * run->state.time));
    EXPECT_EQ(run->state.arrays[0].values[3], 2.0 * run->state.time);
  }
}

TEST(run_store, shrugs_off_half_written_tails_and_a_checkpoint_that_was_not_renamed) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  for (const char* name : {"rows", "snapshots", "impacts"}) append_garbage(folder / ".run" / name);
  testing::write_file(folder / ".run/checkpoint.new", "overbend check");
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  ASSERT_TRUE(run);
  expect_run(run->store, 100);
  give(run->store, 100, 110);
  run->store.checkpoint(state(110));
  run.reset();
  expect_run(RunStore::resume(folder.path(), kModel, kSeed).value().store, 110);
}

TEST(run_store, refuses_another_model_and_another_seed) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  EXPECT_NE(fault_of(folder.path(), kModel + " ").find("the model file has changed"), std::string::npos);
  EXPECT_NE(fault_of(folder.path(), kModel, 7).find("this one 7"), std::string::npos);
  EXPECT_EQ(fault_of(folder.path()), "");
}

TEST(run_store, refuses_other_histories_than_it_holds) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunStore store = std::move(RunStore::resume(folder.path(), kModel, kSeed).value().store);
  EXPECT_THROW(store.begin({columns()[0], columns()[1]}, kStations), std::runtime_error);
  EXPECT_THROW(store.begin(columns(), kStations + 1), std::runtime_error);
  EXPECT_NO_THROW(store.begin(columns(), kStations));
}

TEST(run_store, refuses_a_damaged_checkpoint_wherever_it_is_damaged) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  const fs::path file = folder / ".run/checkpoint";
  const std::string sound = testing::file_text(file);
  for (std::size_t at = 0; at < sound.size(); at += 7) {
    std::string bytes = sound;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    testing::write_file(file, bytes);
    ASSERT_NE(fault_of(folder.path()).find("damaged"), std::string::npos) << at;
    testing::write_file(file, sound.substr(0, at));
    ASSERT_NE(fault_of(folder.path()).find("damaged"), std::string::npos) << at;
  }
  EXPECT_NE(RunStore::find(folder.path()).value().fault, "");
  testing::write_file(file, sound);
  EXPECT_EQ(fault_of(folder.path()), "");
}

TEST(run_store, refuses_data_that_are_shorter_than_the_checkpoint_knows) {
  for (const char* name : {"rows", "snapshots", "impacts"}) {
    const TemporaryFolder folder;
    stop_a_run(folder.path());
    fs::resize_file(folder / ".run" / name, 100);
    EXPECT_NE(fault_of(folder.path()).find("damaged"), std::string::npos) << name;
  }
}

TEST(run_store, refuses_a_checkpoint_of_another_version) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunCheckpoint other = read_checkpoint(folder / ".run/checkpoint");
  other.version = "0.0.1";
  write_checkpoint(other, folder / ".run/checkpoint");
  EXPECT_NE(fault_of(folder.path()).find("version 0.0.1"), std::string::npos);
}

TEST(run_store, is_held_by_one_at_a_time) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  EXPECT_NE(fault_of(folder.path()).find("another run is at work"), std::string::npos);
  EXPECT_THROW(RunStore::create(folder.path(), kModel, kSeed), std::runtime_error);
  run.reset();
  EXPECT_EQ(fault_of(folder.path()), "");
}

TEST(run_store, begins_anew_over_an_older_run) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  EXPECT_FALSE(RunStore::find(folder.path()));
  store.begin(columns(), kStations);
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
  EXPECT_THROW(RunStore::create(folder / "file/results", kModel, kSeed), std::runtime_error);
  EXPECT_EQ(testing::file_text(folder / "file"), "mine");
}

TEST(run_store, takes_nothing_in_before_it_has_begun_and_no_row_of_another_size) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  const std::vector<double> two(2);
  EXPECT_THROW(store.row(two), std::logic_error);
  EXPECT_THROW(store.impact(impact(0)), std::logic_error);
  EXPECT_THROW(store.checkpoint(state(0)), std::logic_error);
  store.begin(columns(), kStations);
  EXPECT_THROW(store.row(two), std::invalid_argument);
  EXPECT_THROW(store.snapshot(0.0, two), std::invalid_argument);
}

TEST(run_store, reads_columns_alike_however_many_fit_its_memory) {
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), kModel, kSeed);
  const std::size_t width = 40, length = 300'000;  // 12 million numbers: three times what is kept
  std::vector<HistoryColumn> many(width, columns()[1]);
  store.begin(many, 0);
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
  store.begin(columns(), kStations);
  give(store, 0, 1000);
  const std::size_t before = pages();
  give(store, 1000, 1'001'000);
  EXPECT_EQ(store.rows(), 1'001'000);
  // 90 MB have been handed over; a page of theirs more or less belongs to the test's own small vectors.
  EXPECT_LE(pages(), before + 256);
}

}  // namespace
}  // namespace overbend

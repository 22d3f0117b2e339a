#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "base/source_digest.h"
#include "runstore/append_file.h"
#include "runstore/checkpoint_file.h"
#include "runstore/run_record.h"
#include "runstore/run_store.h"
#include "support/stored_run.h"

namespace overbend {
namespace {

using namespace testing::stored_run;
using testing::TemporaryFolder;

/// Bytes of a data file that the checkpoint knows.
std::uint64_t stored_bytes(const fs::path& folder, const std::string& name) {
  const RunCheckpoint run_checkpoint = read_checkpoint(folder / ".run/checkpoint");
  return name == "rows"        ? run_checkpoint.row_bytes
         : name == "snapshots" ? run_checkpoint.snapshot_bytes
                               : run_checkpoint.impact_bytes;
}

void append_garbage(const fs::path& file) {
  std::ofstream(file, std::ios::binary | std::ios::app) << "half a ro";
}

TEST(run_store, outlives_a_process_that_dies_without_a_word) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    RunStore store = RunStore::create(folder.path(), kModel, kSeed);
    store.begin(columns(), {kStations, 0});
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
  store.begin(columns(), {kStations, 0});
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

TEST(run_store, rejects_another_model_and_another_seed) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  EXPECT_NE(find_run_error(folder.path(), kModel + " ").find("the model file has changed"), std::string::npos);
  EXPECT_NE(find_run_error(folder.path(), kModel, 7).find("this one 7"), std::string::npos);
  EXPECT_EQ(find_run_error(folder.path()), "");
}

TEST(run_store, rejects_a_damaged_checkpoint_wherever_it_is_damaged) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  const fs::path file = folder / ".run/checkpoint";
  const std::string sound = testing::file_text(file);
  for (std::size_t index = 0; index < sound.size(); index += 7) {
    std::string bytes = sound;
    bytes[index] = static_cast<char>(bytes[index] ^ 0x10);
    testing::write_file(file, bytes);
    ASSERT_NE(find_run_error(folder.path()).find("damaged"), std::string::npos) << index;
    testing::write_file(file, sound.substr(0, index));
    ASSERT_NE(find_run_error(folder.path()).find("damaged"), std::string::npos) << index;
  }
  EXPECT_NE(RunStore::find(folder.path()).value().error, "");
  testing::write_file(file, sound);
  EXPECT_EQ(find_run_error(folder.path()), "");
}

TEST(run_store, rejects_data_that_are_shorter_than_the_checkpoint_knows) {
  for (const char* name : {"rows", "snapshots", "impacts"}) {
    const TemporaryFolder folder;
    stop_a_run(folder.path());
    fs::resize_file(folder / ".run" / name, 100);
    EXPECT_NE(find_run_error(folder.path()).find("damaged"), std::string::npos) << name;
  }
}

TEST(run_store, rejects_data_with_a_single_changed_bit) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  for (const char* name : {"rows", "snapshots", "impacts"}) {
    const fs::path file = folder / ".run" / name;
    const std::string sound = testing::file_text(file);
    const std::uint64_t stored = stored_bytes(folder.path(), name);  // what came after the checkpoint does not count
    for (std::uint64_t sample = 0; sample < stored; sample += 1 + stored / 50) {
      std::string bytes = sound;
      bytes[sample] = static_cast<char>(bytes[sample] ^ 0x80);
      testing::write_file(file, bytes);
      ASSERT_NE(find_run_error(folder.path()).find("damaged"), std::string::npos) << name << " " << sample;
    }
    testing::write_file(file, sound);
  }
  EXPECT_EQ(find_run_error(folder.path()), "");
}

TEST(run_store, does_not_hand_on_data_that_changed_on_disk) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  std::optional<ResumedRun> run = RunStore::resume(folder.path(), kModel, kSeed);
  ASSERT_TRUE(run);
  give(run->store, 100, 20'000);
  expect_run(run->store, 20'000);
  for (const char* name : {"rows", "snapshots", "impacts"}) {
    std::fstream file(folder / ".run" / name, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(1000);
    file.put('\x55');
  }
  give_row(run->store, 20'000);  // what was read before is asked for anew
  EXPECT_THROW(run->store.column(1), std::runtime_error);
  EXPECT_THROW(run->store.snapshot_block(0, 2), std::runtime_error);
  EXPECT_THROW(run->store.impact_block(0, 2), std::runtime_error);
}

TEST(block_sums, two_signs_that_change_in_one_block_are_seen) {
  std::vector<double> values(1000, 1.0);
  const std::uint64_t before = BlockSums::sum(values);
  values[10] = values[700] = -1.0;
  EXPECT_NE(BlockSums::sum(values), before);
}

TEST(block_sums, do_not_depend_on_how_the_numbers_come) {
  std::vector<double> values(3 * BlockSums::kBlock + 17);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i));
  BlockSums at_once, in_parts;
  at_once.add(values);
  for (std::size_t i = 0; i < values.size(); i += 1001) {
    in_parts.add(std::span<const double>(values).subspan(i, std::min<std::size_t>(1001, values.size() - i)));
  }
  EXPECT_EQ(at_once.all(), in_parts.all());
  EXPECT_EQ(at_once.all().size(), 4U);
}

TEST(run_store, rejects_a_checkpoint_of_another_build_or_instruction_set) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunCheckpoint second_run_checkpoint = read_checkpoint(folder / ".run/checkpoint");
  EXPECT_EQ(second_run_checkpoint.version, program_identity());
  EXPECT_NE(program_identity().find(source_digest()), std::string::npos);
  for (const std::string& part :
       {std::string(source_digest()), std::string(", avx2"), std::string(", avx512"), std::string(", baseline")}) {
    const std::size_t index = program_identity().find(part);
    if (index == std::string::npos) continue;
    second_run_checkpoint.version = program_identity().replace(index, part.size(), ", another");
    write_checkpoint(second_run_checkpoint, folder / ".run/checkpoint");
    EXPECT_NE(find_run_error(folder.path()).find("--restart"), std::string::npos) << part;
  }
}

TEST(run_store, rejects_a_checkpoint_of_another_version) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  RunCheckpoint second_run_checkpoint = read_checkpoint(folder / ".run/checkpoint");
  second_run_checkpoint.version = "0.0.1";
  write_checkpoint(second_run_checkpoint, folder / ".run/checkpoint");
  EXPECT_NE(find_run_error(folder.path()).find("version 0.0.1"), std::string::npos);
}

/// Fills the disk for this process; true if that is reported in time and with a message.
bool fill_the_disk(const fs::path& folder) {
  const rlimit limit = {3'000'000, 3'000'000};
  setrlimit(RLIMIT_FSIZE, &limit);
  signal(SIGXFSZ, SIG_IGN);
  RunStore store = std::move(RunStore::resume(folder, kModel, kSeed).value().store);
  try {
    for (int i = 100; i < 1'000'000; ++i) give_row(store, i);
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).find("rows' cannot be written: File too large") != std::string::npos;
  }
  return false;
}

TEST(run_store, keeps_its_checkpoint_when_the_disk_is_full) {
  const TemporaryFolder folder;
  stop_a_run(folder.path());
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(fill_the_disk(folder.path()) ? 0 : 1);
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  expect_run(RunStore::resume(folder.path(), kModel, kSeed).value().store, 100);
}

}  // namespace
}  // namespace overbend

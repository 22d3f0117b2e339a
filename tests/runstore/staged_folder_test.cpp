#include "runstore/staged_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "runstore/written_files.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::file_text;
using testing::TemporaryFolder;
using testing::write_file;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// A run that writes the files with the text `content`.
void write_results(const fs::path& folder, const std::vector<std::string>& files, const std::string& content,
                   const std::vector<std::string>& folders = {}) {
  StagedFolder staged(folder);
  for (const std::string& file : files) write_file(staged.path() / file, content);
  staged.commit("summary.json", folders);
}

TEST(staged_folder, removes_what_it_made_when_it_is_not_committed) {
  const TemporaryFolder folder;
  {
    const StagedFolder staged(folder / "a/b/");
    testing::write_file(staged.path() / "x", "half");
  }
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(staged_folder, leaves_a_folder_that_was_there) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  { const StagedFolder staged(folder / "a"); }
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a"});
  EXPECT_TRUE(names_in(folder / "a").empty());
}

TEST(staged_folder, files_of_an_earlier_run_go_and_those_of_the_user_stay) {
  const TemporaryFolder folder;
  write_results(folder / "out", {"summary.json", "impacts.csv"}, "old");
  write_file(folder / "out/notes.txt", "mine");
  fs::create_directories(folder / "out/drawings");
  write_file(folder / "out/drawings/plan.txt", "mine too");
  fs::create_symlink("notes.txt", folder / "out/link");
  write_results(folder / "out", {"summary.json", "pipe.csv"}, "new");
  EXPECT_EQ(names_in(folder / "out"),
            (std::set<std::string>{"summary.json", "pipe.csv", ".overbend-files", "notes.txt", "drawings", "link"}));
  EXPECT_EQ(file_text(folder / "out/summary.json"), "new");
  EXPECT_EQ(file_text(folder / "out/notes.txt"), "mine");
  EXPECT_EQ(file_text(folder / "out/drawings/plan.txt"), "mine too");
  EXPECT_TRUE(fs::is_symlink(folder / "out/link"));
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out"});
}

TEST(staged_folder, a_file_of_the_user_with_the_name_of_a_result_stays_where_no_run_wrote_it) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_file(folder / "out/impacts.csv", "mine");
  write_results(folder / "out", {"summary.json"}, "new");
  write_results(folder / "out", {"summary.json"}, "newer");
  EXPECT_EQ(file_text(folder / "out/impacts.csv"), "mine");
}

TEST(staged_folder, writes_over_no_file_that_it_has_not_written) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_file(folder / "out/summary.json", "mine");
  EXPECT_THROW(write_results(folder / "out", {"pipe.csv", "summary.json"}, "new"), UnusableFolder);
  EXPECT_EQ(names_in(folder / "out"), std::set<std::string>{"summary.json"});
  EXPECT_EQ(file_text(folder / "out/summary.json"), "mine");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out"});
  fs::remove(folder / "out/summary.json");
  write_results(folder / "out", {"pipe.csv", "summary.json"}, "new");
  write_results(folder / "out", {"pipe.csv", "summary.json"}, "newer");
  EXPECT_EQ(file_text(folder / "out/summary.json"), "newer");
}

TEST(staged_folder, the_folder_keeps_its_rights_and_a_link_to_it_stays_one) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  fs::permissions(folder / "data", fs::perms(0750));
  fs::create_directory_symlink("data", folder / "out");
  write_results(folder / "out", {"summary.json"}, "new");
  EXPECT_TRUE(fs::is_symlink(folder / "out"));
  EXPECT_EQ(file_text(folder / "data/summary.json"), "new");
  EXPECT_EQ(fs::status(folder / "data").permissions(), fs::perms(0750));
}

TEST(staged_folder, folders_of_results_that_no_longer_belong_go) {
  const TemporaryFolder folder;
  for (const char* seed : {"seed-1", "seed-9"}) write_results(folder / "out" / seed, {"summary.json"}, "old");
  write_file(folder / "out/seed-9/notes.txt", "mine");
  write_results(folder / "out/seed-12", {"summary.json"}, "old");
  write_results(folder / "out", {"summary.json", "seeds.csv"}, "old", {"seed-1", "seed-9", "seed-12"});
  write_results(folder / "out", {"summary.json", "seeds.csv"}, "new", {"seed-1"});
  EXPECT_TRUE(fs::exists(folder / "out/seed-1/summary.json"));
  EXPECT_FALSE(fs::exists(folder / "out/seed-12"));
  EXPECT_EQ(names_in(folder / "out/seed-9"), std::set<std::string>{"notes.txt"});
}

// A process in the folder itself would lose its place if the folder were exchanged.
TEST(staged_folder, in_the_current_folder_files_are_replaced_one_by_one) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (chdir(folder.path().c_str()) != 0) _exit(1);
    write_results(".", {"summary.json", "impacts.csv"}, "old");
    write_file("notes.txt", "mine");
    write_results(".", {"summary.json", "pipe.csv"}, "new");
    _exit(fs::exists("summary.json") ? 0 : 2);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(names_in(folder.path()),
            (std::set<std::string>{"summary.json", "pipe.csv", ".overbend-files", "notes.txt"}));
  EXPECT_EQ(file_text(folder / "summary.json"), "new");
}

TEST(staged_folder, killed_at_work_it_leaves_the_old_folder_and_the_next_run_clears_up) {
  const TemporaryFolder folder;
  write_results(folder / "out", {"summary.json"}, "old");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const StagedFolder staged(folder / "out");
    write_file(staged.path() / "summary.json", "half");
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(file_text(folder / "out/summary.json"), "old");
  EXPECT_EQ(names_in(folder.path()).size(), 2U);  // what the killed one left
  const StagedFolder at_work(folder / "other");
  write_results(folder / "out", {"summary.json"}, "new");
  EXPECT_TRUE(fs::exists(at_work.path()));  // not that of a live process
  EXPECT_EQ(names_in(folder.path()).size(), 3U);
}

TEST(staged_folder, killed_after_the_exchange_what_is_the_users_is_brought_over_by_the_next_run) {
  const TemporaryFolder folder;
  write_results(folder / "out", {"summary.json"}, "new");
  const fs::path old = folder / ".overbend-AbCdEf";  // as the exchange leaves it
  fs::create_directories(old / "drawings");
  write_file(old / "summary.json", "old");
  write_file(old / ".overbend-files", "summary.json\n");
  write_file(old / "drawings/plan.txt", "mine");
  mark_old(old, folder / "out");
  write_results(folder / "other", {"summary.json"}, "x");
  EXPECT_EQ(file_text(folder / "out/drawings/plan.txt"), "mine");
  EXPECT_EQ(file_text(folder / "out/summary.json"), "new");
  EXPECT_FALSE(fs::exists(old));
}

TEST(staged_folder, a_folder_that_only_looks_like_a_leftover_is_left_alone) {
  const TemporaryFolder folder;
  fs::create_directory(folder / ".overbend-mine12");
  write_file(folder / ".overbend-mine12/notes.txt", "mine");
  write_results(folder / "out", {"summary.json"}, "new");
  EXPECT_EQ(file_text(folder / ".overbend-mine12/notes.txt"), "mine");
}

TEST(written_files, names_that_lead_out_of_the_folder_are_passed_over) {
  const TemporaryFolder folder;
  write_file(folder / ".overbend-files", "../a\n/etc/b\n..\nsummary.json\nseed-1/\n../\n");
  const WrittenFiles written = read_written(folder.path());
  EXPECT_EQ(written.files, std::vector<std::string>{"summary.json"});
  EXPECT_EQ(written.folders, std::vector<std::string>{"seed-1"});
}

}  // namespace
}  // namespace overbend

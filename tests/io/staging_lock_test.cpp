// What a killed process left is removed, what a living one works in is not.
#include "io/staging_lock.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/staged_folder.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

void fill(const fs::path& folder) {
  fs::create_directories(folder / "deep");
  testing::write_file(folder / "deep" / "file", "data");
}

TEST(staging_lock, an_abandoned_folder_goes_at_the_next_start) {
  const TemporaryFolder folder;
  fill(folder / ".overbend-aZ09bc");
  { const StagedFolder staged(folder.path()); }
  EXPECT_FALSE(fs::exists(folder / ".overbend-aZ09bc"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(staging_lock, a_folder_in_which_a_process_works_stays) {
  const TemporaryFolder folder;
  const StagedFolder mine(folder.path());
  testing::write_file(mine.path() / "summary.json", "{}");
  { const StagedFolder other(folder.path()); }
  remove_abandoned_staging(folder.path());
  EXPECT_TRUE(fs::exists(mine.path() / "summary.json"));
}

TEST(staging_lock, a_folder_is_abandoned_when_its_process_is_killed) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::optional<StagingPlace> place = make_staging(folder.path());
    const char done = place ? 'y' : 'n';
    if (::write(ready[1], &done, 1) == 1) ::pause();
    ::_exit(0);
  }
  char done = 0;
  ASSERT_EQ(::read(ready[0], &done, 1), 1);
  remove_abandoned_staging(folder.path());
  EXPECT_FALSE(fs::is_empty(folder.path()));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  remove_abandoned_staging(folder.path());
  EXPECT_TRUE(fs::is_empty(folder.path()));
  for (const int end : ready) ::close(end);
}

TEST(staging_lock, what_only_looks_like_ours_is_left_alone) {
  const TemporaryFolder folder, elsewhere;
  for (const char* name : {".overbend-short", ".overbend-toolong", ".overbend-ab.def", "overbend-abcdef", "results"}) {
    fill(folder / name);
  }
  testing::write_file(folder / ".overbend-aaaaaa", "a file");
  fill(elsewhere / "kept");
  fs::create_directory_symlink(elsewhere.path(), folder / ".overbend-bbbbbb");
  std::size_t before = 7;
  if (::getuid() == 0) {
    fill(folder / ".overbend-cccccc");
    ASSERT_EQ(::chown((folder / ".overbend-cccccc").c_str(), 12345, 12345), 0);
    ++before;
  }
  remove_abandoned_staging(folder.path());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), before);
  EXPECT_TRUE(fs::exists(elsewhere / "kept/deep/file"));
}

}  // namespace
}  // namespace overbend

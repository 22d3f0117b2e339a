#include "platform/lock.h"

#include <gtest/gtest.h>

#include <fstream>

#include "platform/temporary.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kNew = File::kRead | File::kWrite | File::kCreate;

TEST(lock, one_holds_a_file_alone_or_several_share_it) {
  std::error_code error;
  const ScratchFolder folder(error);
  const fs::path path = folder.path() / "lock";
  File first(path, kNew, error);
  const File second(path, kNew, error);
  ASSERT_FALSE(error) << error.message();
  EXPECT_FALSE(lock_file(first, LockKind::exclusive));
  EXPECT_EQ(lock_file(second, LockKind::shared), std::errc::resource_unavailable_try_again);
  EXPECT_EQ(lock_file(second, LockKind::exclusive), std::errc::resource_unavailable_try_again);
  first = File();  // the lock ends with the file
  EXPECT_FALSE(lock_file(second, LockKind::shared));
  EXPECT_FALSE(lock_file(File(path, File::kRead, error), LockKind::shared));
}

TEST(lock, a_locked_file_can_be_read_and_written_by_others) {
  std::error_code error;
  const ScratchFolder folder(error);
  const File file(folder.path() / "lock", kNew, error);
  ASSERT_FALSE(lock_file(file, LockKind::exclusive));
  std::ofstream(folder.path() / "lock") << "text";
  EXPECT_EQ(fs::file_size(folder.path() / "lock"), 4U);
}

TEST(lock, one_holds_a_folder_and_it_can_be_used_and_removed) {
  std::error_code error;
  const ScratchFolder scratch(error);
  const fs::path folder = scratch.path() / "folder";
  EXPECT_FALSE(lock_folder(folder).is_open());
  fs::create_directory(folder);
  File first = lock_folder(folder);
  EXPECT_TRUE(first.is_open());
  EXPECT_FALSE(lock_folder(folder).is_open());
  std::ofstream(folder / "file") << "text";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  first = File();
  first = lock_folder(folder);
  EXPECT_TRUE(first.is_open());
  EXPECT_EQ(fs::remove_all(folder), 2U);  // by the process that holds it
  first = File();
  EXPECT_FALSE(fs::exists(folder));
}

TEST(lock, a_link_to_a_folder_is_not_locked) {
  std::error_code error;
  const ScratchFolder scratch(error);
  fs::create_directory(scratch.path() / "folder");
  fs::create_directory_symlink("folder", scratch.path() / "link", error);
  if (error) GTEST_SKIP() << "no links: " << error.message();
  EXPECT_FALSE(lock_folder(scratch.path() / "link").is_open());
}

}  // namespace
}  // namespace overbend

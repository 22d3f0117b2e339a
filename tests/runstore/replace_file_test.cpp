// A user's own file gets a new content and stays what it was otherwise.
#include "runstore/replace_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/size_limit.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::file_text;
using testing::TemporaryFolder;
using testing::write_file;

struct stat stat_file(const fs::path& file) {
  struct stat found {};
  EXPECT_EQ(::lstat(file.c_str(), &found), 0) << file;
  return found;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string replace_error(const fs::path& file, std::string_view text) {
  try {
    replace_file(file, text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(replace_file, keeps_mode_and_owner) {
  const TemporaryFolder folder;
  const fs::path file = folder / "model.yaml";
  write_file(file, "old");
  for (const mode_t mode : {0600U, 0640U, 0664U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    if (::getuid() == 0) {
      ASSERT_EQ(::chown(file.c_str(), 12345, 54321), 0);
    }
    const struct stat before = stat_file(file);
    replace_file(file, "new");
    EXPECT_EQ(file_text(file), "new");
    EXPECT_EQ(stat_file(file).st_mode, before.st_mode);
    EXPECT_EQ(stat_file(file).st_uid, before.st_uid);
    EXPECT_EQ(stat_file(file).st_gid, before.st_gid);
  }
}

TEST(replace_file, gives_a_new_file_the_mode_of_the_umask) {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(0027);
  replace_file(folder / "new.yaml", "text");
  ::umask(mask);
  EXPECT_EQ(stat_file(folder / "new.yaml").st_mode & 0777, 0640U);
}

TEST(replace_file, leaves_a_link_and_replaces_what_it_leads_to) {
  const TemporaryFolder folder, elsewhere;
  write_file(elsewhere / "real.yaml", "old");
  fs::create_symlink(elsewhere / "real.yaml", elsewhere / "second.yaml");
  fs::create_symlink(elsewhere / "second.yaml", folder / "model.yaml");
  replace_file(folder / "model.yaml", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "model.yaml"));
  EXPECT_TRUE(fs::is_symlink(elsewhere / "second.yaml"));
  EXPECT_EQ(file_text(elsewhere / "real.yaml"), "new");
}

TEST(replace_file, rejects_what_is_not_a_regular_file) {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "nowhere", folder / "dangling.yaml");
  fs::create_directory(folder / "folder.yaml");
  ASSERT_EQ(::mkfifo((folder / "pipe.yaml").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "device.yaml");
  EXPECT_NE(replace_error(folder / "dangling.yaml", "text").find("broken link"), std::string::npos);
  for (const char* name : {"folder.yaml", "pipe.yaml", "device.yaml"}) {
    EXPECT_NE(replace_error(folder / name, "text").find("not a regular file"), std::string::npos) << name;
  }
  EXPECT_EQ(entries(folder.path()), 4u);
}

TEST(replace_file, is_not_led_astray_by_a_neighbouring_file) {
  const TemporaryFolder folder;
  write_file(folder / "victim", "mine");
  fs::create_symlink(folder / "victim", folder / "model.yaml.part");
  replace_file(folder / "model.yaml", "text");
  EXPECT_EQ(file_text(folder / "victim"), "mine");
  EXPECT_TRUE(fs::is_symlink(folder / "model.yaml.part"));
}

TEST(replace_file, leaves_all_as_it_was_when_the_last_look_objects) {
  const TemporaryFolder folder;
  write_file(folder / "model.yaml", "old");
  EXPECT_THROW(replace_file(folder / "model.yaml", "new", [] { throw std::logic_error("no"); }), std::logic_error);
  EXPECT_EQ(file_text(folder / "model.yaml"), "old");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(replace_file, leaves_the_old_content_when_the_disk_is_full) {
  const TemporaryFolder folder;
  write_file(folder / "model.yaml", "old");
  const std::string error = [&] {
    const testing::SizeLimit limit(1024);
    return replace_error(folder / "model.yaml", std::string(5000, 'x'));
  }();
  EXPECT_NE(error.find("model.yaml"), std::string::npos);
  EXPECT_NE(error.find("File too large"), std::string::npos) << error;
  EXPECT_EQ(file_text(folder / "model.yaml"), "old");
  EXPECT_EQ(entries(folder.path()), 1u);
}

}  // namespace
}  // namespace overbend

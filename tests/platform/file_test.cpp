#include "platform/file.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "platform/temporary.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

class PlatformFile : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(error_) << error_.message(); }

  fs::path operator/(const std::string& name) const { return folder_.path() / name; }
  std::string text(const std::string& name) const {
    std::ifstream stream(folder_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
  }
  static std::span<const std::byte> bytes(const std::string& content) { return std::as_bytes(std::span(content)); }

  std::error_code error_;
  ScratchFolder folder_{error_};
};

constexpr unsigned kNew = File::kRead | File::kWrite | File::kCreate;

TEST_F(PlatformFile, is_read_and_written_by_offset) {
  const File file(*this / "data", kNew, error_);
  ASSERT_FALSE(error_) << error_.message();
  EXPECT_FALSE(file.write(4, bytes("efgh")));
  EXPECT_FALSE(file.write(0, bytes("ab\ncd")));  // bytes as they are, also ends of lines
  EXPECT_EQ(file.size(error_), 8U);
  std::array<std::byte, 10> read{};
  EXPECT_EQ(file.read(2, read, error_), 6U);  // to the end of the file
  EXPECT_FALSE(error_);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(read.data()), 6), "\ncdfgh");
  EXPECT_EQ(file.read(100, read, error_), 0U);
  EXPECT_FALSE(error_);
  EXPECT_FALSE(file.resize(3));
  EXPECT_FALSE(file.sync());
  EXPECT_EQ(text("data"), "ab\n");
}

TEST_F(PlatformFile, is_created_kept_emptied_or_left_alone_as_asked) {
  EXPECT_FALSE(File(*this / "data", File::kRead, error_).is_open());
  EXPECT_EQ(error_, std::errc::no_such_file_or_directory);
  write("data", "text");
  EXPECT_TRUE(File(*this / "data", kNew, error_).is_open());
  EXPECT_EQ(text("data"), "text");
  EXPECT_FALSE(File(*this / "data", kNew | File::kExclusive, error_).is_open());
  EXPECT_EQ(error_, std::errc::file_exists);
  EXPECT_TRUE(File(*this / "data", kNew | File::kTruncate, error_).is_open());
  EXPECT_FALSE(error_);
  EXPECT_EQ(text("data"), "");
}

TEST_F(PlatformFile, can_have_any_name) {
  const std::string name = reinterpret_cast<const char*>(u8"Übergröße 深さ.dat");
  const fs::path path = folder_.path() / fs::path(reinterpret_cast<const char8_t*>(name.c_str()));
  EXPECT_FALSE(File(path, kNew, error_).write(0, bytes("x")));
  EXPECT_TRUE(fs::exists(path));
}

TEST_F(PlatformFile, reports_an_error_of_the_system) {
  const File file(*this / "data", File::kWrite | File::kCreate, error_);
  std::array<std::byte, 1> byte{};
  file.read(0, byte, error_);  // opened for writing only
  EXPECT_TRUE(error_);
  File closed(*this / "data", File::kRead, error_);
  EXPECT_FALSE(closed.close());
  EXPECT_FALSE(closed.is_open());
  EXPECT_TRUE(closed.sync());
}

TEST_F(PlatformFile, a_folder_can_be_synced) {
  EXPECT_FALSE(File(folder_.path(), File::kRead | File::kFolder, error_).sync());
  EXPECT_FALSE(error_);
}

TEST_F(PlatformFile, its_identity_changes_with_its_content_and_not_with_its_name) {
  write("data", "text");
  const auto before = file_identity(*this / "data");
  ASSERT_TRUE(before);
  EXPECT_EQ(before->length, 4U);
  EXPECT_EQ(file_identity(*this / "data"), before);
  EXPECT_EQ(File(*this / "data", File::kRead, error_).identity(), before);
  fs::rename(*this / "data", *this / "renamed");
  const auto renamed = file_identity(*this / "renamed");
  ASSERT_TRUE(renamed);
  EXPECT_EQ(renamed->volume, before->volume);
  EXPECT_EQ(renamed->number, before->number);
  write("renamed", "TEXT");
  EXPECT_NE(file_identity(*this / "renamed"), before);
  EXPECT_FALSE(file_identity(*this / "data"));
  using namespace std::chrono;
  const auto age = system_clock::now().time_since_epoch() - nanoseconds(before->change_time);
  EXPECT_LT(abs(age), minutes(1));
}

TEST_F(PlatformFile, replaces_another_by_a_rename_even_while_it_is_open) {
  write("old", "old");
  write("new", "new");
  const File opened(*this / "new", File::kRead | File::kWrite, error_);
  EXPECT_FALSE(rename_file(*this / "new", *this / "old"));
  EXPECT_EQ(text("old"), "new");
  EXPECT_FALSE(fs::exists(*this / "new"));
  EXPECT_EQ(rename_file(*this / "new", *this / "old"), std::errc::no_such_file_or_directory);
}

TEST_F(PlatformFile, folders_are_exchanged_or_left_as_they_are) {
  for (const char* name : {"a", "b"}) {
    fs::create_directory(*this / name);
    write(std::string(name) + "/name", name);
  }
  const bool exchanged = !exchange_folders(*this / "a", *this / "b");
  EXPECT_EQ(text("a/name"), exchanged ? "b" : "a");
  EXPECT_EQ(text("b/name"), exchanged ? "a" : "b");
  EXPECT_TRUE(exchange_folders(*this / "a", *this / "none"));
  EXPECT_EQ(text("a/name"), exchanged ? "b" : "a");
}

TEST_F(PlatformFile, may_be_written_by_its_owner) {
  write("data", "text");
  EXPECT_FALSE(check_writable(*this / "data"));
  EXPECT_FALSE(check_writable(folder_.path()));
  EXPECT_EQ(check_writable(*this / "none"), std::errc::no_such_file_or_directory);
  EXPECT_TRUE(is_own_file(*this / "data"));
  write("other", "text");
  EXPECT_FALSE(copy_ownership(*this / "data", *this / "other"));
}

TEST_F(PlatformFile, is_touched) {
  write("data", "text");
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(*this / "data", long_ago);
  touch_file(*this / "data");
  EXPECT_GT(fs::last_write_time(*this / "data"), long_ago + std::chrono::minutes(59));
  EXPECT_EQ(text("data"), "text");
  touch_file(*this / "none");
  EXPECT_FALSE(fs::exists(*this / "none"));
}

}  // namespace
}  // namespace overbend

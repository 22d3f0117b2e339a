#include "platform/temporary.h"

#include <gtest/gtest.h>

#include <fstream>

namespace overbend {
namespace {

namespace fs = std::filesystem;

TEST(temporary, folders_have_names_of_their_own) {
  std::error_code error;
  const ScratchFolder scratch(error);
  ASSERT_FALSE(error) << error.message();
  const fs::path first = make_unique_folder(scratch.path(), ".stem-", error);
  ASSERT_FALSE(error) << error.message();
  const fs::path second = make_unique_folder(scratch.path(), ".stem-", error);
  EXPECT_NE(first, second);
  EXPECT_TRUE(fs::is_directory(first) && fs::is_directory(second));
  EXPECT_EQ(first.parent_path(), scratch.path());
  EXPECT_EQ(first.filename().string().size(), std::string(".stem-").size() + 6);
  EXPECT_TRUE(first.filename().string().starts_with(".stem-"));
  EXPECT_TRUE(make_unique_folder(scratch.path() / "none", "x", error).empty());
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
}

TEST(temporary, a_scratch_folder_goes_with_its_content) {
  fs::path path;
  {
    std::error_code error;
    const ScratchFolder scratch(error);
    path = scratch.path();
    fs::create_directory(path / "inside");
    std::ofstream(path / "inside" / "file") << "text";
    EXPECT_TRUE(fs::exists(path / "inside" / "file"));
  }
  EXPECT_FALSE(path.empty());
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace overbend

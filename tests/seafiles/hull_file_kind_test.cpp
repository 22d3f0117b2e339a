#include "seafiles/hull_file_kind.h"

#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

using testing::hull_file;

TEST(hull_file_kind, contents_identify_the_program) {
  const std::vector<std::pair<const char*, HullFileKind>> files = {
      {"wamit-rad-per-s/barge", HullFileKind::wamit_files},
      {"wamit-rad-per-s/barge.hst", HullFileKind::wamit_files},
      {"wamit-out/barge.out", HullFileKind::wamit_output},
      {"aqwa/barge.LIS", HullFileKind::aqwa_listing},
      {"aqwa/barge.AH1", HullFileKind::aqwa_database},
      {"nemoh", HullFileKind::nemoh},
      {"nemoh/Nemoh.cal", HullFileKind::nemoh},
      {"bemio/barge.h5", HullFileKind::bemio},
      {"capytaine/barge-classic.nc", HullFileKind::capytaine},
      {"hydrodyn/HydroDyn.dat", HullFileKind::hydrodyn},
      {"orcaflex-loads/barge.yml", HullFileKind::orcaflex},
      {"hydrostar/barge_yaw.rao", HullFileKind::hydrostar_rao}};
  const testing::ScratchFolder scratch;
  for (const auto& [name, kind] : files) {
    EXPECT_EQ(find_hull_file_kind(hull_file(name)), kind) << name;
    if (!std::filesystem::is_regular_file(hull_file(name)) || kind == HullFileKind::wamit_files) continue;
    const std::string renamed = scratch.write("file.txt", testing::read_text(hull_file(name)));
    EXPECT_EQ(find_hull_file_kind(renamed), kind) << name << " by another name";
  }
}

TEST(hull_file_kind, other_files_are_of_no_kind) {
  const testing::ScratchFolder scratch;
  EXPECT_FALSE(find_hull_file_kind(scratch.write("notes.txt", "waves and vessels\n")));
  EXPECT_FALSE(find_hull_file_kind(scratch.write("empty.out", "")));
  EXPECT_FALSE(find_hull_file_kind(scratch.path("nobody")));
  EXPECT_FALSE(find_hull_file_kind(scratch.path("")));
}

TEST(hull_file_kind, endings_count_in_any_case) {
  EXPECT_TRUE(has_hull_text_ending("a.LIS") && has_hull_text_ending("a.out") && has_hull_text_ending("b.1"));
  EXPECT_TRUE(has_hull_binary_ending("a.NC") && !has_hull_text_ending("a.nc") && !has_hull_text_ending("a.exe"));
}

}  // namespace
}  // namespace overbend

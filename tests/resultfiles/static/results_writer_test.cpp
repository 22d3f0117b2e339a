#include "resultfiles/static/results_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "resultfiles/static/finite_check.h"
#include "resultfiles/summary/summary_json.h"
#include "runstore/run_record.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::solved_case;
using testing::TemporaryFolder;

const std::set<std::string> kAllFiles = {"summary.json",          "pipe.csv",   "supports.csv",   "checks.csv",
                                         "calculation_sheet.csv", "results.h5", ".overbend-files"};

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// Returns the message thrown by writing; empty if none.
std::string find_write_error(const StaticResults& results, const fs::path& folder) {
  try {
    write_static_results(results, {}, folder);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(results_writer, makes_the_folder_and_leaves_the_files_alone_in_it) {
  const TemporaryFolder folder;
  const auto& [description, results] = solved_case("BGL1-T250");
  write_static_results(results, description, folder / "new/deep");
  EXPECT_EQ(names_in(folder / "new/deep"), kAllFiles);
}

TEST(results_writer, replaces_older_results_and_keeps_other_files) {
  const TemporaryFolder folder;
  const auto& [description, results] = solved_case("J12-D400-T560");
  StaticResults older = results;
  older.title = "older";
  write_static_results(older, description, folder.path());
  testing::write_file(folder / "notes.txt", "mine");
  write_static_results(results, description, folder.path());
  EXPECT_EQ(testing::file_text(folder / "summary.json"), static_summary(results));
  EXPECT_EQ(testing::file_text(folder / "notes.txt"), "mine");
}

TEST(results_writer, writes_nothing_when_a_number_is_none_and_names_it) {
  const TemporaryFolder folder;
  StaticResults results = solved_case("BGL1-T250").results;
  results.stations.at(12).bending_moment = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(find_write_error(results, folder / "out").find("stations[12].bending_moment"), std::string::npos);
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(finite_check, finds_what_is_not_finite_wherever_it_is) {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto error_after_change = [](auto spoil) -> std::string {
    StaticResults results = solved_case("BGL1-T250").results;
    spoil(results);
    try {
      require_finite(results);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(0, std::string(error.what()).find(' '));
    }
    return "";
  };
  EXPECT_EQ(error_after_change([](StaticResults&) {}), "");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.lay_back = infinite; }), "lay_back");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.stinger_tip_clearance = -infinite; }),
            "stinger_tip_clearance");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.touchdown.p_W.y() = NAN; }), "touchdown.position_y");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.overbend->strain.s = NAN; }), "overbend.strain.s");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.sections[0].EI = NAN; }), "sections[0].EI");
  EXPECT_EQ(error_after_change([&](StaticResults& r) { r.supports[3].rows[0].rollers[0].normal_W.z() = NAN; }),
            "supports[3].rows[0].rollers[0].normal_z");
}

TEST(results_writer, says_why_a_folder_can_not_be_written) {
  const TemporaryFolder folder;
  testing::write_file(folder / "file", "mine");
  const StaticResults& results = solved_case("J12-D400-T560").results;
  EXPECT_NE(find_write_error(results, folder / "file/results").find("cannot be written"), std::string::npos);
  EXPECT_NE(find_write_error(results, folder / "file").find("cannot be written"), std::string::npos);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"file"});
  EXPECT_EQ(testing::file_text(folder / "file"), "mine");
}

TEST(results_writer, changes_no_file_when_one_of_them_can_not_be_replaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "results.h5");
  testing::write_file(folder / "summary.json", "old");
  const StaticResults& results = solved_case("J12-D400-T560").results;
  EXPECT_NE(find_write_error(results, folder.path()), "");
  EXPECT_EQ(testing::file_text(folder / "summary.json"), "old");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"results.h5", "summary.json"}));
}

TEST(results_file, is_complete_and_described_for_h5py) {
  for (const char* name : {"BGL1-T250", "J12-D400-T560"}) {
    const TemporaryFolder folder;
    const auto& [description, results] = solved_case(name);
    write_static_hdf5(results, description, folder / "results.h5");
    const std::string command = "/usr/bin/python3 " OVERBEND_SOURCE_DIR "/tests/resultfiles/check_results_h5.py " +
                                (folder / "results.h5").string() + " > " + (folder / "told").string() + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << name << ": " << testing::file_text(folder / "told");
  }
}

TEST(text_hash, agrees_with_published_values_of_fnv1a) {
  EXPECT_EQ(text_hash(""), "fnv1a64:cbf29ce484222325");
  EXPECT_EQ(text_hash("foobar"), "fnv1a64:85944171f73967e8");
}

}  // namespace
}  // namespace overbend

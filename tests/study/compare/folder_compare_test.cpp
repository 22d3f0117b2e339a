#include "study/compare/folder_compare.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/program.h"
#include "app/small_lay.h"
#include "report/page_text.h"
#include "report/studies/folder_comparison_page.h"
#include "resultfiles/studies/folder_comparison_writer.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::kSmallLay;
using testing::ProgramRun;
using testing::run_program;
using testing::shown_text;
using testing::TemporaryFolder;
using testing::with;

/// Statics of a model into a folder next to the others.
fs::path solve(const TemporaryFolder& folder, const std::string& name, const std::string& model) {
  testing::write_file(folder / (name + ".yaml"), model);
  const ProgramRun run =
      run_program("static " + (folder / (name + ".yaml")).string() + " -o " + (folder / name).string());
  EXPECT_EQ(run.code, 0) << run.err;
  return folder / name;
}

const std::string kTighter = with(kSmallLay, "tension: 300 kN", "tension: 0.33 MN");

const ComparedResult* result(const FolderComparison& comparison, const std::string& name) {
  const auto found = std::ranges::find(comparison.results, name, &ComparedResult::name);
  return found == comparison.results.end() ? nullptr : &*found;
}

TEST(folder_compare, a_folder_does_not_differ_from_itself) {
  const TemporaryFolder folder;
  const fs::path first_folder = solve(folder, "one", kSmallLay);
  const FolderComparison comparison = compare_folders({first_folder, first_folder});
  EXPECT_TRUE(comparison.keys.empty());
  EXPECT_TRUE(partial_findings(comparison).empty());
  for (const ComparedResult& each : comparison.results) EXPECT_EQ(each.max_relative_change(), 0.0) << each.name;
}

TEST(folder_compare, reports_the_key_that_was_changed_and_what_followed) {
  const TemporaryFolder folder;
  const fs::path first_folder = solve(folder, "one", kSmallLay), second = solve(folder, "other", kTighter);
  const FolderComparison comparison = compare_folders({first_folder, second});
  ASSERT_EQ(comparison.keys.size(), 1u);
  EXPECT_EQ(comparison.keys[0].key, "tensioner.tension");
  EXPECT_EQ(comparison.keys[0].values, (std::vector<std::string>{"300 kN", "0.33 MN"}));
  const ComparedResult* tension = result(comparison, "static.top_tension");
  ASSERT_NE(tension, nullptr);
  EXPECT_NEAR(*tension->change(1), 0.1, 1e-5);
  EXPECT_EQ(comparison.folders[0].name, "one");
  for (std::size_t i = 1; i < comparison.results.size(); ++i) {
    EXPECT_GE(comparison.results[i - 1].max_relative_change(), comparison.results[i].max_relative_change());
  }
  ASSERT_FALSE(comparison.figures.empty());
  EXPECT_EQ(comparison.figures[0].curves.size(), 2u);
}

TEST(folder_compare, page_and_table_hold_what_differs) {
  const TemporaryFolder folder;
  const fs::path first_folder = solve(folder, "one", kSmallLay), second = solve(folder, "other", kTighter);
  const FolderComparison comparison = compare_folders({first_folder, second});
  const std::string table = folder_comparison_table(comparison),
                    page = shown_text(folder_comparison_document(comparison).body);
  EXPECT_NE(table.find("input,tensioner.tension,,300 kN,0.33 MN,"), std::string::npos);
  EXPECT_NE(table.find("result,static.top_tension,kN,300.0"), std::string::npos) << table;  // the effective one
  EXPECT_NE(page.find("0.33 MN"), std::string::npos);
  EXPECT_EQ(table.find("nan"), std::string::npos);
}

TEST(folder_compare, a_check_is_compared_with_the_same_check) {
  const TemporaryFolder folder;
  const fs::path first_folder = solve(folder, "one", kSmallLay);
  const fs::path second_folder = solve(folder, "other", kSmallLay + "checks: {codes: api}\n");
  int checks = 0;
  for (const ComparedResult& each : compare_folders({first_folder, second_folder}).results) {
    if (!each.name.starts_with("checks.") || each.name.starts_with("checks.worst")) continue;
    EXPECT_EQ(each.max_relative_change(), 0.0) << each.text;
    ++checks;
  }
  EXPECT_GT(checks, 2);
}

TEST(folder_compare, folders_of_one_name_are_distinguished_by_where_they_lie) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "a");
  fs::create_directories(folder / "b");
  const fs::path first_folder = solve(folder, "a/results", kSmallLay);
  fs::copy(first_folder, folder / "b/results", fs::copy_options::recursive);
  const FolderComparison comparison = compare_folders({first_folder, folder / "b/results"});
  EXPECT_EQ(comparison.folders[0].name, "a/results");
  EXPECT_EQ(comparison.folders[1].name, "b/results");
}

TEST(folder_compare, a_folder_without_results_is_named) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "empty");
  try {
    compare_folders({folder / "empty", folder / "empty"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("empty: no results.h5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace overbend

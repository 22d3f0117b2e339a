#include <gtest/gtest.h>

#include "app/program.h"
#include "app/small_lay.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::run_program;
using testing::Scratch;
using testing::with;

/// A folder with the statics of the small lay.
struct Solved {
  Solved() {
    scratch.write("model.yaml", kSmallLay);
    first = run_program("static " + scratch.file("model.yaml") + " -o " + scratch.file("out"));
  }
  testing::ProgramRun check(const std::string& more) const {
    return run_program("check-results " + scratch.file("out") + " " + more);
  }
  Scratch scratch;
  testing::ProgramRun first;
};

std::string find_check_lines(const std::string& out) {
  const std::size_t first = out.find("  check, "), last = out.rfind("  check, ");
  return out.substr(first, out.find('\n', last) - first);
}

TEST(check_results_command, prints_the_checks_as_the_analysis_did_and_writes_nothing) {
  const Solved solved;
  const std::string before = solved.scratch.read("out/summary.json");
  const auto again = solved.check("");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out.find("small lay\n"), 0U) << again.out;
  EXPECT_EQ(find_check_lines(again.out), find_check_lines(solved.first.out));
  EXPECT_EQ(solved.scratch.read("out/summary.json"), before);
}

TEST(check_results_command, writes_only_into_a_new_folder) {
  const Solved solved;
  const auto rejected = solved.check("-o " + solved.scratch.file("out"));
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("is not empty"), std::string::npos) << rejected.err;
  const auto written = solved.check("--set checks.yield_basis=smys -o " + solved.scratch.file("smys"));
  EXPECT_EQ(written.code, 0) << written.err;
  EXPECT_NE(find_check_lines(written.out), find_check_lines(solved.first.out));
  EXPECT_NE(solved.scratch.read("smys/checks.csv"), solved.scratch.read("out/checks.csv"));
}

TEST(check_results_command, rejects_other_keys_and_folders_without_results) {
  const Solved solved;
  const auto key = solved.check("--set pipe.length='900 m'");
  EXPECT_EQ(key.code, 2);
  EXPECT_NE(key.err.find("--set pipe.length: only keys below 'checks'"), std::string::npos) << key.err;
  const auto nothing = run_program("check-results " + solved.scratch.file("nowhere"));
  EXPECT_EQ(nothing.code, 2);
  EXPECT_NE(nothing.err.find("there are no results in"), std::string::npos) << nothing.err;
}

TEST(check_results_command, ends_with_4_where_it_is_strict_and_a_check_is_exceeded) {
  const Solved solved;
  EXPECT_EQ(solved.check("--set 'checks.limits.tension=100 kN'").code, 0);
  EXPECT_EQ(solved.check("--strict --set 'checks.limits.tension=100 kN'").code, 4);
  EXPECT_EQ(solved.check("--strict --set 'checks.limits.tension=900 kN'").code, 0);
}

TEST(check_results_command, checks_each_of_several_seeds_and_writes_none_of_them) {
  const Scratch scratch;
  scratch.write("model.yaml", with(kSmallLay, "duration: 10 s", "duration: 4 s, seeds: [1, 2]"));
  ASSERT_EQ(run_program("dynamic " + scratch.file("model.yaml") + " -o " + scratch.file("out")).code, 0);
  const auto all = run_program("check-results " + scratch.file("out"));
  EXPECT_EQ(all.code, 0) << all.err;
  for (const char* run : {"small lay, seed-1\n", "small lay, seed-2\n"}) {
    EXPECT_NE(all.out.find(run), std::string::npos) << all.out;
  }
  const auto rejected = run_program("check-results " + scratch.file("out") + " -o " + scratch.file("new"));
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("one run"), std::string::npos) << rejected.err;
}

}  // namespace
}  // namespace overbend

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>

#include "support/program_path.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::case_file;
using testing::file_text;
using testing::TemporaryFolder;

struct Ended {
  int code = -1;
  std::string out, err;
};

/// Runs the program with `words` in `folder`; its output goes to files elsewhere.
Ended run(const fs::path& folder, const std::string& message) {
  const TemporaryFolder prescribed;
  const std::string command = "cd '" + folder.string() + "' && '" + testing::program_path() + "' " + message + " > '" +
                              (prescribed / "out").string() + "' 2> '" + (prescribed / "err").string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_text(prescribed / "out"), file_text(prescribed / "err")};
}

std::string with_tension(const std::string& tension) {
  std::string text = file_text(case_file("BGL1-T250"));
  const std::string given = "tension: 250 kN";
  return text.replace(text.find(given), given.size(), "tension: " + tension);
}

TEST(static_command, writes_the_results_to_the_given_folder_and_prints_the_key_ones) {
  const TemporaryFolder folder;
  const Ended done = run(folder.path(), "static " + case_file("BGL1-T250") + " -o deep/out");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  for (const char* file : {"summary.json", "pipe.csv", "supports.csv", "results.h5"}) {
    EXPECT_TRUE(fs::is_regular_file(folder / "deep/out" / file)) << file;
  }
  for (const char* said :
       {"top tension", "horizontal tension", "lay-back", "departure angle", "overbend bending stress",
        "sagbend bending stress", "stinger tip clearance", "max. roller reaction", "balance of forces", "deep/out"}) {
    EXPECT_NE(done.out.find(said), std::string::npos) << said;
  }
}

TEST(static_command, counts_every_length_from_the_tensioner) {
  const TemporaryFolder folder;
  const Ended done = run(folder.path(), "static " + case_file("BGL1-T250") + " -o out");
  EXPECT_NE(done.out.find(" m from the tensioner\n  overbend von Mises stress"), std::string::npos) << done.out;
  EXPECT_EQ(done.out.find(" at s = "), std::string::npos) << done.out;
}

std::string with_limit(const std::string& limit) {
  return file_text(case_file("BGL1-T250")) + "\nchecks: {limits: {tension: " + limit + "}}\n";
}

TEST(static_command, rejects_a_mesh_that_would_fill_the_memory) {
  const TemporaryFolder folder;
  std::string text = file_text(case_file("J12-D400-T560"));
  text.replace(text.find("water_depth: 400 m"), 18, "water_depth: 1200 m");
  text.replace(text.find("tension: 560 kN"), 15, "tension: 1500 kN");
  testing::write_file(folder / "fine.yaml", text + "\nanalysis: {mesh: {longest_element: 0.02 m}}\n");
  const Ended rejected = run(folder.path(), "static fine.yaml -o out");
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("analysis.mesh.longest_element"), std::string::npos) << rejected.err;
  EXPECT_NE(rejected.err.find("elements, the maximum is 50000"), std::string::npos) << rejected.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(static_command, reports_the_deciding_checks) {
  const TemporaryFolder folder;
  const Ended done = run(folder.path(), "static " + case_file("BGL1-T250") + " -o out --strict");
  EXPECT_EQ(done.code, 0) << done.err;
  for (const char* said : {"check, overbend", "check, sagbend", "DNV-ST-F101 (2021)", "from the tensioner"}) {
    EXPECT_NE(done.out.find(said), std::string::npos) << said;
  }
  EXPECT_TRUE(fs::is_regular_file(folder / "out/checks.csv"));
}

TEST(static_command, strict_ends_with_4_and_names_the_worst_check_with_the_results_written) {
  const TemporaryFolder folder;
  testing::write_file(folder / "weak.yaml", with_limit("200 kN"));
  const Ended strict = run(folder.path(), "static weak.yaml -o out --strict");
  EXPECT_EQ(strict.code, 4);
  EXPECT_NE(strict.err.find("Tension at the tensioner"), std::string::npos) << strict.err;
  EXPECT_NE(strict.err.find("1.25"), std::string::npos) << strict.err;
  EXPECT_EQ(std::count(strict.err.begin(), strict.err.end(), '\n'), 1);
  for (const char* file : {"summary.json", "checks.csv", "results.h5", "report.html"}) {
    EXPECT_TRUE(fs::is_regular_file(folder / "out" / file)) << file;
  }
  EXPECT_EQ(run(folder.path(), "static weak.yaml -o again").code, 0);
}

TEST(static_command, names_the_folder_after_the_model_when_none_is_given) {
  const TemporaryFolder folder;
  const Ended done = run(folder.path(), "static " + case_file("J12-D400-T560"));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(fs::is_regular_file(folder / "J12-D400-T560.results/summary.json"));
  EXPECT_EQ(done.out.find("overbend bending stress"), std::string::npos);
}

TEST(static_command, ends_with_3_and_writes_nothing_when_the_tension_is_far_too_low) {
  const TemporaryFolder folder;
  testing::write_file(folder / "low.yaml", with_tension("5 kN"));
  const Ended done = run(folder.path(), "static low.yaml -o out");
  EXPECT_EQ(done.code, 3);
  EXPECT_EQ(done.out, "");
  EXPECT_EQ(done.err.substr(0, 40), "overbend: no solution: the tension is to");
  EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(static_command, ends_with_2_and_writes_nothing_when_the_model_is_wrong) {
  const TemporaryFolder folder;
  testing::write_file(folder / "wrong.yaml", with_tension("250 m"));
  const Ended done = run(folder.path(), "static wrong.yaml -o out");
  EXPECT_EQ(done.code, 2);
  EXPECT_NE(done.err.find("wrong.yaml:"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
  EXPECT_EQ(run(folder.path(), "static missing.yaml -o out").code, 2);
  EXPECT_EQ(run(folder.path(), "static").code, 2);
}

TEST(static_command, ends_with_2_when_the_folder_can_not_be_written) {
  const TemporaryFolder folder;
  testing::write_file(folder / "file", "mine");
  const Ended done = run(folder.path(), "static " + case_file("J12-D400-T560") + " -o file");
  EXPECT_EQ(done.code, 2);
  EXPECT_NE(done.err.find("'file' cannot be written"), std::string::npos) << done.err;
  EXPECT_EQ(file_text(folder / "file"), "mine");
}

}  // namespace
}  // namespace overbend

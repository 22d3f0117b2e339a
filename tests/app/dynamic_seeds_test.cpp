#include <gtest/gtest.h>

#include "app/child_program.h"
#include "app/program.h"
#include "app/small_lay.h"
#include "base/json.h"
#include "support/csv_text.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::ChildProgram;
using testing::file_text;
using testing::kSmallLay;
using testing::ProgramRun;
using testing::run_program;
using testing::TemporaryFolder;
using testing::with;

const std::string kSeeds = with(kSmallLay, "duration: 10 s", "seeds: [7, 3, 12], duration: 10 s");

ProgramRun run_seeds_model(const TemporaryFolder& folder, const std::string& model, const std::string& more = "") {
  testing::write_file(folder / "lay.yaml", model);
  return run_program("dynamic " + (folder / "lay.yaml").string() + " -o " + (folder / "out").string() + " " + more);
}

Json load_summary(const fs::path& results) {
  return read_json(file_text(results / "summary.json"));
}

bool same_tables(const fs::path& first_folder, const fs::path& two) {
  for (const char* file : {"pipe.csv", "supports.csv", "impacts.csv"}) {
    if (file_text(first_folder / file).empty() || file_text(first_folder / file) != file_text(two / file)) return false;
  }
  return true;
}

TEST(dynamic_seeds, a_table_of_the_user_is_not_written_over_and_the_cases_stay) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  testing::write_file(folder / "out/seeds.csv", "mine");
  const std::string two = with(kSmallLay, "duration: 10 s", "seeds: [7, 3], duration: 1 s");
  const ProgramRun run = run_seeds_model(folder, two);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("'seeds.csv' in it was not written by the program"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("internal error"), std::string::npos) << run.err;
  EXPECT_EQ(file_text(folder / "out/seeds.csv"), "mine");
}

TEST(dynamic_seeds, each_seed_has_its_folder_and_the_summary_gathers_them) {
  const TemporaryFolder folder, alone;
  const ProgramRun run = run_seeds_model(folder, kSeeds);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("3 of 3"), std::string::npos) << run.out;
  const Json summary = load_summary(folder / "out");
  const Json& seeds = summary.at("seeds");
  ASSERT_EQ(seeds.at("runs").size(), 3U);
  EXPECT_TRUE(seeds.at("failed").empty());
  EXPECT_GT(summary.at("static").at("top_tension"), 0.0);

  const std::vector<std::string> table = testing::csv_lines(file_text(folder / "out/seeds.csv"));
  ASSERT_EQ(table.size(), 4U);
  double sum = 0.0, max_value = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& row = seeds.at("runs").at(i);
    EXPECT_EQ(row.at("seed"), (std::vector<int>{7, 3, 12})[i]);
    const fs::path results = folder / "out" / row.at("folder").get<std::string>();
    EXPECT_TRUE(fs::is_regular_file(results / "report.html"));
    const Json dynamic = load_summary(results).at("dynamic");
    EXPECT_EQ(dynamic.at("seed"), row.at("seed"));
    const double stress = dynamic.at("overbend").at("max_von_mises").at("max");
    EXPECT_EQ(row.at("overbend_max_von_mises").get<double>(), stress);
    EXPECT_NEAR(testing::value_in(table, i + 1, "overbend_max_von_mises [MPa]"), stress / 1e6, 1e-9 * stress / 1e6);
    sum += stress;
    max_value = std::max(max_value, stress);
  }
  const Json& over_seeds = seeds.at("statistics").at("overbend_max_von_mises");
  EXPECT_NEAR(over_seeds.at("mean").get<double>(), sum / 3.0, 1e-12 * sum);
  EXPECT_EQ(over_seeds.at("max").get<double>(), max_value);
  EXPECT_LT(over_seeds.at("min").get<double>(), max_value);  // the seeds are different seas
  EXPECT_TRUE(over_seeds.at("gumbel").is_null());            // three runs are too few for a distribution

  // A seed among others is the seed alone.
  ASSERT_EQ(run_seeds_model(alone, with(kSmallLay, "duration: 10 s", "seeds: [12], duration: 10 s")).code, 0);
  EXPECT_TRUE(same_tables(alone / "out", folder / "out/seed-12"));
}

TEST(dynamic_seeds, results_do_not_depend_on_the_number_of_threads) {
  const TemporaryFolder temporary_folder, two;
  ASSERT_EQ(run_seeds_model(temporary_folder, kSeeds, "--threads 1").code, 0);
  ASSERT_EQ(run_seeds_model(two, kSeeds, "--threads 2").code, 0);
  for (const char* seed : {"seed-7", "seed-3", "seed-12"}) {
    EXPECT_TRUE(same_tables(temporary_folder / "out" / seed, two / "out" / seed)) << seed;
  }
  EXPECT_EQ(file_text(temporary_folder / "out/seeds.csv"), file_text(two / "out/seeds.csv"));
  EXPECT_EQ(load_summary(temporary_folder / "out").at("seeds"), load_summary(two / "out").at("seeds"));
}

TEST(dynamic_seeds, one_that_fails_is_listed_and_the_others_go_on) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  testing::write_file(folder / "out/seed-3", "in the way");
  const ProgramRun run = run_seeds_model(folder, kSeeds);
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.err.find("overbend: seed 3: "), std::string::npos) << run.err;
  const Json seeds = load_summary(folder / "out").at("seeds");
  EXPECT_EQ(seeds.at("runs").size(), 2U);
  ASSERT_EQ(seeds.at("failed").size(), 1U);
  EXPECT_EQ(seeds.at("failed").at(0).at("seed"), 3);
  EXPECT_NE(file_text(folder / "out/seeds.csv").find("failed: "), std::string::npos);

  // The file in the way is removed: resumed, the others are not run again.
  fs::remove(folder / "out/seed-3");
  const auto before = fs::last_write_time(folder / "out/seed-7/summary.json");
  EXPECT_EQ(run_seeds_model(folder, kSeeds, "--resume").code, 0);
  EXPECT_EQ(fs::last_write_time(folder / "out/seed-7/summary.json"), before);
  EXPECT_EQ(load_summary(folder / "out").at("seeds").at("runs").size(), 3U);
}

TEST(dynamic_seeds, interrupted_and_resumed_give_the_same_bits) {
  const std::string model = with(kSeeds, "duration: 10 s, build_up: 5 s, output_step: 0.5 s",
                                 "duration: 30 s, build_up: 5 s, output_step: 0.1 s");
  const TemporaryFolder whole, stopped;
  ASSERT_EQ(run_seeds_model(whole, model).code, 0);
  testing::write_file(stopped / "lay.yaml", model);
  ChildProgram program(stopped.path(), {"dynamic", "lay.yaml", "-o", "out", "--checkpoint", "0", "--threads", "1"});
  ASSERT_TRUE(program.signal_after(stopped / "out/seed-3", 5.0, SIGINT));  // the second: the first is done
  EXPECT_EQ(program.end(), 130);
  EXPECT_TRUE(fs::exists(stopped / "out/seed-7/summary.json"));
  EXPECT_TRUE(fs::exists(stopped / "out/seed-3/.run/checkpoint"));
  EXPECT_FALSE(fs::exists(stopped / "out/seed-12"));

  const ProgramRun second_program_run =
      run_seeds_model(stopped, with(model, "tension: 300 kN", "tension: 301 kN"), "--resume");
  EXPECT_EQ(second_program_run.code, 2);
  EXPECT_NE(second_program_run.err.find("another model"), std::string::npos) << second_program_run.err;

  EXPECT_EQ(run_seeds_model(stopped, model, "--resume").code, 0);
  for (const char* seed : {"seed-7", "seed-3", "seed-12"}) {
    EXPECT_TRUE(same_tables(whole / "out" / seed, stopped / "out" / seed)) << seed;
  }
  EXPECT_EQ(file_text(whole / "out/seeds.csv"), file_text(stopped / "out/seeds.csv"));
}

TEST(dynamic_seeds, rejected_as_a_whole_when_the_input_is_wrong_for_all) {
  const TemporaryFolder folder;
  testing::write_file(folder / "out", "a file");
  const ProgramRun run = run_seeds_model(folder, kSeeds);
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(file_text(folder / "out"), "a file");
}

}  // namespace
}  // namespace overbend

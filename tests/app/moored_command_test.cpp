/// The program on a hull on its mooring lines without a pipe, in time.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/program.h"
#include "base/json.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "support/program_path.h"

namespace overbend {
namespace {

using testing::ProgramRun;
using testing::run_program;
using testing::Scratch;

/// The example with few waves, over a short time; `more` in its dynamic analysis.
std::string barge(const std::string& more = "") {
  std::ifstream in(testing::example("moored-barge.yaml"));
  std::stringstream text;
  text << in.rdbuf();
  std::string model = text.str();
  const auto put = [&](const std::string& old, const std::string& new_text) {
    const std::size_t index = model.find(old);
    ASSERT_NE(index, std::string::npos) << old;
    model.replace(index, old.size(), new_text);
  };
  put("seed: 1}", "seed: 1, components: 30}");
  put("../data/bgl1/bgl1", OVERBEND_SOURCE_DIR "/data/bgl1/bgl1");
  put("duration: 10800 s, build_up: 300 s", "duration: 20 s, build_up: 10 s" + more);
  return model;
}

ProgramRun run_barge(const Scratch& scratch, const std::string& model, const std::string& more = "") {
  return run_program("dynamic " + scratch.write("barge.yaml", model) + " -o " + scratch.file("out") + " " + more);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(moored_command, follows_the_barge_and_writes_what_it_found) {
  const Scratch scratch;
  const ProgramRun done = run_barge(scratch, barge());
  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* said : {"Horizontal offset", "starboard bow", "slow sway", "energy drift", "fewer than 20"}) {
    EXPECT_TRUE(has(done.out, said)) << said << "\n" << done.out;
  }
  EXPECT_FALSE(has(done.out, "top tension") || has(done.out, "sagbend")) << done.out;
  for (const char* file : {"summary.json", "moorings.csv", "results.h5", "report.html"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(scratch.file(std::string("out/") + file))) << file;
  }
  const Json summary = read_json(scratch.read("out/summary.json"));
  const Json& dynamic = summary["dynamic"];
  EXPECT_EQ(dynamic["duration"], 20.0);
  ASSERT_EQ(dynamic["moorings"].size(), 8U);
  const double start = summary["static"]["moorings"][0]["fairlead_tension"];
  EXPECT_NEAR(dynamic["moorings"][0]["start_fairlead_tension"], start, 0.02 * start);
  EXPECT_GT(dynamic["vessel"]["pitch"]["max"], dynamic["vessel"]["pitch"]["min"]);
  EXPECT_FALSE(dynamic.contains("top_tension"));
  EXPECT_EQ(dynamic["checks"]["worst"]["id"], "anchor_load") << dynamic["checks"];
  EXPECT_EQ(dynamic["verdict"]["kind"], "passed") << dynamic["verdict"];
}

TEST(moored_command, has_results_that_are_read_as_they_were_written) {
  const Scratch scratch;
  ASSERT_EQ(run_barge(scratch, barge()).code, 0);
  const StoredDynamics stored = read_dynamic_results(scratch.file("out/results.h5"));
  ASSERT_FALSE(stored.statics.results.has_pipe());
  ASSERT_TRUE(stored.statics.results.moorings && stored.statics.results.hull);
  const Json dynamic = read_json(scratch.read("out/summary.json"))["dynamic"];
  EXPECT_EQ(stored.results.vessel->roll.whole.max, dynamic["vessel"]["roll"]["max"]);
  EXPECT_EQ(*stored.results.moorings[7].fairlead_tension.most_probable_max,
            dynamic["moorings"][7]["fairlead_tension"]["most_probable_max"]);
  EXPECT_EQ(stored.results.run.steps, dynamic["steps"]);
  EXPECT_EQ(stored.results.extremes.size(), dynamic["extremes"].size());
  const std::string before = scratch.read("out/report.html");
  ASSERT_EQ(run_program("report " + scratch.file("out")).code, 0);
  const auto without_date = [](std::string page) { return page.erase(page.find("Written"), 120); };
  EXPECT_EQ(without_date(scratch.read("out/report.html")), without_date(before));
}

TEST(moored_command, is_not_run_again_where_it_is_finished) {
  const Scratch scratch;
  ASSERT_EQ(run_barge(scratch, barge()).code, 0);
  const ProgramRun again = run_barge(scratch, barge(), "--resume");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(has(again.err, "is already finished (20 s)")) << again.err;
  EXPECT_TRUE(has(again.out, "starboard bow")) << again.out;
}

TEST(moored_command, gathers_seeds_by_offset_and_tension) {
  const Scratch scratch;
  const ProgramRun done = run_barge(scratch, barge(", seeds: [1, 2]"));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json seeds = read_json(scratch.read("out/summary.json"))["seeds"];
  ASSERT_EQ(seeds["runs"].size(), 2U);
  const Json two = read_json(scratch.read("out/seed-2/summary.json"))["dynamic"];
  EXPECT_EQ(seeds["runs"][1]["largest_offset"], two["vessel"]["offset"]["max"]);
  EXPECT_NE(seeds["runs"][0]["largest_mooring_tension"], seeds["runs"][1]["largest_mooring_tension"]);
  EXPECT_FALSE(seeds["runs"][0].contains("top_tension_max"));
}

TEST(moored_command, makes_the_code_checks_of_its_mooring_lines_again) {
  const Scratch scratch;
  ASSERT_EQ(run_barge(scratch, barge()).code, 0);
  const auto worst = [&](const char* folder) {
    return read_json(scratch.read(std::string(folder) + "/summary.json"))["dynamic"]["checks"]["worst"];
  };
  const ProgramRun checked = run_program("check-results " + scratch.file("out") + " -o " + scratch.file("again"));
  ASSERT_EQ(checked.code, 0) << checked.err;
  EXPECT_GT(worst("out")["utilisation"].get<double>(), 0.1);
  EXPECT_EQ(worst("again"), worst("out"));
}

TEST(moored_command, is_compared_by_offsets_and_tensions_with_another_run) {
  const Scratch scratch;
  ASSERT_EQ(run_barge(scratch, barge()).code, 0);
  std::string rougher = barge();
  rougher.replace(rougher.find("hs: 1.5 m"), 9, "hs: 2.5 m");
  ASSERT_EQ(run_program("dynamic " + scratch.write("rough.yaml", rougher) + " -o " + scratch.file("rough")).code, 0);
  const ProgramRun compared =
      run_program("compare " + scratch.file("out") + " " + scratch.file("rough") + " -o " + scratch.file("compared"));
  ASSERT_EQ(compared.code, 0) << compared.err;
  const std::string table = scratch.read("compared/comparison.csv");
  EXPECT_TRUE(has(table, "input,environment.waves.hs,,1.5 m,2.5 m")) << table;
  EXPECT_TRUE(has(table, "result,dynamic.vessel.pitch.max,deg,")) << table;
  EXPECT_TRUE(has(table, "result,dynamic.moorings[port bow].fairlead_tension.max,kN,")) << table;
  EXPECT_TRUE(has(table, "result,static.moorings[port bow].fairlead_tension,kN,")) << table;
  EXPECT_TRUE(has(scratch.read("compared/comparison.html"), "Fairlead tension of port bow"));
}

TEST(moored_command, gives_studies_what_the_vessel_and_its_lines_did) {
  const Scratch scratch;
  scratch.write("barge.yaml", barge());
  const std::string study = scratch.write("study.yaml",
                                          "overbend_study: 1\nbase: barge.yaml\nanalysis: dynamic\n"
                                          "axes: [{key: environment.waves.hs, values: [1 m, 2 m]}]\n");
  const ProgramRun done = run_program("study " + study + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err << done.out;
  EXPECT_TRUE(has(done.out, "dynamic.vessel.offset")) << done.out;
  EXPECT_TRUE(has(done.out, "max(dynamic.moorings[*].fairlead_tension.max)")) << done.out;
  EXPECT_FALSE(has(done.out, "none")) << done.out;
}

}  // namespace
}  // namespace overbend

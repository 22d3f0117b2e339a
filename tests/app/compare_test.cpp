#include <gtest/gtest.h>

#include "app/child_program.h"
#include "app/program.h"
#include "app/small_lay.h"
#include "base/json.h"
#include "study/seeds/compare_gather.h"
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

/// A range that the small lay leaves at once, and a machine that follows it.
const std::string kControlled =
    with(kSmallLay, "tension: 300 kN}", "tension: 300 kN, range: [299 kN, 301 kN], velocity: 0.3 m/s, travel: 1 m}");

ProgramRun compare(const TemporaryFolder& folder, const std::string& model, const std::string& more) {
  testing::write_file(folder / "lay.yaml", model);
  return run_program("compare " + (folder / "lay.yaml").string() + " -o " + (folder / "out").string() + " " + more);
}

Json load_json(const fs::path& file) {
  return read_json(file_text(file));
}

/// The row of a quantity: its cells by the names of the head.
double cell(const std::vector<std::string>& table, const std::string& quantity, const std::string& column) {
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (table[i].rfind(quantity + ",", 0) == 0) return testing::value_in(table, i, column);
  }
  ADD_FAILURE() << "no " << quantity;
  return 0.0;
}

TEST(compare, a_page_of_the_user_is_seen_before_anything_is_computed) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  testing::write_file(folder / "out/comparison.html", "mine");
  const ProgramRun run = compare(folder, kControlled, "--of tensioner");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("'comparison.html' in it was not written by the program"), std::string::npos) << run.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), fs::directory_iterator()), 1);
}

TEST(compare, the_variants_own_summaries_agree_with_the_table) {
  const TemporaryFolder folder;
  const ProgramRun run = compare(folder, kControlled, "--of tensioner --threads 2");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::vector<std::string> table = testing::csv_lines(file_text(folder / "out/comparison.csv"));
  const Json variants = load_json(folder / "out/comparison.json").at("comparison").at("variants");
  ASSERT_EQ(variants.size(), 3U);
  for (const Json& variant : variants) {
    const std::string name = variant.at("name");
    const Json dynamic = load_json(folder / "out" / name / "summary.json").at("dynamic");
    EXPECT_EQ(variant.at("top_tension_max"), dynamic.at("top_tension").at("max")) << name;
    EXPECT_EQ(variant.at("overbend_max_von_mises"), dynamic.at("overbend").at("max_von_mises").at("max")) << name;
    const double tension = dynamic.at("tensioner").at("max_tension");
    EXPECT_EQ(variant.at("tension_max").get<double>(), tension) << name;
    EXPECT_NEAR(cell(table, "tension_max", name), tension / 1e3, 1e-9 * tension / 1e3) << name;  // twelve digits
    EXPECT_TRUE(fs::is_regular_file(folder / "out" / name / "report.html"));
  }
  EXPECT_NE(file_text(folder / "out/comparison.html").find("compared_tensioner"), std::string::npos);
}

TEST(compare, off_does_not_travel_and_constant_keeps_its_tension) {
  const TemporaryFolder folder;
  ASSERT_EQ(compare(folder, kControlled, "--of tensioner").code, 0);
  const std::vector<std::string> table = testing::csv_lines(file_text(folder / "out/comparison.csv"));
  EXPECT_EQ(cell(table, "largest_travel", "off"), 0.0);
  EXPECT_EQ(cell(table, "pay_out_count", "off"), 0.0);
  EXPECT_GT(cell(table, "time_out_of_range", "off"), 0.0);
  EXPECT_GT(cell(table, "largest_travel", "controlled"), 0.0);
  EXPECT_LT(cell(table, "tension_std", "constant"), 1e-3 * cell(table, "tension_std", "off"));  // a solver's tolerance
}

TEST(compare, a_variant_is_the_run_of_the_model_with_its_key_set) {
  const TemporaryFolder folder, alone;
  ASSERT_EQ(compare(folder, kControlled, "--of tensioner").code, 0);
  testing::write_file(alone / "lay.yaml", with(kControlled, "travel: 1 m}", "travel: 1 m, mode: constant}"));
  ASSERT_EQ(run_program("dynamic " + (alone / "lay.yaml").string() + " -o " + (alone / "out").string()).code, 0);
  for (const char* file : {"pipe.csv", "supports.csv", "impacts.csv"}) {
    EXPECT_EQ(file_text(folder / "out/constant" / file), file_text(alone / "out" / file)) << file;
  }
}

TEST(compare, without_a_range_the_tensioner_is_rejected_in_one_line) {
  const TemporaryFolder folder;
  const ProgramRun run = compare(folder, kSmallLay, "--of tensioner");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("tensioner.range is missing"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(compare, contact_reports_on_every_box_in_both_models) {
  const TemporaryFolder folder;
  const ProgramRun run = compare(folder, kSmallLay, "--of contact");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json comparison = load_json(folder / "out/comparison.json").at("comparison");
  const Json& supports = comparison.at("supports");
  ASSERT_EQ(supports.size(), 5U);
  for (const char* name : {"rollers", "gap_springs"}) {
    const Json boxes = load_json(folder / "out" / name / "summary.json").at("dynamic").at("supports");
    double sum = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(supports[i].at(name).at("contact_share"), boxes[i].at("contact_share"));
      EXPECT_EQ(supports[i].at(name).at("peak_reaction"), boxes[i].at("reaction").at("max"));
      sum += boxes[i].at("contact_share").get<double>();
    }
    const Json& variant = comparison.at("variants")[std::string(name) == "rollers" ? 0 : 1];
    EXPECT_NEAR(variant.at("boxes_carrying").get<double>(), sum, 1e-12 * sum);  // of five doubles
  }
}

/// A barge that throws the pipe off its rollers.
const std::string kThrown = with(kSmallLay, "heave: {amplitude: 0.3 m, period: 7 s}, pitch: {amplitude: 0.5 deg",
                                 "heave: {amplitude: 1 m, period: 5 s}, pitch: {amplitude: 3 deg");

TEST(compare, impacts_captured_are_counted_in_fewer_steps_and_not_reported_too_small) {
  const TemporaryFolder folder;
  const ProgramRun run = compare(folder, kThrown, "--of impacts");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json resolved = load_json(folder / "out/resolved/summary.json").at("dynamic");
  const Json captured = load_json(folder / "out/captured/summary.json").at("dynamic");
  EXPECT_LT(captured.at("steps").get<int>(), 0.8 * resolved.at("steps").get<int>());
  ASSERT_GT(resolved.at("impact_count").get<int>(), 2);
  EXPECT_GT(captured.at("impact_count").get<int>(), 0);
  const auto hardest = [](const Json& dynamic) {
    double force = 0.0;
    for (const Json& box : dynamic.at("impacts")) {
      force = std::max(force, box.value("largest_impact_force", 0.0));
    }
    return force;
  };
  EXPECT_GT(hardest(captured), 0.9 * hardest(resolved));
  double max_value = 0.0;
  for (const Json& box : captured.at("supports"))
    max_value = std::max(max_value, box.at("reaction").at("max").get<double>());
  EXPECT_GE(max_value, hardest(captured));
  const std::string page = file_text(folder / "out/comparison.html");
  EXPECT_NE(page.find("Captured against resolved"), std::string::npos);
  EXPECT_NE(page.find("compared_contact"), std::string::npos);
}

TEST(compare, killed_and_resumed_gives_the_same_comparison) {
  const std::string model = with(kControlled, "duration: 10 s, build_up: 5 s, output_step: 0.5 s",
                                 "duration: 20 s, build_up: 5 s, output_step: 0.2 s");
  const TemporaryFolder whole, stopped;
  ASSERT_EQ(compare(whole, model, "--of tensioner").code, 0);
  testing::write_file(stopped / "lay.yaml", model);
  {
    ChildProgram program(stopped.path(), {"compare", "lay.yaml", "--of", "tensioner", "-o", "out", "--checkpoint", "0",
                                          "--threads", "1"});
    ASSERT_TRUE(program.signal_after(stopped / "out/controlled", 5.0, SIGKILL));  // the second: the first is done
    EXPECT_EQ(program.end(), -SIGKILL);
  }
  EXPECT_FALSE(fs::exists(stopped / "out/comparison.html"));
  const auto off = fs::last_write_time(stopped / "out/off/summary.json");
  ASSERT_EQ(compare(stopped, model, "--of tensioner --resume").code, 0);
  EXPECT_EQ(fs::last_write_time(stopped / "out/off/summary.json"), off);
  EXPECT_EQ(file_text(whole / "out/comparison.csv"), file_text(stopped / "out/comparison.csv"));
  EXPECT_TRUE(fs::is_regular_file(stopped / "out/comparison.html"));
}

TEST(compare, interrupted_leaves_checkpoints_and_says_how_to_go_on) {
  const TemporaryFolder folder;
  testing::write_file(folder / "lay.yaml", with(kSmallLay, "duration: 10 s", "duration: 300 s"));
  ChildProgram program(folder.path(),
                       {"compare", "lay.yaml", "--of", "contact", "-o", "out", "--checkpoint", "0", "--threads", "2"});
  ASSERT_TRUE(program.signal_after(folder / "out/rollers", 1.0, SIGINT));
  EXPECT_EQ(program.end(), 130);
  EXPECT_TRUE(fs::exists(folder / "out/rollers/.run/checkpoint"));
  EXPECT_FALSE(fs::exists(folder / "out/comparison.json"));
}

TEST(compare, neighbouring_rows_of_one_state_are_one_span) {
  const std::vector<TensionerSpan> spans = tensioner_spans({0.0, 1.0, 2.0, 3.0}, {0.0, 0.0, 2.0, 2.0});
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].to, 2.0);
  EXPECT_EQ(spans[1].from, 2.0);
  EXPECT_EQ(spans[1].to, 3.0);
  EXPECT_EQ(spans[1].state, 2);
}

/// Two folders of statics of the small lay, the tension of the second raised.
void two_statics(const TemporaryFolder& folder) {
  testing::write_file(folder / "a.yaml", kSmallLay);
  testing::write_file(folder / "b.yaml", with(kSmallLay, "tension: 300 kN", "tension: 330 kN"));
  for (const char* name : {"a", "b"}) {
    const std::string stem = (folder / name).string();
    ASSERT_EQ(run_program("static " + stem + ".yaml -o " + stem).code, 0);
  }
}

TEST(compare, result_folders_are_put_next_to_each_other) {
  const TemporaryFolder folder;
  two_statics(folder);
  const std::string a = (folder / "a").string(), b = (folder / "b").string(), out = (folder / "out").string();
  const ProgramRun run = run_program("compare " + a + " " + b + " -o " + out);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("tensioner.tension: 300 kN | 330 kN"), std::string::npos) << run.out;
  EXPECT_TRUE(fs::exists(folder / "out/comparison.html"));
  EXPECT_TRUE(fs::exists(folder / "out/comparison.csv"));
}

TEST(compare, folders_that_cannot_be_compared_end_with_a_sentence) {
  const TemporaryFolder folder;
  two_statics(folder);
  const std::string a = (folder / "a").string(), b = (folder / "b").string();
  EXPECT_EQ(run_program("compare " + a).code, 2);
  EXPECT_EQ(run_program("compare " + a + " " + b + " --of tensioner").code, 2);
  EXPECT_EQ(run_program("compare " + a + ".yaml").code, 2);
  const ProgramRun missing = run_program("compare " + a + " " + (folder / "none").string());
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.err.find("none: no results.h5"), std::string::npos) << missing.err;
  EXPECT_EQ(run_program("compare " + a + " " + b + " -o " + b).code, 2);  // its results would be lost
  EXPECT_TRUE(fs::exists(folder / "b/results.h5"));
}

}  // namespace
}  // namespace overbend

/// The program's goal seek: files, lines and exit codes.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program.h"
#include "small_lay.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::run_program;
using testing::Scratch;

std::string seeking(const std::string& until) {
  return kSmallLay +
         "seek:\n  vary: {key: tensioner.tension, from: 250 kN, to: 400 kN}  # a comment\n  until: " + until + "\n";
}

TEST(seek_command, writes_the_statics_of_the_answer_with_the_way_there) {
  const Scratch scratch;
  const std::string model = scratch.write("lay.yaml", seeking("{result: static.bottom_tension, equals: 310 kN}"));
  const auto done = run_program("seek " + model + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("tensioner.tension"), std::string::npos);
  const Json summary = read_json(scratch.read("out/summary.json"));
  EXPECT_NEAR(summary["static"]["bottom_tension"].get<double>(), 310e3, 1.0);
  const Json& seek = summary["seek"];
  EXPECT_NEAR(seek["answer"].get<double>(), summary["static"]["top_tension"].get<double>(), 50.0);
  EXPECT_EQ(seek["unit"], "N");
  EXPECT_GT(seek["slope"].get<double>(), 0.5);
  EXPECT_EQ(seek["path"].size(), seek["evaluations"].get<std::size_t>());
  EXPECT_NE(scratch.read("out/model.yaml").find("# a comment"), std::string::npos);
  EXPECT_NE(scratch.read("out/seek.csv").find("tensioner.tension [kN],static.bottom_tension [kN],failure"),
            std::string::npos);
  EXPECT_NE(scratch.read("out/report.html").find("Goal seek"), std::string::npos);
}

TEST(seek_command, without_an_answer_it_says_why_and_ends_with_code_3) {
  const Scratch scratch;
  const std::string model = scratch.write("lay.yaml", seeking("{result: static.bottom_tension, equals: 900 kN}"));
  const auto done = run_program("seek " + model + " -o " + scratch.file("out"));
  EXPECT_EQ(done.code, 3);
  EXPECT_NE(done.err.find("it goes from"), std::string::npos) << done.err;
  const Json summary = read_json(scratch.read("out/summary.json"));
  EXPECT_EQ(summary["seek"]["found"], false);
  EXPECT_TRUE(summary["seek"]["answer"].is_null());
}

TEST(seek_command, leaves_a_model_of_that_name_in_the_folder_alone) {
  const Scratch scratch;
  const std::string text = seeking("{result: static.bottom_tension, equals: 310 kN}");
  const std::string model = scratch.write("model.yaml", text);
  const auto rejected = run_program("seek " + model + " -o " + scratch.file("."));
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("was not written by the program"), std::string::npos) << rejected.err;
  EXPECT_EQ(scratch.read("model.yaml"), text);
  // Its own answer is replaced by the next one, but never under an analysis that reads it.
  ASSERT_EQ(run_program("seek " + model + " -o " + scratch.file("out")).code, 0);
  ASSERT_EQ(run_program("seek " + model + " -o " + scratch.file("out")).code, 0);
  const std::string answer = scratch.read("out/model.yaml");
  for (const std::string command : {"static ", "seek ", "lay-table ", "dynamic "}) {
    const auto kept = run_program(command + scratch.file("out/model.yaml") + " -o " + scratch.file("out"));
    EXPECT_EQ(kept.code, 2) << command;
    EXPECT_NE(kept.err.find("is among the results"), std::string::npos) << kept.err;
    EXPECT_EQ(scratch.read("out/model.yaml"), answer) << command;
  }
}

TEST(seek_command, reports_the_warnings_of_the_answer) {
  const Scratch scratch;
  // The tension that is found lies outside of the tensioner's range, as `overbend static` would say.
  const std::string text = testing::with(seeking("{result: static.bottom_tension, equals: 310 kN}"), "tension: 300 kN}",
                                         "tension: 300 kN, range: [290 kN, 310 kN]}");
  const auto done = run_program("seek " + scratch.write("lay.yaml", text) + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  ASSERT_FALSE(read_json(scratch.read("out/summary.json"))["warnings"].empty());
  EXPECT_NE(done.out.find("  caution: "), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("does not contain the set tension"), std::string::npos) << done.out;
}

TEST(seek_command, needs_something_to_seek) {
  const Scratch scratch;
  const auto done = run_program("seek " + scratch.write("lay.yaml", kSmallLay) + " -o " + scratch.file("out"));
  EXPECT_EQ(done.code, 2);
  EXPECT_NE(done.err.find("seek"), std::string::npos);
}

/// For a lift: all its stages with the lengths found, and the stage to be copied.
TEST(seek_command, of_a_lift_writes_its_stages) {
  const Scratch scratch;
  const std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/validation/lift_cases/DL8-one.yaml");
  const std::string model = scratch.write(
      "lift.yaml", text +
                       "\nseek:\n  vary: {key: 'operation.stages[at the surface].lengths.davit 1', within: 3 m}\n"
                       "  until: {result: 'operation.stages[at the surface].lines.pipe.first_end.z', equals: 6 m}\n");
  const auto done = run_program("seek " + model + " -o " + scratch.file("out"));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("- {name: at the surface, lengths: {davit 1: "), std::string::npos) << done.out;
  const Json summary = read_json(scratch.read("out/summary.json"));
  const Json& stages = summary["operation"]["stages"];
  ASSERT_EQ(stages.size(), 5U);
  EXPECT_NEAR(stages[4]["lines"]["pipe"]["first_end"]["z"].get<double>(), 6.0, 1e-5);
  EXPECT_EQ(summary["seek"]["stages"].size(), 1U);
  EXPECT_NEAR(summary["seek"]["answer"].get<double>(), stages[4]["davits"]["davit 1"]["length"].get<double>(), 1e-6);
  const std::string report = scratch.read("out/report.html");
  EXPECT_NE(report.find("Goal seek"), std::string::npos);
  EXPECT_NE(report.find("\"text\":\"- {name: at the surface"), std::string::npos);
  // The model that was written gives the same.
  ASSERT_EQ(run_program("static " + scratch.file("out/model.yaml") + " -o " + scratch.file("again")).code, 0);
  const Json again = read_json(scratch.read("again/summary.json"))["operation"]["stages"];
  EXPECT_EQ(again[4]["lines"], stages[4]["lines"]);
}

}  // namespace
}  // namespace overbend

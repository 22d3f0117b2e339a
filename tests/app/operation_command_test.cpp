// Operations on the line as a user runs them.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/program.h"
#include "app/small_lay.h"
#include "base/json.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::ProgramRun;
using testing::run_program;
using testing::Scratch;

const std::string kHeadAndCable =
    "  type: abandonment\n"
    "  head: {length: 5 m, weight_in_air: 30 kN, weight_submerged: 22 kN}\n"
    "  cable: {diameter: 60 mm, weight_in_air: 150 N/m, weight_submerged: 130 N/m, axial_stiffness: 200 MN, "
    "breaking_load: 2000 kN}\n";
const std::string kSlack = "    - {name: slack, cable_out: 90 m, tension: 2 kN}\n";

/// A small lay that is abandoned; its stages after `more`.
std::string abandoned(const std::string& stages) {
  return kSmallLay + "operation:\n" + kHeadAndCable + "  stages:\n" + stages;
}

const std::string kTwo =
    "    - {name: past the tip, cable_out: 75 m, tension: 250 kN}\n"
    "    - {name: bed, cable_out: 130 m, tension: 150 kN}\n";

bool says(const std::string& text, const std::string& message) {
  return text.find(message) != std::string::npos;
}

TEST(operation_command, static_runs_all_stages_and_one_that_cannot_be_leaves_the_others_standing) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo + kSlack));
  const ProgramRun run = run_program("static " + model + " -o " + folder.file("out"));
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* arguments : {"cable out", "head depth", "past the tip", "bed", "slack", "2 of 3 equilibria"}) {
    EXPECT_TRUE(says(run.out, arguments)) << arguments << "\n" << run.out;
  }
  for (const char* file : {"summary.json", "stages.csv", "results.h5"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.file(std::string("out/") + file))) << file;
  }
  const Json stages = read_json(folder.read("out/summary.json"))["operation"]["stages"];
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_EQ(stages[0]["name"], "past the tip");
  EXPECT_GT(stages[1]["head"]["x"], stages[0]["head"]["x"]);
  EXPECT_LT(stages[1]["head"]["z"], stages[0]["head"]["z"]);
  EXPECT_EQ(stages[2]["status"], "failed");
  EXPECT_FALSE(stages[2]["failure"]["why"].get<std::string>().empty());
}

TEST(operation_command, what_the_lay_of_a_stage_warns_of_is_said_with_the_stage) {
  const Scratch folder;
  const std::string model =
      folder.write("lay.yaml", testing::with(abandoned(kTwo), "yield_stress: 414 MPa", "yield_stress: 120 MPa"));
  const ProgramRun run = run_program("static " + model + " -o " + folder.file("out"));
  EXPECT_EQ(run.code, 0) << run.err;
  const Json stages = read_json(folder.read("out/summary.json"))["operation"]["stages"];
  int warnings = 0;
  for (const Json& stage : stages) {
    for (const Json& finding : stage["lay_findings"]) {
      EXPECT_TRUE(says(run.out, "[" + finding["code"].get<std::string>() + "]")) << run.out;
      ++warnings;
    }
  }
  EXPECT_GT(warnings, 0);
}

TEST(operation_command, where_no_stage_can_be_there_is_no_solution) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kSlack));
  const ProgramRun run = run_program("static " + model + " -o " + folder.file("out"));
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(says(run.err, "no stage of the operation has an equilibrium")) << run.err;
}

TEST(operation_command, strict_looks_at_the_checks_of_every_stage) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo) + "checks: {limits: {tension: 200 kN}}\n");
  EXPECT_EQ(run_program("static " + model + " -o " + folder.file("out")).code, 0);
  EXPECT_EQ(run_program("static " + model + " --strict -o " + folder.file("out")).code, 4);
}

TEST(operation_command, a_stage_without_equilibrium_exceeds_the_verdict_of_terminal_and_files) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo + kSlack));
  const ProgramRun run = run_program("static " + model + " --strict -o " + folder.file("out"));
  EXPECT_EQ(run.code, 4);
  EXPECT_TRUE(says(run.err, "1 of 3 stages have no equilibrium")) << run.err;
  EXPECT_TRUE(says(run.out, "1 OF 3 STAGES WITHOUT EQUILIBRIUM")) << run.out;
  EXPECT_EQ(read_json(folder.read("out/summary.json"))["verdict"]["kind"], "exceeded");
  const ProgramRun again = run_program("check-results " + folder.file("out") + " --strict");
  EXPECT_EQ(again.code, 4);
  EXPECT_TRUE(says(again.out, "1 OF 3 STAGES WITHOUT EQUILIBRIUM")) << again.out;
}

TEST(operation_command, one_stage_is_a_static_analysis_of_its_own) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo));
  ASSERT_EQ(run_program("static " + model + " -o " + folder.file("all")).code, 0);
  ASSERT_EQ(run_program("static " + model + " --stage 2 -o " + folder.file("second")).code, 0);
  ASSERT_EQ(run_program("static " + model + " --stage bed -o " + folder.file("named")).code, 0);
  const Json all = read_json(folder.read("all/summary.json"))["operation"]["stages"][1];
  const Json second = read_json(folder.read("second/summary.json"));
  EXPECT_EQ(second["title"], "small lay, bed");
  EXPECT_NEAR(second["static"]["head"]["x"].get<double>(), all["head"]["x"].get<double>(), 1e-3);
  EXPECT_EQ(read_json(folder.read("named/summary.json"))["static"]["head"], second["static"]["head"]);
  const ProgramRun checked = run_program("check-results " + folder.file("second"));
  EXPECT_EQ(checked.code, 0) << checked.err;
}

TEST(operation_command, a_stage_that_is_none_is_reported_with_those_there_are) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo));
  for (const char* wanted : {"3", "0", "sea", "-1", "1.5"}) {
    const ProgramRun run = run_program("static " + model + " --stage=" + wanted + " -o " + folder.file("out"));
    EXPECT_EQ(run.code, 2) << wanted;
    EXPECT_TRUE(says(run.err, "from 1 ('past the tip') to 2 ('bed')")) << run.err;
  }
  const std::string lay = folder.write("lay_only.yaml", kSmallLay);
  EXPECT_TRUE(says(run_program("static " + lay + " --stage 1").err, "no operation on the line"));
}

TEST(operation_command, check_lists_the_stages) {
  const Scratch folder;
  const std::string model = folder.write(
      "lay.yaml", kSmallLay + "operation:\n" + kHeadAndCable +
                      "  stages: {from: 60 m, to: 120 m, steps: 2, tension: bottom, bottom_tension: 90 kN}\n");
  const ProgramRun run = run_program("check " + model);
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* arguments : {"operation abandonment", "stage 3", "120.0", "90.0 kN at touchdown"}) {
    EXPECT_TRUE(says(run.out, arguments)) << arguments << "\n" << run.out;
  }
}

TEST(operation_command, a_stage_goes_into_the_time_domain_and_a_resumed_run_knows_it) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo));
  const std::string command = "dynamic " + model + " --duration '2 s' -o " + folder.file("out");
  const ProgramRun run = run_program(command + " --stage bed");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.out, "small lay, bed")) << run.out;
  EXPECT_EQ(read_json(folder.read("out/run.json"))["stage"], "bed");
  const Json summary = read_json(folder.read("out/summary.json"));
  EXPECT_TRUE(says(json_text(summary["assumptions"]), "stage 'bed' of the operation abandonment"))
      << summary["assumptions"];
  // The cable lies over the rollers: a kink of it is no strain of the pipe.
  EXPECT_TRUE(summary["dynamic"]["overbend"].is_null());
  EXPECT_LT(summary["dynamic"]["sagbend"]["max_strain"]["max"].get<double>(), 0.01);
  const ProgramRun again = run_program(command + " --resume");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(says(again.err, "is already finished")) << again.err;
  EXPECT_EQ(run_program(command + " --resume --stage 1").code, 2);
}

TEST(operation_command, a_run_without_a_stage_is_of_the_lay_and_says_so) {
  const Scratch folder;
  const std::string model = folder.write("lay.yaml", abandoned(kTwo));
  const ProgramRun run = run_program("dynamic " + model + " --duration '2 s' -o " + folder.file("out"));
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string warning = "no stage of the operation abandonment was chosen";
  EXPECT_TRUE(says(run.out, warning)) << run.out;
  EXPECT_TRUE(says(json_text(read_json(folder.read("out/summary.json"))["warnings"]), warning));
}

TEST(operation_command, goal_seek_and_lay_table_are_of_the_lay_and_say_so) {
  const Scratch folder;
  const std::string model =
      folder.write("lay.yaml", abandoned(kTwo) +
                                   "seek: {vary: {key: tensioner.tension, from: 250 kN, to: 400 kN}, "
                                   "until: {result: static.bottom_tension, equals: 270 kN}}\n");
  const std::string warning = "no stage of the operation abandonment was chosen; the normal lay is analysed";
  const ProgramRun seek = run_program("seek " + model + " -o " + folder.file("sought"));
  ASSERT_EQ(seek.code, 0) << seek.err;
  EXPECT_TRUE(says(seek.out, warning)) << seek.out;
  EXPECT_TRUE(says(json_text(read_json(folder.read("sought/summary.json"))["warnings"]), warning));
  const ProgramRun table =
      run_program("lay-table " + model + " --tension '300 kN..350 kN/1' -o " + folder.file("table"));
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_TRUE(says(table.out, warning)) << table.out;
}

TEST(operation_command, a_cable_on_a_route_that_bends_is_rejected_regardless_of_what_is_asked_of_its_stages) {
  const Scratch folder;
  const std::string model =
      folder.write("lay.yaml", abandoned(kTwo) + "route: {legs: [{length: 280 m}, {radius: 900 m, angle: 20 deg}]}\n");
  const std::string rejection = "route: a line with a cable on a curved route is not supported";
  for (const char* stage : {"", " --stage 1"}) {
    const ProgramRun run = run_program("static " + model + stage + " -o " + folder.file("out"));
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_TRUE(says(run.err, rejection)) << run.err;
  }
  EXPECT_TRUE(says(run_program("check " + model).out, rejection));
}

/// They were passed over without a word.
TEST(operation_command, derivatives_of_all_stages_are_rejected) {
  const Scratch scratch;
  const auto stages = run_program("static --sensitivities " + scratch.write("lay.yaml", abandoned(kTwo)));
  EXPECT_EQ(stages.code, 2);
  EXPECT_NE(stages.err.find("--sensitivities: sensitivities are computed for a single stage; select it with --stage"),
            std::string::npos)
      << stages.err;
  const auto lift = run_program("static --sensitivities " OVERBEND_SOURCE_DIR "/examples/davit-level.yaml");
  EXPECT_EQ(lift.code, 2);
  EXPECT_NE(lift.err.find("the stages of a lift are not supported"), std::string::npos) << lift.err;
}

}  // namespace
}  // namespace overbend

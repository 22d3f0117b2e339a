#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/child_program.h"
#include "app/program.h"
#include "app/small_lay.h"
#include "base/finding.h"
#include "base/json.h"
#include "report/page_text.h"
#include "support/program_path.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::ChildProgram;
using testing::document_in;
using testing::file_text;
using testing::kMoving;
using testing::kSmallLay;
using testing::kWaves;
using testing::ProgramRun;
using testing::run_program;
using testing::shown_text;
using testing::TemporaryFolder;
using testing::with;

/// `overbend dynamic MODEL -o FOLDER/out MORE`, the model written to FOLDER/lay.yaml first.
ProgramRun run_dynamic_model(const TemporaryFolder& folder, const std::string& model, const std::string& more = "") {
  testing::write_file(folder / "lay.yaml", model);
  return run_program("dynamic " + (folder / "lay.yaml").string() + " -o " + (folder / "out").string() + " " + more);
}

Json load_summary(const fs::path& results) {
  return read_json(file_text(results / "summary.json"));
}

/// Differences that a script finds between two folders of results; empty: nothing but measured times.
std::string differences(const fs::path& first_folder, const fs::path& two) {
  const TemporaryFolder prescribed;
  const std::string command = "/usr/bin/python3 " OVERBEND_SOURCE_DIR "/tests/app/same_results.py " +
                              first_folder.string() + " " + two.string() + " > " + (prescribed / "out").string() +
                              " 2>&1";
  return std::system(command.c_str()) == 0 ? "" : "different: " + file_text(prescribed / "out");
}

TEST(dynamic_command, prints_the_findings_of_the_run_and_of_its_statics) {
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, with(kSmallLay, "yield_stress: 414 MPa", "yield_stress: 60 MPa"));
  ASSERT_EQ(run.code, 0) << run.err;
  const Json summary = load_summary(folder / "out");
  ASSERT_FALSE(summary.at("warnings").empty());
  for (const Json& findings : {summary.at("findings"), summary.at("dynamic").at("findings")}) {
    for (const Json& finding : findings) {
      const std::string line = finding["severity"].get<std::string>() + ": " + finding["message"].get<std::string>() +
                               " [" + finding["code"].get<std::string>() + "]\n";
      EXPECT_NE(run.out.find(line), std::string::npos) << line;
    }
  }
}

TEST(dynamic_command, rejects_a_run_in_which_nothing_moves) {
  const std::string at_rest = with(with(kSmallLay, kWaves, "waves: {type: none}"), kMoving, "motion: fixed");
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, at_rest, "--duration '0.5 s'");
  EXPECT_EQ(run.code, 2) << run.err;
  EXPECT_NE(run.err.find("nothing moves in the dynamic analysis"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("add waves"), std::string::npos) << run.err;
}

/// A tensioner on its brake, whose tension swings with the barge.
const std::string kLockedLay = with(kSmallLay, "tension: 300 kN", "tension: 300 kN, mode: locked");

TEST(dynamic_command, a_tensioner_without_mode_keeps_its_tension_and_a_finding_says_so) {
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, kSmallLay);
  ASSERT_EQ(run.code, 0) << run.err;
  const Json tension = load_summary(folder / "out").at("dynamic").at("top_tension");
  EXPECT_NEAR(tension.at("min"), 300e3, 300.0);
  EXPECT_NEAR(tension.at("max"), 300e3, 300.0);
  EXPECT_NE(run.out.find("[tensioner-mode-assumed]"), std::string::npos) << run.out;
}

TEST(dynamic_command, writes_all_files_and_prints_the_key_results) {
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, kLockedLay);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.find("is already finished"), std::string::npos) << run.err;  // that is said of an earlier run
  for (const char* file : {"summary.json", "pipe.csv", "supports.csv", "impacts.csv", "results.h5", "report.html"}) {
    EXPECT_TRUE(fs::is_regular_file(folder / "out" / file)) << file;
  }
  EXPECT_FALSE(fs::exists(folder / "out/.run"));
  for (const char* said : {"small lay", "top tension", "overbend von Mises", "sagbend von Mises",
                           "stinger tip clearance", "impacts", "energy drift", "time loop", "/out"}) {
    EXPECT_NE(run.out.find(said), std::string::npos) << said << "\n" << run.out;
  }
  const Json dynamic = load_summary(folder / "out").at("dynamic");
  EXPECT_DOUBLE_EQ(dynamic.at("duration"), 10.0);
  EXPECT_EQ(dynamic.at("seed"), 3);
  const double min_value = dynamic.at("top_tension").at("min"), max_value = dynamic.at("top_tension").at("max");
  EXPECT_LT(min_value, 290e3);  // a locked brake on a heaving barge: the tension swings about what statics has
  EXPECT_GT(max_value, 310e3);
  EXPECT_LT(std::abs(dynamic.at("energy_drift").get<double>()), 0.01);
}

TEST(dynamic_command, strict_ends_with_4_when_a_check_is_exceeded_in_time) {
  const TemporaryFolder folder;
  const std::string weak = kLockedLay + "checks: {limits: {tension: 310 kN}}\n";  // 300 kN at rest
  const ProgramRun run = run_dynamic_model(folder, weak, "--strict");
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_NE(run.err.find("Tension at the tensioner"), std::string::npos) << run.err;
  const Json checks = load_summary(folder / "out").at("dynamic").at("checks");
  EXPECT_EQ(checks.at("worst").at("id"), "tensioner_load");
  EXPECT_GT(checks.at("worst").at("utilisation").get<double>(), 1.0);
  EXPECT_TRUE(fs::is_regular_file(folder / "out/checks.csv"));
}

TEST(dynamic_command, the_report_made_again_has_the_same_checks) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_dynamic_model(folder, kSmallLay).code, 0);
  const auto section = [&] {
    const Json body = document_in(file_text(folder / "out/report.html"))["body"];
    const auto checks = std::ranges::find_if(body, [](const Json& item) { return item["id"] == "checks"; });
    return checks == body.end() ? std::string() : shown_text((*checks)["body"]);
  };
  const std::string first = section();
  ASSERT_FALSE(first.empty());
  ASSERT_EQ(run_program("report " + (folder / "out").string()).code, 0);
  EXPECT_EQ(section(), first);
}

TEST(dynamic_command, takes_the_duration_from_the_command_line) {
  const TemporaryFolder folder;
  const std::string model = with(kSmallLay, "  dynamic: {duration: 10 s, build_up: 5 s, output_step: 0.5 s}\n", "");
  const ProgramRun run = run_dynamic_model(folder, model, "--duration '0.05 min'");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(load_summary(folder / "out").at("dynamic").at("duration"), 3.0, 1e-9);
}

// A run long enough to be met at work, with a checkpoint after each of its rows.
const std::string kLongLay = with(kSmallLay, "duration: 10 s, build_up: 5 s, output_step: 0.5 s",
                                  "duration: 50 s, build_up: 5 s, output_step: 0.1 s");

TEST(dynamic_command, killed_at_any_moment_and_resumed_gives_the_same_bits) {
  const TemporaryFolder whole, killed;
  ASSERT_EQ(run_dynamic_model(whole, kLongLay).code, 0);
  testing::write_file(killed / "lay.yaml", kLongLay);
  std::mt19937 random(1);
  for (const double from : {-5.0, 10.0, 25.0}) {
    const double moment = std::uniform_real_distribution<double>(from, from + 14.0)(random);
    ChildProgram program(killed.path(), {"dynamic", "lay.yaml", "-o", "out", "--checkpoint", "0", "--resume"});
    ASSERT_TRUE(program.signal_after(killed / "out", moment, SIGKILL)) << "it ended before " << moment << " s";
    EXPECT_EQ(program.end(), -SIGKILL);
    EXPECT_FALSE(fs::exists(killed / "out/summary.json"));
  }
  const ProgramRun resumed = run_dynamic_model(killed, kLongLay, "--resume");
  EXPECT_EQ(resumed.code, 0);
  EXPECT_NE(resumed.err.find("Continuing from t = "), std::string::npos) << resumed.err;
  EXPECT_EQ(differences(whole / "out", killed / "out"), "");
}

TEST(dynamic_command, interrupted_leaves_a_checkpoint_that_serves_the_same_model_alone) {
  const TemporaryFolder whole, stopped;
  ASSERT_EQ(run_dynamic_model(whole, kLongLay).code, 0);
  testing::write_file(stopped / "lay.yaml", kLongLay);
  ChildProgram program(stopped.path(), {"dynamic", "lay.yaml", "-o", "out", "--checkpoint", "0"});
  ASSERT_TRUE(program.signal_after(stopped / "out", 5.0, SIGINT));
  EXPECT_EQ(program.end(), 130);
  EXPECT_TRUE(fs::exists(stopped / "out/.run/checkpoint"));
  EXPECT_FALSE(fs::exists(stopped / "out/summary.json"));

  for (const std::string& second : {with(kLongLay, "tension: 300 kN", "tension: 301 kN"),
                                    with(kLongLay, "components: 20, seed: 3", "components: 20, seed: 4")}) {
    const ProgramRun rejected = run_dynamic_model(stopped, second, "--resume");
    EXPECT_EQ(rejected.code, 2);
    EXPECT_NE(rejected.err.find("the model file has changed"), std::string::npos) << rejected.err;
  }
  const ProgramRun longer = run_dynamic_model(stopped, kLongLay, "--resume --duration '60 s'");
  EXPECT_EQ(longer.code, 2) << longer.err;

  EXPECT_EQ(run_dynamic_model(stopped, kLongLay, "--resume").code, 0);
  EXPECT_EQ(differences(whole / "out", stopped / "out"), "");
}

TEST(dynamic_command, a_run_of_months_begins_at_once_and_hears_a_signal) {
  const TemporaryFolder folder;
  // To add up a sea of so many waves over its whole duration would take a minute.
  testing::write_file(folder / "lay.yaml", with(kSmallLay, "components: 20", "components: 200"));
  const auto start = std::chrono::steady_clock::now();
  ChildProgram program(folder.path(), {"dynamic", "lay.yaml", "-o", "out", "--duration", "1e7 s", "--checkpoint", "0"});
  ASSERT_TRUE(program.signal_after(folder / "out", -4.0, SIGTERM));
  EXPECT_EQ(program.end(), 130);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(dynamic_command, a_signal_is_heard_within_a_row_of_output_that_takes_long) {
  const TemporaryFolder folder;
  testing::write_file(folder / "lay.yaml", with(kSmallLay, "output_step: 0.5 s", "output_step: 1e6 s"));
  ChildProgram program(folder.path(), {"dynamic", "lay.yaml", "-o", "out", "--duration", "1e7 s"});
  while (!fs::exists(folder / "out/.run/lock")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // on its way
  program.send(SIGINT);
  EXPECT_EQ(program.end(), 130);
  EXPECT_FALSE(fs::exists(folder / "out"));  // there was nothing to keep
}

/// A run of kLongLay in FOLDER/out, interrupted; its sea is from a file in FOLDER.
const std::string kFileLay = with(kLongLay, kWaves, "waves: {type: user, spectrum_file: sea.csv, components: 20}");

void interrupt_a_run(const TemporaryFolder& folder) {
  testing::write_file(folder / "sea.csv", "omega_rad_s,density_m2s\n0.5,0\n0.9,0.3\n1.5,0\n");
  testing::write_file(folder / "lay.yaml", kFileLay);
  ChildProgram program(folder.path(), {"dynamic", "lay.yaml", "-o", "out", "--checkpoint", "0"});
  ASSERT_TRUE(program.signal_after(folder / "out", 5.0, SIGINT));
  ASSERT_EQ(program.end(), 130);
}

TEST(dynamic_command, an_unfinished_run_is_not_dropped_without_a_word) {
  const TemporaryFolder folder;
  interrupt_a_run(folder);
  const std::string before = file_text(folder / "out/.run/checkpoint");
  const ProgramRun rejected = run_dynamic_model(folder, kFileLay);
  EXPECT_EQ(rejected.code, 2);
  for (const char* said : {"unfinished run", "t = ", "--resume", "--restart"}) {
    EXPECT_NE(rejected.err.find(said), std::string::npos) << rejected.err;
  }
  EXPECT_EQ(file_text(folder / "out/.run/checkpoint"), before);
  EXPECT_EQ(run_dynamic_model(folder, kFileLay, "--resume --restart").code, 2);
  const ProgramRun anew = run_dynamic_model(folder, kFileLay, "--restart --duration '2 s'");
  EXPECT_EQ(anew.code, 0) << anew.err;
  EXPECT_NEAR(load_summary(folder / "out").at("dynamic").at("duration"), 2.0, 1e-9);
  EXPECT_EQ(run_dynamic_model(folder, kFileLay, "--duration '2 s'").code, 0);  // a finished one is replaced
}

TEST(dynamic_command, resumes_however_the_path_of_the_model_is_written) {
  const TemporaryFolder folder;
  interrupt_a_run(folder);
  testing::write_file(folder / "sea.csv", "omega_rad_s,density_m2s\n0.5,0\n0.9,0.4\n1.5,0\n");
  const std::string absolute = (folder / "lay.yaml").string(), out = (folder / "out").string();
  const ProgramRun second_program_run = run_program("dynamic " + absolute + " -o " + out + " --resume");
  EXPECT_EQ(second_program_run.code, 2) << "another sea";
  testing::write_file(folder / "sea.csv", "omega_rad_s,density_m2s\n0.5,0\n0.9,0.3\n1.5,0\n");
  const ProgramRun resumed = run_program("dynamic " + absolute + " -o " + out + " --resume");  // begun as lay.yaml
  EXPECT_EQ(resumed.code, 0) << resumed.err;
}

TEST(dynamic_command, damaged_data_of_a_run_are_rejected) {
  const TemporaryFolder folder;
  interrupt_a_run(folder);
  std::fstream rows(folder / "out/.run/rows", std::ios::binary | std::ios::in | std::ios::out);
  rows.seekp(100);
  rows.put('\x55');
  rows.close();
  const ProgramRun rejected = run_dynamic_model(folder, kFileLay, "--resume");
  EXPECT_EQ(rejected.code, 2);
  EXPECT_NE(rejected.err.find("rows' is damaged"), std::string::npos) << rejected.err;
}

TEST(dynamic_command, results_of_one_run_stand_alone_in_their_folder) {
  const TemporaryFolder folder;
  const std::string seeds = with(kSmallLay, "duration: 10 s", "seeds: [1, 9], duration: 2 s");
  ASSERT_EQ(run_dynamic_model(folder, seeds).code, 0);
  ASSERT_EQ(run_dynamic_model(folder, with(seeds, "[1, 9]", "[1, 2]")).code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/seed-1/summary.json"));
  EXPECT_FALSE(fs::exists(folder / "out/seed-9"));
  ASSERT_EQ(run_dynamic_model(folder, kSmallLay, "--duration '2 s'").code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/seeds.csv"));
  EXPECT_FALSE(fs::exists(folder / "out/seed-1"));
  EXPECT_TRUE(fs::exists(folder / "out/impacts.csv"));
  ASSERT_EQ(run_program("static " + (folder / "lay.yaml").string() + " -o " + (folder / "out").string()).code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/impacts.csv"));
  EXPECT_FALSE(load_summary(folder / "out").contains("dynamic"));
}

TEST(dynamic_command, with_all_streams_closed_no_text_lands_in_results) {
  const TemporaryFolder open, closed;
  ASSERT_EQ(run_dynamic_model(open, kSmallLay).code, 0);
  testing::write_file(closed / "lay.yaml", kSmallLay);
  const std::string command = testing::program_path() + " dynamic " + (closed / "lay.yaml").string() + " -o " +
                              (closed / "out").string() + " <&- >&- 2>&-";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(differences(open / "out", closed / "out"), "");
}

TEST(dynamic_command, resumed_after_its_end_says_that_it_is_finished_and_runs_nothing) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_dynamic_model(folder, kSmallLay).code, 0);
  const fs::file_time_type written = fs::last_write_time(folder / "out/summary.json");
  const ProgramRun again = run_dynamic_model(folder, kSmallLay, "--resume");
  EXPECT_EQ(again.code, 0);
  EXPECT_NE(again.err.find("is already finished (10 s)."), std::string::npos) << again.err;
  EXPECT_NE(again.out.find("top tension"), std::string::npos) << again.out;
  EXPECT_EQ(fs::last_write_time(folder / "out/summary.json"), written);
  const ProgramRun second_program_run =
      run_dynamic_model(folder, with(kSmallLay, "tension: 300 kN", "tension: 301 kN"), "--resume");
  EXPECT_EQ(second_program_run.code, 2);
  EXPECT_NE(second_program_run.err.find("holds results of another model file"), std::string::npos)
      << second_program_run.err;
  EXPECT_EQ(run_dynamic_model(folder, kSmallLay).code, 0);  // without --resume it runs anew
  EXPECT_NE(fs::last_write_time(folder / "out/summary.json"), written);
}

struct BadUnit {
  const char* what;
  std::string model;
  std::string more;
  std::string said;
};

TEST(dynamic_command, rejects_what_it_can_not_run_in_one_clear_line_and_writes_nothing) {
  const std::string dynamic = "  dynamic: {duration: 10 s, build_up: 5 s, output_step: 0.5 s}\n";
  const std::string duration = "duration: 10 s, build_up";
  const std::vector<BadUnit> rejections = {
      {"no dynamics", with(kSmallLay, dynamic, ""), "", "lay.yaml:22: analysis.dynamic: "},
      {"coupled", with(kSmallLay, kMoving, "motion: {coupled: barge.1}"), "", "coupled"},
      {"no RAO file", with(kSmallLay, kMoving, "motion: {raos: nowhere.csv}"), "", "nowhere.csv could not be read"},
      {"no record", with(kSmallLay, kMoving, "motion: {history: nowhere.csv}"), "", "nowhere.csv could not be read"},
      {"range", with(kSmallLay, "tension: 300 kN", "tension: 300 kN, range: [310 kN, 320 kN], velocity: 0.2 m/s"), "",
       "lay.yaml:13: tensioner.range: "},
      {"short record", with(kSmallLay, kMoving, "motion: {history: motion.csv}"), "", "to 9 s"},
      {"spectrum", with(kSmallLay, kWaves, "waves: {type: user, spectrum_file: nowhere.csv}"), "",
       "lay.yaml:6: environment.waves.spectrum_file: "},
      {"seed twice", with(kSmallLay, duration, "seeds: [4, 5, 4], " + duration), "", "4 is given twice"},
      {"no unit", kSmallLay, "--duration 600", "--duration"},
      {"no time", kSmallLay, "--duration '6 m'", "--duration"},
      {"backwards", kSmallLay, "--duration=-6s", "--duration"},
      {"nothing", kSmallLay, "--duration '0 s'", "--duration"}};
  for (const BadUnit& rejection : rejections) {
    SCOPED_TRACE(rejection.what);
    const TemporaryFolder folder;
    testing::write_file(folder / "motion.csv", "time_s,heave_m\n-10,0\n0,0.1\n9,0\n");
    const ProgramRun run = run_dynamic_model(folder, rejection.model, rejection.more);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(rejection.said), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
}

TEST(dynamic_command, follows_a_record_that_covers_the_run) {
  const TemporaryFolder folder;
  testing::write_file(folder / "motion.csv", "time_s,heave_m\n0,0\n5,0.1\n10,0\n");
  const ProgramRun run = run_dynamic_model(folder, with(kSmallLay, kMoving, "motion: {history: motion.csv}"));
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(dynamic_command, ends_with_3_when_statics_has_no_solution) {
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, with(kSmallLay, "tension: 300 kN", "tension: 3 kN"));
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err.rfind("overbend: no solution: ", 0), 0U) << run.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(dynamic_command, keeps_a_fixed_step) {
  const TemporaryFolder folder;
  const ProgramRun run = run_dynamic_model(folder, with(kSmallLay, "build_up: 5 s", "step: 0.05 s, build_up: 5 s"));
  ASSERT_EQ(run.code, 0) << run.err;
  const Json dynamic = load_summary(folder / "out").at("dynamic");
  EXPECT_NEAR(dynamic.at("smallest_step"), 0.05, 1e-6);
  EXPECT_NEAR(dynamic.at("largest_step"), 0.05, 1e-6);
  EXPECT_EQ(dynamic.at("steps"), 300);  // of 15 s
}

TEST(dynamic_command, in_calm_water_on_a_barge_that_hardly_moves_nothing_happens) {
  const TemporaryFolder folder;
  const std::string model =
      with(with(kLockedLay, kMoving, "motion: {harmonic: {heave: {amplitude: 1e-9 m, period: 8 s}}}"), kWaves,
           "waves: {type: none}");
  ASSERT_EQ(run_dynamic_model(folder, model).code, 0);
  const Json summary = load_summary(folder / "out");
  const Json statics = summary.at("static"), dynamic = summary.at("dynamic");
  const double tension = statics.at("top_tension");
  for (const char* quantity : {"top_tension", "bottom_tension", "lay_back", "departure_angle"}) {
    const Json& spread = dynamic.at(quantity);
    const double mean = spread.at("mean");
    // Statics balances forces to 1e-9 of the line's weight; a line that hangs free feels that 100 times over at most.
    EXPECT_NEAR(spread.at("min"), mean, 1e-6 * std::abs(mean)) << quantity;
    EXPECT_NEAR(spread.at("max"), mean, 1e-6 * std::abs(mean)) << quantity;
  }
  // Statics and dynamics read the tension from the same state in two ways, which differ by the coarseness of the mesh.
  EXPECT_NEAR(dynamic.at("top_tension").at("mean"), tension, 1e-4 * tension);
  EXPECT_EQ(dynamic.at("impact_count"), 0);
  for (std::size_t i = 0; i < statics.at("supports").size(); ++i) {
    const double reaction = statics.at("supports").at(i).at("reaction");
    EXPECT_NEAR(dynamic.at("supports").at(i).at("reaction").at("max"), reaction, 1e-3 * tension);
  }
}

TEST(dynamic_command, runs_a_j_lay_without_supports) {
  const TemporaryFolder folder;
  std::string model = kSmallLay.substr(0, kSmallLay.find("rollers:")) + kSmallLay.substr(kSmallLay.find("analysis:"));
  model = with(model, "{x: -40 m, z: 1.6 m, tension: 300 kN}", "{x: 0 m, z: 10 m, guide: pinned, tension: 120 kN}");
  const ProgramRun run = run_dynamic_model(folder, model);
  ASSERT_EQ(run.code, 0) << run.err;
  const Json dynamic = load_summary(folder / "out").at("dynamic");
  EXPECT_TRUE(dynamic.at("overbend").is_null());
  EXPECT_TRUE(dynamic.at("stinger_tip_clearance").is_null());
  EXPECT_TRUE(dynamic.at("supports").empty());
  EXPECT_GT(dynamic.at("sagbend").at("max_von_mises").at("max"), dynamic.at("sagbend").at("max_von_mises").at("min"));
  EXPECT_EQ(run.out.find("impacts"), std::string::npos);
}

}  // namespace
}  // namespace overbend

#include "resultfiles/moored/mooring_tables.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/json.h"
#include "resultfiles/moored/moored_dynamics_hdf5.h"
#include "resultfiles/moored/move_table.h"
#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

MooringResults two_states() {
  MooringResults results;
  MooringLineResult line;
  line.name = "bow, port";
  line.length = 1000.0;
  line.first_segment_length = 750.0;
  line.fairlead_tension = 3e5;
  line.on_bed = 120.0;
  line.utilisation = 0.125;
  results.rest.name = "static";
  results.rest.vessel.surge = 1.5;
  results.rest.vessel.natural_periods = {{"surge", 67.0}};
  results.rest.vessel.stiffness.assign(36, 2.0);
  results.rest.mooring_force.assign(6, 3.0);
  results.rest.mooring_stiffness.assign(36, 4.0);
  results.rest.moorings = {line};
  results.operation = "pull_ahead";
  results.stages = {results.rest};
  results.stages[0].name = "pulled ahead";
  results.distance = 12.0;
  results.winches = {{"bow, port", 750.0, 739.0, 3e5, 3.1e5}};
  return results;
}

StaticResults hull_alone(MooringResults moorings) {
  StaticResults results;
  results.title = "barge";
  results.version = "1";
  results.moorings = std::move(moorings);
  return results;
}

TEST(mooring_files, the_summary_reports_where_hull_and_lines_are) {
  const Json summary = static_summary_json(hull_alone(two_states()));
  const Json& rest = summary["static"];
  EXPECT_EQ(rest["vessel"]["surge"], 1.5);
  EXPECT_EQ(rest["vessel"]["natural_periods"][0]["mode"], "surge");
  EXPECT_EQ(rest["vessel"]["natural_periods"][0]["period"], 67.0);
  EXPECT_EQ(rest["vessel"]["stiffness"][5][5], 2.0);
  EXPECT_EQ(rest["mooring_stiffness"].size(), 6);
  EXPECT_EQ(rest["moorings"][0]["name"], "bow, port");
  EXPECT_EQ(rest["moorings"][0]["fairlead_tension"], 3e5);
  EXPECT_EQ(rest["moorings"][0]["length_on_bed"], 120.0);
  EXPECT_EQ(rest["moorings"][0]["utilisation"], 0.125);
  EXPECT_TRUE(rest["moorings"][0]["clearance"].is_null());
}

TEST(mooring_files, the_summary_reports_what_the_winches_do) {
  const Json operation = static_summary_json(hull_alone(two_states()))["operation"];
  EXPECT_EQ(operation["type"], "pull_ahead");
  EXPECT_EQ(operation["stages"][0]["name"], "pulled ahead");
  EXPECT_EQ(operation["stages"][0]["winch_lengths"]["bow, port"], 750.0);
  EXPECT_EQ(operation["pull_ahead"]["lines"][0]["winch"], -11.0);
}

TEST(mooring_files, the_table_has_a_row_per_state_and_line) {
  const std::string table = moorings_table(two_states());
  EXPECT_NE(table.find("state,line,length [m]"), std::string::npos) << table;
  EXPECT_NE(table.find("static,\"bow, port\",1000,750,300"), std::string::npos) << table;
  EXPECT_NE(table.find("pulled ahead,\"bow, port\""), std::string::npos);
}

TEST(mooring_files, rejects_what_is_no_number) {
  MooringResults results = two_states();
  results.rest.moorings[0].horizontal = std::numeric_limits<double>::quiet_NaN();
  try {
    write_static_files(hull_alone(results), {}, "/nowhere");
    FAIL() << "a number that is none was written";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("static.moorings.bow, port.horizontal"), std::string::npos)
        << error.what();
  }
}

HullResults hull() {
  HullResults hull;
  hull.entries = {{"surge", "pitch", 3.25, 1e6, 1.01e6, 0.004, 0.0075}};
  hull.groups = {{"surge, pitch", "state space", 12, -1e-6, 0.02, 0.0}};
  hull.states = 88;
  hull.damping = {{"sway", 77.1, 4.54e6, 0.0002, 0.032, 0.06, 0.0, 0.0, 0.0922, 0.0001}};
  hull.drift = {-45.4e3, 217.8e3, 1.2e6};
  hull.current = {1e3, 265.3e3, 0.0};
  hull.min_current_force = 146e3;
  hull.max_current_force = 398e3;
  return hull;
}

TEST(mooring_files, results_h5_gives_back_what_was_written) {
  const testing::TemporaryFolder folder;
  StaticResults statics = hull_alone(two_states());
  statics.hull = hull();
  statics.findings = {{FindingCode::unknown, "look at this"}};
  MooringResults& results = *statics.moorings;
  results.rest.moorings[0].clearance = 12.5;
  results.rest.moorings[0].nearest_object = "pipeline";
  results.rest.moorings[0].shape_W = {Vec3(57.0, 15.0, 3.0), Vec3(500.0, 200.0, -80.0), Vec3(963.0, 438.0, -89.0)};
  results.stages[0].mooring_stiffness.clear();  // of a hull that is held
  MoveStep step;
  step.advance = 6.0;
  step.vessel.surge = 6.01;
  step.lengths = {744.0};
  step.tensions = {3.05e5};
  step.pipe.emplace();
  step.pipe->max_reaction_support = "stinger 3";
  results.steps = {step, step};
  results.anchors = {{17, "bow, port", "its length", Vec3(1.0, 2.0, -89.0), Vec3(3.0, 4.0, -89.0), 980.0}};
  Description description;
  description.source_text = "title: barge\n";
  write_static_files(statics, description, folder.path());
  const StoredStatics read = read_static_results(folder.path() / "results.h5");
  const MooringResults& stored = read.results.moorings.value();
  EXPECT_EQ(read.model_text, "title: barge\n");
  EXPECT_FALSE(read.results.has_pipe());
  EXPECT_EQ(static_summary(read.results), static_summary(statics));
  EXPECT_EQ(moorings_table(stored), moorings_table(results));
  EXPECT_EQ(stored.rest.moorings[0].shape_W, results.rest.moorings[0].shape_W);
  EXPECT_TRUE(stored.stages[0].mooring_stiffness.empty());
  EXPECT_EQ(move_table(stored), move_table(results));
  EXPECT_EQ(stored.steps[1].pipe.value().max_reaction_support, "stinger 3");
  EXPECT_EQ(stored.anchors.at(0).joint, 17);
  EXPECT_EQ(stored.anchors[0].to_W, results.anchors[0].to_W);
  EXPECT_EQ(stored.stages[0].mooring_force, results.stages[0].mooring_force);
}

TEST(mooring_files, the_summary_reports_what_damps_the_hull) {
  StaticResults results = hull_alone(two_states());
  results.hull = hull();
  const Json prescribed = static_summary_json(results)["static"]["hull"];
  EXPECT_EQ(prescribed["damping"][0]["mode"], "sway");
  EXPECT_EQ(prescribed["damping"][0]["drift"], 0.032);
  EXPECT_EQ(prescribed["radiation"][0]["added_mass_error"], 0.0075);
  EXPECT_EQ(prescribed["fit"][0]["order"], 12);
  EXPECT_EQ(prescribed["drift"]["sway"], 217.8e3);
  EXPECT_EQ(prescribed["current_range"]["most"], 398e3);
}

TEST(mooring_files, the_table_of_a_dynamic_analysis_has_its_tensions_in_addition_to_the_rest) {
  MooringLineDynamics line;
  line.name = "bow, port";
  line.fairlead_tension.whole = {2e5, 5e5, 3.1e5, 4e4};
  line.fairlead_tension.most_probable_max = 6e5;
  const std::string table = moorings_table(two_states(), {line});
  EXPECT_NE(table.find("most probable largest fairlead tension [kN]"), std::string::npos) << table;
  EXPECT_NE(table.find(",310,40,200,500,600,"), std::string::npos) << table;
  EXPECT_NE(table.find("pulled ahead"), std::string::npos);
}

TEST(mooring_files, moored_dynamics_come_back_from_results_h5) {
  const testing::TemporaryFolder folder;
  DynamicResults results;
  results.vessel.emplace();
  results.vessel->sway.whole = {-1.0, 2.0, 0.5, 0.75};
  results.vessel->sway.slow.std = 0.6;
  results.vessel->covariance = -0.125;
  results.vessel->confidence = "few cycles";
  results.thrust = {{"surge", {-1e5, 3e5, 2e5, 4e4}, 5e5, 3e5, 12.5}, {"sway", {}, 1e5, std::nullopt, 0.0}};
  MooringLineDynamics line;
  line.name = "bow, port";
  line.fairlead_tension.most_probable_max = 6e5;
  line.utilisation = 0.25;
  line.points = {0.0, 0.5, 1.0};
  line.events = {{12.5, "parted"}};
  line.parted_at = 12.5;
  MooringLineDynamics second_mooring_line_dynamics;
  second_mooring_line_dynamics.name = "stern";
  second_mooring_line_dynamics.points = {0.0, 1.0};
  results.moorings = {line, second_mooring_line_dynamics};
  {
    Hdf5Writer file(folder.path() / "results.h5");
    file.group("/dynamic", "A run");
    write_moored_dynamics(file, results);
    file.close();
  }
  DynamicResults read;
  read_moored_dynamics(Hdf5Reader(folder.path() / "results.h5"), read);
  Json wanted, found;
  add_moored_dynamics(results, wanted);
  add_moored_dynamics(read, found);
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(read.moorings[0].points, line.points);
  EXPECT_EQ(read.moorings[1].points, second_mooring_line_dynamics.points);
  EXPECT_FALSE(read.moorings[1].parted_at);
  EXPECT_EQ(wanted["dynamic"]["vessel"]["sway"]["slow"]["std"], 0.6);
  EXPECT_EQ(wanted["dynamic"]["thrust"][0]["given"]["max"], 3e5);
  EXPECT_EQ(wanted["dynamic"]["thrust"][0]["time_at_limit"], 12.5);
  EXPECT_EQ(wanted["dynamic"]["thrust"][1]["thrust_limit"], nullptr);
  EXPECT_EQ(wanted["dynamic"]["moorings"][0]["fairlead_tension"]["most_probable_max"], 6e5);
  EXPECT_EQ(wanted["dynamic"]["moorings"][0]["events"][0]["what"], "parted");
}

}  // namespace
}  // namespace overbend

#include "resultfiles/mooring_writer.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace overbend {
namespace {

MooringResults two_states() {
  MooringResults results;
  results.title = "barge";
  results.version = "1";
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

TEST(mooring_writer, the_summary_tells_where_hull_and_lines_are) {
  const nlohmann::json summary = nlohmann::json::parse(mooring_summary(two_states()));
  const nlohmann::json& rest = summary["static"];
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

TEST(mooring_writer, the_summary_tells_what_the_winches_do) {
  const nlohmann::json operation = nlohmann::json::parse(mooring_summary(two_states()))["operation"];
  EXPECT_EQ(operation["type"], "pull_ahead");
  EXPECT_EQ(operation["stages"][0]["name"], "pulled ahead");
  EXPECT_EQ(operation["stages"][0]["winch_lengths"]["bow, port"], 750.0);
  EXPECT_EQ(operation["pull_ahead"]["lines"][0]["winch"], -11.0);
}

TEST(mooring_writer, the_table_has_a_row_per_state_and_line) {
  const std::string table = moorings_table(two_states());
  EXPECT_NE(table.find("state,line,length [m]"), std::string::npos) << table;
  EXPECT_NE(table.find("static,\"bow, port\",1000,750,300"), std::string::npos) << table;
  EXPECT_NE(table.find("pulled ahead,\"bow, port\""), std::string::npos);
}

TEST(mooring_writer, refuses_what_is_no_number) {
  MooringResults results = two_states();
  results.rest.moorings[0].horizontal = std::numeric_limits<double>::quiet_NaN();
  try {
    write_mooring_files(results, {}, "/nowhere");
    FAIL() << "a number that is none was written";
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("static.moorings.bow, port.horizontal"), std::string::npos)
        << fault.what();
  }
}

}  // namespace
}  // namespace overbend

#include <gtest/gtest.h>

#include <set>

#include "base/json.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::filled_dynamics;
using testing::solved_case;

Json make_results_summary(const std::string& name) {
  const StaticResults& statics = solved_case(name).results;
  return read_json(dynamic_summary(statics, filled_dynamics(statics)));
}

void expect_numbers(const Json& json, const std::set<std::string>& keys, const std::string& place) {
  for (const std::string& key : keys) EXPECT_TRUE(json.contains(key) && json[key].is_number()) << place << "." << key;
}

void expect_spreads(const Json& json, const std::set<std::string>& keys, const std::string& place) {
  for (const std::string& key : keys) {
    ASSERT_TRUE(json.contains(key)) << place << "." << key;
    expect_numbers(json[key], {"min", "max", "mean", "std"}, std::string(place).append(".").append(key));
  }
}

void expect_region(const Json& region) {
  const std::set<std::string> keys = {"max_bending_moment", "max_bending_stress", "max_von_mises", "max_strain"};
  expect_spreads(region, keys, "region");
  for (const std::string& key : keys) {
    expect_numbers(region[key], {"time"}, key);
    expect_numbers(region[key]["at"], {"s", "x", "y", "z"}, key);
  }
}

void expect_common_keys(const Json& dynamic) {
  expect_spreads(dynamic, {"top_tension", "bottom_tension", "lay_back", "departure_angle"}, "dynamic");
  expect_region(dynamic["sagbend"]);
  expect_numbers(dynamic["tensioner"],
                 {"min_tension", "max_tension", "travel_min", "travel_max", "time_out_of_range", "time_at_limit",
                  "pay_out_count", "haul_in_count"},
                 "tensioner");
  expect_numbers(
      dynamic,
      {"energy_drift", "steps", "newton_iterations", "real_time_ratio", "duration", "build_up", "seed", "impact_count"},
      "dynamic");
  ASSERT_EQ(dynamic["extremes"].size(), 2U);
  expect_numbers(dynamic["extremes"][0]["weibull"], {"estimate", "low", "high"}, "weibull");
}

TEST(dynamic_summary, has_every_key_of_the_contract_in_s_lay) {
  const Json dynamic = make_results_summary("BGL1-T250")["dynamic"];
  expect_common_keys(dynamic);
  expect_spreads(dynamic, {"stinger_tip_clearance"}, "dynamic");
  expect_region(dynamic["overbend"]);
  ASSERT_EQ(dynamic["supports"].size(), 13U);
  ASSERT_EQ(dynamic["impacts"].size(), 13U);
  for (const Json& support : dynamic["supports"]) {
    expect_spreads(support, {"reaction", "vertical", "longitudinal", "lateral", "separation"}, "support");
    expect_numbers(support, {"contact_share", "impacts"}, "support");
    expect_numbers(support["reaction_percentiles"], {"p50", "p90", "p99"}, "support");
    ASSERT_EQ(support["rows"].size(), 1U);
    expect_spreads(support["rows"][0]["bottom"], {"reaction", "separation"}, "bottom");
  }
  for (const Json& impacts : dynamic["impacts"]) {
    EXPECT_TRUE(impacts["name"].is_string());
    expect_numbers(impacts, {"count", "largest_approach_velocity", "largest_impact_force", "dent_depth"}, "impacts");
  }
}

TEST(dynamic_summary, leaves_null_what_has_no_sense_in_j_lay) {
  const Json dynamic = make_results_summary("J12-D400-T560")["dynamic"];
  expect_common_keys(dynamic);
  EXPECT_TRUE(dynamic["stinger_tip_clearance"].is_null());
  EXPECT_TRUE(dynamic["overbend"].is_null());
  EXPECT_TRUE(dynamic["supports"].empty());
  EXPECT_TRUE(dynamic["impacts"].empty());
}

TEST(dynamic_summary, keeps_what_statics_writes) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  Json summary = dynamic_summary_json(statics, filled_dynamics(statics));
  summary.erase("dynamic");
  EXPECT_EQ(summary, static_summary_json(statics));
}

TEST(dynamic_summary, keeps_rollers_in_their_rows_and_takes_the_largest_of_a_support) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  DynamicResults results = filled_dynamics(statics);
  std::vector<RollerDynamics>& rollers = results.supports[2].rollers;
  rollers = {{}, {}, {}};
  rollers[1].row = rollers[2].row = 1;
  rollers[2].position = RollerPosition::port;
  rollers[1].max_impact_force = 5e5;
  rollers[2].max_impact_force = 4e5;
  rollers[2].reaction.max = 3.5;
  const Json dynamic = read_json(dynamic_summary(statics, results))["dynamic"];
  EXPECT_EQ(dynamic["impacts"][2]["largest_impact_force"], 5e5);
  ASSERT_EQ(dynamic["supports"][2]["rows"].size(), 2U);
  EXPECT_EQ(dynamic["supports"][2]["rows"][1]["port"]["reaction"]["max"], 3.5);
  EXPECT_EQ(dynamic["supports"][2]["rows"][0].size(), 1U);
}

TEST(dynamic_summary, gives_numbers_as_they_are) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  const DynamicResults results = filled_dynamics(statics);
  const Json dynamic = read_json(dynamic_summary(statics, results))["dynamic"];
  EXPECT_EQ(dynamic["lay_back"]["std"], results.lay_back.std);
  EXPECT_EQ(dynamic["seed"].get<std::uint64_t>(), results.seed);
  EXPECT_EQ(dynamic["sagbend"]["max_strain"]["at"]["z"], results.sagbend.strain.p_W.z());
  EXPECT_EQ(dynamic["tensioner"]["travel_min"], results.tensioner.travel.min);
  EXPECT_EQ(dynamic["energy_drift"], results.energy.error / results.energy.throughput);
}

}  // namespace
}  // namespace overbend

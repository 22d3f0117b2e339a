#include "resultfiles/summary/summary_json.h"

#include <gtest/gtest.h>

#include <set>

#include "base/json.h"
#include "resultfiles/static/results_writer.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;

Json make_results_summary(const std::string& name) {
  return read_json(static_summary(solved_case(name).results));
}

void expect_keys(const Json& json, const std::set<std::string>& keys, const std::string& place) {
  for (const std::string& key : keys) EXPECT_TRUE(json.contains(key)) << place << "." << key;
}

void expect_numbers(const Json& json, const std::set<std::string>& keys, const std::string& place) {
  expect_keys(json, keys, place);
  for (const std::string& key : keys) EXPECT_TRUE(json.contains(key) && json[key].is_number()) << place << "." << key;
}

void expect_region(const Json& region, const std::string& place) {
  expect_numbers(region, {"max_bending_moment", "max_bending_stress", "max_von_mises", "max_strain"}, place);
  expect_numbers(region["at"], {"s", "x", "y", "z", "astern"}, place + ".at");
}

void expect_common_keys(const Json& json) {
  expect_keys(json, {"title", "version", "assumptions", "assumption_ranks", "warnings", "derived", "static"}, "");
  EXPECT_EQ(json["status"], "converged");
  expect_numbers(json["derived"], {"EA", "EI", "weight_in_air", "weight_submerged", "steel_area"}, "derived");
  const Json& statics = json["static"];
  expect_numbers(statics,
                 {"top_tension", "bottom_tension", "largest_tension", "lay_back", "suspended_length", "departure_angle",
                  "top_to_touchdown", "length_top_to_touchdown", "total_length", "iterations", "wall_time",
                  "roller_stiffness", "largest_penetration", "top_inclination"},
                 "static");
  expect_keys(statics, {"stinger_tip_clearance", "overbend", "largest_reaction", "method", "history"}, "static");
  expect_numbers(statics["touchdown"], {"x", "y", "z", "s"}, "touchdown");
  expect_numbers(statics["anchor"], {"x", "y", "z"}, "anchor");
  expect_numbers(statics["balance"], {"force_residual", "global"}, "balance");
  expect_region(statics["sagbend"], "sagbend");
}

TEST(summary_json, has_every_key_of_the_contract_in_s_lay) {
  const Json json = make_results_summary("BGL1-T250");
  expect_common_keys(json);
  const Json& statics = json["static"];
  EXPECT_TRUE(statics["stinger_tip_clearance"].is_number());
  expect_region(statics["overbend"], "overbend");
  expect_keys(statics["largest_reaction"], {"value", "support"}, "largest_reaction");
  ASSERT_EQ(statics["supports"].size(), 13U);
  for (const Json& support : statics["supports"]) {
    expect_keys(support, {"name", "reaction", "vertical", "longitudinal", "lateral", "separation", "rows"}, "support");
    ASSERT_EQ(support["rows"].size(), 1U);
    expect_numbers(support["rows"][0]["bottom"], {"reaction", "separation"}, "bottom");
  }
}

TEST(summary_json, reports_on_the_laid_pipe_on_an_uneven_bed) {
  StaticResults results = solved_case("S16-T300").results;
  EXPECT_FALSE(read_json(static_summary(results))["static"].contains("seabed"));
  BedResults& bed = results.bed.emplace();
  bed.contacts.resize(2);
  bed.spans.resize(1);
  bed.hogging_moment = 91e3;
  const Json seabed = read_json(static_summary(results))["static"]["seabed"];
  expect_numbers(seabed, {"tail_tension", "max_penetration", "max_penetration_x"}, "static.seabed");
  EXPECT_EQ(seabed["max_hogging_moment"]["value"], 91e3);
  expect_numbers(seabed["max_sagging_moment"], {"value", "x"}, "static.seabed.max_sagging_moment");
  ASSERT_EQ(seabed["contacts"].size(), 2U);
  expect_numbers(seabed["contacts"][0], {"x_from", "x_to"}, "contacts");
  ASSERT_EQ(seabed["free_spans"].size(), 1U);
  expect_numbers(seabed["free_spans"][0],
                 {"x_from", "x_to", "length", "max_gap", "max_gap_x", "max_sagging_moment", "max_sagging_moment_x"},
                 "free_spans");
}

TEST(summary_json, has_nulls_in_j_lay_where_supports_are_asked_for) {
  const Json json = make_results_summary("J12-D400-T560");
  expect_common_keys(json);
  EXPECT_TRUE(json["static"]["stinger_tip_clearance"].is_null());
  EXPECT_TRUE(json["static"]["overbend"].is_null());
  EXPECT_TRUE(json["static"]["largest_reaction"].is_null());
  EXPECT_TRUE(json["static"]["supports"].empty());
}

TEST(summary_json, gives_numbers_back_to_the_last_bit) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  const Json json = make_results_summary("BGL1-T250");
  EXPECT_EQ(json["static"]["lay_back"].get<double>(), results.lay_back);
  EXPECT_EQ(json["static"]["overbend"]["max_bending_moment"].get<double>(), results.overbend->bending_moment.value);
  EXPECT_EQ(json["static"]["overbend"]["at"]["s"].get<double>(), results.overbend->bending_moment.s);
  EXPECT_EQ(json["derived"]["EI"].get<double>(), results.sections.at(0).EI);
}

TEST(summary_json, names_side_rollers_by_their_place) {
  StaticResults results = solved_case("BGL1-T250").results;
  RollerResult port;
  port.position = RollerPosition::port;
  port.reaction = 12.5;
  results.supports.at(2).rows.at(0).rollers.push_back(port);
  const Json json = read_json(static_summary(results));
  EXPECT_EQ(json["static"]["supports"][2]["rows"][0]["port"]["reaction"], 12.5);
}

TEST(summary_json, stays_readable_when_the_title_is_no_utf8) {
  StaticResults results = solved_case("J12-D400-T560").results;
  results.title = "caf\xe9";
  EXPECT_EQ(read_json(static_summary(results))["title"], "caf\xef\xbf\xbd");
}

}  // namespace
}  // namespace overbend

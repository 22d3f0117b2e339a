// A stinger on hinges in the files.
#include <gtest/gtest.h>

#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/stinger_fields.h"
#include "support/result_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::BitsVisitor;
using testing::kListBytes;
using testing::SizeVisitor;
using testing::solved_case;
using testing::TemporaryFolder;

StingerSectionResult section_with_tank(const std::string& name, double angle) {
  StingerSectionResult section;
  section.name = name;
  section.angle = angle;
  section.floats = true;
  section.hinge_force = 112e3;
  section.hinge_vertical = 107e3;
  section.at_stop = true;
  section.tip_W = Vec3(-96.0, 1.0, -9.0);
  StingerTankResult& tank = section.tanks.emplace_back();
  tank.name = "tank of " + name;
  tank.buoyancy = 360e3 + angle;
  return section;
}

std::string result_bits(const std::vector<StingerSectionResult>& stinger) {
  BitsVisitor bits;
  for (const StingerSectionResult& section : stinger) {
    visit_stinger_section(section, bits);
    for (const StingerTankResult& tank : section.tanks) visit_stinger_tank(tank, bits);
  }
  return bits.text;
}

TEST(field_lists, hold_every_member_of_a_stinger) {
  SizeVisitor section, tank;
  visit_stinger_section<const StingerSectionResult>(StingerSectionResult{}, section);
  visit_stinger_tank<const StingerTankResult>(StingerTankResult{}, tank);
  EXPECT_EQ(section.bytes + kListBytes, sizeof(StingerSectionResult));
  EXPECT_EQ(tank.bytes, sizeof(StingerTankResult));
}

TEST(results_reader, gives_back_a_stinger_with_its_tanks) {
  StaticResults results = solved_case("BGL1-T250").results;
  results.stinger = {section_with_tank("first", -0.1), section_with_tank("second", 0.2)};
  results.stinger[0].tanks.push_back({"another", 1.0, 2.0, 3.0, 4.0, 0.5, 6.0});
  const TemporaryFolder folder;
  write_static_hdf5(results, {}, folder / "results.h5");
  const StaticResults stored = read_static_results(folder / "results.h5").results;
  ASSERT_EQ(stored.stinger.size(), 2U);
  ASSERT_EQ(stored.stinger[0].tanks.size(), 2U);
  EXPECT_EQ(result_bits(stored.stinger), result_bits(results.stinger));
}

TEST(summary, reports_a_stinger_of_one_section_as_an_object) {
  StaticResults results = solved_case("BGL1-T250").results;
  EXPECT_FALSE(static_summary_json(results)["static"].contains("stinger"));
  results.stinger = {section_with_tank("", -0.1)};
  results.stinger[0].tip_W = results.stern_shoe_W + results.R_WV * Vec3(-36.0, 0.0, -13.0);
  const Json stinger = static_summary_json(results)["static"]["stinger"];
  EXPECT_EQ(stinger["angle"], -0.1);
  EXPECT_EQ(stinger["hinge_force"]["vertical"], 107e3);
  EXPECT_EQ(stinger["hinge_force"]["magnitude"], 112e3);
  EXPECT_EQ(stinger["at_stop"], true);
  EXPECT_NEAR(stinger["tip_roller"]["x"].get<double>(), 36.0, 1e-9);
  EXPECT_NEAR(stinger["tip_roller"]["z"].get<double>(), -13.0, 1e-9);
  EXPECT_EQ(stinger["tanks"][0]["name"], "tank of ");
  EXPECT_FALSE(stinger.contains("sections"));
}

TEST(summary, lists_the_sections_of_a_stinger_that_has_several) {
  StaticResults results = solved_case("BGL1-T250").results;
  results.stinger = {section_with_tank("first", -0.1), section_with_tank("second", 0.2)};
  const Json stinger = static_summary_json(results)["static"]["stinger"];
  ASSERT_EQ(stinger["sections"].size(), 2U);
  EXPECT_EQ(stinger["angle"], -0.1);
  EXPECT_EQ(stinger["sections"][1]["name"], "second");
  EXPECT_EQ(stinger["sections"][1]["angle"], 0.2);
}

}  // namespace
}  // namespace overbend

// A cable is held to its breaking load; the codes are about the pipe.
#include <gtest/gtest.h>

#include <algorithm>

#include "checks/check_station.h"
#include "checks/run_checks.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

struct Abandoned {
  Model model;
  StaticResults results;
};

/// A stage of the J-lay of the references, its cable with a breaking load.
const Abandoned& abandoned() {
  static const Abandoned kStage = [] {
    Description d = read_model(OVERBEND_SOURCE_DIR "/validation/operation_cases/AR12-J.yaml").description.value();
    d.operation.lay.cable->breaking_load = 4000e3;
    Model model = build_model(make_stage_description(d, lay_stages(d).at(2)));
    StaticResults results = checked_statics(model, solve_lay(model));
    return Abandoned{std::move(model), std::move(results)};
  }();
  return kStage;
}

const CheckRow* find_check_row(const CheckTable& table, const std::string& id) {
  const auto found = std::find_if(table.rows.begin(), table.rows.end(), [&](const CheckRow& r) { return r.id == id; });
  return found == table.rows.end() ? nullptr : &*found;
}

// The tension of a cable suspended from its winch has its maximum there.
TEST(cable_checks, the_cable_is_held_to_its_breaking_load_over_a_safety_factor) {
  const CheckRow* row = find_check_row(abandoned().results.checks, "cable_load");
  ASSERT_NE(row, nullptr);
  EXPECT_NEAR(row->utilisation, 3.0 * 340e3 / 4000e3, 3e-4);  // with the factor that is assumed
  EXPECT_EQ(row->capacity, 4000e3 / 3.0);
  EXPECT_NEAR(row->from_top, 0.0, 1e-9);
  EXPECT_TRUE(row->judged());
}

TEST(cable_checks, without_a_breaking_load_the_check_is_not_made) {
  Model model = abandoned().model;
  model.description.operation.lay.cable->breaking_load.reset();
  const CheckTable table = check_statics(model, abandoned().results);
  const CheckRow* row = find_check_row(table, "cable_load");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->status, CheckStatus::not_done);
  EXPECT_NE(row->remark.find("breaking_load"), std::string::npos);
}

TEST(cable_checks, a_lay_without_a_cable_has_no_such_row) {
  const Description d = read_model(OVERBEND_SOURCE_DIR "/validation/operation_cases/AR12-J.yaml").description.value();
  Model model = build_model(d);
  EXPECT_EQ(find_check_row(checked_statics(model, solve_lay(model)).checks, "cable_load"), nullptr);
}

TEST(cable_checks, no_code_looks_at_a_station_of_the_cable) {
  const auto& [model, results] = abandoned();
  const double total = results.total_length;
  const CheckStations all = static_stations(model, results);
  ASSERT_FALSE(all.stations.empty());
  EXPECT_LT(all.stations.size(), results.stations.size());
  for (const CheckStation& station : all.stations) {
    EXPECT_NE(model.kind_at(total - station.s), SectionKind::cable) << station.from_top;
  }
  for (const double s : results.checks.along.s) EXPECT_NE(model.kind_at(total - s), SectionKind::cable);
  for (const CheckRow& row : results.checks.rows) {
    if (row.id == "cable_load" || !row.judged()) continue;
    EXPECT_NE(model.kind_at(row.from_top), SectionKind::cable) << row.id;
  }
}

TEST(cable_checks, a_line_that_is_all_cable_is_held_to_nothing_else) {
  const Model& model = abandoned().model;
  StaticResults results = abandoned().results;
  const double total = results.total_length;
  std::erase_if(results.stations,
                [&](const Station& station) { return model.kind_at(total - station.s) != SectionKind::cable; });
  const CheckTable table = check_statics(model, results);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows.front().id, "cable_load");
  EXPECT_TRUE(table.along.s.empty());
}

TEST(cable_checks, what_is_assumed_names_no_tensile_strength_of_the_cable) {
  const std::vector<std::string> said = texts(abandoned().results.checks.assumptions);
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                          [](const std::string& s) { return s.find("breaking load only") != std::string::npos; }));
  EXPECT_TRUE(std::none_of(said.begin(), said.end(),
                           [](const std::string& s) { return s.find("of 'cable'") != std::string::npos; }));
}

}  // namespace
}  // namespace overbend

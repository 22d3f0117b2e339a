#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "report/bgl1_results.h"
#include "report/page/quantity.h"
#include "report/page_text.h"
#include "report/report.h"
#include "report/stages/operation_report.h"
#include "report/studies/lay_table_page.h"
#include "report/studies/seek_texts.h"
#include "report/studies/study_page.h"
#include "report/synthetic_dynamics.h"
#include "report/synthetic_moorings.h"
#include "report/synthetic_operation.h"
#include "report/synthetic_study.h"
#include "study/lay_table/lay_table.h"
#include "support/us_units.h"

namespace overbend {
namespace {

using testing::bgl1;

/// Without what is in the words of others: messages, assumptions, places of checks, the model's text and its title.
std::string labels_without_values(const Document& document) {
  std::string text;
  for (const Json& entry : document.front["entries"]) text += entry[1].get<std::string>() + "\n";
  for (const Json& section : document.body.json()) {
    const std::string id = section["id"];
    if (id != "assumptions" && id != "model" && id != "failed") text += testing::shown_text(section["body"]);
  }
  return std::regex_replace(text, std::regex("[^\n|]* with a wire core"), "");
}

/// Every place at which a metric unit stands behind a number, in a head, in a cell or in brackets.
std::set<std::string> metric_units(const std::string& text) {
  static const std::regex kMetric(
      R"((\d ?(kN|MPa|kJ|mm|m)\b|[\[(/, ](kN|MPa|MN|kJ|mm2?|cm4)\b|\[(m|m/s|t|kg/m|N/m|N s)\]|\[m\b)[^\n]{0,30})");
  std::set<std::string> found;
  for (std::sregex_iterator sample(text.begin(), text.end(), kMetric), none; sample != none; ++sample)
    found.insert(sample->str());
  return found;
}

void expect_us(const Document& document) {
  const std::string text = labels_without_values(document);
  EXPECT_TRUE(std::regex_search(text, std::regex("\\b(kip|ft|ksi)\\b")));
  for (const std::string& place : metric_units(text)) ADD_FAILURE() << place;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

StaticResults lay() {
  StaticResults results = bgl1().results;
  results.title = "A lay";
  return results;
}

TEST(report_units, of_a_lay_in_time_are_customary_where_that_is_asked_for) {
  const UsUnits units;
  expect_us(report_document(lay(), testing::synthetic_dynamics(lay()), bgl1().model_text));
}

TEST(report_units, of_moored_hulls_and_lines_are_customary_where_that_is_asked_for) {
  const UsUnits units;
  expect_us(testing::moored_document_in_time());
  expect_us(report_document(testing::synthetic_hull_alone(testing::synthetic_pull_ahead()),
                            testing::example_text("moored-barge")));
  expect_us(
      report_document(testing::synthetic_lines(), testing::synthetic_lines_in_time(), testing::example_text("jumper")));
}

TEST(report_units, of_operations_and_studies_are_customary_where_that_is_asked_for) {
  const UsUnits units;
  expect_us(operation_report_document(testing::synthetic_abandonment(), testing::abandonment_text()));
  for (const char* shape : {"maps", "swings", "sample", "operability"}) {
    expect_us(study_document(testing::synthetic_study(shape)));
  }
}

TEST(report_units, of_a_lay_table_are_customary_where_that_is_asked_for) {
  const ModelReading reading = read_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/first-model.yaml");
  LayTableDescription asked;
  asked.vary = LayTableVary::depth;
  asked.from = 40.0;
  asked.to = 45.0;
  asked.steps = 1;
  const UsUnits units;
  const Document document =
      lay_table_document(make_lay_table(*reading.description, asked), reading.description->source_text);
  expect_us(document);
  EXPECT_TRUE(has(testing::shown_text(document), "147.638"));  // 45 m [ft]
}

TEST(report_units, numbers_are_those_of_independent_factors) {
  constexpr double kNewtonsPerKip = 4448.2216152605, kPascalsPerKsi = 6.894757293168361e6;
  const UsUnits units;
  const Document document = report_document(lay(), bgl1().model_text);
  const std::string page = testing::shown_text(document);
  EXPECT_TRUE(has(page, fmt::format("| {:.2f} | kip |", lay().top_tension / kNewtonsPerKip)));
  EXPECT_TRUE(has(page, fmt::format("| {:.2f} | ksi |", lay().sagbend.von_mises.value / kPascalsPerKsi)));
  EXPECT_TRUE(has(page, fmt::format("| {:.1f} | ft |", lay().lay_back / 0.3048)));
  EXPECT_TRUE(has(page, "Steel outside diameter | 16 | in"));
  EXPECT_TRUE(has(page, "Seabed stiffness | 2088.54 | lbf/ft2"));  // 100 kPa
  EXPECT_TRUE(has(page_text(document), "\"paper\":\"letter\""));
  EXPECT_TRUE(has(page_text(document), "\"m\":{\"name\":\"ft\",\"factor\":3.28"));  // what the figures draw lengths in
}

TEST(report_units, of_damping_and_stiffness_follow_from_force_and_length) {
  const std::string text = testing::example_text("moored-barge");
  StaticResults results = testing::synthetic_hull_alone(testing::synthetic_stages());
  results.hull = testing::synthetic_hull();
  const ModeDampingResult mode = results.hull->damping.front();
  const UsUnits units;
  const std::string page = testing::shown_text(report_document(results, text));
  constexpr double kPerMetre = 0.3048 / 4448.2216152605;  // kip/ft of N/m
  EXPECT_EQ(mode.mode, "surge");
  EXPECT_TRUE(has(page, fmt::format("{:.4g}", mode.critical * kPerMetre)));
  EXPECT_TRUE(has(page, "[kip/ft, kip, kip ft]"));
  EXPECT_TRUE(has(page, fmt::format("{:.5g}", results.moorings->rest.vessel.stiffness[0] * kPerMetre)));
}

TEST(report_units, plain_numbers_have_no_more_digits_than_mean_something) {
  EXPECT_EQ(quantity("carrying_share", "1").text(0.99987), "0.9999");
}

TEST(report_units, of_keys_are_those_they_are_written_in_or_customary) {
  SeekUnknown key;
  key.unit = "N";
  key.show = "kN";
  EXPECT_EQ(quantity_text(4448.2216152605, key, 4), "4.448 kN");
  const UsUnits units;
  EXPECT_EQ(quantity_text(4448.2216152605, key, 4), "1 kip");
  key.unit = "m";
  key.show = "mm";
  EXPECT_EQ(quantity_text(0.0254, key, 4), "1 in");
  key.unit = "N*m";
  key.show = "kN*m";
  EXPECT_EQ(quantity_text(1355.8179483314, key, 4), "1 kip ft");
  key.unit = "kg/m^3";  // has no customary unit here
  key.show = "kg/m^3";
  EXPECT_EQ(quantity_text(1025.0, key, 4), "1025 kg/m^3");
}

}  // namespace
}  // namespace overbend

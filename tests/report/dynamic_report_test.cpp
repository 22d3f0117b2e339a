#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <regex>
#include <set>

#include "base/json.h"
#include "base/shown_unit.h"
#include "report/bgl1_results.h"
#include "report/page/quantity.h"
#include "report/page_text.h"
#include "report/report.h"
#include "report/studies/report_data.h"
#include "report/synthetic_dynamics.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;
using testing::row_count;
using testing::section_body;
using testing::section_text;
using testing::shown_text;
using testing::synthetic_dynamics;

const DynamicResults& example() {
  static const DynamicResults kResults = synthetic_dynamics(bgl1().results);
  return kResults;
}

Document make_document(const DynamicResults& results) {
  return report_document(bgl1().results, results, bgl1().model_text);
}

Json make_page_data(const DynamicResults& results) {
  return report_data(bgl1().results, &results)["dynamic"];
}

TEST(dynamic_report, stands_alone_and_stays_below_a_size_that_mail_carries) {
  const std::string page = page_text(make_document(example()));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?\s*(https?:|//))")));
  EXPECT_LT(page.size(), 900'000u);
}

TEST(dynamic_report, gives_the_extremes_of_mooring_lines_a_table_of_their_own) {
  DynamicResults results = example();
  EXPECT_EQ(shown_text(make_document(results)).find("extremes of the mooring lines"), std::string::npos);
  results.extremes.push_back({"mooring/port bow/fairlead_tension",
                              "N",
                              false,
                              40,
                              4e5,
                              4.2e5,
                              4e5,
                              4.4e5,
                              "Weibull",
                              "good",
                              "",
                              4.2e5,
                              4e5,
                              4.4e5,
                              4.2e5,
                              4e5,
                              4.4e5,
                              {},
                              {},
                              {},
                              true});
  const std::string page = shown_text(make_document(results));
  const std::size_t lay = page.find("Most probable extremes in three hours");
  const std::size_t lines = page.find("Most probable extremes of the mooring lines in three hours");
  ASSERT_NE(lines, std::string::npos);
  EXPECT_LT(lay, lines);
  EXPECT_GT(page.find("Fairlead tension, port bow", lay), lines);
}

TEST(dynamic_report, says_in_its_head_what_sea_and_motion_it_ran_in) {
  const std::string head = testing::front_text(make_document(example()).front);
  EXPECT_NE(head.find("Dynamic pipelay analysis"), std::string::npos);
  EXPECT_NE(head.find("JONSWAP, Hs 4 m, Tp 12.9 s, gamma 1 by rule, from 180 deg, long-crested"), std::string::npos);
  EXPECT_NE(head.find("RAOs of rao.csv"), std::string::npos);
  EXPECT_NE(head.find("60 min after a build-up of 60 s"), std::string::npos);
  EXPECT_NE(head.find("generalized-alpha"), std::string::npos);
  EXPECT_NE(head.find("Seed | 7\n"), std::string::npos);
}

TEST(dynamic_report, sets_static_next_to_dynamic_in_its_key_results) {
  const std::string text = section_text(make_document(example()), "results");
  const StaticResults& statics = bgl1().results;
  for (const double stress : {statics.overbend->von_mises.value, example().overbend.von_mises.over_time.max,
                              statics.sagbend.von_mises.value, example().sagbend.von_mises.over_time.max}) {
    EXPECT_NE(text.find(fixed(stress / 1e6, 1)), std::string::npos) << stress;
  }
  EXPECT_NE(text.find(fixed(example().top_tension.min / 1e3, 1) + " to " + fixed(example().top_tension.max / 1e3, 1)),
            std::string::npos);
  EXPECT_NE(section_text(make_document(example()), "run").find(fixed(100.0 * example().energy.drift(), 4)),
            std::string::npos);
}

TEST(dynamic_report, sets_the_energy_of_a_free_hull_into_the_balance_that_it_sums_up) {
  DynamicResults results = example();
  EXPECT_EQ(section_text(make_document(results), "run").find("floats"), std::string::npos);
  results.energy = {};
  results.energy.kinetic = 2e3;
  results.energy.fluid = 3e3;
  results.energy.bodies = 40e3;
  results.energy.on_bodies = 38.5e3;
  results.energy.error = 0.5e3;
  const std::string text = section_text(make_document(results), "run");
  for (const char* number : {"38.500", "41.500", "40.000", "42.000", "0.500"}) {  // work, in all; stored, in all; error
    EXPECT_NE(text.find(std::string("| ") + number), std::string::npos) << number;
  }
}

TEST(dynamic_report, holds_the_static_report_too) {
  const Document document = make_document(example());
  for (const char* id : {"static-results", "figures", "summary", "supports", "inputs", "assumptions", "balance"}) {
    EXPECT_NE(section_text(document, id), "") << id;
  }
  const std::vector<std::string> all = testing::panels(document.body.json());
  EXPECT_EQ(std::ranges::count_if(all, [](const std::string& panel) { return panel.starts_with("mises/"); }), 2);
  // Assumptions of both, each once.
  for (const std::string& assumption : texts(example().assumptions)) {
    EXPECT_EQ(count(section_text(document, "assumptions"), assumption), 1u) << assumption;
  }
}

TEST(dynamic_report, has_no_two_sections_of_one_name) {
  std::set<std::string> seen;
  for (const std::string& id : testing::section_ids(make_document(example())))
    EXPECT_TRUE(seen.insert(id).second) << id;
}

TEST(dynamic_report, has_a_line_for_every_box_and_every_roller) {
  const Document document = make_document(example());
  std::size_t rollers = 0;
  for (const SupportDynamics& box : example().supports) rollers += box.rollers.size();
  EXPECT_EQ(row_count(section_body(document, "dynamic-supports")), example().supports.size());
  EXPECT_EQ(row_count(section_body(document, "dynamic-rollers")), rollers);
}

TEST(dynamic_report, prints_the_twenty_hardest_impacts_and_folds_the_rest) {
  const Json body = section_body(make_document(example()), "impacts");
  const auto folded = std::ranges::find_if(body, [](const Json& block) { return block["kind"] == "folded"; });
  ASSERT_NE(folded, body.end());
  EXPECT_FALSE((*folded)["printed"].get<bool>());
  EXPECT_EQ(row_count((*folded)["body"]), example().hardest_impacts.size() - 20);
  EXPECT_EQ(row_count(body), example().hardest_impacts.size());
}

TEST(dynamic_report, of_a_calm_run_claims_no_impacts_and_no_fits) {
  const Document document = make_document(synthetic_dynamics(bgl1().results, true));
  const std::string text = shown_text(document);
  EXPECT_NE(text.find("The pipe never lands on a roller after leaving it."), std::string::npos);
  for (const std::string& panel : testing::panels(document.body.json())) EXPECT_FALSE(panel.starts_with("impacts/"));
  EXPECT_NE(text.find("fewer than 30 peaks"), std::string::npos);
  EXPECT_NE(text.find("Rollers that lose contact | 0 | "), std::string::npos);
}

TEST(dynamic_report, marks_the_tile_of_stress_beyond_yield_and_only_then) {
  DynamicResults results = example();
  EXPECT_EQ(shown_text(make_document(results)).find("over: Overbend von Mises"), std::string::npos);
  results.overbend.von_mises.over_time.max = 2.0 * bgl1().results.stations.back().yield_stress;
  const std::string page = shown_text(make_document(results));
  EXPECT_NE(page.find("200.0 % of yield, at "), std::string::npos);
  EXPECT_NE(page.find("over: Overbend von Mises"), std::string::npos);
}

TEST(dynamic_report, lists_the_boxes_that_the_pipe_left_in_the_order_of_time) {
  DynamicResults results = example();
  EXPECT_EQ(shown_text(make_document(results)).find("The pipe left these boxes"), std::string::npos);
  results.supports[0].left_to_starboard = 12.0;
  results.supports[1].left_to_port = 3.0;
  const std::string first = results.supports[1].name, second = results.supports[0].name;
  EXPECT_NE(shown_text(make_document(results))
                .find("The pipe left these boxes: " + first + ", to port at t = 3.0 s, " + second +
                      ", to starboard at t = 12.0 s."),
            std::string::npos);
}

TEST(dynamic_report, hostile_text_of_the_user_is_harmless) {
  const std::string attack = "</script><script>alert(1)</script><img src=x onerror=alert(2)>";
  DynamicResults results = example();
  results.findings = {{FindingCode::unknown, attack}};
  results.assumptions = {{AssumptionRank::governing, attack}};
  results.supports.front().name = attack;
  results.histories.front().name = "support/" + attack + "/reaction";
  results.run.integrator = attack;
  const std::string page = page_text(make_document(results));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
}

TEST(dynamic_report, without_supports_shows_no_empty_overbend) {
  StaticResults statics = bgl1().results;
  statics.supports.clear();
  statics.overbend.reset();
  statics.stinger_tip_clearance.reset();
  const Document document = report_document(statics, synthetic_dynamics(statics), "");
  for (const std::string& panel : testing::panels(document.body.json())) {
    EXPECT_FALSE(panel.ends_with("/overbend") || panel.ends_with("/reactions")) << panel;
  }
  EXPECT_EQ(section_text(document, "dynamic-supports"), "");
  EXPECT_EQ(section_text(document, "impacts"), "");
  EXPECT_EQ(shown_text(document).find("Overbend von Mises"), std::string::npos);
}

TEST(dynamic_report, is_written_as_a_file) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "overbend_dynamic_report_test.html";
  write_report(bgl1().results, example(), bgl1().model_text, file);
  EXPECT_GT(std::filesystem::file_size(file), 300'000u);
  std::filesystem::remove(file);
}

TEST(dynamic_report_data, envelopes_run_from_the_tensioner_and_keep_their_peaks) {
  const Json data = make_page_data(example());
  const std::vector<double> s = data["envelopes"]["s"];
  EXPECT_DOUBLE_EQ(s.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(s.begin(), s.end()));
  const std::vector<double> max_value = data["envelopes"]["von_mises"]["max"];
  const double wanted = *std::max_element(example().von_mises.max.begin(), example().von_mises.max.end());
  EXPECT_NEAR(*std::max_element(max_value.begin(), max_value.end()), wanted, 1e-6 * wanted);  // seven digits are kept
}

TEST(dynamic_report_data, histories_keep_least_and_greatest_to_their_resolution) {
  const Json data = make_page_data(example());
  for (const Json& history : data["histories"]) {
    if (history["title"] != "Top tension") continue;
    const auto named = [](const std::string& name) {
      return std::find_if(example().histories.begin(), example().histories.end(),
                          [&](const HistorySummary& h) { return h.name == name; });
    };
    const auto source = named("top_tension"), peaks = named("top_tension_peak");  // down to the rows, up to the peaks
    const double quantum = history["quantum"], lowest = history["lowest"];
    const std::vector<int> low = history["low"], high = history["high"];
    EXPECT_LE(low.size(), 1000u);
    const double min_value = 1e-3 * *std::min_element(source->low.begin(), source->low.end());
    const double max_value = 1e-3 * *std::max_element(peaks->high.begin(), peaks->high.end());
    EXPECT_NEAR(lowest + quantum * *std::min_element(low.begin(), low.end()), min_value, quantum);
    EXPECT_NEAR(lowest + quantum * *std::max_element(high.begin(), high.end()), max_value, quantum);
    EXPECT_NEAR(history["static"].get<double>(), 1e-3 * bgl1().results.top_tension, 1e-4);
    return;
  }
  FAIL() << "no history of the top tension";
}

TEST(dynamic_report, reports_an_extreme_alike_in_card_table_and_figure) {
  DynamicResults results = example();
  results.top_tension = {77.9e3, 416.0e3, 249.2e3, 66.0e3};  // of every step; the rows of the history miss the ends
  results.overbend.von_mises.over_time = {318.2e6, 359.3e6, 334.0e6, 6.1e6};
  for (ExtremeEstimate& e : results.extremes) e.observed = 0.9 * e.observed;
  const Document document = make_document(results);
  EXPECT_NE(section_text(document, "results").find("77.9 to 416.0"), std::string::npos);
  const std::string tables = section_text(document, "statistics");
  EXPECT_NE(tables.find("77.9 | 249.2 | 416.0"), std::string::npos);
  const std::size_t extremes = tables.find("Most probable extremes");
  ASSERT_NE(extremes, std::string::npos);
  EXPECT_NE(tables.find("359.3", extremes), std::string::npos);
  const Json data = make_page_data(results);
  const auto max_magnitude = [&](const std::string& title) {
    for (const Json& history : data["histories"]) {
      if (history["title"] == title) return history["over_time"]["max"].get<double>();
    }
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(max_magnitude("Top tension"), 416.0);
  EXPECT_DOUBLE_EQ(max_magnitude("Overbend von Mises stress"), 359.3);
}

TEST(dynamic_report_data, shows_the_supports_that_are_pressed_hardest) {
  std::vector<std::string> shown;
  const Json data = make_page_data(example());
  for (const Json& history : data["histories"]) {
    if (history["group"] == "reactions") shown.push_back(history["title"]);
  }
  ASSERT_EQ(shown.size(), 4u);
  const auto hardest = std::max_element(example().supports.begin(), example().supports.end(),
                                        [](const SupportDynamics& a, const SupportDynamics& b) {
                                          return a.static_reaction < b.static_reaction;  // as the made-up run scales
                                        });
  EXPECT_EQ(shown.front(), "Reaction, " + hardest->name);
}

TEST(dynamic_report_data, what_is_not_finite_does_not_break_the_page) {
  DynamicResults results = example();
  const double infinity = std::numeric_limits<double>::infinity();
  results.histories.front().low.front() = -infinity;
  results.histories.front().high.back() = std::numeric_limits<double>::quiet_NaN();
  results.von_mises.max.front() = infinity;
  results.supports.front().separation.min = infinity;
  const std::string data = json_text(report_data(bgl1().results, &results));
  EXPECT_TRUE(Json::accept(data));
  for (const char* word : {"NaN", "nan", "Infinity", "inf,"}) {
    EXPECT_EQ(data.find(word), std::string::npos) << word;
  }
  const std::string text = section_text(make_document(results), "dynamic-supports");
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(dynamic_report_data, spectra_are_cut_where_nothing_is_left) {
  const Json data = make_page_data(example());
  EXPECT_EQ(data["spectra"].size(), example().spectra.size());
  for (const Json& spectrum : data["spectra"]) {
    const std::vector<double> f = spectrum["frequency"];
    EXPECT_LT(f.back(), 0.5) << spectrum["title"];  // the made-up ones reach to 1 Hz
    EXPECT_GT(f.back(), 2.0 / 12.9) << spectrum["title"];
  }
}

TEST(dynamic_report_data, what_does_not_move_has_no_spectrum) {
  DynamicResults results = example();
  for (double& density : results.spectra.front().density) density *= 1e-16;
  EXPECT_EQ(make_page_data(results)["spectra"].size(), example().spectra.size() - 1);
}

TEST(quantity, names_and_units_are_those_of_people) {
  EXPECT_EQ(quantity("support/stinger 8/reaction", "N").name, "Reaction, stinger 8");
  EXPECT_EQ(quantity("support/a/b/reaction", "N").name, "Reaction, a/b");
  EXPECT_EQ(quantity("top_tension_peak", "N").name, "Top tension");
  EXPECT_EQ(quantity("overbend_von_mises_peak", "Pa").name, "Overbend von Mises stress");
  EXPECT_EQ(quantity("top_tension", "N").text(250'000.0), "250.0");
  EXPECT_EQ(quantity("pitch", "rad").text(0.0174532925), "1.00");
  EXPECT_EQ(quantity("sagbend_strain_peak", "1").text(0.00054), "0.0540");
  EXPECT_EQ(quantity("something new", "furlong").unit, "furlong");
}

TEST(quantity, durations_are_reported_in_a_unit_that_fits) {
  EXPECT_EQ(readable_duration(60.0), "60 s");
  EXPECT_EQ(readable_duration(3600.0), "60 min");
  EXPECT_EQ(readable_duration(10'800.0), "3 h");
}

}  // namespace
}  // namespace overbend

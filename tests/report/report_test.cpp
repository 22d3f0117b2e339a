#include "report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "base/shown_unit.h"
#include "report/bgl1_results.h"
#include "report/page/html.h"
#include "report/page_text.h"
#include "report/studies/report_data.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

using testing::bgl1;
using testing::count;
using testing::panels;
using testing::row_count;
using testing::section_body;
using testing::section_text;
using testing::shown_text;

TEST(report, stands_alone_without_any_outside_address) {
  const std::string page = page_text(report_document(bgl1().results, bgl1().model_text));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?\s*(https?:|//))")));
  EXPECT_EQ(count(page, "@import"), 0u);
  EXPECT_EQ(count(page, "type=\"module\""), 0u);
  EXPECT_EQ(count(page, "fetch(\""), 0u);
}

TEST(report, stays_below_a_size_that_mail_carries) {
  EXPECT_LT(page_text(report_document(bgl1().results, bgl1().model_text)).size(), 700'000u);
}

TEST(report, shows_its_numbers) {
  const StaticResults& results = bgl1().results;
  const std::string text = shown_text(report_document(results, bgl1().model_text));
  EXPECT_NE(text.find(fixed(results.lay_back, 2)), std::string::npos);
  EXPECT_NE(text.find(fixed(results.overbend->von_mises.value / 1e6, 1)), std::string::npos);
  EXPECT_NE(text.find(fixed(results.bottom_tension / 1e3, 2)), std::string::npos);
  for (const SupportResult& box : results.supports) {
    EXPECT_NE(text.find(box.name), std::string::npos) << box.name;
  }
  for (const std::string& assumption : texts(results.assumptions)) {
    EXPECT_NE(text.find(assumption), std::string::npos) << assumption;
  }
  EXPECT_NE(text.find("concrete"), std::string::npos);  // inputs are read from the model text
}

TEST(report, has_a_line_for_every_roller) {
  const Document page = report_document(bgl1().results, bgl1().model_text);
  std::size_t rollers = 0;
  for (const SupportResult& box : bgl1().results.supports) {
    for (const RowResult& row : box.rows) {
      rollers += row.rollers.size();
    }
  }
  ASSERT_GT(rollers, 100u);
  EXPECT_EQ(row_count(section_body(page, "rollers")), rollers);
}

TEST(report, has_a_panel_of_every_diagram_for_whole_line_and_overbend) {
  const std::vector<std::string> all = panels(report_document(bgl1().results, bgl1().model_text).body.json());
  for (const std::string figure : {"configuration", "geometry", "tension", "moment", "bending", "mises", "strain"}) {
    for (const std::string part : {"whole", "overbend"}) {
      EXPECT_EQ(std::ranges::count(all, figure + "/" + part), 1) << figure << " " << part;
    }
  }
  for (const std::string panel : {"stinger/stinger", "reactions/bars", "separations/bars"}) {
    EXPECT_EQ(std::ranges::count(all, panel), 1) << panel;
  }
}

TEST(report, says_in_its_head_how_many_findings_there_are) {
  StaticResults results = bgl1().results;
  results.findings.clear();
  EXPECT_NE(shown_text(report_document(results, "")).find("Status | converged\n"), std::string::npos);
  results.findings = {{FindingCode::unknown, "one"}, {FindingCode::unknown, "two"}};
  const std::string text = shown_text(report_document(results, ""));
  EXPECT_NE(text.find("Status | converged, 2 findings"), std::string::npos);
  EXPECT_NE(text.find("caution: Two (unknown)"), std::string::npos);
}

TEST(report, marks_the_tile_of_stress_beyond_yield_and_only_then) {
  StaticResults results = bgl1().results;
  EXPECT_EQ(section_text(report_document(results, ""), "results").find("over: "), std::string::npos);
  results.overbend->von_mises.value = 2.0 * results.stations.back().yield_stress;
  const std::string text = section_text(report_document(results, ""), "results");
  EXPECT_NE(text.find("over: Overbend von Mises"), std::string::npos);
  EXPECT_NE(text.find("200.0 % of yield, at "), std::string::npos);
}

TEST(report, hostile_text_of_the_user_is_harmless) {
  const std::string attack = "</script><script>alert(1)</script><img src=x onerror=alert(2)>";
  StaticResults results = bgl1().results;
  results.title = attack;
  results.vessel_name = attack;
  results.findings = {{FindingCode::unknown, attack}};
  results.supports.front().name = attack;
  const std::string page = page_text(report_document(results, "title: " + attack));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
}

TEST(report, shows_head_findings_and_key_results_without_scripts) {
  const std::string page = page_text(report_document(bgl1().results, bgl1().model_text));
  const std::string plain = page.substr(page.find("<noscript>"), page.find("</noscript>") - page.find("<noscript>"));
  EXPECT_NE(plain.find("<h1>" + html::escape(bgl1().results.title) + "</h1>"), std::string::npos);
  EXPECT_NE(plain.find("Overbend von Mises: " + fixed(bgl1().results.overbend->von_mises.value / 1e6, 1) + " MPa"),
            std::string::npos);
  EXPECT_NE(plain.find("<h2>Code checks</h2>"), std::string::npos);
  for (const CheckRow& row : bgl1().results.checks.rows) {
    EXPECT_NE(plain.find("<td>" + html::escape(row.name) + "</td>"), std::string::npos) << row.name;
  }
}

TEST(report, a_model_text_that_can_not_be_read_is_printed_all_the_same) {
  const Document page = report_document(bgl1().results, "no: [model");
  EXPECT_NE(section_text(page, "model").find("no: [model"), std::string::npos);
}

TEST(report, without_supports_shows_no_empty_overbend) {
  StaticResults results = bgl1().results;
  results.supports.clear();
  results.overbend.reset();
  results.stinger_tip_clearance.reset();
  results.last_support.clear();
  const Document page = report_document(results, "");
  EXPECT_EQ(std::ranges::count(panels(page.body.json()), "tension/overbend"), 0);
  const std::string text = shown_text(page);
  EXPECT_EQ(text.find("Roller boxes"), std::string::npos);
  EXPECT_NE(text.find("J-lay"), std::string::npos);
  EXPECT_NE(text.find("Suspended length"), std::string::npos);
}

TEST(report, is_written_to_a_neighbouring_file_and_renamed) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "overbend_report_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_report(bgl1().results, bgl1().model_text, folder / "report.html");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  EXPECT_GT(std::filesystem::file_size(folder / "report.html"), 100'000u);
  // A folder in the way: an error that names it, and no half-written file.
  std::filesystem::create_directories(folder / "taken" / "inside");
  EXPECT_THROW(write_report(bgl1().results, bgl1().model_text, folder / "taken"), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder / ".taken.part"));
  std::filesystem::remove_all(folder);
}

TEST(report_data, keeps_the_extremes_and_runs_from_the_tensioner) {
  const StaticResults& results = bgl1().results;
  const Json data = report_data(results);
  const std::vector<double> s = data["stations"]["s"];
  const std::vector<double> mises = data["stations"]["von_mises"];
  EXPECT_DOUBLE_EQ(s.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(s.begin(), s.end()));
  // Seven digits are kept.
  EXPECT_NEAR(*std::max_element(mises.begin(), mises.end()), results.overbend->von_mises.value,
              1e-6 * results.overbend->von_mises.value);
  EXPECT_EQ(data["supports"].size(), results.supports.size());
}

TEST(report_data, thins_a_very_long_line_but_keeps_its_peaks) {
  StaticResults results = bgl1().results;
  const std::vector<Station> few = results.stations;
  results.stations.clear();
  for (std::size_t i = 0; i < 20'000; ++i) {
    Station station = few.front();
    station.s = 0.1 * static_cast<double>(i);
    station.von_mises = i == 12'345 ? 300e6 : 50e6;
    station.region = Region::sagbend;
    results.stations.push_back(station);
  }
  const Json data = report_data(results);
  const std::vector<double> mises = data["stations"]["von_mises"];
  EXPECT_LT(mises.size(), 3000u);
  EXPECT_DOUBLE_EQ(*std::max_element(mises.begin(), mises.end()), 300e6);
}

TEST(places, ship_axes_run_astern_and_to_port) {
  const StaticResults& results = bgl1().results;  // heading east: astern is west, port is north
  const Vec3 p = ship_point(results, results.stern_shoe_W + Vec3(-10.0, 3.0, 1.0));
  EXPECT_NEAR(p.x(), 10.0, 1e-9);
  EXPECT_NEAR(p.y(), 3.0, 1e-9);
}

TEST(places, a_place_between_stations_is_interpolated) {
  const StaticResults& results = bgl1().results;
  const Station& a = results.stations[10];
  const Station& b = results.stations[11];
  const Station middle = station_at(results, 0.5 * (a.s + b.s));
  EXPECT_NEAR(middle.effective_tension, 0.5 * (a.effective_tension + b.effective_tension), 1e-6);
  EXPECT_NEAR((middle.p_W - 0.5 * (a.p_W + b.p_W)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace overbend

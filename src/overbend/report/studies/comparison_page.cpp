#include "report/studies/comparison_page.h"

#include <fmt/format.h>

#include <cmath>

#include "report/page/figure_list.h"
#include "report/page/front_page.h"
#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/studies/comparison_sections.h"
#include "report/studies/report_data.h"
#include "resultfiles/studies/seeds_writer.h"
#include "results/findings.h"

namespace overbend {
namespace {

/// Four digits; what is next to nothing by its order.
std::string short_number(double value) {
  const double size = std::abs(value);
  if (size >= 1e4) return fmt::format("{:.0f}", value);
  return size > 0.0 && size < 1e-3 ? fmt::format("{:.1e}", value) : fmt::format("{:.4g}", value);
}

std::string quantities_section(const Comparison& comparison) {
  std::vector<html::Head> head = {{"Quantity", "", true}, {"Unit", "", true}};
  for (const ComparedRun& run : comparison.runs) head.push_back({run.name, ""});
  html::Table table("", head, "plain");
  for (std::size_t i = 0; i < comparison.quantities.size(); ++i) {
    const ShownUnit unit = table_unit(comparison.quantities[i]);
    std::vector<std::string> cells = {comparison.quantities[i].description, std::string(unit.name)};
    for (const ComparedRun& run : comparison.runs) cells.push_back(short_number(run.values.at(i) * unit.factor));
    table.row(cells);
  }
  std::vector<std::string> counts = {"Findings", "-"};
  for (const ComparedRun& run : comparison.runs) counts.push_back(std::to_string(run.results.findings.size()));
  table.row(counts);
  return html::section("quantities", "Results of the variants",
                       table.str() + "<p class=\"small\">From the end of the build-up to the end of the run.</p>\n");
}

const char* title_of(ComparisonOf of) {
  switch (of) {
    case ComparisonOf::tensioner:
      return "Tensioner off, controlled and constant";
    case ComparisonOf::contact:
      return "Rollers and gap springs";
    case ComparisonOf::impacts:
      return "Impacts resolved and captured";
  }
  broken_promise("every comparison has a title");
}

const std::vector<Figure>& figures_of(ComparisonOf of) {
  static const std::vector<Figure> kTensioner = {
      {"compared_tensioner",
       "Time history of tension at the tensioner: off, controlled and constant, with the operational range",
       {"tension_whole", "tension_close"}},
      {"compared_tensioner", "Time history of tensioner travel", {"travel_whole", "travel_close"}}};
  static const std::vector<Figure> kContact = {
      {"compared_contact",
       "Fraction of time in contact, per box and bottom roller; \u00d7 marks a box that never carries",
       {"share"}},
      {"compared_contact",
       "Peak reaction of each box; the white line marks the static value, dots are individual bottom rollers",
       {"peak"}},
      {"compared_contact",
       "Possible damage to steel and coating by the hardest contact of each box",
       {"dent", "load"}}};
  return of == ComparisonOf::tensioner ? kTensioner : kContact;
}

std::string figures(const Comparison& comparison) {
  int number = 0;
  const auto always = [](const Figure&, const std::string&) { return true; };
  return figure_section("figures", "Figures", figure_list(figures_of(comparison.of), always, number));
}

std::string links_section(const Comparison& comparison) {
  std::string items;
  for (const ComparedRun& run : comparison.runs) {
    items += fmt::format("<li><a href=\"{0}/report.html\">{0}</a>: {1}</li>\n", html::escape(run.name),
                         html::escape(run.words));
  }
  return html::section("reports", "Reports of the variants", "<ul>\n" + items + "</ul>\n");
}

/// Of the variants by name, then of the static state that all begin from.
Findings variant_findings(const StaticResults& statics, const Comparison& comparison) {
  Findings all;
  for (const ComparedRun& run : comparison.runs) {
    for (Finding finding : run.results.findings) {
      finding.message = run.name + ": " + finding.message;
      all.push_back(std::move(finding));
    }
  }
  return merge(std::move(all), statics.findings);
}

}  // namespace

std::string comparison_html(const StaticResults& statics, const Comparison& comparison, const std::string& model_text) {
  const Findings findings = variant_findings(statics, comparison);
  std::vector<std::pair<std::string, std::string>> entries = subject_entries(statics);
  entries.emplace_back("Simulated", duration_words(comparison.duration) + " each");
  entries.emplace_back("Status", status_words("completed", findings.size()));
  entries.emplace_back("Program", "Overbend " + statics.version);
  entries.emplace_back("Written", written_now());
  const std::string body = title_block(std::string("Comparison: ") + title_of(comparison.of), statics.title, entries) +
                           comparison_section(comparison) + findings_section(findings) + figures(comparison) +
                           quantities_section(comparison) + boxes_section(comparison) + links_section(comparison) +
                           model_text_section(model_text);
  return whole_page(statics.title + " - comparison", body, report_data(statics, comparison));
}

void write_comparison_page(const StaticResults& statics, const Comparison& comparison, const std::string& model_text,
                           const std::filesystem::path& file) {
  write_page(comparison_html(statics, comparison, model_text), file);
}

}  // namespace overbend

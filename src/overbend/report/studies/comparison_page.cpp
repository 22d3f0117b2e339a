#include "report/studies/comparison_page.h"

#include <fmt/format.h>

#include <cmath>

#include "report/page/figure_list.h"
#include "report/page/make_front_page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/studies/comparison_sections.h"
#include "report/studies/report_data.h"
#include "resultfiles/studies/seeds_writer.h"
#include "results/findings.h"

namespace overbend {
namespace {

/// Formats with four digits; negligible values by their order of magnitude.
std::string short_number(double value) {
  const double size = std::abs(value);
  if (size >= 1e4) return fmt::format("{:.0f}", value);
  return size > 0.0 && size < 1e-3 ? fmt::format("{:.1e}", value) : fmt::format("{:.4g}", value);
}

Blocks quantities_section(const Comparison& comparison) {
  Table table{"", {TableColumn("Quantity"), TableColumn("Unit")}};
  std::vector<TableCell> counts = {"Findings", "-"};
  for (const ComparedRun& run : comparison.runs) {
    table.column(TableColumn::texts(run.name));
    counts.emplace_back(std::to_string(run.results.findings.size()));
  }
  for (std::size_t i = 0; i < comparison.quantities.size(); ++i) {
    const ShownUnit unit = table_unit(comparison.quantities[i]);
    std::vector<TableCell> cells = {comparison.quantities[i].description, unit.name};
    for (const ComparedRun& run : comparison.runs) cells.emplace_back(short_number(run.values.at(i) * unit.factor));
    table.row(cells);
  }
  table.row(counts);
  return block::section("quantities", "Results of the variants",
                        table + block::remark("From the end of the build-up to the end of the run."));
}

const char* comparison_title(ComparisonType of) {
  switch (of) {
    case ComparisonType::tensioner:
      return "Tensioner off, controlled and constant";
    case ComparisonType::contact:
      return "Rollers and gap springs";
    case ComparisonType::impacts:
      return "Impacts resolved and captured";
  }
  broken_promise("every comparison has a title");
}

const std::vector<Figure>& make_figures(ComparisonType of) {
  static const std::vector<Figure> kTensioner = {
      {"compared_tensioner",
       "Time history of tension at the tensioner: off, controlled and constant, with the operational range",
       {"tension_whole", "tension_close"}},
      {"compared_tensioner", "Time history of tensioner travel", {"travel_whole", "travel_close"}}};
  static const std::vector<Figure> kContact = {
      {"compared_contact",
       "Fraction of time in contact, per box and bottom roller; \u00d7 marks a box that is never in contact",
       {"share"}},
      {"compared_contact",
       "Peak reaction of each box; the white line marks the static value, dots are individual bottom rollers",
       {"peak"}},
      {"compared_contact",
       "Possible damage to steel and coating by the largest contact force of each box",
       {"dent", "load"}}};
  return of == ComparisonType::tensioner ? kTensioner : kContact;
}

/// Each variant has its own folder.
Blocks links_section(const Comparison& comparison) {
  Blocks links;
  for (const ComparedRun& run : comparison.runs) {
    links += block::paragraph(run.label + ": ", run.name, run.name + "/report.html");
  }
  return block::section("reports", "Reports of the variants", links);
}

/// Findings of the variants by name, then of their common static state.
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

Document comparison_document(const StaticResults& statics, const Comparison& comparison,
                             const std::string& model_text) {
  FrontPage front = make_front_page(std::string("Comparison: ") + comparison_title(comparison.of), statics.title,
                                    std::nullopt, variant_findings(statics, comparison));
  front.entries = subject_entries(statics);
  front.entries.emplace_back("Simulated", readable_duration(comparison.duration) + " each");
  front.entries.emplace_back("Status", status_label("completed", front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + statics.version);
  front.entries.emplace_back("Written", written_now());
  return {statics.title + " - comparison", front_page(front),
          comparison_section(comparison) +
              block::section("figures", "Figures", figure_list(make_figures(comparison.of))) +
              quantities_section(comparison) + boxes_section(comparison) + links_section(comparison) +
              model_text_section(model_text),
          report_data(statics, comparison)};
}

void write_comparison_page(const StaticResults& statics, const Comparison& comparison, const std::string& model_text,
                           const std::filesystem::path& file) {
  write_page(comparison_document(statics, comparison, model_text), file);
}

}  // namespace overbend

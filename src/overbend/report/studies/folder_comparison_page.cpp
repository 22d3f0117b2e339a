#include "report/studies/folder_comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/finding.h"
#include "base/shown_unit.h"
#include "report/page/json_number.h"
#include "report/page/make_front_page.h"
#include "resultfiles/studies/folder_comparison_writer.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxRows = 400;

const char* word(ResultsKind kind) {
  switch (kind) {
    case ResultsKind::statics:
      return "static analysis";
    case ResultsKind::dynamics:
      return "dynamic analysis";
    case ResultsKind::seeds:
      return "dynamic analysis, several seeds";
    default:
      return "operation on the line";
  }
}

std::string number(double value) {
  const double size = std::abs(value);
  if (size >= 1e5) return fmt::format("{:.0f}", value);
  return size > 0.0 && size < 1e-3 ? fmt::format("{:.2e}", value) : fmt::format("{:.5g}", value);
}

/// Adds a column for each folder; `is_text`: for columns of text instead of numbers.
Table with_folders(Table table, const FolderComparison& comparison, bool is_text) {
  for (const ComparedFolder& folder : comparison.folders) {
    table.column(is_text ? TableColumn(folder.name) : TableColumn::texts(folder.name));
  }
  return table;
}

Blocks folders_section(const FolderComparison& comparison) {
  Table table{"",
              {TableColumn("Results"),
               TableColumn("Model"),
               TableColumn("Kind"),
               TableColumn("Program"),
               TableColumn("Governing check"),
               {"Warnings", "", 0}}};
  for (const ComparedFolder& folder : comparison.folders) {
    table.row({folder.name, folder.title, word(folder.kind), folder.version,
               folder.governing.empty() ? "-" : folder.governing, folder.findings.size()});
  }
  Blocks body = table;
  for (const std::string& note : comparison.notes) body += block::paragraph(note);
  return block::section("folders", "Compared results", body);
}

Blocks keys_section(const FolderComparison& comparison) {
  constexpr const char *kId = "inputs", *kHeading = "Differences of the inputs";
  if (comparison.keys.empty()) {
    return block::section(kId, kHeading, block::paragraph("The model files have the same value for every key."));
  }
  Table table = with_folders({"", {TableColumn("Key")}}, comparison, true);
  for (std::size_t i = 0; i < std::min(comparison.keys.size(), kMaxRows); ++i) {
    std::vector<TableCell> cells = {comparison.keys[i].key};
    for (const std::string& value : comparison.keys[i].values) cells.emplace_back(value.empty() ? "not given" : value);
    table.row(cells);
  }
  std::string note = "Equal quantities in different units do not count as a difference.";
  if (comparison.keys.size() > kMaxRows) {
    note += fmt::format(" The first {} of {} keys; comparison.csv has all.", kMaxRows, comparison.keys.size());
  }
  return block::section(kId, kHeading, table + block::remark(note));
}

std::string change_text(const ComparedResult& result, std::size_t folder) {
  const auto change = result.change(folder);
  if (!change) return "-";
  if (*change == 0.0) return "0";
  return std::abs(*change) < 5e-5 ? "< 0.01" : fmt::format("{:+.2f}", 100.0 * *change);
}

Table results_table(const FolderComparison& comparison, bool key) {
  Table table = with_folders({"", {TableColumn("Result"), TableColumn("Unit")}, "dense summary"}, comparison, false);
  for (std::size_t i = 1; i < comparison.folders.size(); ++i) {
    table.column(TableColumn::texts(comparison.folders.size() > 2 ? comparison.folders[i].name : "Change", "%"));
  }
  for (const ComparedResult& result : comparison.results) {
    if (result.key != key || table.rows.size() == kMaxRows) continue;
    const ShownUnit unit = shown_unit(result.name, result.unit);
    std::vector<TableCell> cells = {result.text, unit_label(unit)};
    for (const auto& value : result.values) cells.emplace_back(value ? number(*value * unit.factor) : "-");
    for (std::size_t i = 1; i < result.values.size(); ++i) cells.emplace_back(change_text(result, i));
    table.row(cells, result.max_relative_change() == 0.0 ? RowMark::soft : RowMark::none);
  }
  return table;
}

Blocks results_section(const FolderComparison& comparison) {
  return block::section("results", "Results",
                        results_table(comparison, true) +
                            block::folded("All other results", results_table(comparison, false), false) +
                            block::remark("Changes in per cent of the first column's value, the largest first; "
                                          "comparison.csv has the same rows."));
}

Blocks findings_part(const FolderComparison& comparison) {
  Table table = with_folders({"", {TableColumn("Finding"), TableColumn("Severity")}, "checks"}, comparison, true);
  for (const PartialFinding& partial : partial_findings(comparison)) {
    std::vector<TableCell> cells = {partial.finding.message, name(partial.finding.severity())};
    for (const bool has : partial.has) cells.emplace_back(has ? "yes" : "-");
    table.row(cells);
  }
  return block::section("findings", "Findings not common to all runs", table);
}

Blocks figures(const FolderComparison& comparison) {
  if (comparison.figures.empty()) return {};
  return block::section("figures", "Figures",
                        block::figure({"overlay", "Results of all folders, overlaid", {"all"}, true}));
}

Json figures_json(const FolderComparison& comparison) {
  Json names = Json::array(), figures = Json::array();
  for (const ComparedFolder& folder : comparison.folders) names.push_back(folder.name);
  for (const OverlaidFigure& figure : comparison.figures) {
    Json curves = Json::array();
    for (const OverlaidCurve& curve : figure.curves) {
      Json points = Json::array();
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        points.push_back(Json::array({json_number(curve.x[i]), json_number(curve.y[i])}));
      }
      curves.push_back({{"folder", curve.folder}, {"points", points}});
    }
    figures.push_back(
        {{"title", figure.title}, {"x_label", figure.x_label}, {"y_label", figure.y_label}, {"curves", curves}});
  }
  return {{"names", names}, {"figures", figures}};
}

std::string subject(const FolderComparison& comparison) {
  std::string names;
  for (const ComparedFolder& folder : comparison.folders) names += (names.empty() ? "" : ", ") + folder.name;
  return names;
}

}  // namespace

Document folder_comparison_document(const FolderComparison& comparison) {
  FrontPage front = make_front_page("Comparison of results", subject(comparison), std::nullopt, {});
  front.entries = {{"Folders", std::to_string(comparison.folders.size())},
                   {"Differing keys", std::to_string(comparison.keys.size())},
                   {"Compared with", comparison.folders.front().name},
                   {"Written", written_now()}};
  return {front.title + " - comparison",
          front_page(front),
          folders_section(comparison) + results_section(comparison) + findings_part(comparison) + figures(comparison) +
              keys_section(comparison),
          {{"overlay", figures_json(comparison)}}};
}

void write_folder_comparison_page(const FolderComparison& comparison, const std::filesystem::path& file) {
  write_page(folder_comparison_document(comparison), file);
}

}  // namespace overbend

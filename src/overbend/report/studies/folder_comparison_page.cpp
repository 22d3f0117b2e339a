#include "report/studies/folder_comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/finding.h"
#include "base/json.h"
#include "base/shown_unit.h"
#include "report/page/figure_list.h"
#include "report/page/front_page.h"
#include "report/page/html.h"
#include "report/page/json_number.h"
#include "report/page/page.h"
#include "report/page/sections.h"
#include "resultfiles/studies/folder_comparison_writer.h"

namespace overbend {
namespace {

constexpr std::size_t kMostRows = 400;

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

std::vector<html::Head> with_folders(std::vector<html::Head> head, const FolderComparison& comparison, bool text) {
  for (const ComparedFolder& folder : comparison.folders) head.push_back({folder.name, "", text});
  return head;
}

std::string folders_section(const FolderComparison& comparison) {
  html::Table table("",
                    {{"Results", "", true},
                     {"Model", "", true},
                     {"Kind", "", true},
                     {"Program", "", true},
                     {"Governing check", "", true},
                     {"Warnings", ""}},
                    "plain");
  for (const ComparedFolder& folder : comparison.folders) {
    table.row({folder.name, folder.title, word(folder.kind), folder.version,
               folder.governing.empty() ? "-" : folder.governing, std::to_string(folder.findings.size())});
  }
  std::string notes;
  for (const std::string& note : comparison.notes) notes += "<p>" + html::escape(note) + "</p>\n";
  return html::section("folders", "What is compared", table.str() + notes);
}

std::string keys_section(const FolderComparison& comparison) {
  if (comparison.keys.empty()) {
    return html::section("inputs", "Differences of the inputs", "<p>The model files say the same in every key.</p>\n");
  }
  html::Table table("", with_folders({{"Key", "", true}}, comparison, true), "plain");
  for (std::size_t i = 0; i < std::min(comparison.keys.size(), kMostRows); ++i) {
    std::vector<std::string> cells = {comparison.keys[i].key};
    for (const std::string& value : comparison.keys[i].values) cells.push_back(value.empty() ? "not given" : value);
    table.row(cells);
  }
  std::string note = "Equal quantities in other units are no difference.";
  if (comparison.keys.size() > kMostRows) {
    note += fmt::format(" The first {} of {} keys; comparison.csv has all.", kMostRows, comparison.keys.size());
  }
  return html::section("inputs", "Differences of the inputs", table.str() + "<p class=\"small\">" + note + "</p>\n");
}

std::string change_words(const ComparedResult& result, std::size_t folder) {
  const auto change = result.change(folder);
  if (!change) return "-";
  if (*change == 0.0) return "0";
  return std::abs(*change) < 5e-5 ? "< 0.01" : fmt::format("{:+.2f}", 100.0 * *change);
}

std::string results_table(const FolderComparison& comparison, bool key) {
  std::vector<html::Head> head = with_folders({{"Result", "", true}, {"Unit", "", true}}, comparison, false);
  for (std::size_t i = 1; i < comparison.folders.size(); ++i) {
    head.push_back({comparison.folders.size() > 2 ? comparison.folders[i].name : "Change", "%"});
  }
  html::Table table("", head, "dense summary");
  std::size_t rows = 0;
  for (const ComparedResult& result : comparison.results) {
    if (result.key != key || rows == kMostRows) continue;
    ++rows;
    const ShownUnit unit = shown_unit(result.name, result.unit);
    std::vector<std::string> cells = {result.text, text_of(unit)};
    for (const auto& value : result.values) cells.push_back(value ? number(*value * unit.factor) : "-");
    for (std::size_t i = 1; i < result.values.size(); ++i) cells.push_back(change_words(result, i));
    table.row(cells, result.largest_change() == 0.0 ? "soft" : "");
  }
  return rows == 0 ? "" : table.str();
}

std::string results_section(const FolderComparison& comparison) {
  std::string body = results_table(comparison, true);
  const std::string others = results_table(comparison, false);
  if (!others.empty()) body += html::folded("All other results", others, false);
  return html::section("results", "Results",
                       body +
                           "<p class=\"small\">Changes in per cent of the first column's value, the largest first; "
                           "comparison.csv has the same rows.</p>\n");
}

std::string findings_part(const FolderComparison& comparison) {
  const std::vector<PartialFinding> findings = partial_findings(comparison);
  if (findings.empty()) return "";
  html::Table table("", with_folders({{"Finding", "", true}, {"Severity", "", true}}, comparison, true), "checks");
  for (const PartialFinding& partial : findings) {
    std::vector<std::string> cells = {partial.finding.message, name(partial.finding.severity())};
    for (const bool has : partial.has) cells.emplace_back(has ? "yes" : "-");
    table.row(cells);
  }
  return html::section("findings", "Findings not common to all runs", table.str());
}

std::string figures(const FolderComparison& comparison) {
  static const std::vector<Figure> kFigures = {
      {"overlay", "Results of all folders laid over each other", {"all"}, true}};
  int number = 0;
  const auto always = [](const Figure&, const std::string&) { return true; };
  return comparison.figures.empty() ? "" : figure_section("figures", "Figures", figure_list(kFigures, always, number));
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

std::string folder_comparison_html(const FolderComparison& comparison) {
  const std::vector<std::pair<std::string, std::string>> entries = {
      {"Folders", std::to_string(comparison.folders.size())},
      {"Differing keys", std::to_string(comparison.keys.size())},
      {"Compared with", comparison.folders.front().name},
      {"Written", written_now()}};
  const std::string body = title_block("Comparison of results", subject(comparison), entries) +
                           folders_section(comparison) + results_section(comparison) + findings_part(comparison) +
                           figures(comparison) + keys_section(comparison);
  return overlay_frame(subject(comparison) + " - comparison", body, json_text({{"overlay", figures_json(comparison)}}));
}

void write_folder_comparison_page(const FolderComparison& comparison, const std::filesystem::path& file) {
  write_page(folder_comparison_html(comparison), file);
}

}  // namespace overbend

#include "report/studies/lay_table_page.h"

#include <fmt/format.h>

#include "report/page/figure_list.h"
#include "report/page/front_of.h"
#include "report/page/front_page.h"
#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/studies/lay_table_data.h"
#include "resultfiles/studies/lay_table_writer.h"

namespace overbend {
namespace {

std::string cell_text(const TableCell& cell, int digits) {
  if (const auto* number = std::get_if<double>(&cell)) return html::fixed(*number, digits);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* verdict = std::get_if<VerdictCell>(&cell)) return verdict->text;
  return "-";
}

bool is_text(const DataTable& data, std::size_t column) {
  for (const auto& row : data.rows) {
    if (std::holds_alternative<double>(row[column])) return false;
  }
  return true;
}

/// "top tension [kN]" as a name and a unit.
html::Head head_of(const std::string& heading, bool text) {
  const std::size_t unit = heading.find(" [");
  if (unit == std::string::npos) return {heading, "", text};
  return {heading.substr(0, unit), heading.substr(unit + 2, heading.size() - unit - 3), text};
}

/// Serious findings are too long for a cell: they stand below the table.
std::string short_remark(const LayTableRow& row) {
  return row.serious.empty() ? row.reason : row.reason + (row.reason.empty() ? "*" : " *");
}

std::string serious_remarks(const LayTable& table) {
  std::vector<std::string> list;
  const ShownUnit unit = shown_unit("", table.vary == LayTableVary::tension ? "N" : "m");
  for (const LayTableRow& row : table.rows) {
    if (row.serious.empty()) continue;
    std::string text = shown(row.varied, unit, 1) + ": ";
    for (const Finding& finding : row.serious) text += finding.message + (&finding == &row.serious.back() ? "." : "; ");
    list.push_back(std::move(text));
  }
  return list.empty() ? "" : "<h3>Remarks on rows marked *</h3>\n" + html::list(list);
}

std::string columns_table(const LayTable& table, const DataTable& data, const std::string& caption,
                          const std::vector<std::size_t>& columns) {
  std::vector<html::Head> heads;
  for (const std::size_t i : columns) heads.push_back(head_of(data.columns[i].heading, is_text(data, i)));
  html::Table out(caption, heads, "dense summary");
  for (std::size_t r = 0; r < data.rows.size(); ++r) {
    std::vector<std::string> cells;
    for (const std::size_t i : columns) {
      const bool remark = i + 1 == data.columns.size();
      cells.push_back(remark ? short_remark(table.rows[r]) : cell_text(data.rows[r][i], data.columns[i].digits));
    }
    const bool passed = table.rows[r].lay && table.rows[r].lay->passed();
    out.row(cells, passed ? "" : "over");
  }
  return out.str();
}

/// Two tables below each other: all columns in one would be wider than the page.
std::string rows_section(const LayTable& table) {
  const DataTable data = lay_table_data(table);
  std::vector<std::size_t> lay, carried;
  bool behind = false;
  for (std::size_t i = 0; i < data.columns.size(); ++i) {
    const std::string& heading = data.columns[i].heading;
    behind = behind || heading.starts_with("largest reaction");
    if (!behind) lay.push_back(i);
    const bool says_which = heading == "row" || heading.starts_with("tension") || heading.starts_with("depth");
    if (behind || says_which) carried.push_back(i);
  }
  return html::section("rows", "Lays",
                       columns_table(table, data, "Shape, stress and strain", lay) +
                           columns_table(table, data, "Reactions and checks", carried) +
                           "<p class=\"small\">Rows named least and largest are the limits within which every "
                           "governing check is passed, found by bisection to 0.1 %. The same rows are in "
                           "lay-table.csv and lay-table.xlsx.</p>\n" +
                           serious_remarks(table));
}

const LayTableRow* row_of(const LayTable& table, LayRowKind kind) {
  for (const LayTableRow& row : table.rows) {
    if (row.kind == kind) return &row;
  }
  return nullptr;
}

std::string varied_words(const LayTable& table, const LayTableRow& row) {
  const ShownUnit unit = shown_unit("", table.vary == LayTableVary::tension ? "N" : "m");
  return shown(row.varied, unit, 1);
}

/// What the table says, in sentences.
std::string summary_section(const LayTable& table) {
  std::vector<std::string> list;
  const char* what = table.vary == LayTableVary::tension    ? "tension"
                     : table.vary == LayTableVary::lay_back ? "lay-back"
                                                            : "water depth";
  for (const LayRowKind kind : {LayRowKind::least, LayRowKind::largest}) {
    const LayTableRow* row = row_of(table, kind);
    if (row == nullptr) continue;
    list.push_back(fmt::format("The {} {} with every governing check passed is {}; {}.",
                               kind == LayRowKind::least ? "least" : "largest", what, varied_words(table, *row),
                               row->reason));
  }
  std::size_t passed = 0, asked = 0;
  for (const LayTableRow& row : table.rows) {
    if (row.kind != LayRowKind::step) continue;
    ++asked;
    if (row.lay && row.lay->passed()) ++passed;
  }
  list.push_back(fmt::format("{} of {} rows pass every governing check.", passed, asked));
  return html::section("summary", "Summary", html::list(list));
}

std::string figures() {
  static const std::vector<Figure> kFigures = {
      {"lay_table",
       "The lays of the table; the range within which every governing check is passed is shaded",
       {"curves"},
       true}};
  int number = 0;
  const auto always = [](const Figure&, const std::string&) { return true; };
  return figure_section("figures", "Curves", figure_list(kFigures, always, number));
}

/// Vessel, pipe and depth of the model; nothing where the program can no longer read it.
std::vector<std::pair<std::string, std::string>> model_entries(const std::string& model_text) {
  const std::optional<Description> model = description_of(model_text);
  if (!model) return {};
  const SteelDescription& steel = model->pipe.section.steel;
  return {{"Vessel", model->vessel.name},
          {"Pipe", fmt::format("{} x {} steel", clearances().text(steel.outside_diameter, 1),
                               shown(steel.wall_thickness, section_length(), 2))},
          {"Water depth", shown(model->environment.water_depth, "m", 2)}};
}

}  // namespace

std::string lay_table_html(const LayTable& table, const std::string& model_text) {
  std::vector<std::pair<std::string, std::string>> entries = model_entries(model_text);
  entries.insert(entries.end(), {{"Rows", std::to_string(table.rows.size())},
                                 {"Status", status_words("completed", table.findings.size())},
                                 {"Program", "Overbend " + table.version},
                                 {"Written", written_now()}});
  const std::string body = title_block("Lay table", table.title, entries) + summary_section(table) +
                           findings_section(table.findings) + figures() + rows_section(table) +
                           assumptions_section(table.assumptions) + model_text_section(model_text);
  const Json data = {{"lay_table", lay_table_curves(table)}};
  return lay_table_frame(table.title + " - lay table", body, json_text(data));
}

void write_lay_table_page(const LayTable& table, const std::string& model_text, const std::filesystem::path& file) {
  write_page(lay_table_html(table, model_text), file);
}

}  // namespace overbend

#include "report/studies/lay_table_page.h"

#include <fmt/format.h>

#include "report/page/make_front_page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/studies/lay_table_data.h"
#include "resultfiles/studies/lay_table_writer.h"

namespace overbend {
namespace {

/// Serious findings are too long for a cell: they are listed below the table.
std::string short_remark(const LayTableRow& row) {
  return row.serious.empty() ? row.reason : row.reason + (row.reason.empty() ? "*" : " *");
}

std::string varied_quantity_text(const LayTable& table, const LayTableRow& row) {
  return shown(row.varied, table.vary == LayTableVary::tension ? "N" : "m", 1);
}

Blocks serious_remarks(const LayTable& table) {
  std::vector<std::string> list;
  for (const LayTableRow& row : table.rows) {
    if (row.serious.empty()) continue;
    std::string text = varied_quantity_text(table, row) + ": ";
    for (const Finding& finding : row.serious) text += finding.message + (&finding == &row.serious.back() ? "." : "; ");
    list.push_back(std::move(text));
  }
  if (list.empty()) return {};
  return block::subheading("Remarks on rows marked *") + block::list(list);
}

/// The lays with their short remarks and without coloured verdicts.
Table report_rows(const LayTable& table) {
  Table rows = lay_table_data(table);
  rows.look = "dense summary";
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    TableRow& row = rows.rows[i];
    if (!table.rows[i].lay || !table.rows[i].lay->passed()) row.mark = RowMark::over;
    row.cells.back() = short_remark(table.rows[i]);
    for (TableCell& cell : row.cells) {
      if (std::holds_alternative<std::monostate>(cell)) cell = "-";
      if (const auto* verdict = std::get_if<VerdictCell>(&cell)) cell = std::string(verdict->text);
    }
  }
  return rows;
}

Table with_columns(const Table& table, const std::string& title, const std::vector<std::size_t>& columns) {
  Table part{title, {}, table.look};
  for (const std::size_t i : columns) part.column(table.columns[i]);
  for (const TableRow& row : table.rows) {
    std::vector<TableCell> cells;
    for (const std::size_t i : columns) cells.push_back(row.cells[i]);
    part.row(std::move(cells), row.mark);
  }
  return part;
}

/// Two tables below each other: all columns in one would exceed the page width.
Blocks rows_section(const LayTable& table) {
  const Table rows = report_rows(table);
  std::vector<std::size_t> shape, carried;
  bool behind = false;
  for (std::size_t i = 0; i < rows.columns.size(); ++i) {
    const std::string& title = rows.columns[i].title;
    behind = behind || title == "largest reaction";
    if (!behind) shape.push_back(i);
    if (behind || title == "row" || title == "tension" || title == "depth") carried.push_back(i);
  }
  return block::section(
      "rows", "Lays",
      with_columns(rows, "Shape, stress and strain", shape) + with_columns(rows, "Reactions and checks", carried) +
          block::remark("Rows named least and largest are the limits within which every governing check passes, "
                        "found by bisection to 0.1 %. The same rows are in lay-table.csv and lay-table.xlsx.") +
          serious_remarks(table));
}

const LayTableRow* find_limit_row(const LayTable& table, LayRowKind kind) {
  for (const LayTableRow& row : table.rows) {
    if (row.kind == kind) return &row;
  }
  return nullptr;
}

/// Summary of the table in sentences.
Blocks summary_section(const LayTable& table) {
  std::vector<std::string> list;
  const char* what = table.vary == LayTableVary::tension    ? "tension"
                     : table.vary == LayTableVary::lay_back ? "lay-back"
                                                            : "water depth";
  for (const LayRowKind kind : {LayRowKind::minimum, LayRowKind::maximum}) {
    const LayTableRow* row = find_limit_row(table, kind);
    if (row == nullptr) continue;
    list.push_back(fmt::format("The {} {} with every governing check passed is {}; {}.",
                               kind == LayRowKind::minimum ? "least" : "largest", what,
                               varied_quantity_text(table, *row), row->reason));
  }
  std::size_t passed = 0, asked = 0;
  for (const LayTableRow& row : table.rows) {
    if (row.kind != LayRowKind::step) continue;
    ++asked;
    if (row.lay && row.lay->passed()) ++passed;
  }
  list.push_back(fmt::format("{} of {} rows pass every governing check.", passed, asked));
  return block::section("summary", "Summary", block::list(list));
}

Blocks figures() {
  return block::section("figures", "Curves",
                        block::figure({"lay_table",
                                       "The lays of the table; the range within which every governing check passes "
                                       "is shaded",
                                       {"curves"},
                                       true}));
}

/// Vessel, pipe and depth of the model; nothing if the model can no longer be read.
std::vector<std::pair<std::string, std::string>> model_entries(const std::string& model_text) {
  const std::optional<Description> model = read_description(model_text);
  if (!model) return {};
  const SteelDescription& steel = model->pipe.section.steel;
  return {{"Vessel", model->vessel.name},
          {"Pipe", fmt::format("{} x {} steel", clearances().text(steel.outside_diameter, 1),
                               shown(steel.wall_thickness, section_length(), 2))},
          {"Water depth", shown(model->environment.water_depth, "m", 2)}};
}

}  // namespace

Document lay_table_document(const LayTable& table, const std::string& model_text) {
  FrontPage front = make_front_page("Lay table", table.title, std::nullopt, table.findings);
  front.entries = model_entries(model_text);
  front.entries.insert(front.entries.end(), {{"Rows", std::to_string(table.rows.size())},
                                             {"Status", status_label("completed", table.findings.size())},
                                             {"Program", "Overbend " + table.version},
                                             {"Written", written_now()}});
  return {table.title + " - lay table",
          front_page(front),
          summary_section(table) + figures() + rows_section(table) + assumptions_section(table.assumptions) +
              model_text_section(model_text),
          {{"lay_table", lay_table_curves(table)}}};
}

void write_lay_table_page(const LayTable& table, const std::string& model_text, const std::filesystem::path& file) {
  write_page(lay_table_document(table, model_text), file);
}

}  // namespace overbend

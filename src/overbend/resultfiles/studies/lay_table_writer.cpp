#include "resultfiles/studies/lay_table_writer.h"

#include <cmath>
#include <stdexcept>

#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/json_fields.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/data_table.h"
#include "resultfiles/tables/xlsx_table.h"
#include "results/fields/lay_table_fields.h"
#include "results/tables/field_table.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

/// Empty cells in the place of those of a lay.
struct EmptyCells {
  std::vector<TableCell>& cells;
  template <class Value>
  void operator()(const ResultField& f, const Value&) {
    if (!f.heading.empty()) cells.emplace_back();
  }
};

std::vector<TableCell> make_cells(const LayTable& table, const LayTableRow& row) {
  std::vector<TableCell> cells;
  FieldCells visit{cells};
  visit_lay_table_place(table.vary, table.route, row, visit);
  if (row.lay) {
    visit_lay_table_values(*row.lay, visit);
  } else {
    EmptyCells empty{cells};
    const LayTableValues none;
    visit_lay_table_values(none, empty);
  }
  cells.emplace_back(VerdictCell{row.lay ? row.lay->verdict : VerdictKind::exceeded, lay_verdict(row)});
  cells.emplace_back(make_remark(row));
  return cells;
}

/// Columns of a row without a lay.
struct NoLay {
  TableWriter& table;
  void operator()(const ResultField& f, double) { table(f, std::optional<double>()); }
  void operator()(const ResultField& f, const std::optional<double>&) { table(f, std::optional<double>()); }
  void operator()(const ResultField& f, const std::string&) { table(f, std::string()); }
};

/// Throws if a number is not finite.
struct FiniteRow {
  void operator()(const ResultField& f, double value) const {
    if (!std::isfinite(value)) throw std::runtime_error("lay table: " + f.name + " is not finite");
  }
  void operator()(const ResultField& f, const std::optional<double>& value) const {
    if (value) (*this)(f, *value);
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) const {}
};

Json row_json(const LayTable& table, const LayTableRow& row) {
  JsonWriter<SummaryStyle> json;
  visit_lay_table_place(table.vary, table.route, row, json);
  if (row.lay) visit_lay_table_values(*row.lay, json);
  json["verdict"] = lay_verdict(row);
  json["reason"] = make_remark(row);
  json["solves"] = row.solves;
  return json.take();
}

}  // namespace

std::string lay_verdict(const LayTableRow& row) {
  if (!row.lay) return "no lay";
  return word(row.lay->verdict);
}

Table lay_table_data(const LayTable& table) {
  Table data{"lay table", {}};
  FieldColumns head{data.columns};
  const LayTableRow example;
  visit_lay_table_place(table.vary, table.route, example, head);
  const LayTableValues values;
  visit_lay_table_values(values, head);
  data.column(TableColumn("verdict")).column(TableColumn("remark"));
  for (const LayTableRow& row : table.rows) data.row(make_cells(table, row));
  return data;
}

void write_lay_table_groups(DatasetSink& file, const LayTable& table) {
  TableWriter rows;
  for (const LayTableRow& row : table.rows) {
    rows(index_field("Number of the row, from 0"), rows.rows());
    visit_lay_table_place(table.vary, table.route, row, rows);
    const LayTableValues none;
    if (row.lay) {
      visit_lay_table_values(*row.lay, rows);
    } else {
      NoLay visit{rows};
      visit_lay_table_values(none, visit);
    }
    rows(ResultField{"verdict", "1", "passed, reserved, exceeded, or no lay"}, lay_verdict(row));
    rows(ResultField{"reason", "1", "Reason for a missing lay, exceeded check, or limit of the range"},
         make_remark(row));
    rows.end_row();
  }
  rows.write(file, "/lay_table", "A lay in each row");
}

std::string lay_table_summary(const LayTable& table) {
  Json rows = Json::array();
  for (const LayTableRow& row : table.rows) rows.push_back(row_json(table, row));
  Json part = {{"vary", table.route ? "route" : word(table.vary)}};
  if (table.route) part["tension"] = word(table.tension);
  if (table.route || table.vary == LayTableVary::depth) part["held_tension"] = table.held_tension;
  part["rows"] = rows;
  part["solves"] = table.solves;
  part["wall_time"] = table.wall_time;
  const Json summary = {{"status", "completed"},
                        {"title", table.title},
                        {"version", table.version},
                        {"assumptions", texts(table.assumptions)},
                        {kAssumptionRanks, rank_names(table.assumptions)},
                        {"warnings", messages(table.findings)},
                        {"findings", findings_json(table.findings)},
                        {"units", "SI: m, N, Pa, rad, s; angles from horizontal"},
                        {"lay_table", part}};
  return summary_text(summary);
}

void write_lay_table_files(const LayTable& table, const std::filesystem::path& folder) {
  for (const LayTableRow& row : table.rows) {
    const FiniteRow finite;
    visit_lay_table_place(table.vary, table.route, row, finite);
    if (row.lay) visit_lay_table_values(*row.lay, finite);
  }
  const Table data = lay_table_data(table);
  write_text(folder / "lay-table.csv", csv_text(data));
  write_xlsx({data}, folder / "lay-table.xlsx");
  write_text(folder / "summary.json", lay_table_summary(table));
}

}  // namespace overbend

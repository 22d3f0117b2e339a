#include "report/static/checks_section.h"

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "report/page/calculation_sheet.h"
#include "report/page/json_number.h"
#include "resultfiles/static/check_tables.h"
#include "results/fields/location_names.h"
#include "results/fields/result_field.h"
#include "results/verdict.h"

namespace overbend {
namespace {

/// Four significant digits or more, without exponents.
std::string number(double value) {
  const double size = std::abs(value);
  return fixed(value, size >= 1000.0 ? 0 : size >= 100.0 ? 1 : size >= 1.0 ? 3 : 4);
}

/// Replaces the blank in a unit by a no-break space.
std::string with_no_break_space(std::string unit) {
  const std::size_t space = unit.find(' ');
  return space == std::string::npos ? unit : unit.replace(space, 1, "\u00a0");
}

std::string code_text(const CheckRow& row) {
  return row.clause.empty() ? row.code : row.code + ", " + row.clause;
}

std::string status_text(const CheckRow& row) {
  std::string text = row.governing ? word(row.status) : "for information";
  if (!row.governing && row.status != CheckStatus::passed) text += std::string(", ") + word(row.status);
  return row.remark.empty() ? text : text + ": " + row.remark;
}

RowMark row_mark(const CheckRow& row) {
  if (!row.governing) return RowMark::soft;
  return row.status == CheckStatus::exceeded ? RowMark::over : RowMark::none;
}

TableCell reserve(const CheckRow& row) {
  return row.reserve >= 999.0 ? TableCell("> 999") : TableCell(row.reserve);
}

/// By descending utilisation; checks that could not be judged are last.
std::vector<const CheckRow*> find_rows(const CheckTable& table, CheckRegion region) {
  std::vector<const CheckRow*> rows;
  for (const CheckRow& row : table.rows) {
    if (row.region == region) rows.push_back(&row);
  }
  const auto rank = [](const CheckRow* row) { return row->judged() ? (row->governing ? 0 : 1) : 2; };
  std::stable_sort(rows.begin(), rows.end(), [&](const CheckRow* a, const CheckRow* b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : a->utilisation > b->utilisation;
  });
  return rows;
}

TableCell time_cell(const CheckRow& row) {
  return row.in_time ? TableCell(row.time) : TableCell("static");
}

Table governing_table(const StaticResults& statics, const CheckTable& checks) {
  Table table{"Governing check of each region",
              {TableColumn("Region"),
               TableColumn("Check"),
               TableColumn("Code"),
               {"Utilisation", "-", 3},
               {"Reserve factor", "-", 2},
               TableColumn("Place"),
               {"Along pipe", "m", 1},
               {"Time", "s", 1},
               TableColumn("Status")},
              "checks"};
  for (const CheckRegion region : check_regions()) {
    const CheckRow* row = governing_check(checks, region);
    if (row == nullptr) continue;
    table.row({region_title(region), row->name, code_text(*row), row->utilisation, reserve(*row),
               location_name(statics, *row), along_pipe(statics, *row), time_cell(*row), word(row->status)},
              row_mark(*row));
  }
  return table;
}

/// Every check of a region with its position: along the laid pipe, or as text for lines, moorings and anchors.
Table region_table(const StaticResults& statics, const CheckTable& checks, CheckRegion region, bool along) {
  const auto add = [](std::vector<TableColumn>& all, const std::vector<TableColumn>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  std::vector<TableColumn> columns = {TableColumn("Check"), TableColumn("Code")};
  if (!along) add(columns, {TableColumn("Place")});
  add(columns, {TableColumn::texts("Demand"),
                TableColumn::texts("Capacity"),
                TableColumn("Unit"),
                {"Utilisation", "-", 3},
                {"Reserve factor", "-", 2}});
  if (along) add(columns, {{"Along pipe", "m", 1}, {"X", "m", 1}, {"Z", "m", 1}, {"Time", "s", 1}});
  add(columns, {TableColumn("Status")});
  Table table{along ? region_title(region) : "Checks of all lines, moorings and wires", columns, "checks"};
  for (const CheckRow* row : find_rows(checks, region)) {
    std::vector<TableCell> cells = {row->name, code_text(*row)};
    const bool done = row->status != CheckStatus::not_done;
    if (!along) cells.emplace_back(done ? location_name(statics, *row) : row->line);
    if (done) {
      const ShownUnit unit = check_unit(*row);
      cells.insert(cells.end(), {number(row->demand * unit.factor), number(row->capacity * unit.factor),
                                 with_no_break_space(std::string(unit.name)), row->utilisation, reserve(*row)});
    }
    if (done && along) {
      const Vec3 p = ship_point(statics, row->p_W);
      cells.insert(cells.end(), {along_pipe(statics, *row), p.x(), p.z(), time_cell(*row)});
    }
    cells.resize(columns.size() - 1);
    cells.emplace_back(status_text(*row));
    table.row(cells, row_mark(*row));
  }
  return table;
}

Table inputs_table(const CheckTable& checks) {
  Table table{"",
              {TableColumn("Check"), TableColumn("Region"), TableColumn("Symbol"), TableColumn("Meaning"),
               TableColumn::texts("Value"), TableColumn("Unit")},
              "dense"};
  for (const CheckRow& row : checks.rows) {
    std::string name = row.name + ", " + row.code;
    for (const CheckInput& input : row.inputs) {
      const ShownUnit unit = check_unit(input);
      table.row(
          {name, region_title(row.region), input.symbol, input.meaning, number(input.value * unit.factor), unit.name});
      name.clear();
    }
  }
  return table;
}

/// Summary of the table, and the meaning of its columns.
Blocks headline(const CheckTable& table) {
  return block::paragraph(make_verdict(table, {}).because +
                              " The reserve factor is the factor on the load effects, at unchanged pressure, at which "
                              "the utilisation is 1.",
                          kBasisOfChecks, "calculation-sheet");
}

}  // namespace

Blocks checks_section(const StaticResults& statics, const CheckTable& table) {
  if (table.rows.empty() && table.along.s.empty()) return {};
  Blocks body = headline(table);
  if (table.along.s.empty()) {
    body += region_table(statics, table, CheckRegion::line, false);
    return block::section("checks", "Code checks", body);
  }
  Figure figure = {
      "checks",
      "Utilisation of the code checks along the pipe: DNV displacement controlled (DNV strain) and load controlled "
      "(DNV load), simplified laying criteria (laying strain), equivalent stress over 0.87 f_y (stress), bending and "
      "external pressure (API RP 1111)",
      {"whole"}};
  if (!statics.supports.empty()) figure.parts.emplace_back("overbend");
  body += governing_table(statics, table) + block::figure(figure);
  for (const CheckRegion region : check_regions()) body += region_table(statics, table, region, true);
  return block::section("checks", "Code checks", body);
}

Blocks check_inputs_section(const CheckTable& table) {
  return block::section("check-inputs", "Appendix: input values of the checks",
                        block::folded("Input values of each check", inputs_table(table)));
}

Json checks_figure_data(const StaticResults& statics, const CheckTable& table) {
  if (table.along.s.empty()) return nullptr;
  Json data;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    Json column = Json::array();
    for (auto value = values.rbegin(); value != values.rend(); ++value) column.push_back(json_number(*value));
    data[name] = column;
  };
  std::vector<double> along;
  for (const double s : table.along.s) along.push_back(from_tensioner(statics, s));
  add("s", along);
  add("load", table.along.load);
  add("strain", table.along.strain);
  add("stress", table.along.stress);
  add("laying", table.along.laying);
  add("api", table.along.api);
  add("governing", table.along.governing);
  return data;
}

}  // namespace overbend

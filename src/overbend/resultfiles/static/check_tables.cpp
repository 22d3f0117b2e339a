#include "resultfiles/static/check_tables.h"

#include <limits>

#include "resultfiles/tables/csv_fields.h"
#include "results/fields/check_fields.h"

namespace overbend {
namespace {

std::string inputs_text(const CheckRow& row) {
  std::string text;
  for (const CheckInput& input : row.inputs) {
    if (!text.empty()) text += "; ";
    const ShownUnit unit = check_unit(input);
    text += fmt::format("{} = {:.6g}", input.symbol, input.value * unit.factor);
    if (!unit.name.empty()) text.append(" ").append(unit.name);
  }
  return text;
}

/// Writes numbers only for completed checks, demand and capacity in the units of the row.
struct CheckCells {
  CsvTable& table;
  const CheckRow& row;

  void operator()(const ResultField& f, double value) {
    if (f.heading.empty()) return;
    const bool absent = row.status == CheckStatus::not_done || (f.name == "time" && !row.in_time);
    const double factor = f.units == kVaries ? check_unit(row).factor : shown_unit(f).factor;
    table.cell(absent ? std::numeric_limits<double>::quiet_NaN() : value * factor);
  }
  void operator()(const ResultField& f, const Vec3& value) {
    for (int axis = 0; axis < 3; ++axis) (*this)(ResultField{f.name, f.units}.csv(f.heading), value(axis));
  }
  void operator()(const ResultField& f, const std::string& value) {
    if (f.heading.empty()) return;
    table.cell(f.name == "units" ? unit_label(check_unit(row)) : value);
  }
  void operator()(const ResultField& f, bool value) {
    if (!f.heading.empty()) table.cell(std::string(value ? "yes" : "for information"));
  }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField& f, Enum value) {
    if (!f.heading.empty()) table.cell(std::string(word(value)));
  }
};

/// Writes lines of a calculation sheet: values in SI, so that the formulas can be evaluated directly.
struct SheetCells {
  CsvTable& table;

  void operator()(const ResultField&, double value) { table.cell(value); }
  void operator()(const ResultField&, const std::string& value) { table.cell(value); }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField&, Enum value) {
    table.cell(std::string(word(value)));
  }
};

std::vector<std::string> checks_head() {
  CsvHead head;
  const CheckRow example{};
  visit_check(example, head);
  head.names.emplace_back("inputs");
  return head.names;
}

std::vector<std::string> sheet_head() {
  CsvHead head;
  head.names = {"check", "code", "clause", "region", "s [m]"};
  const SheetLine example{};
  visit_sheet_line(example, head);
  head.names.emplace_back("line");
  return head.names;
}

void add_check(const CheckRow& row, CsvTable& csv) {
  CheckCells cells{csv, row};
  visit_check(row, cells);
  csv.cell(inputs_text(row)).end_row();
}

void add_sheet_line(const CheckRow& row, const SheetLine& line, CsvTable& csv) {
  csv.cell(row.name);
  csv.cell(row.code);
  csv.cell(row.clause);
  csv.cell(std::string(word(row.region)));
  csv.cell(row.s);
  SheetCells cells{csv};
  visit_sheet_line(line, cells);
  csv.cell(row.line).end_row();
}

std::vector<std::string> with_stage(std::vector<std::string> head) {
  head.insert(head.begin(), "stage");
  return head;
}

}  // namespace

ShownUnit check_unit(const CheckRow& row) {
  return shown_unit(row.quantity, row.units);
}

ShownUnit check_unit(const CheckInput& input) {
  if (input.units == "m") return section_length();
  const bool factor = input.meaning.find("factor") != std::string::npos;
  return shown_unit(factor ? "" : input.meaning, input.units);
}

std::string checks_table(const CheckTable& table) {
  CsvTable csv(checks_head());
  for (const CheckRow& row : table.rows) add_check(row, csv);
  return csv.text();
}

std::string checks_table(const std::vector<StageChecks>& stages) {
  CsvTable csv(with_stage(checks_head()));
  for (const StageChecks& stage : stages) {
    for (const CheckRow& row : stage.checks.rows) {
      csv.cell(stage.stage);
      add_check(row, csv);
    }
  }
  return csv.text();
}

std::string calculation_sheet_table(const CheckTable& table) {
  CsvTable csv(sheet_head());
  for (const CheckRow& row : table.rows) {
    for (const SheetLine& line : row.sheet) add_sheet_line(row, line, csv);
  }
  return csv.text();
}

std::string calculation_sheet_table(const std::vector<StageChecks>& stages) {
  CsvTable csv(with_stage(sheet_head()));
  for (const StageChecks& stage : stages) {
    for (const CheckRow& row : stage.checks.rows) {
      for (const SheetLine& line : row.sheet) {
        csv.cell(stage.stage);
        add_sheet_line(row, line, csv);
      }
    }
  }
  return csv.text();
}

}  // namespace overbend

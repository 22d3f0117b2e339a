#include "resultfiles/studies/operability_table.h"

#include <array>

#include "base/units.h"

namespace overbend {
namespace {

constexpr std::array<const char*, 12> kMonths = {"January", "February", "March",     "April",   "May",      "June",
                                                 "July",    "August",   "September", "October", "November", "December"};

/// Column of values in the unit of the study file.
TableColumn input_column(const std::string& title, const std::string& unit) {
  return {title, ShownUnit{"", unit}, 3};
}

/// Returns the factor from SI to the unit shown.
double shown_factor(const std::string& unit, const std::string& show) {
  const std::optional<double> factor = show.empty() ? std::nullopt : unit_factor(show, unit);
  return factor ? 1.0 / *factor : 1.0;
}

TableCell make_cell(const std::optional<double>& value, double factor = 1.0) {
  return value ? TableCell(*value * factor) : TableCell();
}

TableCell axis_cell(const StudyInput& axis, std::size_t index) {
  if (axis.values.empty()) return axis.value_texts.at(index);
  return axis.values.at(index) * shown_factor(axis.unit, axis.show);
}

std::vector<TableCell> make_row(const OperabilityResults& results, const OperabilityCell& cell) {
  std::vector<TableCell> row;
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    row.push_back(axis_cell(results.axes[i], cell.value_indices.at(i)));
  }
  const double factor = shown_factor(results.unit, results.show);
  row.push_back(make_cell(cell.limit, factor));
  if (results.alpha) row.push_back(make_cell(cell.limit, *results.alpha * factor));
  row.emplace_back(limit_state_label(cell));
  row.emplace_back(cell.governing);
  const bool has_above = cell.decided && !cell.beyond;
  row.push_back(cell.limit && cell.below > 0.0 ? TableCell(cell.below) : TableCell());
  row.push_back(has_above && cell.above > 0.0 ? TableCell(cell.above) : TableCell());
  row.emplace_back(cell.runs);
  row.emplace_back(cell.reason);
  return row;
}

}  // namespace

std::string limit_state_label(const OperabilityCell& cell) {
  if (!cell.decided) return "not decided";
  if (!cell.limit) return "below the least";
  return cell.beyond ? "above the largest" : "limit";
}

Table operability_table(const OperabilityResults& results) {
  Table table{"operability", {}};
  for (const StudyInput& axis : results.axes) table.column(input_column(axis.key, axis.show));
  table.column(input_column("largest " + results.over, results.show));
  if (results.alpha) {
    table.column(input_column("alpha x largest (alpha = " + format_number(*results.alpha) + ")", results.show));
  }
  table.column(TableColumn("limit"))
      .column(TableColumn("governing"))
      .column({"utilisation at the limit", "", 3})
      .column({"utilisation above it", "", 3})
      .column({"analyses", "", 0})
      .column(TableColumn("remark"));
  for (const OperabilityCell& cell : results.cells) table.row(make_row(results, cell));
  return table;
}

Table workability_table(const OperabilityResults& results) {
  Table table{"workability", {TableColumn("month"), {"workable", "%", 1}}};
  const std::optional<Workability>& forecast = results.forecast_workability;
  if (forecast) table.column({"workable by forecast, with alpha", "%", 1});
  if (!results.workability) return table;
  const auto add = [&](const std::string& name, double part, const double* with_alpha) {
    std::vector<TableCell> row = {name, 100.0 * part};
    if (with_alpha != nullptr) row.emplace_back(100.0 * *with_alpha);
    table.row(std::move(row));
  };
  const std::vector<double>& months = results.workability->months;
  for (std::size_t i = 0; months.size() == kMonths.size() && i < months.size(); ++i) {
    add(kMonths[i], months[i], forecast ? &forecast->months.at(i) : nullptr);
  }
  add("year", results.workability->year, forecast ? &forecast->year : nullptr);
  add("outside the chart", results.workability->outside, forecast ? &forecast->outside : nullptr);
  return table;
}

}  // namespace overbend

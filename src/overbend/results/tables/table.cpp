#include "results/tables/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "results/result_enum_names.h"

namespace overbend {
namespace {

std::string number_text(const TableColumn& column, double value) {
  return fixed(value * column.factor, column.digits);
}

/// Number in the unit of its column, with four more decimals than shown.
Json number_json(const TableColumn& column, double value) {
  if (!std::isfinite(value)) return "-";
  const double scale = std::pow(10.0, column.digits + 4);
  const double shown = value * column.factor, rounded = std::round(shown * scale) / scale;
  if (!std::isfinite(rounded) || fixed(rounded, column.digits) != fixed(shown, column.digits)) return shown;
  return rounded == 0.0 ? Json(0) : Json(rounded);
}

Json column_json(const TableColumn& column) {
  Json json = {{"title", column.title}};
  if (!column.unit.empty()) json["unit"] = column.unit;
  if (column.is_text) {
    json["words"] = true;
  } else {
    json["digits"] = column.digits;
  }
  return json;
}

Json cell_json(const TableColumn& column, const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return number_json(column, *number);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* verdict = std::get_if<VerdictCell>(&cell)) {
    return {{"verdict", word(verdict->kind)}, {"text", verdict->text}};
  }
  return nullptr;
}

Json row_json(const Table& table, const TableRow& row) {
  Json cells = Json::array();
  for (std::size_t i = 0; i < row.cells.size(); ++i) cells.push_back(cell_json(table.columns[i], row.cells[i]));
  return cells;
}

/// Group headings above the columns with their spans; none without groups.
Json groups_json(const Table& table) {
  Json groups = Json::array();
  bool any = false;
  for (const TableColumn& column : table.columns) {
    any = any || !column.group.empty();
    if (groups.empty() || groups.back()[0] != column.group) groups.push_back({column.group, 0});
    groups.back()[1] = groups.back()[1].get<int>() + 1;
  }
  return any ? groups : Json();
}

bool says_nothing(const TableCell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return std::holds_alternative<std::monostate>(cell) || (text != nullptr && text->empty());
}

/// Returns the number of characters, not bytes: continuation bytes of UTF-8 are not counted.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string room(width - letters(text), ' ');
  return left ? text + room : room + text;
}

}  // namespace

TableColumn::TableColumn(std::string heading, const ShownUnit& shown, int decimals)
    : title(std::move(heading)), unit(shown.name), factor(shown.factor), digits(std::max(0, decimals + shown.more)) {}

TableColumn::TableColumn(std::string heading, std::string_view si, int decimals)
    : TableColumn(std::move(heading), shown_unit(si), decimals) {}

TableColumn TableColumn::texts(std::string heading, std::string_view unit) {
  TableColumn column(std::move(heading));
  column.unit = unit;
  column.is_text = false;
  return column;
}

Table& Table::column(TableColumn column) {
  columns.push_back(std::move(column));
  return *this;
}

Table& Table::groups(const std::vector<std::pair<std::string, int>>& spans) {
  std::size_t i = 0;
  for (const auto& [heading, span] : spans) {
    for (int k = 0; k < span && i < columns.size(); ++k) columns[i++].group = heading;
  }
  return *this;
}

Table Table::with_columns(const std::vector<std::string_view>& keys) const {
  Table chosen{title, {}, look, std::vector<TableRow>(rows.size())};
  for (const std::string_view key : keys) {
    const auto found = ranges::find(columns, key, &TableColumn::key);
    if (found == columns.end()) continue;
    const auto place = static_cast<std::size_t>(found - columns.begin());
    chosen.columns.push_back(*found);
    for (std::size_t i = 0; i < rows.size(); ++i) chosen.rows[i].cells.push_back(rows[i].cells[place]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) chosen.rows[i].mark = rows[i].mark;
  return chosen;
}

Table& Table::drop_empty_columns() {
  for (std::size_t i = columns.size(); i-- > 0;) {
    const auto empty_there = [i](const TableRow& row) { return says_nothing(row.cells[i]); };
    if (!std::all_of(rows.begin(), rows.end(), empty_there)) continue;
    columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(i));
    for (TableRow& row : rows) row.cells.erase(row.cells.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return *this;
}

Table& Table::row(std::vector<TableCell> cells, RowMark mark) {
  rows.push_back({std::move(cells), mark});
  return *this;
}

std::string title_with_unit(const TableColumn& column) {
  return column.unit.empty() ? column.title : column.title + " [" + column.unit + "]";
}

std::string cell_text(const TableColumn& column, const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return number_text(column, *number);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* verdict = std::get_if<VerdictCell>(&cell)) return verdict->text;
  return "";
}

Json table_json(const Table& table) {
  Json json = {{"title", table.title}, {"look", table.look}, {"columns", Json::array()}, {"rows", Json::array()}};
  for (const TableColumn& column : table.columns) json["columns"].push_back(column_json(column));
  if (Json groups = groups_json(table); !groups.is_null()) json["groups"] = std::move(groups);
  for (const TableRow& row : table.rows) json["rows"].push_back(row_json(table, row));
  const bool marked =
      std::any_of(table.rows.begin(), table.rows.end(), [](const TableRow& row) { return row.mark != RowMark::none; });
  if (marked) {
    for (const TableRow& row : table.rows) json["marks"].push_back(name(row.mark));
  }
  return json;
}

Json described_table_json(const Table& table) {
  Json json = table_json(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (!table.columns[i].key.empty()) json["columns"][i]["key"] = table.columns[i].key;
    if (!table.columns[i].description.empty()) json["columns"][i]["description"] = table.columns[i].description;
  }
  return json;
}

std::string table_text(const Table& table, int indent) {
  if (table.empty()) return "";
  const std::size_t count = table.columns.size();
  std::vector<std::vector<std::string>> lines(1);
  for (const TableColumn& column : table.columns) {
    const std::string heading = column.group.empty() ? column.title : column.group + " " + column.title;
    lines.front().push_back(column.unit.empty() ? heading : heading + " " + column.unit);
  }
  for (const TableRow& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back(count);
    for (std::size_t i = 0; i < row.cells.size(); ++i) line[i] = cell_text(table.columns[i], row.cells[i]);
  }
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string written(static_cast<std::size_t>(indent), ' ');
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t width = 0;
      for (const std::vector<std::string>& candidate : lines) width = std::max(width, letters(candidate[i]));
      written += (i == 0 ? "" : "  ") + padded(line[i], width, table.columns[i].is_text);
    }
    text += written.substr(0, written.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

const char* name(RowMark mark) {
  constexpr std::array<const char*, 5> kNames = {"", "over", "soft", "total", "loaded"};
  return kNames[static_cast<std::size_t>(mark)];
}

}  // namespace overbend

#include "seafiles/motion_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "seafiles/column_title.h"
#include "seafiles/motion_record_checks.h"

namespace overbend {
namespace {

constexpr std::array<std::string_view, 6> kFreedomNames = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
constexpr const char* kColumnsHint =
    "motion.columns: {'title in the file': heave_m} names a column, {'title in the file': unused} leaves it out";

class ColumnFinder {
 public:
  ColumnFinder(const ExportedTable& table, const MotionColumns& keys, const std::string& path, Diagnostics& diagnostics)
      : table_(table), header_(table.rows.front()), keys_(keys), path_(path), diagnostics_(diagnostics) {}

  std::optional<std::vector<MotionColumn>> find() {
    for (std::size_t i = 0; i < header_.cells.size() && good_; ++i) take(i);
    if (good_) check_keys();
    if (good_) check_columns();
    if (!good_) return std::nullopt;
    if (!unused_.empty()) {
      add_notice(diagnostics_, path_, 0, "columns that are not used: " + join_items(unused_, "and"));
    }
    return std::move(columns_);
  }

 private:
  void complain(std::string found, std::string expected, std::string hint = {}) {
    good_ = false;
    diagnostics_.add(
        {Severity::error, path_, header_.line, 0, "", std::move(found), std::move(expected), std::move(hint)});
  }

  /// Returns the meaning of a column from the keys of the model; null without one.
  const std::string* keyed(std::string_view cell, const ColumnTitle& title) {
    for (const auto& [name, meaning] : keys_) {
      const std::string key = lower_case(trim(name));
      if (key != lower_case(cell) && key != title.name) continue;
      used_keys_.push_back(name);
      return &meaning;
    }
    return nullptr;
  }

  void take(std::size_t i) {
    const std::string shown = for_display(header_.cells[i]);
    ColumnTitle title = parse_column_title(header_.cells[i]);
    std::vector<std::string> units = {title.unit, bare_unit(table_.unit(i))};
    MotionColumn column;
    if (const std::string* meaning = keyed(header_.cells[i], title)) {
      if (lower_case(trim(*meaning)) == kUnusedColumn) {
        unused_.push_back(shown);
        columns_.push_back(column);
        return;
      }
      title = parse_column_title(*meaning);
      units.insert(units.begin(), title.unit);
    }
    if (!identify(title, column)) {
      return complain("a column '" + shown + "'" + (title.name == lower_case(shown) ? "" : " for '" + title.name + "'"),
                      join_choices(names()), kColumnsHint);
    }
    take_unit(shown, units, column);
    check_repeated(column);
    columns_.push_back(std::move(column));
  }

  static std::vector<std::string> names() {
    std::vector<std::string> names = {"time_s"};
    names.insert(names.end(), kMotionColumns.begin(), kMotionColumns.end());
    return names;
  }

  static bool identify(const ColumnTitle& title, MotionColumn& column) {
    column.is_unix = is_unix_title(title);
    if (is_time_title(title)) {
      column.quantity = MotionColumn::Quantity::time;
      column.label = "time_s";
      return true;
    }
    const auto freedom = ranges::find(kFreedomNames, title.name);
    if (freedom == kFreedomNames.end()) return false;
    column.quantity = MotionColumn::Quantity::freedom;
    column.freedom = static_cast<std::size_t>(freedom - kFreedomNames.begin());
    column.label = kMotionColumns[column.freedom];
    return true;
  }

  /// Takes the unit that is stated; reports units that contradict each other or are of another dimension.
  void take_unit(const std::string& shown, const std::vector<std::string>& units, MotionColumn& column) {
    const bool time = column.quantity == MotionColumn::Quantity::time;
    const char* si_unit = time ? "s" : column.freedom < 3 ? "m" : "rad";
    std::optional<double> factor;
    for (const std::string& unit : units) {
      if (unit.empty() || unit == "-") continue;
      const std::optional<double> value = title_unit_factor(unit, si_unit);
      if (!value && time) continue;  // the pattern of a date, or the zone of a clock
      if (!value) {
        return complain("the unit '" + for_display(unit) + "' of " + shown,
                        column.freedom < 3 ? "a unit of length" : "deg or rad");
      }
      if (factor && std::abs(*factor - *value) > 1e-9 * *value) {
        return complain("two units of " + shown + ": " + for_display(column.unit) + " and " + for_display(unit),
                        "one unit");
      }
      factor = value;
      column.unit = unit;
    }
    if (time) return;
    if (!factor) without_unit_.push_back(shown);
    column.factor = factor.value_or(1.0);
    const std::string usual = column.freedom < 3 ? "m" : "deg";
    if (factor && column.unit != usual && *factor != *title_unit_factor(usual, si_unit)) {
      add_notice(diagnostics_, path_, 0, shown + " is converted from " + column.unit + " to " + usual);
    }
  }

  void check_repeated(const MotionColumn& column) {
    const bool repeated = ranges::any_of(columns_, [&](const MotionColumn& before) {
      return before.quantity == column.quantity && before.freedom == column.freedom;
    });
    if (repeated) complain("the column '" + column.label + "' twice", "each column once");
  }

  void check_keys() {
    for (const auto& [name, meaning] : keys_) {
      if (ranges::find(used_keys_, name) != used_keys_.end()) continue;
      std::vector<std::string> titles;
      for (const std::string_view cell : header_.cells) titles.push_back(for_display(cell));
      complain("no column '" + for_display(name) + "', which motion.columns names",
               "a title of the file: " + join_items(titles, "or"));
    }
  }

  void check_columns() {
    const bool timed = ranges::any_of(
        columns_, [](const MotionColumn& column) { return column.quantity == MotionColumn::Quantity::time; });
    if (!timed) return complain("a header without time_s", "time_s and the degrees of freedom", kColumnsHint);
    if (without_unit_.empty()) return;
    complain((without_unit_.size() > 1 ? "columns" : "a column") + std::string(" without a unit: ") +
                 join_items(without_unit_, "and"),
             "units in the titles, such as heave_m or roll_deg, or in a line below them", kColumnsHint);
  }

  const ExportedTable& table_;
  const TextRow& header_;
  const MotionColumns& keys_;
  const std::string& path_;
  Diagnostics& diagnostics_;
  std::vector<MotionColumn> columns_;
  std::vector<std::string> unused_, without_unit_, used_keys_;
  bool good_ = true;
};

}  // namespace

std::optional<std::vector<MotionColumn>> find_motion_columns(const ExportedTable& table, const MotionColumns& keys,
                                                             const std::string& path, Diagnostics& diagnostics) {
  return ColumnFinder(table, keys, path, diagnostics).find();
}

}  // namespace overbend

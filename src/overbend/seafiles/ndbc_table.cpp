#include "seafiles/ndbc_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string_view> split(std::string_view line) {
  const TextTable table = split_table(line, ' ');
  return table.rows.empty() ? std::vector<std::string_view>{} : table.rows.front().cells;
}

/// Cells of the header, without its '#'.
std::vector<std::string_view> header_cells(std::string_view line) {
  line = trim(line);
  if (line.starts_with('#')) line.remove_prefix(1);
  return split(line);
}

/// Returns the number in a cell, NaN for a missing value; empty if it is no number.
std::optional<double> cell_value(std::string_view cell, NdbcMissing missing) {
  if (cell == "MM") return kMissing;
  const std::optional<double> value = cell_number(cell);
  if (!value) return std::nullopt;
  const bool absent = *value == 999.0 || (missing == NdbcMissing::two_or_three_nines && *value == 99.0);
  return absent ? kMissing : *value;
}

std::string spelled(std::string_view cell) {
  return "'" + for_display(cell) + "'";
}

class RowReader {
 public:
  RowReader(const std::string& path, const TextRow& row, NdbcMissing missing, Diagnostics& diagnostics)
      : path_(path), row_(row), missing_(missing), diagnostics_(diagnostics) {
    out_.line = row.line;
  }

  std::optional<NdbcSpectrumRow> table(const std::vector<std::string_view>& columns, std::size_t date_columns) {
    if (row_.cells.size() != columns.size()) {
      return reject("", std::to_string(row_.cells.size()) + " cells",
                    std::to_string(columns.size()) + ", as the header");
    }
    for (std::size_t i = date_columns; i < columns.size(); ++i) {
      if (!add(columns[i], row_.cells[i])) return std::nullopt;
    }
    return ordered();
  }

  /// The separation frequency of densities is alone, without a frequency in brackets.
  std::optional<NdbcSpectrumRow> pairs(std::size_t date_columns) {
    std::size_t i = date_columns;
    const auto in_brackets = [&](std::size_t k) { return k < row_.cells.size() && row_.cells[k].starts_with('('); };
    if (i + 1 < row_.cells.size() && !in_brackets(i + 1)) ++i;
    for (; i < row_.cells.size(); i += 2) {
      const std::string_view value = row_.cells[i];
      if (!in_brackets(i + 1) || !row_.cells[i + 1].ends_with(')')) {
        return reject("", spelled(value) + " without a frequency in brackets", "pairs such as 0.014 (0.048)");
      }
      const std::string_view frequency = row_.cells[i + 1];
      if (!add(frequency.substr(1, frequency.size() - 2), value)) return std::nullopt;
    }
    return ordered();
  }

 private:
  std::nullopt_t reject(const std::string& key, std::string found, std::string expected) {
    diagnostics_.add({Severity::error, path_, row_.line, 0, key, std::move(found), std::move(expected), ""});
    return std::nullopt;
  }

  bool add(std::string_view frequency, std::string_view value) {
    const std::optional<double> hertz = cell_number(frequency), number = cell_value(value, missing_);
    if (!hertz || !(*hertz > 0.0)) reject("", spelled(frequency), "a frequency in Hz");
    if (!number) reject(for_display(frequency) + " Hz", spelled(value), "a number, or MM for a missing value");
    if (!hertz || !(*hertz > 0.0) || !number) return false;
    out_.frequencies.push_back(*hertz);
    out_.values.push_back(*number);
    written_.push_back(frequency);
    return true;
  }

  /// Checks that the frequencies increase, and names the one that is out of order.
  std::optional<NdbcSpectrumRow> ordered() {
    const std::vector<double>& f = out_.frequencies;
    if (f.size() < 2) return reject("", std::to_string(f.size()) + " frequencies", "at least 2");
    for (std::size_t i = 1; i < f.size(); ++i) {
      if (f[i] > f[i - 1]) continue;
      const bool previous = i >= 2 && f[i] > f[i - 2];  // the one before it is out of order
      const std::size_t wrong = previous ? i - 1 : i;
      const std::string after = wrong + 1 < f.size() ? " and " + for_display(written_[wrong + 1]) : "";
      return reject(
          "", "the frequency " + for_display(written_[wrong]) + " between " + for_display(written_[wrong - 1]) + after,
          "increasing frequencies");
    }
    return std::move(out_);
  }

  const std::string& path_;
  const TextRow& row_;
  NdbcMissing missing_;
  Diagnostics& diagnostics_;
  NdbcSpectrumRow out_;
  std::vector<std::string_view> written_;  ///< Frequencies as written.
};

NdbcTable::Kind find_kind(const std::vector<std::string_view>& columns, std::size_t date_columns) {
  const auto numbers = static_cast<std::size_t>(std::count_if(
      columns.begin(), columns.end(), [](std::string_view cell) { return cell_number(cell).has_value(); }));
  if (numbers > 0 && numbers + date_columns == columns.size()) return NdbcTable::Kind::table;
  const bool pairs =
      std::any_of(columns.begin(), columns.end(), [](std::string_view cell) { return cell == "(freq_1)"; });
  return pairs ? NdbcTable::Kind::pairs : NdbcTable::Kind::sea_states;
}

std::optional<FileTime> row_time(const TextRow& row, std::size_t date_columns) {
  if (row.cells.size() < date_columns) return std::nullopt;
  std::string text;
  for (std::size_t i = 0; i < date_columns; ++i) text += std::string(row.cells[i]) + " ";
  return parse_file_time(text);
}

}  // namespace

bool NdbcTable::has(std::string_view column) const {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

std::string_view NdbcTable::cell(std::size_t row, std::string_view column) const {
  const auto found = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  return found < rows[row].cells.size() && found < columns.size() ? rows[row].cells[found] : std::string_view();
}

std::optional<double> NdbcTable::value(std::size_t row, std::string_view column) const {
  const NdbcMissing missing = column == "MWD" ? NdbcMissing::three_nines : NdbcMissing::two_or_three_nines;
  const std::optional<double> value = cell_value(cell(row, column), missing);
  return value && !std::isnan(*value) ? value : std::nullopt;
}

std::optional<NdbcSpectrumRow> NdbcTable::spectrum_row(std::size_t row, NdbcMissing missing, const std::string& path,
                                                       Diagnostics& diagnostics) const {
  RowReader reader(path, rows[row], missing, diagnostics);
  return kind == Kind::table ? reader.table(columns, date_columns) : reader.pairs(date_columns);
}

bool is_ndbc_header(std::string_view line) {
  const std::vector<std::string_view> cells = header_cells(line);
  const auto is = [&](std::size_t i, std::initializer_list<std::string_view> names) {
    return i < cells.size() && std::find(names.begin(), names.end(), cells[i]) != names.end();
  };
  return is(0, {"YY", "YYYY", "yr"}) && is(1, {"MM", "mo"}) && is(2, {"DD", "dy"}) && is(3, {"hh", "hr"});
}

std::optional<NdbcTable> split_ndbc(std::string_view text, const std::string& path, Diagnostics& diagnostics) {
  const auto reject = [&](int line, std::string found, std::string expected) {
    diagnostics.add({Severity::error, path, line, 0, "", std::move(found), std::move(expected), ""});
    return std::nullopt;
  };
  const std::string_view first = text.substr(0, text.find('\n'));
  if (!is_ndbc_header(first)) return reject(1, "'" + for_display(trim(first)) + "'", "a header #YY MM DD hh mm");
  NdbcTable table;
  table.columns = header_cells(first);
  table.date_columns = table.columns.size() > 4 && table.columns[4] == "mm" ? 5 : 4;
  table.kind = find_kind(table.columns, table.date_columns);
  for (TextRow& row : split_table(text, ' ').rows) {
    if (row.line == 1 || row.cells.front() == "yr") continue;  // headers of old files have no '#'
    const std::optional<FileTime> time = row_time(row, table.date_columns);
    if (!time) return reject(row.line, "'" + for_display(row.cells.front()) + " ...'", "a row that begins with a date");
    if (table.kind == NdbcTable::Kind::sea_states && row.cells.size() != table.columns.size()) {
      return reject(row.line, std::to_string(row.cells.size()) + " cells",
                    std::to_string(table.columns.size()) + ", as in the header");
    }
    table.times.push_back(*time);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace overbend

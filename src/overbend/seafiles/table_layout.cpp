#include "seafiles/table_layout.h"

#include <algorithm>
#include <cctype>

#include "base/interruption.h"
#include "base/ranges.h"
#include "base/text.h"
#include "seafiles/column_title.h"

namespace overbend {
namespace {

constexpr std::size_t kSampleLines = 40;  ///< Number of lines from which the separator is recognised.
constexpr int kLinesBetweenChecks = 10000;
constexpr std::string_view kSeparatorLine = "sep=";  ///< First line of a table for a spreadsheet: "sep=;".

struct Line {
  int number = 0;
  std::string_view text;
};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Returns the lines that are neither empty nor comments, trimmed of blanks and line ends but not of tabs. Comments go
/// to `remarks`.
std::vector<Line> content_lines(std::string_view text, std::vector<TextRow>& remarks) {
  std::vector<Line> lines;
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    std::string_view line = text.substr(from, to - from);
    from = to + 1;
    if (++number % kLinesBetweenChecks == 0) check_interruption();
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    const std::string_view content = trim(line);
    if (content.empty()) continue;
    if (content.front() == '#') {
      remarks.push_back({number, split_remark(content)});
    } else {
      lines.push_back({number, line});
    }
  }
  return lines;
}

/// Returns true if the first line and nearly all of those after it contain the character outside quotes; a damaged line
/// does not change the layout of a file.
bool separates(const std::vector<Line>& lines, char c) {
  constexpr double kNearlyAll = 0.8;
  const std::size_t count = std::min(lines.size(), kSampleLines);
  const auto contains = [c](const Line& line) {
    bool quoted = false;
    return ranges::any_of(line.text, [&](char next) {
      quoted = quoted != (next == '"');
      return next == c && !quoted;
    });
  };
  if (!contains(lines.front())) return false;
  const auto found = std::count_if(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count), contains);
  return static_cast<double>(found) >= kNearlyAll * static_cast<double>(count);
}

/// Returns true if a cell holds several numbers separated by blanks.
bool has_numbers_inside(std::string_view cell) {
  const std::vector<std::string_view> parts = split_line(cell, ' ', false);
  return parts.size() > 1 && ranges::all_of(parts, [](std::string_view part) { return cell_number(part).has_value(); });
}

/// Returns true if the last of the first lines has cells with several numbers: blanks separate, not `c`.
bool blanks_separate_within(const std::vector<Line>& lines, char c) {
  const Line& line = lines[std::min(lines.size(), kSampleLines) - 1];
  return ranges::any_of(split_line(line.text, c, true), has_numbers_inside);
}

char recognise_separator(const std::vector<Line>& lines) {
  for (const char c : {'\t', ';', ','}) {
    if (!separates(lines, c)) continue;
    return c != ';' && blanks_separate_within(lines, c) ? ' ' : c;
  }
  const auto sample = lines.begin() + static_cast<std::ptrdiff_t>(std::min(lines.size(), kSampleLines));
  const bool blanks =
      std::all_of(lines.begin(), sample, [](const Line& line) { return split_line(line.text, ' ', false).size() > 1; });
  return blanks ? ' ' : ',';
}

/// Signs of numbers between digits in a cell.
struct DecimalSigns {
  bool comma = false, point = false;
  bool thousands = true;  ///< True if the commas may be thousands separators.
};

/// Returns the decimal signs of a cell with a number, a range or a percentage; none of other cells.
DecimalSigns decimal_signs(std::string_view cell) {
  DecimalSigns signs;
  if (cell.find_first_not_of("0123456789+-.,eE% ") != std::string_view::npos) return signs;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    if (!is_digit(cell[i - 1]) || !is_digit(cell[i + 1])) continue;
    signs.point = signs.point || cell[i] == '.';
    if (cell[i] != ',') continue;
    signs.comma = true;
    const std::size_t after = cell.find_first_not_of("0123456789", i + 1);
    const std::size_t digits = std::min(after, cell.size()) - i - 1;
    std::size_t start = i;
    while (start > 0 && is_digit(cell[start - 1])) --start;
    if (digits != 3 || i - start > 3 || cell[start] == '0') signs.thousands = false;
  }
  return signs;
}

/// Finds the decimal sign of the table.
class DecimalSignFinder {
 public:
  DecimalSignFinder(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  /// Returns true for commas; reports mixed signs and commas that may separate thousands, and returns nothing.
  std::optional<bool> find(const ExportedTable& table) {
    if (table.separator == ',') return false;
    for (const TextRow& row : table.rows) {
      for (const std::string_view cell : row.cells) take(row.line, cell);
    }
    if (!comma_) return false;
    if (point_) {
      return reject(std::max(comma_->line, point_->line), quoted(*comma_) + " and " + quoted(*point_),
                    "one decimal sign in a file");
    }
    if (thousands_ && table.separator != ';') {
      return reject(comma_->line, quoted(*comma_) + ", with a comma that separates thousands or decimals",
                    "numbers without thousands separators, or semicolons between the cells");
    }
    return true;
  }

 private:
  struct Example {
    int line = 0;
    std::string_view cell;
  };
  static std::string quoted(const Example& example) { return "'" + for_display(example.cell) + "'"; }

  void take(int line, std::string_view cell) {
    const DecimalSigns signs = decimal_signs(cell);
    if (signs.comma && !comma_) comma_ = {line, cell};
    if (signs.point && !point_) point_ = {line, cell};
    thousands_ = thousands_ && (!signs.comma || signs.thousands);
  }

  std::nullopt_t reject(int line, std::string found, std::string expected) {
    diagnostics_.add({Severity::error, path_, line, 0, "", std::move(found), std::move(expected), ""});
    return std::nullopt;
  }

  const std::string& path_;
  Diagnostics& diagnostics_;
  std::optional<Example> comma_, point_;
  bool thousands_ = true;
};

/// Returns the text with decimal points between digits in place of commas, in the cells of the table.
std::shared_ptr<const std::string> with_decimal_points(std::string_view text) {
  auto changed = std::make_shared<std::string>(text);
  for (std::size_t i = 1; i + 1 < changed->size(); ++i) {
    if ((*changed)[i] == ',' && is_digit((*changed)[i - 1]) && is_digit((*changed)[i + 1])) (*changed)[i] = '.';
  }
  return changed;
}

bool is_empty_row(const TextRow& row) {
  return ranges::all_of(row.cells, [](std::string_view cell) { return cell.empty(); });
}

std::vector<TextRow> split_rows(const std::vector<Line>& lines, char separator) {
  std::vector<TextRow> rows;
  rows.reserve(lines.size());
  for (const Line& line : lines) {
    if (line.number % kLinesBetweenChecks == 0) check_interruption();
    TextRow row{line.number, split_line(line.text, separator, true)};
    if (!is_empty_row(row)) rows.push_back(std::move(row));
  }
  return rows;
}

/// Drops empty cells beyond the columns of the header, and of rows without header all empty cells at the end.
void drop_empty_columns(ExportedTable& table) {
  if (table.rows.empty()) return;
  const auto trimmed = [](const TextRow& row, std::size_t width) {
    std::size_t size = row.cells.size();
    while (size > width && row.cells[size - 1].empty()) --size;
    return size;
  };
  table.width = trimmed(table.rows.front(), 0);
  for (TextRow& row : table.rows) row.cells.resize(trimmed(row, table.has_header ? table.width : 0));
}

bool is_unit_row(const TextRow& row) {
  bool any = false;
  for (const std::string_view cell : row.cells) {
    if (cell.empty()) continue;
    if (!is_unit_cell(cell)) return false;
    any = true;
  }
  return any;
}

void take_unit_row(ExportedTable& table) {
  if (!table.has_header || table.rows.size() < 2 || !is_unit_row(table.rows[1])) return;
  table.units = std::move(table.rows[1]);
  table.rows.erase(table.rows.begin() + 1);
}

}  // namespace

std::string_view ExportedTable::unit(std::size_t column) const {
  return column < units.cells.size() ? units.cells[column] : std::string_view();
}

std::optional<ExportedTable> read_exported_table(std::string_view text, const std::string& path,
                                                 Diagnostics& diagnostics) {
  ExportedTable table;
  std::vector<Line> lines = content_lines(text, table.remarks);
  if (lines.empty()) return table;
  const bool stated =
      lines.front().text.size() == kSeparatorLine.size() + 1 && lines.front().text.starts_with(kSeparatorLine);
  table.separator = stated ? lines.front().text.back() : recognise_separator(lines);
  if (stated) lines.erase(lines.begin());
  table.rows = split_rows(lines, table.separator);
  const std::optional<bool> comma = DecimalSignFinder(path, diagnostics).find(table);
  if (!comma) return std::nullopt;
  table.decimal_comma = *comma;
  if (table.decimal_comma) {
    table.text = with_decimal_points(text);
    for (Line& line : lines) line.text = {table.text->data() + (line.text.data() - text.data()), line.text.size()};
    table.rows = split_rows(lines, table.separator);
    add_notice(diagnostics, path, 0, "its decimal commas are read as decimal points");
  }
  table.has_header = !table.rows.empty() && !table.rows.front().cells.front().empty() &&
                     !cell_number(table.rows.front().cells.front());
  drop_empty_columns(table);
  take_unit_row(table);
  return table;
}

std::string row_width_hint(const ExportedTable& table, const TextRow& row) {
  const bool whole = ranges::all_of(row.cells, [](std::string_view cell) {
    return !cell.empty() && cell.find_first_not_of("0123456789+-") == std::string_view::npos;
  });
  const bool commas = table.separator == ',' && row.cells.size() > table.width && whole;
  return commas ? "decimal commas need semicolons or tabs between the cells" : "";
}

void add_notice(Diagnostics& diagnostics, const std::string& path, int line, std::string message) {
  diagnostics.add({Severity::warning, path, line, 0, "", std::move(message), "", "", FindingCode::input_converted});
}

}  // namespace overbend

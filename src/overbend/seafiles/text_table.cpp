#include "seafiles/text_table.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/interruption.h"
#include "base/read_double.h"
#include "base/text.h"

namespace overbend {
namespace {

constexpr std::uintmax_t kMaxFileSize = 64U << 20U;
constexpr int kLinesBetweenChecks = 10000;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Returns the end of a quoted cell that starts at `from`: the separator after its closing quote, or the end of the
/// line. Returns npos if the text there is not a quoted cell.
std::size_t quoted_cell_end(std::string_view line, std::size_t from, char separator) {
  std::size_t quote = line.find_first_not_of(" \t", from);
  if (quote == std::string_view::npos || line[quote] != '"') return std::string_view::npos;
  do {
    quote = line.find('"', quote + 1);
    if (quote == std::string_view::npos) return quote;
    if (quote + 1 < line.size() && line[quote + 1] == '"') {
      ++quote;  // a doubled quote is part of the text
      continue;
    }
    const std::size_t end = line.find_first_not_of(' ', quote + 1);
    if (end == std::string_view::npos) return line.size();
    return line[end] == separator ? end : std::string_view::npos;
  } while (true);
}

std::vector<std::string_view> split_at(std::string_view line, char separator, bool quoted) {
  std::vector<std::string_view> cells;
  std::size_t from = 0;
  while (from <= line.size()) {
    const std::size_t closed = quoted ? quoted_cell_end(line, from, separator) : std::string_view::npos;
    const std::size_t to =
        closed != std::string_view::npos ? closed : std::min(line.find(separator, from), line.size());
    const std::string_view cell = trim(line.substr(from, to - from));
    cells.push_back(closed != std::string_view::npos ? trim(cell.substr(1, cell.size() - 2)) : cell);
    from = to + 1;
  }
  return cells;
}

/// Splits in one pass, because hydrodynamic files have tens of thousands of rows.
std::vector<std::string_view> split_at_white(std::string_view line) {
  constexpr std::size_t kUsualColumns = 8;
  const auto is_white = [](char c) { return c == ' ' || c == '\t'; };
  std::vector<std::string_view> cells;
  cells.reserve(kUsualColumns);
  for (std::size_t from = 0, to = 0; from < line.size(); from = to) {
    while (from < line.size() && is_white(line[from])) ++from;
    to = from;
    while (to < line.size() && !is_white(line[to])) ++to;
    if (to > from) cells.push_back(line.substr(from, to - from));
  }
  return cells;
}

/// Returns why the bytes are not text that can be split into cells; null if they are.
const char* container_error(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("PK\x03\x04"sv)) {
    return "a spreadsheet (XLSX) or another zip archive, not text; save the sheet as CSV";
  }
  if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv)) {
    return "text in UTF-16; save it as UTF-8 or as CSV";
  }
  return nullptr;
}

}  // namespace

std::vector<std::string_view> split_remark(std::string_view line) {
  const std::string_view content = trim(line.substr(1));
  const std::size_t colon = content.find(':');
  if (colon == std::string_view::npos) return {content};
  return {trim(content.substr(0, colon)), trim(content.substr(colon + 1))};
}

std::vector<std::string_view> split_line(std::string_view line, char separator, bool quoted) {
  return separator == ' ' ? split_at_white(line) : split_at(line, separator, quoted);
}

std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics) {
  const auto reject = [&](const char* why) {
    diagnostics.add({Severity::error, path, 0, 0, "", why, "", ""});
    return std::nullopt;
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return reject("this file cannot be read");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kMaxFileSize) return reject("this file is larger than 64 MB");
  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file) return reject("this file could not be read completely");
  if (const char* why = container_error(text)) return reject(why);
  if (std::string_view(text).substr(0, 3) == kByteOrderMark) text.erase(0, 3);
  return text;
}

TextTable split_table(std::string_view text, char separator) {
  TextTable table;
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    const std::string_view line = trim(text.substr(from, to - from));
    from = to + 1;
    ++number;
    if (number % kLinesBetweenChecks == 0) check_interruption();
    if (line.empty()) continue;
    if (line.front() == '#') {
      table.remarks.push_back({number, split_remark(line)});
    } else {
      table.rows.push_back({number, split_line(line, separator, false)});
    }
  }
  return table;
}

std::optional<double> cell_number(std::string_view cell) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = read_double(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace overbend

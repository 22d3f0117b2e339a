#include "seafiles/hull_text.h"

#include <cmath>
#include <filesystem>

#include "base/text.h"

namespace overbend {
namespace {

std::string cell_text(const TextRow& row, std::size_t cell) {
  return cell < row.cells.size() ? "'" + for_display(row.cells[cell]) + "'" : "the end of the line";
}

}  // namespace

HullText::HullText(std::string text, std::string file)
    : text_(std::move(text)), table_(split_table(text_, ' ')), file_(std::move(file)) {}

HullText HullText::read(const std::string& file) {
  Diagnostics diagnostics;
  std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) throw HullFileError(diagnostics.sorted().front().found, "").in_file(file);
  return {std::move(*text), file};
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string joined(const TextRow& row) {
  constexpr std::size_t kMaxCells = 40;
  std::string text;
  for (std::size_t k = 0; k < std::min(row.cells.size(), kMaxCells); ++k) {
    if (k > 0) text += ' ';
    text += row.cells[k];
  }
  return text;
}

bool contains(const TextRow& row, std::string_view part) {
  return joined(row).find(part) != std::string::npos;
}

bool begins_with_number(const TextRow& row) {
  return !row.cells.empty() && cell_number(row.cells[0]).has_value();
}

double require_number(const TextRow& row, std::size_t cell, const std::string& expected) {
  if (cell < row.cells.size()) {
    if (const std::optional<double> value = cell_number(row.cells[cell])) return *value;
  }
  throw HullFileError(row.line, cell_text(row, cell), expected);
}

std::vector<double> require_numbers(const TextRow& row, std::size_t first, std::size_t count,
                                    const std::string& expected) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) values.push_back(require_number(row, first + k, expected));
  return values;
}

void check_point(const Vec3& point, int line, const std::string& expected) {
  constexpr double kMaxCoordinate = 1e4;
  if (point.cwiseAbs().maxCoeff() < kMaxCoordinate) return;
  throw HullFileError(line, "coordinates of 10 km and more", expected);
}

Vec3 require_point(const TextRow& row, std::size_t first, const std::string& expected) {
  const std::vector<double> p = require_numbers(row, first, 3, expected);
  Vec3 point(p[0], p[1], p[2]);
  check_point(point, row.line, expected);
  return point;
}

std::vector<double> numbers_in(const TextRow& row) {
  std::vector<double> values;
  for (const std::string_view cell : row.cells) {
    if (const std::optional<double> value = cell_number(cell)) values.push_back(*value);
  }
  return values;
}

int require_integer(const TextRow& row, std::size_t cell, int low, int high, const std::string& expected) {
  const double value = require_number(row, cell, expected);
  if (value >= low && value <= high && value == std::floor(value)) return static_cast<int>(value);
  throw HullFileError(row.line, cell_text(row, cell), expected);
}

}  // namespace overbend

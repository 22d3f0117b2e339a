#include "seafiles/rao_formats.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "model/waves/rao_table.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend::rao_formats {
namespace {

constexpr int kMaxErrors = 10;

/// Reports errors of table rows, but only the first few, because one mistake often affects every row.
class TableErrors {
 public:
  TableErrors(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  void error(int line, std::string found, std::string expected, std::string hint = {}) {
    if (count_++ >= kMaxErrors) return;
    diagnostics_.add({Severity::error, file_, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
  }
  bool full() const { return count_ >= kMaxErrors; }

 private:
  std::string file_;
  Diagnostics& diagnostics_;
  int count_ = 0;
};

std::string in_quotes(std::string_view cell) {
  return "'" + for_display(cell) + "'";
}

std::optional<double> number(const TextRow& row, std::size_t column, const std::string& name, TableErrors& problems) {
  const std::optional<double> value = cell_number(row.cells[column]);
  if (!value) problems.error(row.line, in_quotes(row.cells[column]), "a number for " + name);
  return value;
}

/// Returns the frequency [rad/s] from a column that may hold a period [s] or a frequency [rad/s or Hz].
std::optional<double> frequency(double value, const std::string& column) {
  if (value <= 0.0) return std::nullopt;
  if (column == "omega_rad_s") return value;
  return column == "period_s" ? 2.0 * kPi / value : 2.0 * kPi * value;
}

// CSV -------------------------------------------------------------------------------------------------------------

/// Parses a point in metres: "0 0 0.818" or "0 0".
std::optional<Vec3> parse_point(std::string_view text) {
  const TextTable table = split_table(text, ' ');
  if (table.rows.size() != 1 || table.rows[0].cells.size() < 2 || table.rows[0].cells.size() > 3) return std::nullopt;
  Vec3 p = Vec3::Zero();
  for (std::size_t i = 0; i < table.rows[0].cells.size(); ++i) {
    const std::optional<double> value = cell_number(table.rows[0].cells[i]);
    if (!value || std::abs(*value) > 1e4) return std::nullopt;
    p(static_cast<Eigen::Index>(i)) = *value;
  }
  return p;
}

void read_point(const TextRow& remark, std::optional<Vec3>& point, TableErrors& problems) {
  point = parse_point(remark.cells[1]);
  if (!point) {
    problems.error(remark.line, in_quotes(remark.cells[1]), "coordinates in metres separated by blanks, '0 0 0.818'");
  }
}

/// Reads a comment that defines a key or states an assumption; others are ignored.
void read_remark(const TextRow& remark, RaoFile& content, TableErrors& problems) {
  constexpr std::size_t kMaxAssumptionLength = 500;
  if (remark.cells.size() != 2) return;
  const std::string key(remark.cells[0]), word(remark.cells[1]);
  RaoSettings& stated = content.stated;
  if (key == "assumption" && !word.empty()) {
    content.assumptions.push_back(for_display(word, kMaxAssumptionLength));
    return;
  }
  if (key == "reference") return read_point(remark, stated.reference, problems);
  if (key == "wave_origin") return read_point(remark, stated.wave_origin, problems);
  for (const ConventionKey& known : convention_keys()) {
    if (key != known.key) continue;
    if (std::find(known.values.begin(), known.values.end(), word) == known.values.end()) {
      problems.error(remark.line, in_quotes(word) + " for " + key, join_choices(known.values));
    } else {
      stated.values[key] = word;
    }
  }
}

/// Indices of the columns in the header line.
struct Columns {
  std::size_t heading = 0, wave = 0, freedom = 0, amplitude = 0, phase = 0, count = 0;
  std::string wave_name, phase_name;
};

std::optional<std::size_t> find_column(const TextRow& header, const std::vector<std::string>& names,
                                       TableErrors& problems) {
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    if (std::find(names.begin(), names.end(), header.cells[i]) != names.end()) return i;
  }
  problems.error(header.line, "a header without a column " + join_items(names, "or"),
                 "heading_deg,omega_rad_s,dof,amplitude,phase_deg");
  return std::nullopt;
}

std::optional<Columns> find_columns(const TextRow& header, TableErrors& problems) {
  const auto heading = find_column(header, {"heading_deg"}, problems);
  const auto wave = find_column(header, {"omega_rad_s", "frequency_hz", "period_s"}, problems);
  const auto freedom = find_column(header, {"dof"}, problems);
  const auto amplitude = find_column(header, {"amplitude"}, problems);
  const auto phase = find_column(header, {"phase_deg", "phase_rad"}, problems);
  if (!heading || !wave || !freedom || !amplitude || !phase) return std::nullopt;
  return Columns{*heading,
                 *wave,
                 *freedom,
                 *amplitude,
                 *phase,
                 header.cells.size(),
                 std::string(header.cells[*wave]),
                 std::string(header.cells[*phase])};
}

/// Returns the index of a degree of freedom given by name or number; -1 if invalid.
int parse_freedom(std::string_view cell) {
  for (std::size_t k = 0; k < 6; ++k) {
    if (lower_case(cell) == kFreedomNames[k]) return static_cast<int>(k);
  }
  return cell.size() == 1 && cell[0] >= '1' && cell[0] <= '6' ? cell[0] - '1' : -1;
}

bool amplitude_is_right(double amplitude, int line, TableErrors& problems) {
  if (amplitude >= 0.0) return true;
  problems.error(line, "an amplitude below zero", "at least 0", "a change of sign is a phase of 180 deg");
  return false;
}

void read_csv_row(const TextRow& row, const Columns& columns, std::vector<RaoRecord>& records, TableErrors& problems) {
  if (row.cells.size() != columns.count) {
    problems.error(row.line, std::to_string(row.cells.size()) + " cells",
                   std::to_string(columns.count) + ", as many as in the header");
    return;
  }
  const auto heading = number(row, columns.heading, "heading_deg", problems);
  const auto wave = number(row, columns.wave, columns.wave_name, problems);
  const auto amplitude = number(row, columns.amplitude, "amplitude", problems);
  const auto phase = number(row, columns.phase, columns.phase_name, problems);
  const int freedom = parse_freedom(row.cells[columns.freedom]);
  if (freedom < 0) {
    problems.error(row.line, in_quotes(row.cells[columns.freedom]), "a degree of freedom: surge to yaw, or 1 to 6");
  }
  if (!heading || !wave || !amplitude || !phase || freedom < 0) return;
  const std::optional<double> omega = frequency(*wave, columns.wave_name);
  if (!omega) {
    problems.error(row.line, in_quotes(row.cells[columns.wave]) + " for " + columns.wave_name, "more than 0");
    return;
  }
  if (!amplitude_is_right(*amplitude, row.line, problems)) return;
  const double turn = columns.phase_name == "phase_deg" ? kDegree : 1.0;
  records.push_back({*heading * kDegree, *omega, freedom, *amplitude, *phase * turn, row.line});
}

}  // namespace

RaoFile read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  TableErrors problems(file, diagnostics);
  RaoFile content;
  const std::optional<ExportedTable> read = read_exported_table(text, file, diagnostics);
  if (!read) return content;
  const ExportedTable& table = *read;
  for (const TextRow& remark : table.remarks) read_remark(remark, content, problems);
  if (table.rows.empty()) return content;
  const std::optional<Columns> columns = find_columns(table.rows.front(), problems);
  if (!columns) return content;
  for (std::size_t i = 1; i < table.rows.size() && !problems.full(); ++i) {
    read_csv_row(table.rows[i], *columns, content.records, problems);
  }
  return content;
}

RaoFile read_wamit(const std::string& text, const std::string& file, const WaveColumnSettings& column,
                   Diagnostics& diagnostics) {
  TableErrors problems(file, diagnostics);
  const TextTable table = split_table(text, ' ');
  RaoFile content;
  std::vector<double> first_column;
  for (std::size_t i = 0; i < table.rows.size() && !problems.full(); ++i) {
    const TextRow& row = table.rows[i];
    if (i == 0 && !cell_number(row.cells[0])) continue;  // optional header line
    if (row.cells.size() != 7) {
      problems.error(row.line, std::to_string(row.cells.size()) + " numbers", "seven: PER BETA I MOD PHA RE IM");
      continue;
    }
    const auto period = number(row, 0, "PER", problems);
    const auto heading = number(row, 1, "BETA", problems);
    const auto amplitude = number(row, 3, "MOD", problems);
    const auto phase = number(row, 4, "PHA", problems);
    const int freedom = parse_freedom(row.cells[2]);
    if (freedom < 0) {
      problems.error(row.line, in_quotes(row.cells[2]), "a mode from 1 to 6", "one body, rigid modes only");
    }
    if (!period || !heading || !amplitude || !phase || freedom < 0) continue;
    if (*period <= 0.0 || !amplitude_is_right(*amplitude, row.line, problems)) continue;
    first_column.push_back(*period);
    content.records.push_back(
        {*heading * kDegree, column_frequency(column, *period), freedom, *amplitude, *phase * kDegree, row.line});
  }
  check_column(column, first_column, file, "vessel.motion.convention.frequencies", diagnostics);
  return content;
}

}  // namespace overbend::rao_formats

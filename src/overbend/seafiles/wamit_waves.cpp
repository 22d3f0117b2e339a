#include "seafiles/wamit_waves.h"

#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/heading_table_builder.h"
#include "seafiles/wamit_table.h"

namespace overbend::wamit {
namespace {

bool reject(const std::string& file, int line, std::string found, std::string expected, Diagnostics& diagnostics,
            std::string hint = {}) {
  diagnostics.add({Severity::error, file, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
  return false;
}

/// Checks period, headings and mode of a row; returns false after an error.
bool check_row(const Table& table, const Row& row, std::size_t mode_column, const HydrodynamicsSource& source,
               Diagnostics& diagnostics) {
  if (row.values[0] <= 0.0) {
    return reject(table.file, row.line, column_label(wave_column(source), row.values[0]), "more than 0", diagnostics);
  }
  for (std::size_t k = 1; k < mode_column; ++k) {
    if (std::abs(row.values[k]) > 360.0) {
      return reject(table.file, row.line, "the heading " + format_number(row.values[k]), "-360 to 360 deg",
                    diagnostics);
    }
  }
  if (mode_index(std::abs(row.values[mode_column]), source.body) == -1) {
    return reject(table.file, row.line, "the mode " + format_number(row.values[mode_column]),
                  "a mode from 1 to 6, of one body", diagnostics, kBodyHint);
  }
  return true;
}

std::optional<HeadingTableBuilder::Built> build(const HeadingTableBuilder& values, const std::string& file,
                                                const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  std::string error;
  auto built = values.build(source.mirror_headings, error);
  if (!built) {
    reject(file, 0, error, "one value for every pair of period and heading", diagnostics);
  }
  return built;
}

}  // namespace

bool read_excitation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                     Diagnostics& diagnostics) {
  const std::optional<Table> table = read_table(file, 7, 7, diagnostics);
  if (!table || !check_wave_column(source, first_column(*table), file, diagnostics)) {
    return false;
  }
  HeadingTableBuilder values;
  const double unit = source.water_density * source.gravity * std::pow(source.length_scale, 2);
  for (const Row& row : table->rows) {
    if (!check_row(*table, row, 2, source, diagnostics)) {
      return false;
    }
    const int mode = mode_index(std::abs(row.values[2]), source.body);
    if (mode == kOtherBody) continue;
    const double arm = mode > 2 ? source.length_scale : 1.0;
    values.add(column_frequency(wave_column(source), row.values[0]), row.values[1] * kDegree, mode,
               unit * arm * std::complex<double>(row.values[5], row.values[6]));
  }
  auto built = build(values, file, source, diagnostics);
  if (built) {
    data.excitation = std::move(built->table);
    data.force = std::move(built->values);
  }
  return built.has_value();
}

bool read_drift(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                Diagnostics& diagnostics) {
  const std::optional<Table> table = read_table(file, 8, 8, diagnostics);
  if (!table || !check_wave_column(source, first_column(*table), file, diagnostics)) {
    return false;
  }
  HeadingTableBuilder values;
  const double unit = source.water_density * source.gravity * source.length_scale;
  for (const Row& row : table->rows) {
    if (!check_row(*table, row, 3, source, diagnostics)) {
      return false;
    }
    const int mode = mode_index(std::abs(row.values[3]), source.body);
    const bool horizontal = mode == 0 || mode == 1 || mode == 5;
    if (!horizontal || std::abs(row.values[1] - row.values[2]) > 1e-6) {
      continue;
    }
    const double omega = column_frequency(wave_column(source), row.values[0]);
    const double arm = mode > 2 ? source.length_scale : 1.0;
    const double force = omega < source.drift_from ? 0.0 : unit * arm * row.values[6];
    values.add(omega, row.values[1] * kDegree, mode, force);
  }
  if (values.empty()) {
    return reject(file, 0, "no mean drift of surge, sway or yaw", "pairs of equal headings", diagnostics);
  }
  const auto built = build(values, file, source, diagnostics);
  if (!built) {
    return false;
  }
  data.drift = built->table;
  for (const CVec6& value : built->values) {
    data.mean_drift.push_back(value.real());
  }
  return true;
}

}  // namespace overbend::wamit

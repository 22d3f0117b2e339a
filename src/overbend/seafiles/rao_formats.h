/// Formats of RAO files; include seafiles/rao_reader.h instead.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/rao_convention.h"
#include "seafiles/wave_column.h"

namespace overbend::rao_formats {

/// Contents of a file: its records and settings. Angles of records are in rad except amplitudes.
struct RaoFile {
  std::vector<RaoRecord> records;
  RaoSettings stated;
  RaoSymmetry symmetry = RaoSymmetry::unstated;
  std::vector<std::string> assumptions;  ///< Sentences on the origin of the data, for reports.
};

/// Readers of the text of a file; errors go to `diagnostics`. `user_settings` selects one of several vessel types and
/// draughts.
RaoFile read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics);
RaoFile read_wamit(const std::string& text, const std::string& file, const WaveColumnSettings& column,
                   Diagnostics& diagnostics);
RaoFile read_orcaflex(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                      Diagnostics& diagnostics);

}  // namespace overbend::rao_formats

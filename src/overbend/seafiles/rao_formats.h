/// Layouts of RAO files; include seafiles/rao_reader.h instead.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/rao_convention.h"
#include "seafiles/wave_column.h"

namespace overbend::rao_formats {

/// Content of a file: its numbers, and its statements about them. Angles of records are in rad except amplitudes.
struct RaoFile {
  std::vector<RaoRecord> records;
  RaoSettings stated;
  RaoSymmetry symmetry = RaoSymmetry::unstated;
  std::vector<std::string> assumptions;  ///< Sentences about the origin of the numbers, for reports.
};

/// Each takes the file's text; faults go to `diagnostics`. `given` chooses among several vessel types and draughts.
RaoFile read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics);
RaoFile read_wamit(const std::string& text, const std::string& file, const WaveColumnSettings& column,
                   Diagnostics& diagnostics);
RaoFile read_orcaflex(const std::string& text, const std::string& file, const RaoSettings& given,
                      Diagnostics& diagnostics);

}  // namespace overbend::rao_formats

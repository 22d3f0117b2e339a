/// Reads a wave scatter diagram.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/study_description.h"
#include "model/description/waves_description.h"

namespace overbend {

/// Meaning of the periods, and the spectrum with which mean periods become peak periods.
struct ScatterSettings {
  std::optional<ScatterPeriod> period = {};  ///< As the study states; empty: as the header states.
  const WavesDescription* waves = nullptr;   ///< Type and gamma of the waves of the study; null: none.
};

/// Reads a table: a header of wave height and periods [s], then a row per significant wave height with the occurrence
/// of each sea. The first cell of the header is `hs_m` (peak periods follow), or names both, "Hs (m) / Tz (s)". Columns
/// `month` (1 to 12, or jan to dec) and `from_deg` (azimuth that the waves come from) may precede it, in this order.
/// Heights and periods are the centres of evenly spaced cells, or ranges "0.5-1" that follow each other and may be
/// uneven. Separators and decimal commas are recognised (seafiles/table_layout.h).
///
/// Numbers are counts or proportional to counts: those of a month are divided by their sum. With the comment
/// `# values: probability` or `# values: per cent`, or per cent signs, they are used as given, and any missing
/// probability of a month is treated as seas outside the diagram. Empty cells are 0. A column or row named total, sum
/// or all must agree with the sum of its values within their rounding.
///
/// Zero up-crossing periods Tz become peak periods by the ratio of the study's spectrum (model/waves/peak_period.h).
///
/// `path` names the text in messages; every error is reported with its line. Returns nothing after an error.
std::optional<ScatterDiagram> read_scatter_text(const std::string& text, const std::string& path,
                                                Diagnostics& diagnostics, const ScatterSettings& settings = {});

/// The same from a file.
std::optional<ScatterDiagram> read_scatter(const std::string& path, Diagnostics& diagnostics,
                                           const ScatterSettings& settings = {});

}  // namespace overbend

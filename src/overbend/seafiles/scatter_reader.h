/// Reads a wave scatter diagram.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/study_description.h"

namespace overbend {

/// Reads CSV text: a header of `hs_m` and the peak periods [s], then a row per significant wave height [m] with the
/// occurrence of each sea. Columns `month` (1 to 12, or jan to dec) and `from_deg` (azimuth that the waves come from)
/// may precede `hs_m`, in this order. Heights and periods are the centres of evenly spaced cells, or ranges "0.5-1".
///
/// Numbers are counts or proportional to counts: those of a month are divided by their sum. With the comment
/// `# values: probability` or `# values: per cent` they are used as given, and any missing probability of a month is
/// treated as seas outside the diagram. Empty cells are 0; a column or row named total, sum or all is skipped.
///
/// `path` names the text in messages; every error is reported with its line. Returns nothing after an error.
std::optional<ScatterDiagram> read_scatter_text(const std::string& text, const std::string& path,
                                                Diagnostics& diagnostics);

/// The same from a file.
std::optional<ScatterDiagram> read_scatter(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend

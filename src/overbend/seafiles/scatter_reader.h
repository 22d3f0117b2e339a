/// Reads a scatter diagram of seas.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/study_description.h"

namespace overbend {

/// Reads CSV text: a header of `hs_m` and the peak periods [s], then a row per significant wave height [m] with how
/// often each sea comes. Columns `month` (1 to 12, or jan to dec) and `from_deg` (azimuth that the waves come from) may
/// stand before `hs_m`, in this order. Heights and periods are the middles of evenly spaced cells, or ranges "0.5-1".
///
/// Numbers are counts or anything in proportion to them: those of a month are divided by their sum. With the remark
/// `# values: probability` or `# values: per cent` they stand as they are, and what a month lacks is seas that the
/// diagram does not have. Empty cells are none; a column or row named total or sum is passed over.
///
/// `path` names the text in messages; every error is reported with its line. Nothing after a fault.
std::optional<ScatterDiagram> read_scatter_text(const std::string& text, const std::string& path,
                                                Diagnostics& diagnostics);

/// The same from a file.
std::optional<ScatterDiagram> read_scatter(const std::string& path, Diagnostics& diagnostics);

}  // namespace overbend

/// A goal seek in the report: what was asked, the answer, the way there.
#pragma once

#include <string>

#include "base/json.h"
#include "results/seek_results.h"

namespace overbend {

/// The section, with its figures numbered on from `figure`.
std::string seek_section(const SeekResults& seek, int& figure);

/// Data of its figures, in the units that keys and results are shown in.
Json seek_figure_data(const SeekResults& seek);

}  // namespace overbend

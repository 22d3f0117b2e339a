/// A goal seek in the report: its goals, the answer, the search path.
#pragma once

#include "report/page/blocks.h"
#include "results/seek_results.h"

namespace overbend {

/// Returns goals, answer and search path as tables and a figure.
Blocks seek_section(const SeekResults& seek);

/// Returns the data of its figures, in the display units of keys and results.
Json seek_figure_data(const SeekResults& seek);

}  // namespace overbend

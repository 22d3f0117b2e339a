/// A goal seek in the report: what was asked, the answer, the way there.
#pragma once

#include "report/page/blocks.h"
#include "results/seek_results.h"

namespace overbend {

Blocks seek_section(const SeekResults& seek);

/// Data of its figures, in the units that keys and results are shown in.
Json seek_figure_data(const SeekResults& seek);

}  // namespace overbend

/// Data of the figures of lines by themselves.
#pragma once

#include "base/json.h"
#include "results/line_results.h"

namespace overbend {

/// Nodes of every line under "lines"; of a run the tensions at the ends under "dynamic", as
/// report/dynamic/history_data.h has histories. SI but for the histories.
Json line_figure_data(const LinesResults& results, double water_depth);

/// Start and end of the histories of a run: the build-up before t = 0, and the duration after it [s].
double build_up_of(const LinesResults& results);
double duration_of(const LinesResults& results);

}  // namespace overbend

/// What mooring lines and lines by themselves are used to: bars and verdict of the first page.
#pragma once

#include <vector>

#include "report/front_page.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"

namespace overbend {

/// Tension over the breaking load, over the working load where the model gives one, anchors over their holding power:
/// the largest of rest and stages.
std::vector<UtilisationBar> mooring_bars(const MooringResults& results, const std::optional<double>& working_load);

/// The same over the time of a dynamic run.
std::vector<UtilisationBar> mooring_bars(const std::vector<MooringLineDynamics>& lines,
                                         const std::optional<double>& working_load);

/// Tension over the breaking load of the lines by themselves, in a run over its time.
std::vector<UtilisationBar> line_bars(const LinesResults& results);

/// Exceeded where a bar is beyond 1, reserved by serious warnings, open without any bar: no safety factor is applied.
Verdict load_verdict(const std::vector<UtilisationBar>& bars, const std::vector<WeighedWarning>& warnings);

}  // namespace overbend

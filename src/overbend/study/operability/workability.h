/// Fraction of time in which the seas are below the limits of a chart.
#pragma once

#include <string>
#include <variant>

#include "model/description/study_description.h"
#include "results/study_results.h"

namespace overbend {

/// The limits are wave heights over heading and period: `chart.over` is environment.waves.hs, and the chart has no
/// other axes than environment.waves.from and environment.waves.tp. A sea takes the limit of the nearest heading (the
/// lowest of all headings if the diagram has no directions), linearly interpolated between the periods; a cell of the
/// diagram counts with the part of its height range below the limit. A limit below the minimum height is 0. Seas
/// outside the chart (periods beyond the first or last, heights above the maximum that was tried and passes, undecided
/// limits, missing probability of the diagram) count as not workable and are reported. `factor` applies to every limit:
/// alpha of DNV-ST-N001. Returns a message if the chart is not suitable.
std::variant<Workability, std::string> workability(const ScatterDiagram& diagram, const OperabilityResults& chart,
                                                   double factor = 1.0);

}  // namespace overbend

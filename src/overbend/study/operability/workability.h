/// How much of the time the seas lie below the limits of a chart.
#pragma once

#include <string>
#include <variant>

#include "model/description/study_description.h"
#include "results/study_results.h"

namespace overbend {

/// The limits are heights over heading and period: `chart.over` is environment.waves.hs, and the chart has no other
/// axes than environment.waves.from and environment.waves.tp. A sea takes the limit of the nearest heading (the
/// lowest of all headings where the diagram has no directions), linearly between the periods; a cell of the diagram
/// counts with the part of its height below the limit. A limit below the least height is 0. Seas outside of the chart
/// (periods beyond the first or last, heights above the largest that was tried and passes, limits that are not decided,
/// what the diagram lacks of a whole) count as not workable and are told. `factor` on every limit: alpha of
/// DNV-ST-N001. A sentence where the chart does not serve.
std::variant<Workability, std::string> workability(const ScatterDiagram& diagram, const OperabilityResults& chart,
                                                   double factor = 1.0);

}  // namespace overbend

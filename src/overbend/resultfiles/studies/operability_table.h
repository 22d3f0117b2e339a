/// The limits of an operability chart, and its workability, as tables.
#pragma once

#include "results/study_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns a row per cell: the values of the other axes, the limit (and with alpha), its governing criterion. Angles
/// and quantities in the units of the study file.
Table operability_table(const OperabilityResults& results);

/// Returns a row per month and one for the year: workable share of time. Without rows if unknown.
Table workability_table(const OperabilityResults& results);

/// Returns a short label of a limit: "limit", "below the least", "above the largest", "not decided".
std::string limit_state_label(const OperabilityCell& cell);

}  // namespace overbend

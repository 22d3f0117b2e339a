/// The limits of a chart of operability, and its workability, as tables.
#pragma once

#include "results/study_results.h"
#include "results/tables/table.h"

namespace overbend {

/// A row per cell: the values of the other axes, the limit (and with alpha), what it is limited by. Angles and
/// quantities in the units that the study file has them in.
Table operability_table(const OperabilityResults& results);

/// A row per month and one for the year: how much of the time is workable. Without rows where nothing is known of it.
Table workability_table(const OperabilityResults& results);

/// What a limit says, in a word or two: "limit", "below the least", "above the largest", "not decided".
std::string limit_words(const OperabilityCell& cell);

}  // namespace overbend

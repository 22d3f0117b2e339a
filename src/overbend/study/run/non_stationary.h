/// Runs whose records are not stationary.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the event that makes the record non-stationary, as a clause: a line parted, an anchor dragged, a brake
/// rendered, a winch or the vessel moved, the hull was released from an offset. Empty if there is none. Reads the
/// mooring lines of `results`.
std::string non_stationary(const Description& description, const DynamicResults& results);

/// Opening of the warning of such a run.
inline constexpr std::string_view kNotStationary = "the record is not stationary";

/// True if the findings of a run contain this warning; several runs with one such run have no three-hour extremes.
bool is_not_stationary(const Findings& findings);

}  // namespace overbend

/// Runs in which something happens after which the record is another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// What happened, as a clause: a line parted, an anchor dragged, a brake rendered, a winch or the vessel moved, the
/// hull was let go from an offset. Empty where nothing did. Reads the mooring lines of `results`.
std::string non_stationary(const Description& description, const DynamicResults& results);

/// How the warning of such a run begins.
inline constexpr std::string_view kNotStationary = "the record is not stationary";

/// Whether it is among the warnings of a run: of several runs with one there are no extremes of three hours either.
bool is_not_stationary(const Findings& findings);

}  // namespace overbend

/// Static value of a quantity of a dynamic run.
#pragma once

#include <optional>
#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Returns the static value of the history or extreme of this name; none if the static results have no such quantity.
std::optional<double> static_value(const StaticResults& statics, const DynamicResults& results,
                                   const std::string& name);

}  // namespace overbend

/// Checks that all output numbers are finite.
#pragma once

#include <string>

#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend {

/// Throws std::runtime_error that names the first quantity that is not finite: "stations[12].bending_moment".
void require_finite(const StaticResults& results);

/// The same for a dynamic analysis: "dynamic.supports[3].reaction_max".
void require_finite(const DynamicResults& results);

/// The same for checks; `place` is the prefix of the names.
void require_finite(const CheckTable& checks, const std::string& place);

}  // namespace overbend

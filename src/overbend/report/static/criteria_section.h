/// Acceptance criteria of the analysis.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/check_results.h"

namespace overbend {

/// Returns every criterion once, governing ones first; then the rule on findings with those that the project accepts.
/// Empty without checks.
Blocks criteria_section(const CheckTable& checks, const std::optional<Description>& description);

}  // namespace overbend

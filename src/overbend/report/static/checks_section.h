/// The code checks of a report.
#pragma once

#include "base/json.h"
#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Governing checks first, the utilisation along the pipe, then every check by region. Empty for results without
/// checks.
Blocks checks_section(const StaticResults& statics, const CheckTable& table);

/// The numbers that went into each check, for the appendix.
Blocks check_inputs_section(const CheckTable& table);

/// Data of the utilisation figure.
Json checks_figure_data(const StaticResults& statics, const CheckTable& table);

}  // namespace overbend

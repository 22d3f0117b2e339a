/// The code checks of a report.
#pragma once

#include "base/json.h"
#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Returns governing checks first, the utilisation along the pipe, then every check by region. Empty for results
/// without checks.
Blocks checks_section(const StaticResults& statics, const CheckTable& table);

/// Returns the input numbers of each check, for the appendix.
Blocks check_inputs_section(const CheckTable& table);

/// Returns the data of the utilisation figure.
Json checks_figure_data(const StaticResults& statics, const CheckTable& table);

}  // namespace overbend
